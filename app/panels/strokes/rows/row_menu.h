// The menu of a row of the Strokes dock.
#pragma once

#include <QList>

class QAction;
class QMenu;
class QModelIndex;

namespace suffuse {

class Editor;
class StrokesModel;

/// Adds what can be done with the row, an index of the model, and with the selection. `more` are commands that do
/// something to what is selected.
void fillRowMenu(QMenu &menu, Editor &editor, StrokesModel &model, const QModelIndex &row,
                 const QList<QAction *> &more);

} // namespace suffuse

// What is seen beside the pointer while rows of the Strokes dock are dragged.
#pragma once

#include <QModelIndexList>
#include <QPixmap>

class QTreeView;

namespace suffuse {

/// A small picture of rows: of one its picture and its name, of several the picture of the first and how many they are.
/// It covers little, so that one sees where the rows go.
QPixmap dragPicture(const QTreeView &view, const QModelIndexList &rows);
/// Where the pointer is in the picture, which hangs below it to the right: the line that shows the place stays free.
QPoint dragHotSpot();

} // namespace suffuse

// Rows of the Strokes dock that are moved by keys.
#pragma once

#include <QModelIndex>
#include <QString>

#include <vector>

namespace suffuse {

class StrokesFilter;
class StrokesModel;
class StrokesView;
class ValueEntry;

/// The numbers of a row and of those around it, the outermost first: they order rows from top to bottom.
std::vector<int> placeOf(QModelIndex row);

/// Moves the selected rows, or else the one with the frame, past the next row above or below; into a group that is open
/// there, and out of theirs at its end. The moves of one entry are one undo step where they follow each other. Returns
/// why nothing was moved, or an empty text.
QString moveRows(StrokesView &view, StrokesModel &model, const StrokesFilter &filter, bool up, ValueEntry &entry);

} // namespace suffuse

// What the rows of the Strokes dock show.
#pragma once

#include "app/panels/strokes/group_marks.h"

#include <QVariant>

namespace suffuse {

/// What the row of a segment, a stroke or a group has in a column (StrokesModel::Column) for a role. The value is
/// invalid where there is nothing to show.
QVariant segmentRowData(const Stroke &stroke, int segment, int column, int role);
QVariant strokeRowData(const Stroke &stroke, int column, int role);
QVariant groupRowData(const Group &group, const GroupMarks &marks, int column, int role);

} // namespace suffuse

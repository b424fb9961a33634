#include "app/panels/strokes/rows/row_data.h"

#include "app/panels/strokes/group_cells.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/session/colour_convert.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/numbers/blend_modes.h"
#include "app/widgets/numbers/display.h"
#include "model/colour/colour_uses.h"
#include "model/shaping/curves/chains.h"

#include <algorithm>

namespace suffuse {

namespace {

QVariant switchData(bool visible, bool locked, int column, int role)
{
    if (role == StrokesModel::SwitchRole)
        return column == StrokesModel::EyeColumn ? visible : locked;
    if (column == StrokesModel::EyeColumn) {
        if (role == Qt::DecorationRole)
            return icon(visible ? "eye" : "eye-off");
        if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole)
            return visible ? StrokesModel::tr("Visible. Click: hide.") : StrokesModel::tr("Hidden. Click: show.");
    } else if (column == StrokesModel::LockColumn) {
        if (role == Qt::DecorationRole)
            return icon(locked ? "lock" : "unlock");
        if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole)
            return locked ? StrokesModel::tr("Locked. Click: unlock.") : StrokesModel::tr("Not locked. Click: lock.");
    }
    return {};
}

/// The icon and the tool tip of a group's eye or lock. They also tell about the strokes in the group.
QVariant groupSwitchData(const Group &group, const GroupMarks &marks, int column, int role)
{
    const bool eye = column == StrokesModel::EyeColumn;
    const Share share = eye ? marks.hidden : marks.locked;
    const bool own = eye ? !group.visible : group.locked;
    if (role == StrokesModel::PartRole)
        return !own && share == Share::Some;
    if (own || share == Share::None)
        return switchData(group.visible, group.locked, column, role);
    const bool all = share == Share::All;
    if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole) {
        if (eye)
            return all ? StrokesModel::tr("All in it is hidden. Click: show it.")
                       : StrokesModel::tr("Some of it is hidden. Click: hide the group.");
        return all ? StrokesModel::tr("All in it is locked. Click: unlock it.")
                   : StrokesModel::tr("Some of it is locked. Click: lock the group.");
    }
    if (all)
        return switchData(false, true, column, role);
    return role == Qt::DecorationRole ? icon(eye ? "eye-part" : "lock-part")
                                      : switchData(group.visible, group.locked, column, role);
}

/// How a stroke of several chains, or one that was erased softly, is made up: "3 pieces, 12 erasures".
QString makeUpOf(const Stroke &stroke)
{
    const int erasures = erasureCount(stroke), pieces = int(chainsOf(stroke).size()) - erasures;
    QStringList parts;
    if (pieces > 1)
        parts << StrokesModel::tr("%Ln piece(s)", nullptr, pieces);
    if (erasures > 0)
        parts << StrokesModel::tr("%Ln erasure(s)", nullptr, erasures);
    //: between "3 pieces" and "12 erasures"
    return parts.join(StrokesModel::tr(", "));
}

/// What is not usual about how a group is put on what lies below: "Multiply · 60 %".
QString blendingOf(const Group &group)
{
    QStringList parts;
    if (group.blend != BlendMode::Normal)
        parts << nameOf(group.blend);
    if (group.opacity < 1)
        parts << shareDisplay().text(double(group.opacity));
    if (parts.isEmpty() && group.isolated)
        parts << StrokesModel::tr("mixes by itself");
    return parts.join(QStringLiteral(" · "));
}

/// "40 segments", and in a second line how the stroke is made up.
QString tipFor(const Stroke &stroke)
{
    const QString segments = StrokesModel::tr("%Ln segment(s)", nullptr, int(stroke.segments.size()));
    const QString makeUp = makeUpOf(stroke);
    return makeUp.isEmpty() ? segments : segments + QLatin1Char('\n') + makeUp;
}

/// What is not usual about a group, a line for each thing.
QString tipFor(const Group &group)
{
    const QString blending = blendingOf(group);
    return ((blending.isEmpty() ? QStringList() : QStringList{blending}) + wordsOfMarks(group)).join(QLatin1Char('\n'));
}

} // namespace

QVariant segmentRowData(const Stroke &stroke, int segment, int column, int role)
{
    if (role == StrokesModel::StrokeIdRole)
        return QVariant::fromValue<qulonglong>(stroke.id);
    if (role == StrokesModel::GroupIdRole)
        return QVariant::fromValue<qulonglong>(0);
    if (role == StrokesModel::SegmentRole)
        return segment;
    if (column != StrokesModel::NameColumn || std::size_t(segment) >= stroke.segments.size())
        return {};
    if (role == Qt::DisplayRole)
        return StrokesModel::tr("Segment %1").arg(segment + 1);
    if (role == StrokesModel::ColourRole)
        return toOpaqueScreen(stroke.segments[std::size_t(segment)].colour);
    return {};
}

QVariant strokeRowData(const Stroke &stroke, int column, int role)
{
    if (role == StrokesModel::SegmentRole)
        return -1;
    if (role == StrokesModel::StrokeIdRole)
        return QVariant::fromValue<qulonglong>(stroke.id);
    if (role == StrokesModel::GroupIdRole)
        return QVariant::fromValue<qulonglong>(0);
    if (column != StrokesModel::NameColumn)
        return switchData(stroke.visible, stroke.locked, column, role);
    switch (role) {
    case Qt::DisplayRole:
        return titleOf(stroke);
    case Qt::EditRole:
        return stroke.name;
    case Qt::ToolTipRole:
        return tipFor(stroke);
    case Qt::AccessibleDescriptionRole:
    case StrokesModel::MakeUpRole:
        return makeUpOf(stroke);
    case StrokesModel::ColourRole:
        return stroke.segments.empty() ? QVariant() : toOpaqueScreen(shownColourOf(stroke));
    case StrokesModel::UnnamedRole:
        return stroke.name.isEmpty();
    default:
        return {};
    }
}

QVariant groupRowData(const Group &group, const GroupMarks &marks, int column, int role)
{
    if (role == StrokesModel::SegmentRole)
        return -1;
    if (role == StrokesModel::StrokeIdRole)
        return QVariant::fromValue<qulonglong>(0);
    if (role == StrokesModel::GroupIdRole)
        return QVariant::fromValue<qulonglong>(group.id);
    if (column != StrokesModel::NameColumn)
        return groupSwitchData(group, marks, column, role);
    switch (role) {
    case Qt::DisplayRole:
        return titleOf(group);
    case Qt::EditRole:
        return group.name;
    case Qt::DecorationRole:
        return icon("group");
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
        return tipFor(group);
    case StrokesModel::MakeUpRole:
        return blendingOf(group);
    case StrokesModel::UnnamedRole:
        return group.name.isEmpty();
    default:
        return {};
    }
}

} // namespace suffuse

// What stands behind the name in a group's row: marks of its switches, its mode and its opacity.
#pragma once

#include "model/painting/painting.h"

#include <QFont>
#include <QRect>
#include <QStringList>

class QPainter;
class QStyleOptionViewItem;

namespace suffuse {

/// Where these stand; what there is no room for is empty.
struct GroupCells {
    QRect marks;
    QRect mode;
    QRect opacity;
};

/// The icons of the switches of a group that are on: clips, mask, wash, draft, solo.
QStringList marksOf(const Group &group);
/// What these say, for people, a line for each.
QStringList wordsOfMarks(const Group &group);

/// The places in `row`, the rectangle of the name's cell, behind what `name` needs of it, in pixels. The mode gives way
/// to a long name; a name that is longer still gives way to the opacity, and all give way to the marks.
GroupCells groupCells(const Group &group, const QRect &row, int name, const QFont &font);
/// Where the first of them begins; the right end of the row where there is none.
int leftOf(const GroupCells &cells, const QRect &row);
/// Paints them as small as they are in that font, and a strip of the colour with which the group is marked.
void paintGroupCells(QPainter &painter, const QStyleOptionViewItem &option, const Group &group,
                     const GroupCells &cells);

} // namespace suffuse

#include "app/panels/strokes/group_cells.h"

#include "app/panels/strokes/rows/row_look.h"
#include "app/widgets/look/group_tags.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/numbers/blend_modes.h"
#include "app/widgets/numbers/display.h"

#include <QCoreApplication>
#include <QFontMetrics>
#include <QPainter>
#include <QStyleOptionViewItem>

#include <algorithm>

namespace suffuse {

namespace {

struct MarkText {
    Q_DECLARE_TR_FUNCTIONS(suffuse::GroupCells)
};

constexpr int cellGap = 8;   ///< logical pixels between cells, and before the row's end
constexpr int markSize = 14; ///< of an icon
constexpr int markStep = 16;
constexpr int roundedOff = 2; ///< of the width of a text, which must not be cut short by it
constexpr int leastName = 40; ///< of picture and name that are cut short
constexpr int leastMode = 28; ///< of a mode that is cut short; below this width it says nothing

QFont smallerFont(const QFont &font)
{
    constexpr double smaller = 0.85;
    QFont small = font;
    small.setBold(false);
    small.setPointSizeF(smaller * font.pointSizeF());
    return small;
}

QString opacityText(const Group &group)
{
    return shareDisplay().text(double(group.opacity));
}

} // namespace

QStringList marksOf(const Group &group)
{
    QStringList icons;
    for (const auto &[on, name] : {std::pair(group.clips, "group-clips"),
                                   {group.mask, "group-mask"},
                                   {group.wash.has_value(), "group-wash"},
                                   {group.draft, "group-draft"},
                                   {group.solo, "group-solo"}})
        if (on)
            icons << QString::fromLatin1(name);
    return icons;
}

QStringList wordsOfMarks(const Group &group)
{
    QStringList words;
    if (group.clips)
        words << MarkText::tr("Clipped to what lies below it in its group");
    if (group.mask)
        words << MarkText::tr("A mask for the others in its group");
    if (group.wash)
        words << MarkText::tr("A wash: its strokes are one");
    if (group.draft)
        words << MarkText::tr("A draft: left out of what is exported");
    if (group.tag != GroupTag::None)
        words << nameOf(group.tag);
    if (group.solo)
        words << MarkText::tr("Shown alone");
    return words;
}

GroupCells groupCells(const Group &group, const QRect &row, int name, const QFont &font)
{
    const QFontMetrics metrics(smallerFont(font));
    int right = row.right() + 1 - cellGap / 2;
    const int percent = roundedOff + std::max(metrics.horizontalAdvance(shareDisplay().text(1)),
                                              metrics.horizontalAdvance(opacityText(group)));
    const int marks = int(marksOf(group).size()) * markStep;
    const int besidesName = percent + (marks > 0 ? marks + cellGap : 0) + 3 * cellGap;
    const int left = row.left() + std::min(name, std::max(leastName, row.width() - besidesName)) + 2 * cellGap;
    // A cell that is wider than what is left, and need not be whole, takes the rest.
    const auto take = [&](int width, int least) {
        const int taken = std::min(width, right - left);
        if (width == 0 || taken < least)
            return QRect();
        const QRect cell(right - taken, row.top(), taken, row.height());
        right -= taken + cellGap;
        return cell;
    };
    GroupCells cells;
    if (marks == 0 || right - left >= percent + cellGap + marks) // else there is room for the marks alone
        cells.opacity = take(percent, percent);
    // The mode stands between both, but gives way to the marks.
    const int mode = metrics.horizontalAdvance(nameOf(group.blend)) + roundedOff;
    const int besides = marks > 0 ? marks + cellGap : 0,
              leastOfMode = group.blend == BlendMode::Normal ? mode : std::min(mode, leastMode);
    if (right - left - besides >= leastOfMode)
        cells.mode = take(std::min(mode, right - left - besides), leastOfMode);
    cells.marks = take(marks, marks);
    return cells;
}

int leftOf(const GroupCells &cells, const QRect &row)
{
    int left = row.right() + 1;
    for (const QRect &cell : {cells.marks, cells.mode, cells.opacity})
        left = cell.isEmpty() ? left : std::min(left, cell.left() - cellGap);
    return left;
}

void paintGroupCells(QPainter &painter, const QStyleOptionViewItem &option, const Group &group, const GroupCells &cells)
{
    const bool selected = isStronglySelected(option);
    const auto colourOf = [&](bool isUsual) {
        return option.palette.color(selected  ? QPalette::HighlightedText
                                    : isUsual ? QPalette::PlaceholderText
                                              : QPalette::Text);
    };
    painter.save();
    painter.setFont(smallerFont(option.font));
    const QFontMetrics metrics = painter.fontMetrics();
    const auto write = [&](const QRect &cell, const QString &text, bool isUsual) {
        painter.setPen(colourOf(isUsual));
        painter.drawText(cell, Qt::AlignRight | Qt::AlignVCenter,
                         metrics.elidedText(text, Qt::ElideRight, cell.width()));
    };
    if (!cells.opacity.isEmpty())
        write(cells.opacity, opacityText(group), group.opacity >= 1);
    if (!cells.mode.isEmpty())
        write(cells.mode, nameOf(group.blend), group.blend == BlendMode::Normal);
    if (!cells.marks.isEmpty()) {
        QRect at(cells.marks.left(), cells.marks.center().y() - markSize / 2, markSize, markSize);
        for (const QString &mark : marksOf(group)) {
            icon(mark).paint(&painter, at, Qt::AlignCenter, selected ? QIcon::Selected : QIcon::Normal);
            at.translate(markStep, 0);
        }
    }
    if (group.tag != GroupTag::None) // a strip before the row
        painter.fillRect(QRect(option.rect.left(), option.rect.top() + 2, 3, option.rect.height() - 4),
                         suffuse::colourOf(group.tag));
    painter.restore();
}

} // namespace suffuse

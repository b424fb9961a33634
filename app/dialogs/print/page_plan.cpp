#include "app/dialogs/print/page_plan.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr double cutSlack = 0.01;                ///< mm that nobody sees
constexpr double point = 72 / millimetresOfInch; ///< of paper, in a millimetre

int dotsIn(double millimetres, double dpi)
{
    return int(std::lround(millimetres / millimetresOfInch * dpi));
}

/// Files and printers count whole points: no strip beside the picture stays empty.
QPageSize sheetPaper(const QSizeF &sheet)
{
    const auto points = [](double side) { return std::max(1, int(std::floor(side * point + 1e-6))); };
    return QPageSize(QSize(points(sheet.width()), points(sheet.height())), QString(), QPageSize::ExactMatch);
}

} // namespace

bool PagePlan::isCut() const
{
    return !room.adjusted(-cutSlack, -cutSlack, cutSlack, cutSlack).contains(picture);
}

PixelRect PagePlan::dots(double dpi) const
{
    if (isEmpty())
        return {};
    const QRectF seen = picture.intersected(room);
    const int left = dotsIn(seen.left(), dpi), top = dotsIn(seen.top(), dpi);
    return {left, top, std::max(1, dotsIn(seen.right(), dpi) - left), std::max(1, dotsIn(seen.bottom(), dpi) - top)};
}

View PagePlan::view(double dpi) const
{
    const PixelRect seen = dots(dpi);
    const double unit = picture.width() / area.width(); // mm
    const auto canvas = [&](double dot, double from) { return (dot / dpi * millimetresOfInch - from) / unit; };
    View view;
    view.scale = dpi / millimetresOfInch * unit;
    view.width = seen.width;
    view.height = seen.height;
    view.centre = {area.left + canvas(seen.x + 0.5 * seen.width, picture.left()),
                   area.top + canvas(seen.y + 0.5 * seen.height, picture.top())};
    return view;
}

QSize PagePlan::sheet(double dpi) const
{
    return {std::max(1, dotsIn(paper.width(), dpi)), std::max(1, dotsIn(paper.height(), dpi))};
}

QPageSize paperOf(const QString &name)
{
    for (int id = 0; id <= int(QPageSize::LastPageSize); ++id)
        if (QPageSize::key(QPageSize::PageSizeId(id)) == name && QPageSize::PageSizeId(id) != QPageSize::Custom)
            return QPageSize(QPageSize::PageSizeId(id));
    return QPageSize(QPageSize::A4);
}

QPageLayout layoutOf(const PrintSetup &setup, const QSizeF &sheet)
{
    const auto &[left, top, right, bottom] = setup.margins;
    const bool isOwn = setup.isOnOwnSheet() && !sheet.isEmpty();
    const QPageSize paper = isOwn ? sheetPaper(sheet) : paperOf(setup.paper);
    return {paper, setup.landscape && !isOwn ? QPageLayout::Landscape : QPageLayout::Portrait,
            QMarginsF(left, top, right, bottom), QPageLayout::Millimeter};
}

PagePlan planOf(const PrintSetup &setup, const Rect &area, double resolution, const QSizeF &sheet)
{
    PagePlan plan;
    plan.area = area;
    if (setup.isOnOwnSheet() && !sheet.isEmpty()) {
        plan.paper = sheet;
    } else {
        plan.paper = QSizeF(paperOf(setup.paper).sizePoints()) / point; // as files and printers count it
        if (setup.landscape)
            plan.paper.transpose();
    }
    const auto &[left, top, right, bottom] = setup.margins;
    plan.room = QRectF(left, top, std::max(0.0, plan.paper.width() - left - right),
                       std::max(0.0, plan.paper.height() - top - bottom));
    if (area.isEmpty() || !(area.width() > 0 && area.height() > 0))
        return plan;
    double unit = millimetresOfInch / resolution;
    if (setup.size == PrintSetup::Size::Scaled)
        unit *= setup.scale / 100;
    if (setup.size == PrintSetup::Size::FitPage)
        unit = std::min(plan.room.width() / area.width(), plan.room.height() / area.height());
    const QSizeF size(unit * area.width(), unit * area.height());
    plan.picture = QRectF(plan.room.center() - QPointF(0.5 * size.width(), 0.5 * size.height()), size);
    return plan;
}

} // namespace suffuse

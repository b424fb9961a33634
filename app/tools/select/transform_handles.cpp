#include "app/tools/select/transform_handles.h"

#include "app/canvas/view_transform.h"

#include <numbers>

namespace suffuse {

namespace {

using Kind = TransformHandle::Kind;

constexpr double standOff = 11;      ///< logical pixels between the box and the middle of a handle
constexpr double hitRadius = 9;      ///< logical pixels
constexpr double roomForMiddle = 34; ///< logical pixels that a side needs to have a handle in its middle
constexpr double turnAngleStep = std::numbers::pi / 12;

Point unit(Point v)
{
    const double l = length(v);
    return l > 0 ? (1 / l) * v : Point{};
}

/// A straight double arrow along x, 16 logical pixels long.
QPainterPath straightArrow()
{
    QPainterPath path;
    path.addPolygon(QPolygonF({{-8, 0},
                               {-3.5, -4},
                               {-3.5, -1.4},
                               {3.5, -1.4},
                               {3.5, -4},
                               {8, 0},
                               {3.5, 4},
                               {3.5, 1.4},
                               {-3.5, 1.4},
                               {-3.5, 4}}));
    path.closeSubpath();
    return path;
}

/// A double arrow that is bent around a corner towards −x.
QPainterPath bentArrow()
{
    QPainterPath bend;
    bend.moveTo(-3.5, -5.5);
    bend.quadTo(4.5, 0, -3.5, 5.5);
    QPainterPathStroker stroker;
    stroker.setWidth(2.8);
    QPainterPath path = stroker.createStroke(bend);
    QPainterPath head;
    head.addPolygon(QPolygonF({{-7.5, -8}, {-0.8, -8.6}, {-3.6, -2.4}}));
    head.closeSubpath();
    head.addPolygon(QPolygonF({{-7.5, 8}, {-0.8, 8.6}, {-3.6, 2.4}}));
    head.closeSubpath();
    head.setFillRule(Qt::WindingFill);
    return path.united(head);
}

QPainterPath centreMark()
{
    QPainterPath path;
    path.moveTo(-6, 0);
    path.lineTo(6, 0);
    path.moveTo(0, -6);
    path.lineTo(0, 6);
    path.addEllipse(QPointF(), 2.5, 2.5);
    return path;
}

const QColor lightGap(255, 255, 255, 120); ///< between dashes, so that the line is seen on any paint

/// Fills of an upright line, to be repeated along it: a dash and a gap.
QImage dashAndGap(const QColor &dash, int width, bool across)
{
    const int dashLength = 4 * width, length = 6 * width;
    QImage image(across ? QSize(length, 1) : QSize(1, length), QImage::Format_ARGB32_Premultiplied);
    image.fill(lightGap);
    QPainter(&image).fillRect(0, 0, across ? dashLength : 1, across ? 1 : dashLength, dash);
    return image;
}

/// Draws a side of the box in dashes. An upright one is a rectangle, which takes a tenth of the time of a line.
void paintSide(QPainter &painter, const QLineF &side, const QColor &colour, double dpr)
{
    constexpr double straight = 1e-6;
    constexpr int piece = 64; // A painter hands more rows than these to other threads, and waking them takes longer.
    const int width = std::max(1, int(std::lround(dpr)));
    const QRectF between = QRectF(side.p1(), side.p2()).normalized();
    const QRect upright((between.topLeft() - QPointF(0.5 * width, 0.5 * width)).toPoint(),
                        between.size().toSize() + QSize(width, width));
    if (between.height() < straight) {
        painter.fillRect(upright, dashAndGap(colour, width, true));
    } else if (between.width() < straight) {
        const QBrush brush = dashAndGap(colour, width, false);
        for (int y = upright.top(); y <= upright.bottom(); y += piece)
            painter.fillRect(upright & QRect(upright.left(), y, width, piece), brush);
    } else {
        painter.setPen(QPen(lightGap, dpr));
        painter.drawLine(side);
        painter.setPen(QPen(colour, dpr, Qt::DashLine));
        painter.drawLine(side);
    }
}

} // namespace

void TransformHandles::setBox(const Rect &box)
{
    m_box = box;
}

Point TransformHandles::centre() const
{
    return {m_box.left + m_centre.x * m_box.width(), m_box.top + m_centre.y * m_box.height()};
}

void TransformHandles::setCentre(Point centre)
{
    const auto share = [](double v, double from, double size) { return size > 0 ? (v - from) / size : 0.5; };
    m_centre = {share(centre.x, m_box.left, m_box.width()), share(centre.y, m_box.top, m_box.height())};
}

Point TransformHandles::anchor(const TransformHandle &handle) const
{
    if (handle.kind == Kind::Centre)
        return centre();
    const auto at = [](int side, double low, double high) { return 0.5 * ((1 - side) * low + (1 + side) * high); };
    return {at(handle.x, m_box.left, m_box.right), at(handle.y, m_box.top, m_box.bottom)};
}

std::vector<TransformHandle> TransformHandles::handles(const View &view, double dpr) const
{
    std::vector<TransformHandle> list;
    if (m_box.isEmpty() || (m_box.width() == 0 && m_box.height() == 0))
        return list;
    const bool wide = m_box.width() * view.scale > roomForMiddle * dpr;
    const bool high = m_box.height() * view.scale > roomForMiddle * dpr;
    if (m_mode == Mode::Turn)
        list.push_back({Kind::Centre, 0, 0});
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            const bool corner = x != 0 && y != 0;
            const bool middle = (x == 0) != (y == 0) && (x == 0 ? wide : high);
            // A side that has no length cannot be scaled along it.
            const bool flat = (x != 0 && m_box.width() == 0) || (y != 0 && m_box.height() == 0);
            if (!corner && (!middle || flat))
                continue;
            if (m_mode == Mode::Scale)
                list.push_back({Kind::Scale, x, y});
            else
                list.push_back({corner ? Kind::Rotate : Kind::Skew, x, y});
        }
    return list;
}

Point TransformHandles::place(const TransformHandle &handle, const View &view, double dpr) const
{
    const Point at = view.toPixels(anchor(handle));
    if (handle.kind == Kind::Centre)
        return at;
    const Point origin = view.toPixels({0, 0});
    const Point right = unit(view.toPixels({1 / view.scale, 0}) - origin);
    const Point down = unit(view.toPixels({0, 1 / view.scale}) - origin);
    return at + standOff * dpr * (double(handle.x) * right + double(handle.y) * down);
}

std::optional<TransformHandle> TransformHandles::at(Point pixel, const View &view, double dpr) const
{
    std::optional<TransformHandle> nearest;
    double least = hitRadius * dpr;
    for (const TransformHandle &handle : handles(view, dpr)) {
        const double distance = length(place(handle, view, dpr) - pixel);
        if (distance <= least) {
            least = distance;
            nearest = handle;
        }
    }
    return nearest;
}

Point TransformHandles::fixedPoint(const TransformHandle &handle, bool atCentre) const
{
    return atCentre ? centre() : anchor({handle.kind, -handle.x, -handle.y});
}

Affine TransformHandles::map(const TransformHandle &handle, Point from, Point to, Qt::KeyboardModifiers modifiers) const
{
    switch (handle.kind) {
    case Kind::Scale:
        return scaling(handle, to - from, modifiers);
    case Kind::Rotate:
        return rotation(handle, from, to, modifiers);
    case Kind::Skew:
        return skewing(handle, to - from, modifiers);
    case Kind::Centre:
        break;
    }
    return {};
}

Affine TransformHandles::scaling(const TransformHandle &handle, Point by, Qt::KeyboardModifiers modifiers) const
{
    const Point fixed = fixedPoint(handle, modifiers & Qt::ShiftModifier);
    const Point before = anchor(handle) - fixed, after = before + by;
    const auto ratio = [](int side, double b, double a) { return side != 0 && b != 0 ? a / b : 1; };
    double kx = ratio(handle.x, before.x, after.x), ky = ratio(handle.y, before.y, after.y);
    // Both axes get one scale, and are mirrored only across the sides that the pointer has passed.
    if (modifiers & Qt::ControlModifier) {
        const Point size{std::abs(before.x), std::abs(before.y)};
        const double k = handle.x != 0 && handle.y != 0 && dot(before, before) > 0
                             ? (std::abs(after.x) * size.x + std::abs(after.y) * size.y) / dot(before, before)
                             : std::abs(handle.x != 0 ? kx : ky);
        kx = std::copysign(k, kx);
        ky = std::copysign(k, ky);
    }
    return Affine::scaling(fixed, kx, ky);
}

Affine TransformHandles::rotation(const TransformHandle &handle, Point from, Point to,
                                  Qt::KeyboardModifiers modifiers) const
{
    const Point fixed = fixedPoint(handle, !(modifiers & Qt::ShiftModifier));
    const Point a = from - fixed, b = to - fixed;
    double angle = std::atan2(cross(a, b), dot(a, b));
    if (modifiers & Qt::ControlModifier)
        angle = turnAngleStep * std::round(angle / turnAngleStep);
    return Affine::rotation(fixed, angle);
}

Affine TransformHandles::skewing(const TransformHandle &handle, Point by, Qt::KeyboardModifiers modifiers) const
{
    const Point fixed = fixedPoint(handle, !(modifiers & Qt::ShiftModifier));
    const Point arm = anchor(handle) - fixed;
    const bool alongX = handle.y != 0;
    const double lever = alongX ? arm.y : arm.x;
    if (lever == 0)
        return {};
    double k = (alongX ? by.x : by.y) / lever;
    if (modifiers & Qt::ControlModifier)
        k = std::tan(std::clamp(turnAngleStep * std::round(std::atan(k) / turnAngleStep), -5 * turnAngleStep,
                                5 * turnAngleStep));
    return Affine::skew(fixed, alongX ? k : 0, alongX ? 0 : k);
}

void TransformHandles::paint(QPainter &painter, const View &view, double dpr, const QColor &accent,
                             const std::optional<TransformHandle> &hovered) const
{
    const std::vector<TransformHandle> list = handles(view, dpr);
    if (list.empty())
        return;
    const Rect window = Rect::of(0, 0, view.width, view.height).grown(8);
    const QPolygonF corners = clippedCorners(view, m_box, window);
    QColor quiet = accent;
    quiet.setAlpha(190);
    for (qsizetype i = 0; i < corners.size(); ++i)
        paintSide(painter, {corners[i], corners[(i + 1) % corners.size()]}, quiet, dpr);
    for (const TransformHandle &handle : list)
        paintHandle(painter, handle, view, dpr, hovered == handle ? accent : QColor(40, 44, 52));
}

void TransformHandles::paintHandle(QPainter &painter, const TransformHandle &handle, const View &view, double dpr,
                                   const QColor &fill) const
{
    static const QPainterPath straight = straightArrow(), bent = bentArrow(), mark = centreMark();
    const Point p = place(handle, view, dpr);
    painter.save();
    painter.translate(p.x, p.y);
    painter.scale(dpr, dpr);
    if (handle.kind == Kind::Centre) {
        strokeTwoTone(painter, mark, fill, 1.3);
    } else {
        // Arrows point away from the box or, for skewing, lie across that direction.
        const Point out = p - view.toPixels(anchor(handle));
        const double across = handle.kind == Kind::Skew ? 90 : 0;
        painter.rotate(std::atan2(out.y, out.x) * 180 / std::numbers::pi + across);
        const QPainterPath &arrow = handle.kind == Kind::Rotate ? bent : straight;
        painter.setPen(QPen(QColor(255, 255, 255, 230), 2.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(arrow);
        painter.fillPath(arrow, fill);
    }
    painter.restore();
}

} // namespace suffuse

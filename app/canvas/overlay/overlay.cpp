#include "app/canvas/overlay/overlay.h"

#include "app/canvas/view_transform.h"

#include <QFontInfo>
#include <QGuiApplication>
#include <QLocale>

#include <array>
#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

constexpr double flatness = 0.3;
constexpr int maxDepth = 40;
constexpr double beyond = 64; ///< Device pixels beyond the window's border through which a line may still run.

Rect canvasWindowOf(const View &view)
{
    return Rect::of(0, 0, view.width, view.height).grown(beyond);
}

bool isFlat(const Cubic &c)
{
    const Point chord = c.p[3] - c.p[0];
    const double l = length(chord);
    const auto off = [&](Point q) {
        const Point d = q - c.p[0];
        return l > 0 ? std::max(std::abs(cross(chord, d)) / l, std::max(-dot(chord, d) / l, dot(chord, d) / l - l))
                     : length(d);
    };
    return std::max(off(c.p[1]), off(c.p[2])) < flatness;
}

void addLine(QPainterPath &path, Point a, Point b, const Rect &window)
{
    if (!clipLine(a, b, window))
        return;
    const QPointF from(a.x, a.y);
    if (path.elementCount() == 0 || path.currentPosition() != from)
        path.moveTo(from);
    path.lineTo(QPointF(b.x, b.y));
}

void flatten(QPainterPath &path, const Cubic &c, const Rect &window, int depth)
{
    if (!c.controlBox().intersects(window))
        return;
    if (depth == 0 || isFlat(c)) {
        addLine(path, c.p[0], c.p[3], window);
        return;
    }
    const auto [left, right] = c.split(0.5);
    flatten(path, left, window, depth - 1);
    flatten(path, right, window, depth - 1);
}

} // namespace

void addCurve(QPainterPath &path, const Cubic &cubic, const View &view)
{
    Cubic pixels;
    for (int i = 0; i < 4; ++i)
        pixels.p[i] = view.toPixels(cubic.p[i]);
    flatten(path, pixels, canvasWindowOf(view), maxDepth);
}

void paintNode(QPainter &painter, Point p, const OverlayColours &colours, double dpr)
{
    const double r = 3.0 * dpr;
    painter.setPen(QPen(colours.accent, 1.2 * dpr));
    painter.setBrush(Qt::white);
    painter.drawEllipse(QPointF(p.x, p.y), r, r);
    painter.setBrush(Qt::NoBrush);
}

QString angleText(double angle)
{
    double degrees = std::remainder(angle * 180 / std::numbers::pi, 360);
    if (std::abs(degrees) < 0.05)
        degrees = 0; // An angle of zero has no minus sign.
    return QLocale().toString(degrees, 'f', 1).replace('-', QChar(0x2212)) + QChar(0xB0);
}

namespace {

constexpr double platePad = 6; ///< logical pixels beside a text on its plate

/// The system's font at its size, since painters here work in device pixels.
void setPlateFont(QPainter &painter, double dpr)
{
    QFont font = QGuiApplication::font();
    font.setPixelSize(qRound(QFontInfo(font).pixelSize() * dpr));
    painter.setFont(font);
}

/// The size of the plate of a text in the painter's font.
QSizeF plateSize(const QPainter &painter, const QString &text, double dpr)
{
    const QFontMetricsF metrics(painter.font());
    return {metrics.horizontalAdvance(text) + 2 * platePad * dpr, metrics.height() + platePad * dpr};
}

void drawOnPlate(QPainter &painter, const QString &text, const QRectF &box, double dpr)
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 20, 24));
    painter.drawRoundedRect(box, 4 * dpr, 4 * dpr);
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, text);
}

} // namespace

void paintPlate(QPainter &painter, const QString &text, Point top, double widest, double dpr)
{
    painter.save();
    setPlateFont(painter, dpr);
    const QString shown = QFontMetricsF(painter.font()).elidedText(text, Qt::ElideRight, widest - 2 * platePad * dpr);
    const QSizeF size = plateSize(painter, shown, dpr);
    drawOnPlate(painter, shown, QRectF(QPointF(top.x - size.width() / 2, top.y), size), dpr);
    painter.restore();
}

void paintBadge(QPainter &painter, const QString &text, Point pixel, double radius, const View &view, double dpr)
{
    painter.save();
    setPlateFont(painter, dpr);
    const double gap = 18 * dpr;
    const QSizeF size = plateSize(painter, text, dpr);
    // The badge stands below the pointer on the right or, where there is no room, elsewhere beside the circle.
    const double off = std::max(gap, std::sqrt(0.5) * radius + 4 * dpr);
    const QRectF window(0, 0, view.width, view.height);
    QRectF box;
    for (const Point side : {Point{1, 1}, Point{-1, 1}, Point{1, -1}, Point{-1, -1}}) {
        const QPointF corner(pixel.x + side.x * off, pixel.y + side.y * off);
        const QRectF there(corner, QPointF(corner.x() + side.x * size.width(), corner.y() + side.y * size.height()));
        box = box.isNull() || !window.contains(box) ? there.normalized() : box;
    }
    if (!window.contains(box)) // The circle fills the window, so the badge cannot stand beside it.
        box = QRectF(QPointF(pixel.x + gap, pixel.y + gap), size);
    box.moveLeft(std::clamp(box.left(), 0.0, std::max(0.0, view.width - size.width())));
    box.moveTop(std::clamp(box.top(), 0.0, std::max(0.0, view.height - size.height())));
    drawOnPlate(painter, text, box, dpr);
    painter.restore();
}

namespace {

/// The pens of a line in two tones, in the order in which they paint: its rim and its core.
std::array<QPen, 2> twoTonePens(const QColor &colour, double width, Qt::PenStyle style, double weight)
{
    QColor core = colour, rim(255, 255, 255, 235);
    core.setAlphaF(float(colour.alphaF() * weight));
    rim.setAlphaF(float(rim.alphaF() * std::pow(weight, 1.5)));
    return {QPen(rim, width * 2.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin),
            QPen(core, width, style, Qt::SquareCap, Qt::RoundJoin)};
}

} // namespace

void strokeTwoTone(QPainter &painter, const QPainterPath &path, const QColor &colour, double width, Qt::PenStyle style,
                   double weight)
{
    painter.setBrush(Qt::NoBrush);
    for (const QPen &pen : twoTonePens(colour, width, style, weight)) {
        painter.setPen(pen);
        painter.drawPath(path);
    }
}

void strokeTwoTone(QPainter &painter, const QList<QLineF> &lines, const QColor &colour, double width, double weight)
{
    for (QPen pen : twoTonePens(colour, width, Qt::SolidLine, weight)) {
        pen.setCapStyle(Qt::FlatCap); // Qt takes four times as long for round ones.
        painter.setPen(pen);
        for (const QLineF &line : lines) // Of all at once it finds where they cross each other.
            painter.drawLine(line);
    }
}

namespace {

constexpr int shadowRings = 5;
// the colour of one ring; the rings lie over each other, so the shadow gets darker towards the canvas
const QColor shadow(0, 0, 0, 11);

/// Around an upright sheet the pasteboard consists of rectangles, which take a tenth of the time of paths.
void paintUprightPasteboard(QPainter &painter, const QRect &window, const QRectF &sheet, const OverlayColours &colours,
                            double dpr)
{
    // A painter hands more rows than these to other threads at a time, and waking them takes longer than filling.
    constexpr int rows = 64;
    const auto fill = [&](const QRegion &region, const QColor &colour) {
        for (const QRect &rect : region)
            for (int y = rect.top(); y <= rect.bottom(); y += rows)
                painter.fillRect(rect & QRect(rect.left(), y, rect.width(), rows), colour);
    };
    const QRect inside(QPoint(int(std::lround(sheet.left())), int(std::lround(sheet.top()))),
                       QPoint(int(std::lround(sheet.right())) - 1, int(std::lround(sheet.bottom())) - 1));
    // Large fills take long even where they are clipped.
    const QRect seen = painter.hasClipping() ? window & painter.clipBoundingRect().toAlignedRect() : window;
    const QRegion outside = QRegion(seen) - inside;
    fill(outside, colours.pasteboard);
    for (int ring = shadowRings; ring >= 1; --ring) {
        const int r = int(std::lround(ring * dpr));
        const QRect wide = inside.translated(0, int(std::lround(dpr))).adjusted(-r, -r, r, r);
        fill(outside & wide, shadow);
    }
    const int d = std::max(1, int(std::lround(dpr)));
    const QRect border = inside.adjusted(-(d / 2), -(d / 2), d - d / 2, d - d / 2);
    fill(QRegion(border & seen) - border.adjusted(d, d, -d, -d), colours.border);
}

bool isUpright(const QPolygonF &polygon)
{
    bool upright = polygon.size() == 4;
    for (int i = 0; upright && i < 4; ++i) {
        const QPointF side = polygon[(i + 1) % 4] - polygon[i];
        upright = std::min(std::abs(side.x()), std::abs(side.y())) < 1e-6;
    }
    return upright;
}

} // namespace

void paintPasteboard(QPainter &painter, const View &view, const Rect &canvas, const OverlayColours &colours, double dpr)
{
    constexpr double fade = 12; // logical pixels for border and shadow
    const Rect window = canvasWindowOf(view);
    const QPolygonF inside = clippedCorners(view, canvas, window);
    const double f = fade * dpr;
    if (painter.hasClipping() && inside.size() > 2) {
        QPainterPath deep; // the sheet, inside which nothing of the pasteboard is seen
        deep.addPolygon(inside);
        if (deep.contains(painter.clipBoundingRect().adjusted(-f, -f, f, f)))
            return;
    }
    const QRectF windowRect(QPointF(window.left, window.top), QPointF(window.right, window.bottom));
    if (isUpright(inside)) {
        paintUprightPasteboard(painter, windowRect.toAlignedRect(), inside.boundingRect(), colours, dpr);
        return;
    }
    QPainterPath outside;
    outside.setFillRule(Qt::OddEvenFill);
    outside.addRect(windowRect);
    QPainterPath sheet;
    if (inside.size() > 2) {
        sheet.addPolygon(inside);
        sheet.closeSubpath();
        outside.addPath(sheet);
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillPath(outside, colours.pasteboard);
    if (sheet.isEmpty())
        return;
    painter.save();
    painter.setClipPath(outside, Qt::IntersectClip);
    painter.setBrush(Qt::NoBrush);
    for (int ring = shadowRings; ring >= 1; --ring) { // The shadow fades within a few pixels.
        painter.setPen(QPen(shadow, 2 * ring * dpr));
        painter.drawPath(sheet.translated(0, dpr));
    }
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.border, dpr));
    painter.drawPath(sheet);
}

void paintGrid(QPainter &painter, const View &view, const Rect &area, double step, double dpr)
{
    constexpr double leastPixels = 8; // least distance of two lines, logical pixels
    constexpr double mostLines = 2000;
    while (step * view.scale < leastPixels * dpr)
        // Every fifth line is drawn, then every tenth, and so on.
        step *= step * view.scale * 5 < leastPixels * dpr ? 10 : 5;
    Rect shown;
    for (const Point corner : {Point{0, 0}, Point{double(view.width), 0}, Point{0, double(view.height)},
                               Point{double(view.width), double(view.height)}})
        shown.include(view.toCanvas(corner));
    const Rect part{std::max(shown.left, area.left), std::max(shown.top, area.top), std::min(shown.right, area.right),
                    std::min(shown.bottom, area.bottom)};
    if (part.isEmpty() || part.width() > mostLines * step || part.height() > mostLines * step)
        return;
    QList<QLineF> fine, strong;
    const auto add = [&](double line, Point a, Point b) {
        const Point p = view.toPixels(a), q = view.toPixels(b);
        (std::fmod(std::abs(line), 5) < 0.5 ? strong : fine) << QLineF(p.x, p.y, q.x, q.y);
    };
    for (double i = std::ceil(part.left / step); i * step <= part.right; ++i)
        add(i, {i * step, part.top}, {i * step, part.bottom});
    for (double i = std::ceil(part.top / step); i * step <= part.bottom; ++i)
        add(i, {part.left, i * step}, {part.right, i * step});
    painter.setPen(QPen(QColor(70, 110, 170, 46), dpr));
    painter.drawLines(fine);
    painter.setPen(QPen(QColor(70, 110, 170, 92), dpr));
    painter.drawLines(strong);
}

void paintSnapMark(QPainter &painter, Point pixel, const OverlayColours &colours, double dpr)
{
    const double r = 5 * dpr;
    QPainterPath path;
    path.moveTo(pixel.x - r, pixel.y - r);
    path.lineTo(pixel.x + r, pixel.y + r);
    path.moveTo(pixel.x - r, pixel.y + r);
    path.lineTo(pixel.x + r, pixel.y - r);
    path.addEllipse(QPointF(pixel.x, pixel.y), 1.6 * r, 1.6 * r);
    strokeTwoTone(painter, path, colours.accent, 1.3 * dpr);
}

} // namespace suffuse

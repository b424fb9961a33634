#include "app/canvas/handles/rulers.h"

#include "app/canvas/overlay/overlay.h"
#include "model/painting/resolution.h"

#include <QFontMetricsF>
#include <QLocale>

#include <cmath>
#include <limits>

namespace suffuse {

namespace {

constexpr double rulerFontPixels = 9;    ///< logical
constexpr double rulerLabelGap = 14;     ///< logical pixels between the end of a label and the next one
constexpr double leastLabelSpacing = 56; ///< logical pixels between two labels
constexpr double leastTickSpacing = 4;   ///< device pixels between two ticks, times the device pixel ratio

/// The least of 1, 2 or 5 times a power of ten that is not less.
double roundRulerStep(double least)
{
    const double power = std::pow(10, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1 - 1e-9))
            return factor * power;
    return 10 * power;
}

QString rulerLabel(double value, const RulerUnit &unit, int decimals)
{
    double shown = value / unit.units;
    if (std::abs(shown) < 0.5 * std::pow(10, -decimals))
        shown = 0; // Zero has no minus sign.
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(shown, 'f', decimals).replace('-', QChar(0x2212));
}

/// Draws one along the x axis of the painter, from 0 to `length` device pixels. The edge to the canvas lies at `width`.
/// Figures end before `end`, where the corner of both rulers lies.
void paintRuler(QPainter &painter, const RulerScale &scale, const RulerUnit &unit, double length, double end,
                double width, const QColor &ink, double dpr)
{
    const double last = scale.first + length * scale.perPixel;
    const double low = std::min(scale.first, last), high = std::max(scale.first, last);
    const auto pixelOf = [&](double value) { return (value - scale.first) / scale.perPixel; };
    QList<QLineF> ticks;
    const double perLabel = std::round(scale.step / scale.tick);
    for (double k = std::ceil(low / scale.tick); k * scale.tick <= high; ++k) {
        const double at = pixelOf(k * scale.tick);
        const bool isLong = std::fmod(std::abs(k), perLabel) < 0.5;
        ticks << QLineF(at, isLong ? 0.25 * width : 0.72 * width, at, width);
    }
    painter.setPen(QPen(ink, dpr));
    painter.drawLines(ticks);
    const QFontMetricsF metrics(painter.font());
    const double gap = 3 * dpr, step = scale.step / std::abs(scale.perPixel);
    const auto labelOf = [&](double k) { return rulerLabel(k * scale.step, unit, scale.decimals); };
    for (double k = std::ceil(low / scale.step) - 1; k * scale.step <= high; ++k) {
        const QString label = labelOf(k);
        const double tick = pixelOf(k * scale.step), wide = metrics.horizontalAdvance(label);
        double at = tick + gap;
        if (tick <= end && at + wide > end) { // It stands before its tick, where the one before leaves room.
            const double before = metrics.horizontalAdvance(labelOf(k - std::copysign(1, scale.perPixel)));
            at = wide + before + 3 * gap <= step ? tick - gap - wide : end;
        }
        if (at < end)
            painter.drawText(QPointF(at, 2 * dpr + metrics.ascent()), label);
    }
}

} // namespace

RulerUnit unitOf(RulerUnits units, double resolution)
{
    switch (units) {
    case RulerUnits::Canvas:
        break;
    case RulerUnits::Millimetres:
        return {QStringLiteral("mm"), resolution / millimetresOfInch};
    case RulerUnits::Inches:
        return {QStringLiteral("in"), resolution};
    }
    return {};
}

RulerScale rulerScale(const View &view, bool down, const RulerUnit &unit, double least)
{
    const Point along = down ? Point{0, 1} : Point{1, 0};
    const Point from = view.toCanvas({0, 0}), way = view.toCanvas(100 * along) - from;
    RulerScale scale;
    scale.countsX = std::abs(way.x) > std::abs(way.y);
    const auto part = [&](Point p) { return scale.countsX ? p.x : p.y; };
    scale.first = part(from);
    scale.perPixel = part(way) / 100;
    const double step = roundRulerStep(least * std::abs(scale.perPixel) / unit.units);
    scale.decimals = std::max(0, int(std::ceil(-std::log10(step) - 1e-9)));
    scale.step = step * unit.units;
    scale.tick = scale.step / 10;
    if (scale.tick < leastTickSpacing / 56.0 * least * std::abs(scale.perPixel))
        scale.tick = scale.step / 5;
    return scale;
}

void paintRulers(QPainter &painter, const View &view, const RulerUnit &unit, const OverlayColours &colours, double dpr)
{
    const bool isDark = colours.pasteboard.lightness() < 128;
    const QColor ground = isDark ? QColor(30, 31, 34) : QColor(240, 241, 243);
    const QColor ink = isDark ? QColor(198, 201, 206) : QColor(66, 69, 74);
    const double width = std::round(rulerWidth * dpr);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    QFont font = painter.font();
    font.setPixelSize(qRound(rulerFontPixels * dpr));
    painter.setFont(font);
    painter.fillRect(QRectF(0, 0, view.width, width), ground);
    painter.fillRect(QRectF(0, width, width, view.height - width), ground);
    for (const bool down : {false, true}) {
        // Labels are the longest at the ends of what is seen; how many digits they have depends on the step in turn.
        RulerScale scale = rulerScale(view, down, unit, leastLabelSpacing * dpr);
        const double length = down ? view.height : view.width;
        const auto longest = [&] {
            const QFontMetricsF metrics(font);
            return std::max(
                metrics.horizontalAdvance(rulerLabel(scale.first, unit, scale.decimals)),
                metrics.horizontalAdvance(rulerLabel(scale.first + length * scale.perPixel, unit, scale.decimals)));
        };
        if (const double wanted = longest() + rulerLabelGap * dpr; wanted > leastLabelSpacing * dpr)
            scale = rulerScale(view, down, unit, wanted);
        painter.save();
        painter.setClipRect(down ? QRectF(0, width, width, view.height) : QRectF(width, 0, view.width, width),
                            Qt::IntersectClip);
        if (down) { // It is read from below.
            painter.rotate(-90);
            painter.translate(-length, 0);
            scale.first += length * scale.perPixel;
            scale.perPixel = -scale.perPixel;
        }
        const double end = down ? length - width : std::numeric_limits<double>::infinity();
        paintRuler(painter, scale, unit, length, end, width, ink, dpr);
        painter.restore();
    }
    painter.setPen(QPen(colours.border, dpr));
    const double edge = width - 0.5 * dpr;
    painter.drawLine(QPointF(edge, edge), QPointF(view.width, edge));
    painter.drawLine(QPointF(edge, edge), QPointF(edge, view.height));
    painter.setPen(ink);
    if (const QString name = unit.name; !name.isEmpty()) {
        font.setPixelSize(qRound(8 * dpr));
        painter.setFont(font);
        painter.drawText(QRectF(0, 0, width, width), Qt::AlignCenter, name);
    }
    painter.restore();
}

} // namespace suffuse

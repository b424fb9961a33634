#include "app/session/fitting/fit_layer.h"

#include "app/session/editor.h"
#include "app/session/files/import_strokes.h"
#include "model/formats/messages.h"
#include "model/shaping/transform.h"
#include "undo/underlay_edits.h"

#include <QCoreApplication>

#include <algorithm>

namespace suffuse {

namespace {

struct FitLayer {
    Q_DECLARE_TR_FUNCTIONS(FitLayer)
};

constexpr GroupId wholeGroup = 1, clippedGroup = 2;

/// A sheet of one colour, which does not spread.
Stroke sheetOf(const Rect &area, const Colour &colour)
{
    constexpr float age = 1e-3f; // It does not spread, so any age will do.
    const std::array<Point, 4> corners{Point{area.left, area.top},
                                       {area.right, area.top},
                                       {area.right, area.bottom},
                                       {area.left, area.bottom}};
    Stroke sheet;
    sheet.id = 1;
    sheet.name = FitLayer::tr("Ground");
    sheet.group = wholeGroup;
    sheet.origin = corners[0];
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Point from = corners[k], to = corners[(k + 1) % corners.size()];
        Segment side;
        side.bezier = {toOffset(from, sheet.origin), toOffset(from + (1.0 / 3) * (to - from), sheet.origin),
                       toOffset(from + (2.0 / 3) * (to - from), sheet.origin), toOffset(to, sheet.origin)};
        side.density = 0; // It bounds the fill, and lays no paint.
        side.maxAge = age;
        side.node = NodeKind::Corner;
        side.colour = colour;
        sheet.segments.push_back(side);
    }
    Fill fill;
    fill.diffusion = 0;
    fill.density = 4; // far above where the style lets anything through
    fill.maxAge = age;
    fill.colour = colour;
    sheet.fill = fill;
    return sheet;
}

/// When all of a layer has dried, of which the first stroke is painted at 0, and when its last stroke begins to dry.
struct Span {
    Microseconds lastBorn = 0, end = 0;
};

Span spanOf(const Painting &layer)
{
    Span span;
    span.end = layer.end();
    for (const StrokePtr &stroke : layer.strokes)
        for (const Segment &segment : stroke->segments)
            span.lastBorn = std::max(span.lastBorn, segment.born);
    return span;
}

/// The layer as if it were painted from a moment on, `pace` times as fast, with paint that dries `drying` times as fast and
/// spreads as far.
void retime(Painting &layer, Microseconds from, double pace, double drying)
{
    StrokeList strokes;
    for (const StrokePtr &stroke : layer.strokes) {
        Stroke later = *stroke;
        for (Segment &segment : later.segments) {
            segment.born = from + Microseconds(double(segment.born) / pace);
            segment.maxAge = float(double(segment.maxAge) / drying);
            segment.diffusion = float(double(segment.diffusion) * drying);
        }
        if (later.fill) {
            Fill fill = *later.fill; // It does not spread.
            fill.born = from + Microseconds(double(fill.born) / pace);
            fill.maxAge = float(double(fill.maxAge) / drying);
            later.fill = fill;
        }
        strokes.push_back(std::make_shared<const Stroke>(std::move(later)));
    }
    layer.strokes = std::move(strokes);
}

/// When the last paint comes that is there at a moment.
Microseconds lastBornBefore(const Painting &painting, Microseconds moment)
{
    Microseconds last = 0;
    const auto take = [&](Microseconds born) {
        if (born <= moment)
            last = std::max(last, born);
    };
    for (const StrokePtr &stroke : painting.strokes) {
        for (const Segment &segment : stroke->segments)
            take(segment.born);
        if (stroke->fill)
            take(stroke->fill->born);
    }
    return last;
}

/// Makes a layer one that was painted just before a moment, after all that was painted till then, and that has dried at
/// the moment. There is as much time for it as there is.
void paintBefore(Painting &layer, const Painting &painting, Microseconds now)
{
    constexpr Microseconds least = 100'000; // Whatever came so shortly before is beside the layer.
    const Span span = spanOf(layer);
    const Microseconds room = std::min(now, std::max(now - lastBornBefore(painting, now), least));
    if (span.end <= room)
        return retime(layer, now - span.end, 1, 1);
    const auto half = double(std::max<Microseconds>(room / 2, 4));
    const double pace = std::max(1.0, double(span.lastBorn) / half);
    const double drying = std::max(1.0, double(span.end - span.lastBorn) / (half - 3)); // Ages are rounded up.
    retime(layer, now - room, pace, drying);
}

bool covers(const Rect &area, const Rect &canvas)
{
    const double slack = 1e-6 * (canvas.width() + canvas.height());
    return area.left <= canvas.left + slack && area.top <= canvas.top + slack && area.right >= canvas.right - slack &&
           area.bottom >= canvas.bottom - slack;
}

} // namespace

Rect areaForFit(const Painting &painting, QSizeF picture, bool onUnderlay)
{
    const bool hasPlace = onUnderlay && painting.underlay && !painting.underlay->area.isEmpty();
    const Rect around = hasPlace ? painting.underlay->area : painting.canvas.area();
    return picture.isEmpty() ? around : fitted(picture.width(), picture.height(), around);
}

Painting layerOfFit(const FitResult &fit, const Rect &area, const Rect &canvas)
{
    Painting layer;
    Group whole;
    whole.id = wholeGroup;
    whole.name = fit.name;
    layer.groups = {whole};
    GroupId inner = wholeGroup;
    if (!covers(area, canvas)) {
        layer.groups.front().isolated = true;
        Group clipped;
        clipped.id = clippedGroup;
        clipped.parent = wholeGroup;
        clipped.name = FitLayer::tr("Strokes");
        clipped.clips = true;
        layer.groups.push_back(clipped);
        inner = clippedGroup;
    }
    Stroke sheet = sheetOf(area, fit.painting.canvas.background);
    layer.strokes.push_back(std::make_shared<const Stroke>(std::move(sheet)));
    const Affine place = Affine::between(fit.painting.canvas.area(), area);
    for (const StrokePtr &stroke : fit.painting.strokes) {
        Stroke placed = transformed(*stroke, place, SpreadRule::Scales);
        placed.id = StrokeId(layer.strokes.size() + 1);
        placed.group = inner;
        layer.strokes.push_back(std::make_shared<const Stroke>(std::move(placed)));
    }
    layer.swatches = fit.painting.swatches;
    return layer;
}

QString insertFit(Editor &editor, const FitResult &fit, const Rect &area)
{
    const Painting &painting = *editor.document().painting();
    Painting layer = layerOfFit(fit, area, painting.canvas.area());
    Landing landing;
    landing.selects = false; // Hundreds of outlines would cover the picture that one has just made.
    const Microseconds now = editor.clock().time();
    const bool isFirst = painting.strokes.empty();
    landing.goesOn = now >= painting.end();
    if (landing.goesOn && !isFirst)
        retime(layer, now, 1, 1);
    else if (!isFirst)
        paintBefore(layer, painting, now);
    const QString said = addStrokes(editor, layer, landing, FitLayer::tr("Picture to strokes"), layer.swatches);
    return joinedSentences({FitLayer::tr("%Ln stroke(s) came in, and a ground below them.", nullptr,
                                         int(fit.painting.strokes.size())),
                            said, landing.goesOn ? QString()
                                                 : FitLayer::tr("The picture was painted quickly, just before the moment "
                                                                "that you look at. All that you painted stays as it is.")});
}

} // namespace suffuse

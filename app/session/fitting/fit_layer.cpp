#include "app/session/fitting/fit_layer.h"

#include "app/session/editor.h"
#include "app/session/files/import_strokes.h"
#include "model/shaping/transform.h"
#include "undo/underlay_edits.h"

#include <QCoreApplication>

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
    const Painting layer = layerOfFit(fit, area, editor.document().painting()->canvas.area());
    Landing landing;
    landing.selects = false; // Hundreds of outlines would cover the picture that one has just made.
    return addStrokes(editor, layer, landing, FitLayer::tr("Picture to strokes"), layer.swatches);
}

} // namespace suffuse

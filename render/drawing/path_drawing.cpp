#include "render/drawing/path_drawing.h"

#include "model/area/area_sets.h"
#include "model/formats/svg/css/css_blending.h"
#include "render/composition/washes.h"
#include "render/drawing/drawn_bounds.h"
#include "render/scene/picture.h"
#include "render/threads/parallel.h"

#include <set>

namespace suffuse {

namespace {

constexpr double closestBands = 0.15;           // canvas units
constexpr double finestShare = 1.0 / (1 << 18); // of the sheet

contours::ContourOptions contourOptions(const Painting &painting, const DrawingOptions &options)
{
    contours::ContourOptions out;
    // Small sheets are looked at from nearer.
    out.tolerance = std::min(out.tolerance, finestShare * std::max(painting.canvas.width, painting.canvas.height));
    out.eta = contours::meanOf(painting.canvas.paper);
    out.cancel = options.cancel;
    return out;
}

/// Opacity where most of a stroke is, for an outline that has one.
double meanOpacity(const contours::StrokeContours &contours)
{
    if (const std::optional<double> even = contours.field().evenOpacity())
        return *even;
    double sum = 0, weights = 0;
    for (const Segment &segment : contours.stroke().segments) {
        const double weight = segment.takesPaint() ? 0 : double(segment.density) * polygonLength(offsetsOf(segment));
        sum += weight * double(segment.colour.opacity), weights += weight;
    }
    if (weights > 0)
        return sum / weights;
    return contours.stroke().fill ? double(contours.stroke().fill->colour.opacity) : 0;
}

/// How far contours of two bands lie apart on the whole.
double distanceOf(const contours::Band &outer, const contours::Band &inner)
{
    double around = 0;
    for (const std::vector<Cubic> &loop : outer.loops)
        for (const Cubic &curve : loop)
            around += polygonLength(curve);
    return around > 0 ? (sizeOf(Area{outer.loops}) - sizeOf(Area{inner.loops})) / around : 0;
}

/// Where contours lie closer together than anyone sees at the sheet's own size, renderers that round each of many thin
/// steps would go astray. There three or five steps become one, at the place of the middle one.
void thinOut(std::vector<contours::Band> &bands)
{
    const auto isTogether = [&](std::size_t from, std::size_t count) {
        if (from + count > bands.size())
            return false;
        const bool rises = bands[from].opacity > (from > 0 ? bands[from - 1].opacity : 0);
        for (std::size_t k = from + 1; k < from + count; ++k)
            if ((bands[k].opacity > bands[k - 1].opacity) != rises)
                return false;
        const double apart = distanceOf(bands[from], bands[from + count - 1]);
        return apart >= 0 && apart < closestBands * double(count - 1);
    };
    std::vector<contours::Band> kept;
    for (std::size_t k = 0; k < bands.size();) {
        const std::size_t count = isTogether(k, 5) ? 5 : isTogether(k, 3) ? 3 : 1;
        kept.push_back({bands[k + count - 1].opacity, std::move(bands[k + count / 2].loops)});
        k += count;
    }
    bands = std::move(kept);
}

DrawnStroke drawn(const StrokePtr &stroke, const DrawingOptions &options, const contours::ContourOptions &how)
{
    const contours::StrokeContours contours(*stroke, options.time, how);
    DrawnStroke out{stroke, {}, {}, stroke->mix.mode == MixMode::Beta && stroke->mix.beta >= 0.5f};
    if (options.kind == DrawingKind::Bands) {
        out.bands = contours.bands(options.bands);
        thinOut(out.bands);
    } else if (contours::Loops loops = contours.outline(0.5); !loops.empty()) {
        out.bands.push_back({meanOpacity(contours), std::move(loops)});
    }
    if (!out.bands.empty())
        out.paint = paintOf(contours, out.bands);
    return out;
}

/// Groups around visible strokes that a drawing has nothing for.
int plainGroups(const Painting &painting, const std::vector<StrokePtr> &visible, DrawingFormat format)
{
    const auto hasMode = [&](BlendMode mode) {
        return cssOf(mode) && (mode != BlendMode::Plus || format != DrawingFormat::Pdf);
    };
    std::set<GroupId> seen;
    int plain = 0;
    for (const StrokePtr &stroke : visible)
        for (const Group *group = painting.findGroup(stroke->group); group && seen.insert(group->id).second;
             group = painting.findGroup(group->parent))
            plain += !hasMode(group->blend);
    return plain;
}

/// PDF has no mode that adds.
PaintingPtr withoutAdding(const PaintingPtr &painting)
{
    auto changed = std::make_shared<Painting>(*painting);
    for (Group &group : changed->groups)
        if (group.blend == BlendMode::Plus)
            group.blend = BlendMode::Normal;
    return changed;
}

/// Whether a stroke is painted with a picture that is missing or cannot be read: then nothing of it is seen.
bool lacksPicture(const Stroke &stroke)
{
    return stroke.picture && !pictureLevels(*stroke.picture);
}

} // namespace

bool comesTogether(const PathDrawing &drawing, const Group &group)
{
    return drawing.bounds.contains(group.id) || group.isolated || group.opacity < 1 ||
           (group.blend != BlendMode::Normal && cssOf(group.blend));
}

PathDrawing drawingOf(const PaintingPtr &painting, const DrawingOptions &options)
{
    PathDrawing out;
    Washes washes;
    out.painting = washes.drawn(withoutDrafts(painting));
    out.format = options.format;
    out.bandCount = options.bands;
    out.unpainted = options.kind == DrawingKind::Hybrid;
    const Visibility isVisible(out.painting->groups);
    std::vector<StrokePtr> visible;
    for (const StrokePtr &stroke : out.painting->strokes)
        if (isVisible(*stroke))
            visible.push_back(stroke);
    if (!out.unpainted)
        out.plain = plainGroups(*out.painting, visible, out.format);
    if (out.format == DrawingFormat::Pdf)
        out.painting = withoutAdding(out.painting);
    const contours::ContourOptions how = contourOptions(*out.painting, options);
    std::vector<DrawnStroke> strokes(visible.size());
    std::atomic<int> done = 0;
    parallelFor(visible.size(), options.threads, [&](std::size_t i) {
        if (options.cancel && options.cancel->load(std::memory_order_relaxed))
            return;
        if (!lacksPicture(*visible[i]))
            strokes[i] = drawn(visible[i], options, how);
        if (const int now = ++done; options.progress)
            options.progress(now, int(visible.size()));
    });
    out.thin = int(std::ranges::count_if(strokes, [](const DrawnStroke &s) { return s.stroke && s.bands.empty(); }));
    if (!out.unpainted)
        takeBounds(out, strokes);
    std::erase_if(strokes, [](const DrawnStroke &stroke) { return stroke.bands.empty(); });
    out.strokes = std::move(strokes);
    return out;
}

} // namespace suffuse

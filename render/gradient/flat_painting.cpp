#include "render/gradient/flat_painting.h"

#include "render/math/paper.h"
#include "render/nodes/node_builder.h"
#include "render/scene/paper.h"

namespace suffuse::gradient {

namespace {

/// Returns why a stroke's picture has no gradient, or an empty text.
QString obstacleOf(const Painting &painting, const Stroke &stroke)
{
    for (const Group *group = painting.findGroup(stroke.group); group; group = painting.findGroup(group->parent))
        if (group->isIsolated() || group->wash)
            return QStringLiteral("it is in a group that is a layer of its own. Take it out of the group");
    if (stroke.picture)
        return QStringLiteral("it is painted with a picture. Remove the picture");
    if (stroke.fill)
        return QStringLiteral("it has a fill. Remove the fill");
    if (stroke.hasLift() && stroke.style.kind == StyleKind::Edge)
        return QStringLiteral("paint is taken away from it, and its edge is darkened. Choose another style");
    return {};
}

QString obstacleOf(const Stroke &stroke, const Segment &segment, Microseconds time, double scale)
{
    if (segment.style && *segment.style != stroke.style)
        return QStringLiteral("its style varies along it. Remove the styles of its segments");
    if (!segment.isIsotropic())
        return QStringLiteral("it spreads more along a direction. Set the ratio of its anisotropy to 1");
    const double finest = segment.lift ? liftFineness : 1, least = finest / scale, spread = segment.spread(time);
    if (spread < least && segment.density > 0)
        return QStringLiteral("it has a spread of %1 units, and %2 are the least at this zoom. Zoom in")
            .arg(spread)
            .arg(least);
    return {};
}

SegmentNumbers numbersOf(const Stroke &stroke, const Segment &segment, Microseconds time)
{
    SegmentNumbers out;
    const Cubic curve = stroke.cubicOf(segment);
    for (std::size_t i = 0; i < 4; ++i)
        out.x[i] = curve.p[i].x, out.y[i] = curve.p[i].y;
    out.density = double(segment.density);
    out.spread = segment.spread(time);
    const Colour &c = segment.colour;
    out.colour[0] = double(c.red), out.colour[1] = double(c.yellow), out.colour[2] = double(c.blue);
    out.opacity = double(c.opacity);
    out.granulation = double(segment.granulation);
    return out;
}

/// η of each pixel, or null where there is no paper.
Result<std::shared_ptr<const std::vector<float>>> paperOf(const Paper &paper, const View &view, const Threads &threads)
{
    if (paper.kind == PaperKind::None || paper.strength == 0)
        return std::shared_ptr<const std::vector<float>>();
    const auto texture = paperTexture(paper);
    if (!texture)
        return Error{texture.error()};
    auto eta = std::make_shared<std::vector<float>>(std::size_t(view.width) * std::size_t(view.height));
    parallelFor(std::size_t(view.height), threads, [&](std::size_t y) {
        for (int x = 0; x < view.width; ++x) {
            const Point at = view.toCanvas({x + 0.5, double(y) + 0.5});
            const auto scale = double(paper.scale), strength = double(paper.strength);
            const double value = paper.kind == PaperKind::Image
                                     ? math::imagePaper(at.x, at.y, (*texture)->grey.data(), (*texture)->width,
                                                        (*texture)->height, scale, strength)
                                     : math::proceduralPaper(at.x, at.y, view.px(), std::int32_t(paper.grain),
                                                             paper.seed, scale, strength);
            (*eta)[y * std::size_t(view.width) + std::size_t(x)] = float(value);
        }
    });
    return std::shared_ptr<const std::vector<float>>(std::move(eta));
}

/// Adds a stroke, if any of it is there at the time. Returns what is in the way.
QString addStroke(const Painting &painting, std::size_t place, Microseconds time, FlatPainting &out)
{
    const Stroke &stroke = *painting.strokes[place];
    if (QString obstacle = obstacleOf(painting, stroke); !obstacle.isEmpty())
        return obstacle;
    FlatScene &scene = out.scene;
    FlatStroke flat;
    flat.first = std::uint32_t(scene.segments.size());
    flat.kind = stroke.style.kind;
    for (std::size_t i = 0; i < 3; ++i)
        flat.xi[i] = double(stroke.style.xi[i]);
    flat.keep = stroke.mix.mode == MixMode::Beta ? 1 - double(stroke.mix.beta) : 1;
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const Segment &segment = stroke.segments[k];
        if (segment.spread(time) <= 0)
            continue;
        if (QString obstacle = obstacleOf(stroke, segment, time, scene.view.scale); !obstacle.isEmpty())
            return obstacle;
        scene.segments.push_back(numbersOf(stroke, segment, time));
        scene.marks.push_back({stroke.beginsChain(k), segment.lift});
        out.segments.push_back(k);
    }
    flat.count = std::uint32_t(scene.segments.size()) - flat.first;
    if (flat.count == 0)
        return {};
    scene.strokes.push_back(flat);
    out.strokes.push_back(place);
    return {};
}

} // namespace

Result<FlatPainting> flatten(const Painting &painting, Microseconds time, const View &view, const Threads &threads)
{
    FlatPainting out;
    out.scene.view = view;
    const Colour &ground = painting.canvas.background;
    const double opacity = double(ground.opacity); // on white, which is 0
    out.scene.background[0] = opacity * double(ground.red);
    out.scene.background[1] = opacity * double(ground.yellow);
    out.scene.background[2] = opacity * double(ground.blue);
    auto paper = paperOf(painting.canvas.paper, view, threads);
    if (!paper)
        return Error{paper.error()};
    out.scene.paper = std::move(*paper);
    const Visibility isVisible(painting.groups);
    for (std::size_t i = 0; i < painting.strokes.size(); ++i) {
        if (!isVisible(*painting.strokes[i]))
            continue;
        if (const QString obstacle = addStroke(painting, i, time, out); !obstacle.isEmpty())
            return Error{QStringLiteral("stroke %1: its picture has no gradient, since %2.")
                             .arg(painting.strokes[i]->id)
                             .arg(obstacle)};
    }
    return out;
}

} // namespace suffuse::gradient

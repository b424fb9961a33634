#include "render/gradient/flat_painting.h"

#include "render/gradient/outline_rule.h"
#include "render/math/paper.h"
#include "render/nodes/segment_nodes.h"
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
    const bool lifts = std::ranges::any_of(stroke.segments, &Segment::lift);
    if (lifts && stroke.style.kind == StyleKind::Edge)
        return QStringLiteral("paint is taken away from it, and its edge is darkened. Choose another style");
    return {};
}

QString obstacleOf(const Stroke &stroke, const Segment &segment, Microseconds time, double scale)
{
    if (!segment.takesPaint() && segment.style && *segment.style != stroke.style)
        return QStringLiteral("its style varies along it. Remove the styles of its segments");
    if (!segment.isIsotropic())
        return QStringLiteral("it spreads more along a direction. Set the ratio of its anisotropy to 1");
    const double finest = segment.lift ? liftFineness : segment.fade ? fadeFineness : 1;
    const double least = finest / scale, spread = segment.spread(time);
    if (spread < least && segment.density > 0)
        return QStringLiteral("it has a spread of %1 units, and %2 are the least at this zoom. Zoom in")
            .arg(spread)
            .arg(least);
    return {};
}

QString obstacleOf(const Fill &fill, Microseconds time, double scale)
{
    if (!fill.isIsotropic())
        return QStringLiteral("its fill spreads more along a direction. Set the ratio of its anisotropy to 1");
    if (fill.gradient)
        return QStringLiteral("the colour of its fill changes. Give it one colour");
    if (fill.spread(time) < 1 / scale)
        return QStringLiteral("its fill has a spread of %1 units, and %2 are the least at this zoom. Zoom in")
            .arg(fill.spread(time))
            .arg(1 / scale);
    return {};
}

void setColour(const Colour &c, double (&colour)[3], double &opacity)
{
    colour[0] = double(c.red), colour[1] = double(c.yellow), colour[2] = double(c.blue);
    opacity = double(c.opacity);
}

FillNumbers numbersOf(const Fill &fill, Microseconds time)
{
    FillNumbers out;
    out.density = double(fill.density);
    out.spread = fill.spread(time);
    setColour(fill.colour, out.colour, out.opacity);
    out.granulation = double(fill.granulation);
    return out;
}

SegmentNumbers numbersOf(const Stroke &stroke, const Segment &segment, Microseconds time)
{
    SegmentNumbers out;
    const Cubic curve = stroke.cubicOf(segment);
    for (std::size_t i = 0; i < 4; ++i)
        out.x[i] = curve.p[i].x, out.y[i] = curve.p[i].y;
    out.spread = segment.spread(time);
    out.density = out.spread > 0 ? double(segment.density) : 0;
    setColour(segment.colour, out.colour, out.opacity);
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

/// Whether the outline of the last stroke crosses itself.
bool outlineCrosses(const FlatScene &scene)
{
    FlatScene alone;
    const FlatStroke &stroke = scene.strokes.back();
    alone.segments.assign(scene.segments.begin() + stroke.first, scene.segments.end());
    alone.marks.assign(scene.marks.begin() + stroke.first, scene.marks.end());
    alone.strokes = {stroke};
    alone.strokes[0].first = 0;
    const OutlineRules rules = chooseOutlines(alone, Precision().unseen);
    return crossesItself(alone, rules, rules.fills.front());
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
    flat.filled = stroke.fill && stroke.fill->age(time) > 0;
    if (flat.filled) {
        if (QString obstacle = obstacleOf(*stroke.fill, time, scene.view.scale); !obstacle.isEmpty())
            return obstacle;
        flat.fill = numbersOf(*stroke.fill, time);
    }
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const Segment &segment = stroke.segments[k];
        const bool there = segment.spread(time) > 0;
        if (!there && !flat.filled) // It may bound the fill before it is there.
            continue;
        if (QString obstacle = obstacleOf(stroke, segment, time, scene.view.scale); there && !obstacle.isEmpty())
            return obstacle;
        scene.segments.push_back(numbersOf(stroke, segment, time));
        scene.marks.push_back({stroke.beginsChain(k), segment.lift, segment.fade});
        out.segments.push_back(k);
    }
    flat.count = std::uint32_t(scene.segments.size()) - flat.first;
    if (flat.count == 0)
        return {};
    scene.strokes.push_back(flat);
    out.strokes.push_back(place);
    if (flat.filled && outlineCrosses(scene))
        return QStringLiteral("the outline of its fill crosses itself. Move its nodes, or remove the fill");
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

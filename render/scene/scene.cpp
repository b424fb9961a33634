#include "render/scene/scene.h"

#include "model/paint/style_function.h"
#include "render/math/scalar.h"
#include "render/nodes/colour_line.h"
// It has templates over the numbers, which must be declared before.
#include "render/math/shade.h"

#include <algorithm>
#include <cstring>

namespace suffuse {

namespace {

/// The linear part of the view, from canvas to pixels: (dx, dy) → (m00 dx + m01 dy, m10 dx + m11 dy).
struct Linear {
    double m00, m01, m10, m11;

    explicit Linear(const View &v)
    {
        const double c = std::cos(v.rotation) * v.scale, s = std::sin(v.rotation) * v.scale, flip = v.mirrored ? -1 : 1;
        m00 = c * flip;
        m01 = -s;
        m10 = s * flip;
        m11 = c;
    }
    Point operator()(Point d) const { return {m00 * d.x + m01 * d.y, m10 * d.x + m11 * d.y}; }
};

/// The metric of a node in pixels: J^−T M J^−1, where J is a similarity.
struct Metric {
    double a, b, c;

    Metric(const Node &n, const Linear &j, double scale)
    {
        const double k = 1 / (scale * scale * scale * scale);
        if (n.b == 0 && n.a == n.c) {
            a = c = n.a / (scale * scale);
            b = 0;
            return;
        }
        // J^−1 = Jᵀ/scale² for a similarity: M′ = J M Jᵀ / scale⁴.
        const double ax = j.m00 * n.a + j.m01 * n.b, ay = j.m00 * n.b + j.m01 * n.c;
        const double bx = j.m10 * n.a + j.m11 * n.b, by = j.m10 * n.b + j.m11 * n.c;
        a = k * (ax * j.m00 + ay * j.m01);
        b = k * (ax * j.m10 + ay * j.m11);
        c = k * (bx * j.m10 + by * j.m11);
        if (std::abs(b) < 1e-9 * std::min(a, c))
            b = 0;
    }
    /// The half-sizes of the box of q ≤ r².
    Point reach(double r) const
    {
        const double det = a * c - b * b;
        return {r * std::sqrt(c / det), r * std::sqrt(a / det)};
    }
    /// The eigenvalues.
    double greatest() const { return 0.5 * (a + c) + radius(); }
    double least() const { return 0.5 * (a + c) - radius(); }
    /// The spread along the narrowest axis.
    double narrowest() const { return 1 / std::sqrt(greatest()); }

private:
    double radius() const { return a == c && b == 0 ? 0 : std::hypot(0.5 * (a - c), b); }
};

PixelRect toPixelRect(const Rect &r, const PixelRect &window)
{
    const int right = window.x + window.width, bottom = window.y + window.height;
    if (r.isEmpty() || r.right < window.x || r.bottom < window.y || r.left > right || r.top > bottom)
        return {};
    const int x0 = int(std::max<double>(window.x, std::floor(r.left)));
    const int y0 = int(std::max<double>(window.y, std::floor(r.top)));
    const int x1 = int(std::min<double>(right, std::ceil(r.right)));
    const int y1 = int(std::min<double>(bottom, std::ceil(r.bottom)));
    return {x0, y0, x1 - x0, y1 - y0};
}

/// What neighbours along a stroke have in common: most segments have nodes of one metric.
struct Footprint {
    double a, b, c, cutRadius; ///< of the node for which it was made
    Metric metric;
    Point reach;
    double narrowest;

    Footprint(const Node &n, const Linear &j, double scale)
        : a(n.a), b(n.b), c(n.c), cutRadius(n.cutRadius), metric(n, j, scale), reach(metric.reach(n.cutRadius)),
          narrowest(metric.narrowest())
    {}
    bool fits(const Node &n) const { return n.a == a && n.b == b && n.c == c && n.cutRadius == cutRadius; }
};

/// A node in pixels.
struct Placed {
    Point at;
    float weight;
    std::uint32_t row;
    std::uint32_t footprint;
};

/// How the segments of a stroke that lay paint differ from the first of them, and whether there are segments that lift
/// paint, or fade it.
struct Differences {
    bool colour = false, granulation = false, style = false, kind = false, lift = false, fade = false;

    void look(const NodeValues &first, const NodeValues &v)
    {
        lift |= v.lift, fade |= v.fade;
        if (!v.laysPaint())
            return;
        colour |= v.colour != first.colour;
        granulation |= v.granulation != first.granulation;
        style |= v.style != first.style;
        kind |= v.style.kind != first.style.kind;
    }
    void operator|=(const Differences &d)
    {
        colour |= d.colour, granulation |= d.granulation, style |= d.style, kind |= d.kind, lift |= d.lift;
        fade |= d.fade;
    }
};

/// What is seen of some of a stroke's groups.
struct PlacedNodes {
    Differences differences;
    std::vector<SmallSegment> small;
    std::vector<Footprint> footprints;
    std::vector<Placed> laying, lifting, fading, oblique; ///< all but the last are separable
    std::vector<DeepNode> deep;
    Rect box;
    double narrowestLaid = 1e300; ///< px, of the nodes that lay paint
};

/// Writes the nodes of a stroke, from the `at`-th on. Floats could not tell boxes far from the corner of the grid
/// apart.
void writeNodes(const std::vector<Placed> &placed, const std::vector<Footprint> &footprints, const PixelRect &window,
                SceneStroke &s, std::size_t at)
{
    const NodeBoxSink boxes = s.boxes.sink();
    std::uint32_t last = ~0u;
    float radius = -1, cut = 0, slowest = 0, steepest = 0;
    for (const Placed &p : placed) {
        const Footprint &f = footprints[p.footprint];
        const Metric &m = f.metric;
        if (p.footprint != last) {
            last = p.footprint;
            if (float(f.cutRadius) != radius) // Most nodes of a stroke have the same one.
                radius = float(f.cutRadius), cut = std::exp(-radius * radius);
            slowest = float(m.least() * 0.9999);
            steepest = float(std::sqrt(m.greatest()));
        }
        s.nodes[at] = {p.at.x, p.at.y, float(m.a), float(m.b), float(m.c), p.weight, cut, p.row};
        boxes.x[at] = float(p.at.x - window.x);
        boxes.y[at] = float(p.at.y - window.y);
        // The factor 1.0001 covers the rounding to float.
        boxes.reachX[at] = float(f.reach.x * 1.0001);
        boxes.reachY[at] = float(f.reach.y * 1.0001);
        boxes.weight[at] = std::max(p.weight, 0.0f); // It is a bound of the paint that is laid.
        boxes.slowest[at] = slowest;
        boxes.steepest[at] = std::abs(p.weight) * steepest;
        boxes.node[at] = std::uint32_t(at);
        ++at;
    }
}

/// Extends a box by where a node may be seen: the node's box, and a pixel around it for the coverage of the pixel in
/// which it ends.
void includeNode(Rect &box, Point at, Point reach)
{
    box.include({at.x - reach.x - 1, at.y - reach.y - 1});
    box.include({at.x + reach.x + 1, at.y + reach.y + 1});
}

/// Extends a box for small segments, which decide how the pixels of their neighbours are sampled.
void includeSmall(Rect &box, const StrokeNodes &nodes, const NodeGroup &group, Point base, const Linear &j,
                  const View &view)
{
    for (std::uint32_t i = group.reachBegin; i < group.reachEnd; ++i)
        if (const SegmentReach &r = nodes.reaches[i]; r.spread * view.scale < 1)
            for (const double x : {r.box.left, r.box.right})
                for (const double y : {r.box.top, r.box.bottom})
                    includeNode(box, base + j({x, y}), {1, 1});
}

SmallSegment smallSegment(const SegmentReach &r, Point origin, const View &view)
{
    const double octaves = -std::log2(r.spread * view.scale);
    const int level = std::min(6, int(std::ceil(octaves)));
    const int quarter = std::clamp(int(std::floor(levelQuarters * (1 + octaves - level))), 0, levelQuarters - 1);
    return {
        level, quarter, {origin.x + r.box.left, origin.y + r.box.top, origin.x + r.box.right, origin.y + r.box.bottom}};
}

/// Puts the groups [from, to) into the picture. If `bounds` is not null, it gets the pixels that each group can change.
PlacedNodes placeGroups(const StrokeNodes &source, std::size_t from, std::size_t to, Point origin,
                        const PictureGrid &grid, PixelRect *bounds)
{
    const View &view = grid.view;
    const Rect seen = Rect::of(grid.window.x, grid.window.y, grid.window.width, grid.window.height).grown(1);
    PlacedNodes out;
    out.footprints.reserve(to - from);
    out.laying.reserve(source.groups[to - 1].end - source.groups[from].begin);
    const Linear j(view);
    // Subtracting in double before scaling keeps the digits of a painting far from 0 at deep zoom.
    const Point fromCentre = origin - view.centre, base = view.toPixels(origin);
    Rect box; // the box of a group
    const auto add = [&](const Node &n, std::uint32_t row, bool fades) {
        if (out.footprints.empty() || !out.footprints.back().fits(n))
            out.footprints.emplace_back(n, j, view.scale);
        const Footprint &f = out.footprints.back();
        if (n.weight > 0 && !fades)
            out.narrowestLaid = std::min(out.narrowestLaid, f.narrowest);
        const Point d = j(fromCentre + Point{n.x, n.y});
        const Point at{d.x + 0.5 * view.width, d.y + 0.5 * view.height};
        if (at.x + f.reach.x < seen.left || at.y + f.reach.y < seen.top || at.x - f.reach.x > seen.right ||
            at.y - f.reach.y > seen.bottom)
            return;
        includeNode(box, at, f.reach);
        const double weight = fades ? n.weight / double(fadeUnit) : n.weight;
        if (f.narrowest > deepSpread)
            out.deep.push_back({at.x, at.y, f.metric.a, f.metric.b, f.metric.c, weight, row});
        else
            (f.metric.b != 0 ? out.oblique : fades ? out.fading : weight < 0 ? out.lifting : out.laying)
                .push_back({at, float(weight), row, std::uint32_t(out.footprints.size() - 1)});
    };
    for (std::size_t g = from; g < to; ++g) {
        const NodeGroup &group = source.groups[g];
        box = {};
        const bool fades = source.rows[group.row].fade;
        for (std::uint32_t i = group.begin; i < group.end; ++i)
            add(source.nodes[i], group.row + (group.rowPerNode ? i - group.begin : 0), fades);
        out.box = out.box.united(box);
        if (!bounds)
            continue;
        includeSmall(box, source, group, base, j, view);
        bounds[g] = toPixelRect(box, grid.window);
    }
    const std::size_t rowsEnd = to < source.groups.size() ? source.groups[to].row : source.rows.size();
    const NodeValues *laying = firstLaying(source.rows);
    const NodeValues &first = laying ? *laying : source.rows.front();
    for (std::size_t k = source.groups[from].row; k < rowsEnd; ++k)
        out.differences.look(first, source.rows[k]);
    for (std::uint32_t k = source.groups[from].reachBegin; k < source.groups[to - 1].reachEnd; ++k)
        if (const SegmentReach &r = source.reaches[k]; r.spread * view.scale < 1)
            out.small.push_back(smallSegment(r, origin, view));
    return out;
}

/// Puts the nodes of the stroke into the picture, in the order that SceneStroke tells. Finds its bounds, and in what
/// its segments differ.
Differences placeNodes(SceneStroke &s, const PictureGrid &grid, Threads threads, bool changes)
{
    const StrokeNodes &source = *s.source;
    constexpr std::size_t share = 64, worthSharing = 8 * share; // counted in groups
    const std::size_t count = source.groups.size();
    if (count == 0)
        return {};
    if (changes)
        s.groupBounds.resize(count);
    std::vector<PlacedNodes> parts(threads.count() == 1 || count < worthSharing ? 1 : (count + share - 1) / share);
    parallelFor(parts.size(), threads, [&](std::size_t k) {
        const std::size_t from = k * share, to = k + 1 == parts.size() ? count : from + share;
        parts[k] = placeGroups(source, from, to, s.stroke->origin, grid, changes ? s.groupBounds.data() : nullptr);
    });
    std::size_t laying = 0, painted = 0, separable = 0, nodes = 0;
    Differences differences;
    Rect box;
    s.calm = true;
    for (const PlacedNodes &part : parts) {
        s.calm &= part.narrowestLaid >= liftFineness;
        laying += part.laying.size();
        painted += part.laying.size() + part.lifting.size();
        separable += part.laying.size() + part.lifting.size() + part.fading.size();
        nodes += part.laying.size() + part.lifting.size() + part.fading.size() + part.oblique.size();
        box = box.united(part.box);
        differences |= part.differences;
        s.small.insert(s.small.end(), part.small.begin(), part.small.end());
        s.deep.insert(s.deep.end(), part.deep.begin(), part.deep.end());
    }
    s.smallRuns.resize((s.small.size() + smallRun - 1) / smallRun);
    for (std::size_t i = 0; i < s.small.size(); ++i)
        s.smallRuns[i / smallRun] = s.smallRuns[i / smallRun].united(s.small[i].reach);
    s.laying = int(laying);
    s.painted = int(painted);
    s.separable = int(separable);
    s.bounds = toPixelRect(box, grid.window);
    s.nodes.resize(nodes);
    s.boxes.reserve(nodes);
    std::vector<std::array<std::size_t, 4>> places; // where the nodes of each kind and part begin
    std::array<std::size_t, 4> place{0, laying, painted, separable};
    for (const PlacedNodes &part : parts) {
        places.push_back(place);
        place[0] += part.laying.size(), place[1] += part.lifting.size();
        place[2] += part.fading.size(), place[3] += part.oblique.size();
    }
    parallelFor(parts.size(), threads, [&](std::size_t k) {
        const PlacedNodes &part = parts[k];
        writeNodes(part.laying, part.footprints, grid.window, s, places[k][0]);
        writeNodes(part.lifting, part.footprints, grid.window, s, places[k][1]);
        writeNodes(part.fading, part.footprints, grid.window, s, places[k][2]);
        writeNodes(part.oblique, part.footprints, grid.window, s, places[k][3]);
    });
    return differences;
}

/// What a fill carries beside its density: at the begin of its gradient, and at its end.
std::array<NodeValues, 2> valuesOf(const Stroke &stroke)
{
    const Fill &fill = *stroke.fill;
    const NodeValues from{fill.colour, fill.granulation, stroke.style};
    NodeValues to = from;
    if (fill.gradient)
        to.colour = fill.gradient->colour;
    return {from, to};
}

/// Whether the fill's edge is as soft as nodes of a calm stroke.
bool isCalm(const SceneFill &fill)
{
    return !fill.crisp && !fill.deep && fill.level == 0 && fill.narrowest >= liftFineness;
}

/// Chooses constants where all segments and the fill agree, and channels where they differ.
void planChannels(SceneStroke &s, Differences differ)
{
    std::vector<NodeValues> withFill;
    std::span<const NodeValues> rows(s.source->rows);
    if (s.fill) {
        withFill.assign(rows.begin(), rows.end());
        for (const NodeValues &values : valuesOf(*s.stroke))
            withFill.push_back(values);
        rows = withFill;
        for (const NodeValues &values : rows.last(2))
            differ.look(*firstLaying(rows), values);
    }
    const NodeValues &first = *firstLaying(rows);
    s.shade.colour = first.colour;
    s.shade.grain = first.granulation;
    if (const auto line = differ.colour ? lineThrough(rows) : std::nullopt) {
        s.shade.lineChannel = s.channels++;
        s.shade.colour = line->from;
        s.shade.colourEnd = line->to;
    } else if (differ.colour) {
        s.shade.colourChannel = s.channels, s.channels += 4;
    }
    if (differ.granulation)
        s.shade.grainChannel = s.channels++;
    s.granulated = s.shade.grainChannel >= 0 || s.shade.grain != 1;
    s.shade.kinds = 0;
    for (StyleKind kind : styleKinds) {
        const auto member = std::find_if(rows.begin(), rows.end(),
                                         [&](const NodeValues &v) { return v.laysPaint() && v.style.kind == kind; });
        if (member == rows.end())
            continue;
        KindParams &p = s.shade.kind[s.shade.kinds++];
        p.kind = kind;
        std::copy_n(member->style.xi.begin(), 3, p.xi);
        if (differ.kind)
            p.shareChannel = s.channels++;
        if (differ.style)
            p.xiChannel = s.channels, s.channels += xiCount(kind);
    }
    // φ⁺ itself has a channel if it is needed. Otherwise only max(0, φ⁺ − φ⁻) matters.
    if (differ.lift && (s.channels > 0 || hasRim(first.style.kind)))
        s.shade.laidChannel = s.channels++;
    if (differ.fade)
        s.shade.fadeChannel = s.channels++;
}

/// Finds the levels of styles. If ξ varies, the levels do, too, and a bound is not worth it.
void findLevels(SceneStroke &s)
{
    s.hasLevels = !isDeep(s);
    for (int k = 0; k < s.shade.kinds; ++k) {
        const KindParams &kind = s.shade.kind[k];
        s.hasLevels &= kind.xiChannel < 0;
        s.level[k] = math::withStyle<float>(
            kind.kind, [&](int i) { return kind.xi[i]; }, [](const auto &style) { return style.level(); });
        s.lowest = k == 0 ? s.level[k] : std::min(s.lowest, s.level[k]);
    }
}

/// Writes the channels of what carries some values; they are 0 before.
void writeChannels(const ShadeParams &shade, const NodeValues &v, float *row)
{
    if (v.fade)
        row[shade.fadeChannel] = fadeUnit;
    if (!v.laysPaint())
        return; // What lifts only counts in the density.
    if (shade.laidChannel >= 0)
        row[shade.laidChannel] = 1;
    if (const int c = shade.colourChannel; c >= 0) {
        const float colour[4] = {v.colour.red, v.colour.yellow, v.colour.blue, v.colour.opacity};
        std::copy_n(colour, 4, row + c);
    }
    if (shade.lineChannel >= 0)
        row[shade.lineChannel] = ColourLine{shade.colour, shade.colourEnd}.placeOf(v.colour);
    if (shade.grainChannel >= 0)
        row[shade.grainChannel] = v.granulation;
    for (int i = 0; i < shade.kinds; ++i) {
        const KindParams &p = shade.kind[i];
        if (p.kind != v.style.kind)
            continue;
        if (p.shareChannel >= 0)
            row[p.shareChannel] = 1;
        if (p.xiChannel >= 0)
            std::copy_n(v.style.xi.begin(), xiCount(p.kind), row + p.xiChannel);
    }
}

void fillValues(SceneStroke &s)
{
    if (s.channels == 0)
        return;
    const auto &rows = s.source->rows;
    s.values.assign(std::size_t(s.channels) * rows.size(), 0.0f);
    for (std::size_t k = 0; k < rows.size(); ++k)
        writeChannels(s.shade, rows[k], s.values.data() + k * std::size_t(s.channels));
}

void setFillChannels(const SceneStroke &s, SceneFill &fill)
{
    const auto [from, to] = valuesOf(*s.stroke);
    std::array<float, maxChannels> end{};
    writeChannels(s.shade, from, fill.from.data());
    writeChannels(s.shade, to, end.data());
    for (std::size_t c = 0; c < end.size(); ++c)
        fill.step[c] = end[c] - fill.from[c];
}

PixelRect unitedRects(const PixelRect &a, const PixelRect &b)
{
    if (a.isEmpty() || b.isEmpty())
        return a.isEmpty() ? b : a;
    const int left = std::min(a.x, b.x), top = std::min(a.y, b.y);
    return {left, top, std::max(a.x + a.width, b.x + b.width) - left, std::max(a.y + a.height, b.y + b.height) - top};
}

} // namespace

Rect visibleBox(const PictureGrid &grid)
{
    const PixelRect &w = grid.window;
    Rect box;
    for (const int x : {w.x, w.x + w.width})
        for (const int y : {w.y, w.y + w.height})
            box.include(grid.view.toCanvas({double(x), double(y)}));
    return box;
}

PixelRect pixelBounds(const StrokeNodes &nodes, const NodeGroup &group, Point origin, const PictureGrid &grid)
{
    const View &view = grid.view;
    const Linear j(view);
    const Point base = view.toPixels(origin);
    Rect box;
    for (std::uint32_t i = group.begin; i < group.end;) {
        const Footprint f(nodes.nodes[i], j, view.scale);
        Rect centres;
        do
            centres.include(base + j({nodes.nodes[i].x, nodes.nodes[i].y}));
        while (++i < group.end && f.fits(nodes.nodes[i]));
        includeNode(box, {centres.left, centres.top}, f.reach);
        includeNode(box, {centres.right, centres.bottom}, f.reach);
    }
    includeSmall(box, nodes, group, base, j, view);
    return toPixelRect(box, grid.window);
}

SceneStroke makeSceneStroke(StrokePtr stroke, std::shared_ptr<const StrokeNodes> nodes, const PictureGrid &grid,
                            Threads threads, bool changes, std::shared_ptr<SceneFill> fill)
{
    SceneStroke s;
    s.stroke = std::move(stroke);
    s.source = std::move(nodes);
    if (!firstLaying(s.source->rows) && !fill)
        return s;
    if (s.stroke->picture) {
        s.picture = scenePicture(*s.stroke, grid);
        if (!s.picture)
            return s;
    }
    s.fill = fill;
    s.keep = s.stroke->mix.mode == MixMode::Beta ? 1 - s.stroke->mix.beta : 1;
    const Differences differences = placeNodes(s, grid, threads, changes);
    planChannels(s, differences);
    s.calm &= !s.picture && math::hasOneStyle(s.shade) && s.deep.empty() && (!fill || isCalm(*fill));
    findLevels(s);
    fillValues(s);
    if (fill) {
        setFillChannels(s, *fill);
        s.bounds = unitedRects(s.bounds, fill->bounds);
    }
    return s;
}

} // namespace suffuse

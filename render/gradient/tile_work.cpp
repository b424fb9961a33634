#include "render/gradient/tile_work.h"

#include <algorithm>
#include <cstring>

namespace suffuse::gradient {

namespace {

template <class Numbers>
void valuesOf(const Numbers &s, double (&out)[values])
{
    std::copy_n(s.colour, 3, out);
    out[3] = s.opacity, out[4] = s.granulation;
}

/// The values of a run.
void valuesOf(const FlatScene &scene, const FlatStroke &stroke, const TileRun &run, double (&out)[values])
{
    if (run.segment >= scene.segments.size())
        valuesOf(stroke.fill, out);
    else
        valuesOf(scene.segments[run.segment], out);
}

Source sourceOf(const SceneNodes &nodes, const TileRun &run)
{
    return nodes.segments[run.segment].outline ? Source::Outline : Source::Segment;
}

bool isLift(const FlatScene &scene, const TileRun &run)
{
    return !scene.marks.empty() && run.segment < scene.segments.size() && scene.marks[run.segment].lift;
}

/// How many nodes make a stroke paler, from the first of its runs on.
int fadingNodes(const TileList &list, const TileStroke &stroke)
{
    return int(list.runs[stroke.firstPaint].first - list.runs[stroke.firstRun].first);
}

/// Calls use(source, first, count) for the nodes of its paint that are like a segment's, and for those on an outline.
template <class Use>
void forBothSources(const SceneNodes &nodes, const TileList &list, const TileStroke &stroke, Use use)
{
    const TileRun &last = list.runs[stroke.endRun - 1];
    const bool filled = sourceOf(nodes, last) == Source::Outline;
    const std::uint32_t first = list.runs[stroke.firstPaint].first, end = filled ? last.first : last.end;
    if (first < end)
        use(Source::Segment, first, int(end - first));
    if (filled)
        use(Source::Outline, last.first, int(last.end - last.first));
}

} // namespace

template <class Number>
Shading<Number> TileWork<Number>::shadingOf(const FlatScene &scene, const FlatStroke &stroke)
{
    Shading<Number> how{};
    how.kind = stroke.kind;
    for (int i = 0; i < 3; ++i)
        how.xi[i] = Number(stroke.xi[i]);
    how.keep = Number(stroke.keep);
    double constant[values];
    stroke.filled ? valuesOf(stroke.fill, constant) : valuesOf(scene.segments[stroke.first], constant);
    for (int i = 0; i < values; ++i)
        how.constant[i] = Number(constant[i]);
    how.varies = !stroke.oneColour;
    how.leastLaid = Number(stroke.filled ? std::max(4e-6 * stroke.fill.density, 1e-30) : 1e-30);
    return how;
}

template <class Number>
void TileWork<Number>::begin(const FlatScene &scene, const TilePlace &place)
{
    m_place = place;
    for (int c = 0; c < 3; ++c)
        std::fill_n(m_ryb.v[c], tileSize, Number(scene.background[c]));
    for (int y = 0; scene.ground && y < place.height; ++y) {
        const float *from = scene.ground->data() +
                            3 * (std::size_t(place.y + y) * std::size_t(scene.view.width) + std::size_t(place.x));
        for (int x = 0; x < place.width; ++x)
            for (int c = 0; c < 3; ++c)
                m_ryb.v[c][y * tileSide + x] = Number(*from++);
    }
    m_paper = scene.paper != nullptr;
    if (!m_paper)
        return;
    std::fill_n(m_eta, tileSize, Number(1));
    for (int y = 0; y < place.height; ++y)
        for (int x = 0; x < place.width; ++x)
            m_eta[y * tileSide + x] = Number(
                (*scene.paper)[std::size_t(place.y + y) * std::size_t(scene.view.width) + std::size_t(place.x + x)]);
}

template <class Number>
void TileWork<Number>::draw(const FlatScene &scene, const SceneNodes &nodes, const TileList &list, bool keep)
{
    m_nodes.resize(list.nodes.size());
    const double left = m_place.x + 0.5, top = m_place.y + 0.5;
    for (const TileRun &run : list.runs) {
        const PixelSegment &segment = nodes.segments[run.segment];
        const auto inverse = Number(segment.inverse), cut = Number(segment.cut), reach = Number(segment.reach);
        for (std::uint32_t i = run.first; i < run.end; ++i) {
            const PixelNode &node = nodes.nodes[list.nodes[i]];
            m_nodes[i] = {Number(node.x - left), Number(node.y - top), inverse, Number(node.weight), cut, reach};
        }
    }
    m_strokes.resize(std::max<std::size_t>(keep ? list.strokes.size() : 1, 1));
    m_values.resize(m_strokes.size());
    for (std::size_t i = 0; i < list.strokes.size(); ++i) {
        const TileStroke &tileStroke = list.strokes[i];
        const FlatStroke &stroke = scene.strokes[tileStroke.stroke];
        StrokeTile<Number> &tile = m_strokes[keep ? i : 0];
        ValueTile<Number> *varying = nullptr;
        bool add = false;
        forBothSources(nodes, list, tileStroke, [&](Source source, std::uint32_t first, int count) {
            m_kernels.accumulate(source, m_nodes.data() + first, count, add, tile.sums);
            add = true;
        });
        Shading<Number> how = shadingOf(scene, stroke);
        if (const int fading = fadingNodes(list, tileStroke); fading > 0) {
            how.fades = true;
            m_kernels.fade(m_nodes.data() + list.runs[tileStroke.firstRun].first, fading, tile.left);
        }
        if (!stroke.oneColour) {
            varying = &m_values[keep ? i : 0];
            std::memset(varying, 0, sizeof *varying);
            for (std::uint32_t r = tileStroke.firstPaint; r < tileStroke.endRun; ++r) {
                const TileRun &run = list.runs[r];
                double value[values];
                valuesOf(scene, stroke, run, value);
                if (!isLift(scene, run))
                    m_kernels.addValues(sourceOf(nodes, run), m_nodes.data() + run.first, int(run.end - run.first),
                                        value, *varying);
            }
        }
        m_kernels.mixStroke(how, tile, varying, m_paper ? m_eta : nullptr, keep, m_ryb);
    }
}

template <class Number>
const ColourTile<Number> &TileWork<Number>::rgb()
{
    m_kernels.toRgb(m_ryb, m_rgb);
    return m_rgb;
}

template <class Number>
void TileWork<Number>::back(const FlatScene &scene, const SceneNodes &nodes, const TileList &list,
                            TileSlopes<Number> &out)
{
    out.nodes.assign(list.nodes.size(), {});
    out.strokes.assign(list.strokes.size(), {});
    out.values.assign(list.runs.size() * values, Number(0));
    m_kernels.rgbBack(m_ryb, m_by);
    for (std::size_t i = list.strokes.size(); i-- > 0;)
        strokeBack(scene, nodes, list, i, out);
}

template <class Number>
void TileWork<Number>::strokeBack(const FlatScene &scene, const SceneNodes &nodes, const TileList &list, std::size_t at,
                                  TileSlopes<Number> &out)
{
    const TileStroke &tileStroke = list.strokes[at];
    const FlatStroke &stroke = scene.strokes[tileStroke.stroke];
    const ValueTile<Number> *varying = stroke.oneColour ? nullptr : &m_values[at];
    const int fading = fadingNodes(list, tileStroke);
    Shading<Number> how = shadingOf(scene, stroke);
    how.fades = fading > 0;
    if (!m_kernels.strokeBack(how, m_strokes[at], varying, m_paper ? m_eta : nullptr, scene.byXi, m_by, m_bySums,
                              out.strokes[at]))
        return;
    if (const std::uint32_t first = list.runs[tileStroke.firstRun].first; fading > 0)
        m_kernels.nodesBack(Source::Segment, m_nodes.data() + first, fading, m_bySums.fading, m_bySums.firstRow,
                            m_bySums.endRow, out.nodes.data() + first);
    const auto back = [&](Source source, std::uint32_t first, int count) {
        m_kernels.nodesBack(source, m_nodes.data() + first, count, m_bySums.sums, m_bySums.firstRow, m_bySums.endRow,
                            out.nodes.data() + first);
    };
    if (!varying)
        return forBothSources(nodes, list, tileStroke, back);
    for (std::uint32_t r = tileStroke.firstPaint; r < tileStroke.endRun; ++r) {
        const TileRun &run = list.runs[r];
        const int count = int(run.end - run.first);
        if (isLift(scene, run)) {
            back(Source::Segment, run.first, count);
            continue;
        }
        double value[values];
        valuesOf(scene, stroke, run, value);
        m_kernels.valuesBack(sourceOf(nodes, run), m_nodes.data() + run.first, count, value, m_bySums,
                             out.nodes.data() + run.first, out.values.data() + r * values);
    }
}

template class TileWork<float>;
template class TileWork<double>;

} // namespace suffuse::gradient

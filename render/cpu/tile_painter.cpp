#include "render/cpu/tile_painter.h"

#include "render/cpu/deep.h"

#include <algorithm>
#include <numbers>

namespace suffuse::cpu {

namespace {

/// The working memory for one block. It is large, so each thread has one on the heap.
struct Scratch {
    Sums sums;
    Shaded shaded;
    Shaded samples;
    Backdrop backdrop;
    alignas(64) float eta[blockSize];
    alignas(64) float sampleEta[blockSize];
    float rgba[blockSize * 4];
    Point centres[blockSize]; ///< of the block's pixels, canvas units
    std::vector<std::uint32_t> runs;  ///< runs of boxes that meet the block, where it is supersampled,
    std::vector<std::uint32_t> group; ///< and nodes that meet a group of its pixels
};

class BlockPainter {
public:
    /// The block is the `index`-th one of tile `tile`. `under` is the picture to start from; null for the background.
    BlockPainter(const Frame &frame, std::size_t tile, std::size_t index, int x, int y, const Backdrop *under,
                 Scratch &scratch)
        : m_frame(frame), m_tile(tile), m_index(index), m_x(x), m_y(y), m_s(scratch)
    {
        if (under) {
            m_s.backdrop = *under;
            return;
        }
        const Colour &b = frame.canvas.background;
        // A background that is not opaque lies on white, RYB (0, 0, 0).
        const float ryb[3] = {b.red * b.opacity, b.yellow * b.opacity, b.blue * b.opacity};
        for (int c = 0; c < 3; ++c)
            std::fill_n(m_s.backdrop.ryb[c], blockSize, frame.transparent ? 0.0f : ryb[c]);
        std::fill_n(m_s.backdrop.coverage, blockSize, 0.0f);
        m_s.backdrop.transparent = frame.transparent;
    }

    Backdrop &backdrop() { return m_s.backdrop; }

    /// Begins a map of the strokes that follow; null ends it.
    void record(OverMap *map)
    {
        m_map = map;
        if (!map)
            return;
        for (int c = 0; c < 3; ++c) {
            std::fill_n(map->keep[c], blockSize, 1.0f);
            std::fill_n(map->add[c], blockSize, 0.0f);
            std::fill_n(map->limit[c], blockSize, 1.0f);
        }
        std::fill_n(map->hold, blockSize, 1.0f);
        std::fill_n(map->gain, blockSize, 0.0f);
    }

    /// Adds a stroke. `prefix` has the sums of the nodes before those that are listed; it is empty if there are none.
    void add(const SceneStroke &scene, NodeList listed, std::span<const float> prefix)
    {
        const Block block{double(m_x), double(m_y), 1};
        const float *paper = scene.granulated ? eta() : nullptr;
        const bool small = markLevels(scene);
        if (!small && scene.deep.empty()) {
            sum(scene, listed, block, prefix);
            m_frame.kernels->shadeInto(scene.shade, m_s.sums, paper, 1, scene.keep, m_s.backdrop, m_map);
            return;
        }
        if (!small || std::ranges::find(m_level, 0) != m_level.end()) // some pixel is not supersampled
            evaluate(scene, listed, block, paper, m_s.shaded, prefix);
        if (small)
            supersample(scene);
        m_frame.kernels->mix(m_s.shaded, scene.keep, m_s.backdrop);
        if (m_map)
            m_frame.kernels->compose(m_s.shaded, scene.keep, *m_map);
    }

    /// Writes the block's first columns and rows into `rgba`, in rows that are `stride` pixels apart.
    void finish(float *rgba, int stride, int columns, int rows)
    {
        const bool whole = columns == blockSide && rows == blockSide;
        m_frame.kernels->finish(m_s.backdrop, m_frame.transparent, whole ? rgba : m_s.rgba, whole ? stride : blockSide);
        for (int j = 0; j < rows && !whole; ++j)
            std::copy_n(m_s.rgba + j * blockSide * 4, std::size_t(columns) * 4, rgba + std::size_t(j) * stride * 4);
    }

private:
    void sum(const SceneStroke &scene, NodeList listed, const Block &block, std::span<const float> prefix)
    {
        m_s.sums.take(prefix);
        const auto oblique = std::lower_bound(listed.begin(), listed.end(), std::uint32_t(scene.separable));
        m_frame.kernels->accumulate(block, scene.nodes.data(), listed.data(), int(listed.size()),
                                    int(oblique - listed.begin()), scene.values.data(), scene.channels, !prefix.empty(),
                                    m_s.sums);
    }

    /// Computes opacity and colour of a stroke at a block of samples.
    void evaluate(const SceneStroke &scene, NodeList listed, const Block &block, const float *eta, Shaded &out,
                  std::span<const float> prefix = {})
    {
        sum(scene, listed, block, prefix);
        if (scene.deep.empty())
            m_frame.kernels->shade(scene.shade, m_s.sums, eta, float(block.step), out);
        else
            shadeDeep(*m_frame.kernels, scene, block, m_s.sums, eta, out);
    }

    /// The paper at the block's pixels, which is computed once for all strokes.
    const float *eta()
    {
        if (!m_eta && m_frame.paper->isThere())
            m_eta = m_frame.paper->at(m_tile, m_index, {double(m_x), double(m_y), 1}, m_s.eta);
        return m_eta;
    }

    /// The centres of the block's pixels in canvas units, once for all strokes.
    const Point *centres()
    {
        const View &view = m_frame.view;
        const double cosine = std::cos(view.rotation), sine = std::sin(view.rotation);
        for (int at = 0; at < blockSize && !m_haveCentres; ++at)
            m_s.centres[at] = view.toCanvas({m_x + at % blockSide + 0.5, m_y + at / blockSide + 0.5}, cosine, sine);
        m_haveCentres = true;
        return m_s.centres;
    }

    /// Finds for each pixel the greatest level of the small segments that reach it (docs/reference.md). Returns false
    /// if there are none.
    bool markLevels(const SceneStroke &stroke)
    {
        if (stroke.small.empty())
            return false;
        m_level.fill(0);
        bool any = false;
        const View &view = m_frame.view;
        const double quarter = view.rotation / (0.5 * std::numbers::pi);
        const bool upright = std::abs(quarter - std::round(quarter)) < 1e-12;
        const double margin = view.px() * (upright ? 0.5 : std::numbers::sqrt2 / 2);
        const Point *centre = centres();
        Rect area; // of the centres, and more than rounding takes
        for (const int corner : {0, blockSide - 1, blockSize - blockSide, blockSize - 1})
            area.include(centre[corner]);
        area = area.grown(0.1 * view.px());
        int everywhere = 0; // the level that all pixels have at least
        for (const SmallSegment &segment : stroke.small) {
            const Rect box = segment.reach.grown(margin);
            if (segment.level <= everywhere || box.right < area.left || box.left > area.right ||
                box.bottom < area.top || box.top > area.bottom)
                continue;
            if (box.contains({area.left, area.top}) && box.contains({area.right, area.bottom}))
                everywhere = segment.level;
            for (int at = 0; at < blockSize; ++at)
                if (m_level[std::size_t(at)] < segment.level && box.contains(centre[at]))
                    m_level[std::size_t(at)] = std::uint8_t(segment.level), any = true;
        }
        return any;
    }

    /// Replaces opacity and colour of the marked pixels by means over 2^k × 2^k points.
    void supersample(const SceneStroke &stroke)
    {
        Meeting block;
        const Area area = areaOf(Rect::of(m_x, m_y, blockSide, blockSide));
        const int runs = findRuns(*m_frame.kernels, stroke, {0, stroke.nodes.size()}, area, m_s.runs, block);
        m_s.group.resize(std::max(m_s.group.size(), std::size_t(runs) * boxRun));
        for (int level = 1; level <= 6; ++level) {
            if (std::find(m_level.begin(), m_level.end(), level) == m_level.end())
                continue;
            const int side = std::max(1, blockSide >> level); // pixels along a side of a group of samples
            for (int j = 0; j < blockSide; j += side)
                for (int i = 0; i < blockSide; i += side)
                    supersampleGroup(stroke, runs, level, i, j, side);
        }
    }

    void supersampleGroup(const SceneStroke &stroke, int runs, int level, int i, int j, int side)
    {
        bool any = false;
        for (int y = j; y < j + side; ++y)
            for (int x = i; x < i + side; ++x)
                any |= m_level[y * blockSide + x] == level;
        if (!any)
            return;
        Meeting cell;
        m_frame.kernels->listNodes(stroke.boxes.boxes(), int(stroke.nodes.size()), m_s.runs.data(), runs,
                                   {double(m_x + i), double(m_y + j), double(side)}, m_s.group.data(), &cell);
        const bool shown = shows(stroke, cell);
        const NodeList listed(m_s.group.data(), std::size_t(cell.count));
        std::array<std::array<double, 4>, blockSize> mean{}; // w and w·C of the group's pixels
        const int samples = 1 << level;                      // along a side of a pixel
        const double step = 1.0 / samples;
        const int blocks = std::max(1, samples / blockSide); // blocks of samples along a side of the group
        for (int v = 0; v < blocks && shown; ++v)
            for (int u = 0; u < blocks; ++u) {
                const Block block{m_x + i + u * blockSide * step, m_y + j + v * blockSide * step, step};
                const bool paper = stroke.granulated && m_frame.paper->isThere();
                if (paper)
                    m_frame.paper->fill(block, level, m_s.sampleEta);
                evaluate(stroke, listed, block, paper ? m_s.sampleEta : nullptr, m_s.samples);
                for (int y = 0; y < blockSide; ++y)
                    for (int x = 0; x < blockSide; ++x) {
                        const int at = y * blockSide + x;
                        auto &m = mean[blocks > 1 ? 0 : std::size_t((y >> level) * side + (x >> level))];
                        m[0] += double(m_s.samples.w[at]);
                        for (int c = 0; c < 3; ++c)
                            m[1 + c] += double(m_s.samples.w[at]) * double(m_s.samples.colour[c][at]);
                    }
            }
        const double share = 1.0 / (double(samples) * samples);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const int at = (j + y) * blockSide + i + x;
                if (m_level[at] != level)
                    continue;
                const auto &m = mean[std::size_t(y * side + x)];
                m_s.shaded.w[at] = float(m[0] * share);
                for (int c = 0; c < 3; ++c)
                    m_s.shaded.colour[c][at] = m[0] > 0 ? float(m[1 + c] / m[0]) : 0.0f;
            }
    }

    const Frame &m_frame;
    const std::size_t m_tile, m_index;
    int m_x;
    int m_y;
    Scratch &m_s;
    OverMap *m_map = nullptr;
    const float *m_eta = nullptr;
    bool m_haveCentres = false;
    std::array<std::uint8_t, blockSize> m_level{};
};

/// Adds the strokes [from, to) to a block of the tile.
void addStrokes(BlockPainter &painter, const TileStrokes &strokes, std::size_t block, std::size_t from, std::size_t to)
{
    for (std::size_t i = from; i < to; ++i)
        if (const auto nodes = strokes.nodesAt(i, block))
            painter.add(strokes[i], *nodes, strokes.sumsAt(i, block));
}

} // namespace

void paintTile(const Frame &frame, const PixelRect &tile, const TileStrokes &strokes, const TilePlan &plan,
               const SceneStroke *edited, float *rgba)
{
    thread_local const auto scratch = std::make_unique<Scratch>();
    // If the edited stroke misses this tile, all the rest lies above it.
    const bool meetsEdited = plan.below < strokes.size() && &strokes[plan.below] == edited;
    const std::size_t above = plan.below + (meetsEdited ? 1 : 0);
    std::size_t index = 0;
    for (int y = 0; y < tile.height; y += blockSide)
        for (int x = 0; x < tile.width; x += blockSide, ++index) {
            const Backdrop *under = plan.haveUnder ? &plan.layers->under[index] : nullptr;
            BlockPainter painter(frame, plan.tile, index, tile.x + x, tile.y + y, under, *scratch);
            addStrokes(painter, strokes, index, 0, plan.below);
            if (plan.storeUnder)
                plan.layers->under[index] = painter.backdrop();
            addStrokes(painter, strokes, index, plan.below, above);
            if (plan.applyOver) {
                frame.kernels->apply(plan.layers->over[index], painter.backdrop());
            } else {
                painter.record(plan.storeOver ? &plan.layers->over[index] : nullptr);
                addStrokes(painter, strokes, index, above, strokes.size());
            }
            painter.finish(rgba + (std::size_t(y) * tile.width + x) * 4, tile.width,
                           std::min(blockSide, tile.width - x), std::min(blockSide, tile.height - y));
        }
}

} // namespace suffuse::cpu

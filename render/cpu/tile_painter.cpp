#include "render/cpu/tile_painter.h"

#include "render/cpu/deep.h"
#include "render/cpu/pixel_levels.h"
#include "render/math/scalar.h"
// It has templates over the numbers, which must be declared before.
#include "render/math/colour.h"
#include "render/math/picture.h"

#include <algorithm>
#include <utility>

namespace suffuse::cpu {

namespace {

/// The working memory for one block. It is large, so each thread has one on the heap.
struct Scratch {
    Sums sums;
    Shaded shaded;
    Shaded samples;
    /// The canvas, and each layer that is open, from the outermost on. There may be more behind them, whose memory is
    /// kept.
    std::vector<Backdrop> backdrops{1};
    std::vector<LayerBounds> bounds{1};  ///< of each of these
    std::vector<KeptLayer> kept;         ///< layers that are put next
    alignas(64) float share[blockSize];  ///< of a layer that is bounded
    alignas(64) float source[blockSize]; ///< its coverage in the end
    alignas(64) float eta[blockSize];
    alignas(64) float sampleEta[blockSize];
    float rgba[blockSize * 4];
    PixelLevels levels;
    alignas(64) float quarterEta[4][blockSize]; ///< at the four samples of each pixel
    alignas(64) float covered[blockSize];       ///< by a crisp fill
    Sums insideSums;
    Shaded insideShaded;
    std::vector<std::uint32_t> runs;  ///< runs of boxes that meet the block, where it is supersampled,
    std::vector<std::uint32_t> whole; ///< nodes that meet the block
    std::vector<std::uint32_t> group; ///< and nodes that meet a group of its pixels
};

class BlockPainter {
public:
    /// The block is the `index`-th one of tile `tile`. `layers` have what to start from; null for the background.
    BlockPainter(const Frame &frame, std::size_t tile, std::size_t index, int x, int y, const TileLayers *layers,
                 Scratch &scratch)
        : m_frame(frame), m_tile(tile), m_index(index), m_x(x), m_y(y), m_s(scratch),
          m_walk(*frame.composition, layers && !layers->open.empty() ? layers->open[index].place : LayerPlace())
    {
        m_s.levels.begin(frame.grid.view, x, y);
        if (layers) {
            if (!layers->open.empty())
                restore(layers->open[index]);
            backdrop() = layers->under[index];
            return;
        }
        m_s.bounds.front().base = Layer::none, m_s.bounds.front().masks = 0;
        clear(bareRyb(frame));
        backdrop().hasCoverage = frame.transparent || !frame.composition->isFlat();
    }

    /// Keeps what was painted so far.
    void storeUnder(TileLayers &layers) const
    {
        layers.under[m_index] = m_s.backdrops[m_open];
        if (layers.open.empty())
            return;
        OpenLayers &open = layers.open[m_index];
        open.place = m_walk.place();
        open.below.assign(m_s.backdrops.begin(), m_s.backdrops.begin() + std::ptrdiff_t(m_open));
        open.bounds.clear();
        if (m_frame.composition->isBounded)
            open.bounds.assign(m_s.bounds.begin(), m_s.bounds.begin() + std::ptrdiff_t(m_open) + 1);
    }
    Backdrop &backdrop() { return m_s.backdrops[m_open]; }

    /// Begins and ends the layers between the stroke before and this one, which has this place among all.
    void goTo(std::size_t place)
    {
        m_walk.toStroke(
            place, [this](int) { beginLayer(); }, [this](int layer) { endLayer(layer); });
    }
    /// Opens the layers around what is edited, be it in this block or not.
    void openAround(const Edited &edited)
    {
        if (edited.layer == Layer::none)
            return goTo(edited.place);
        m_walk.toLayer(
            edited.layer, [this](int) { beginLayer(); }, [this](int layer) { endLayer(layer); });
    }
    /// Ends all layers.
    void goToEnd()
    {
        m_walk.toEnd([this](int) { beginLayer(); }, [this](int layer) { endLayer(layer); });
    }

    /// Begins to record what follows; null ends that.
    void record(OverSteps *steps)
    {
        m_record = steps;
        m_recorded = m_open;
        if (steps)
            steps->clear();
    }
    /// Does all that was recorded, up to the end.
    void apply(const OverSteps &over)
    {
        for (const OverSteps::Step &step : over.steps) {
            if (step.kind == OverSteps::Kind::Picture) {
                m_s.kept.push_back({howToPut(step.layer), &over.pictures[step.place]});
                continue;
            }
            putKept();
            if (step.kind == OverSteps::Kind::Map) {
                turnTo(false);
                m_frame.kernels->apply(over.maps[step.place], backdrop());
            } else {
                turnTo(true);
                --m_open;
                m_frame.kernels->toRgb(backdrop());
                m_frame.kernels->putEnded(howToPut(step.layer),
                                          step.isBounded ? over.shares[step.place].values : nullptr,
                                          m_s.backdrops[m_open + 1], backdrop());
            }
        }
        putKept();
    }

    /// Adds the coverage of a stroke to that of the base of which it is a part, which has this place among all. The
    /// stroke is added as onto nothing: what it covers there is its opacity, to the bit.
    template <class Add>
    void addPart(std::size_t place, Add add)
    {
        const int part = m_frame.composition->shapeOf(place);
        if (part == Layer::none)
            return;
        beginLayer();
        add();
        m_s.bounds[m_open - 1].addPart(part, BlendMode::Normal, backdrop().coverage);
        --m_open;
    }

    /// Adds a stroke. `prefix` has the sums of the nodes before those that are listed; it is empty if there are none.
    void add(const SceneStroke &scene, NodeList listed, std::span<const float> prefix, BlockFill fill)
    {
        m_fill = fill;
        m_map = m_record && m_open == m_recorded ? &m_record->map() : nullptr;
        const Block block{double(m_x), double(m_y), 1};
        const float *paper = scene.granulated ? eta() : nullptr;
        const bool small = m_s.levels.mark(scene, fill.tile), crisp = fill && scene.fill->crisp;
        m_isBare = fill && !isDeep(scene) && listed.empty() && prefix.empty();
        m_isLevel = m_isBare && !paper && fill.tile->isLevel(scene.channels);
        if (!small && m_isLevel && fill.presence == FillPresence::Inside) {
            fill.tile->setInside(scene.channels, m_s.sums);
            if (scene.picture) {
                m_frame.kernels->shadeLevel(scene.shade, m_s.sums, 1, m_s.shaded);
                return mixShaded(scene);
            }
            m_frame.kernels->shadeLevelInto(scene.shade, m_s.sums, 1, scene.keep, backdrop(), m_map);
            return;
        }
        if (!small && !isDeep(scene) && !crisp && !scene.picture) {
            sum(scene, listed, block, prefix);
            addFill(scene, block);
            m_frame.kernels->shadeInto(scene.shade, m_s.sums, paper, 1, scene.keep, backdrop(), m_map);
            return;
        }
        if (small && !prefix.empty()) {
            listed = listWhole(scene);
            prefix = {};
        }
        const bool calm = small && scene.calm && m_s.levels.has(1);
        if (calm) {
            if (shadeCalm(scene, listed, block, paper))
                return;
        } else if (!small || m_s.levels.has(0)) {
            evaluate(scene, listed, block, paper, m_s.shaded, prefix);
        }
        if (small)
            supersample(scene, listed);
        mixShaded(scene);
    }

    /// Writes the block's first columns and rows into `rgba`, in rows that are `stride` pixels apart.
    void finish(float *rgba, int stride, int columns, int rows)
    {
        const bool whole = columns == blockSide && rows == blockSide;
        m_frame.kernels->finish(backdrop(), m_isRgb, m_frame.transparent, whole ? rgba : m_s.rgba,
                                whole ? stride : blockSide);
        for (int j = 0; j < rows && !whole; ++j)
            std::copy_n(m_s.rgba + j * blockSide * 4, std::size_t(columns) * 4, rgba + std::size_t(j) * stride * 4);
    }

private:
    /// RYB where there is no paint. A background that is not opaque lies on white, RYB (0, 0, 0).
    static std::array<float, 3> bareRyb(const Frame &frame)
    {
        const Colour &b = frame.canvas.background;
        if (frame.transparent)
            return {};
        return {b.red * b.opacity, b.yellow * b.opacity, b.blue * b.opacity};
    }

    void clear(const std::array<float, 3> &ryb)
    {
        for (std::size_t c = 0; c < 3; ++c)
            std::fill_n(backdrop().ryb[c], blockSize, ryb[c]);
        std::fill_n(backdrop().coverage, blockSize, 0.0f);
    }

    /// Makes a backdrop above the present one, whose content is not set.
    void open()
    {
        if (++m_open == m_s.backdrops.size()) {
            m_s.backdrops.emplace_back();
            m_s.bounds.emplace_back();
        }
        m_s.bounds[m_open].base = Layer::none, m_s.bounds[m_open].masks = 0;
    }

    /// Opens layers as they were, up to the innermost backdrop, whose content is not set.
    void restore(const OpenLayers &layers)
    {
        for (const Backdrop &below : layers.below)
            backdrop() = below, open();
        std::copy(layers.bounds.begin(), layers.bounds.end(), m_s.bounds.begin());
    }

    void beginLayer()
    {
        open();
        clear({});
        backdrop().hasCoverage = true;
    }

    void endLayer(int number)
    {
        const Layer &layer = m_frame.composition->layers[std::size_t(number)];
        const Backdrop &ended = backdrop();
        const LayerBounds &own = m_s.bounds[m_open];
        LayerBounds &around = m_s.bounds[m_open - 1];
        const float *share = boundsOf(layer, own, around, m_s.share) ? m_s.share : nullptr;
        if (m_record && m_open == m_recorded)
            m_record->addEnd(number, share), --m_recorded;
        else if (m_record && m_open == m_recorded + 1 && !layer.isMask)
            m_record->addPicture(*m_frame.kernels, number, ended, share, layer.actsEverywhere());
        --m_open;
        if (layer.isMask || layer.shape != Layer::none) {
            for (std::size_t at = 0; at < blockSize; ++at)
                m_s.source[at] = ended.coverage[at] * (share ? layer.opacity * share[at] : layer.opacity);
            if (layer.isMask)
                return around.addMask(m_s.source);
            around.addPart(layer.shape, layer.shapeMode, m_s.source);
        }
        putLayer(number, share, ended);
    }

    /// Puts what a layer shows on the present backdrop. `share`: what its bounds let through; null for all.
    void putLayer(int number, const float *share, const Backdrop &shown)
    {
        m_frame.kernels->put(howToPut(number), share, shown, backdrop());
    }

    /// Puts the layers in hand that are kept as pictures.
    void putKept()
    {
        if (m_s.kept.empty())
            return;
        turnTo(true);
        m_frame.kernels->putKept(m_s.kept.data(), int(m_s.kept.size()), backdrop());
        m_s.kept.clear();
    }
    /// Makes RGB of the present backdrop, or RYB again.
    void turnTo(bool rgb)
    {
        if (rgb != m_isRgb)
            (rgb ? m_frame.kernels->toRgb : m_frame.kernels->toRyb)(backdrop());
        m_isRgb = rgb;
    }

    LayerPut howToPut(int number) const
    {
        const Layer &layer = m_frame.composition->layers[std::size_t(number)];
        const bool onCanvas = layer.parent == Layer::none;
        LayerPut how{layer.blend, layer.opacity, onCanvas && !m_frame.transparent, {1, 1, 1}};
        if (onCanvas) {
            const std::array<float, 3> ryb = bareRyb(m_frame);
            const math::Triple<float> rgb = math::rgbFromRyb(ryb[0], ryb[1], ryb[2]);
            how.bare[0] = rgb.x, how.bare[1] = rgb.y, how.bare[2] = rgb.z;
        }
        return how;
    }

    /// Mixes what was shaded of a stroke into the block.
    void mixShaded(const SceneStroke &scene)
    {
        if (scene.picture)
            showPicture(scene.picture->view);
        m_frame.kernels->mix(m_s.shaded, scene.keep, backdrop());
        if (m_map)
            m_frame.kernels->compose(m_s.shaded, scene.keep, *m_map);
    }

    /// Puts a picture in the place of the colours, where the stroke is.
    void showPicture(const PictureView &picture)
    {
        for (int y = 0; y < blockSide; ++y)
            for (int x = 0; x < blockSide; ++x) {
                const int at = y * blockSide + x;
                if (!(m_s.shaded.w[at] > 0))
                    continue;
                const math::PicturePaint paint = math::shown(picture, m_x + x + 0.5, m_y + y + 0.5, m_s.shaded.w[at]);
                m_s.shaded.w[at] = paint.w;
                m_s.shaded.colour[0][at] = paint.red;
                m_s.shaded.colour[1][at] = paint.yellow;
                m_s.shaded.colour[2][at] = paint.blue;
            }
    }

    void sum(const SceneStroke &scene, NodeList listed, const Block &block, std::span<const float> prefix)
    {
        m_s.sums.take(prefix);
        m_frame.kernels->accumulate(block, listedOf(scene, listed), !prefix.empty(), m_s.sums);
    }

    /// Adds a fill that is neither crisp nor deep to the sums.
    void addFill(const SceneStroke &scene, const Block &block)
    {
        if (!m_fill || scene.fill->crisp || scene.fill->deep)
            return;
        if (m_fill.presence == FillPresence::Inside)
            m_fill.tile->addInside(block, scene.channels, m_s.sums);
        else
            m_fill.tile->addTo(*m_frame.kernels, block, scene.channels, m_s.sums);
    }

    /// Computes opacity and colour of a stroke at a block of samples.
    void evaluate(const SceneStroke &scene, NodeList listed, const Block &block, const float *eta, Shaded &out,
                  std::span<const float> prefix = {})
    {
        const bool crisp = m_fill && scene.fill->crisp;
        if (!crisp || !m_isLevel)
            sum(scene, listed, block, prefix);
        addFill(scene, block);
        if (crisp)
            shadeCrisp(scene, block, eta, out);
        else
            shadeSums(scene, block, m_s.sums, eta, out);
    }

    void shadeSums(const SceneStroke &scene, const Block &block, Sums &sums, const float *eta, Shaded &out)
    {
        if (isDeep(scene))
            shadeDeep(*m_frame.kernels, scene, block, sums, eta, out);
        else
            m_frame.kernels->shade(scene.shade, sums, eta, float(block.step), out);
    }

    /// What a crisp fill covers of a sample, and what it leaves, are shaded each by itself.
    void shadeCrisp(const SceneStroke &scene, const Block &block, const float *eta, Shaded &out)
    {
        m_fill.tile->cover(block, m_s.covered);
        if (m_isLevel) {
            m_fill.tile->setInside(scene.channels, m_s.insideSums);
            m_frame.kernels->shadeLevel(scene.shade, m_s.insideSums, float(block.step), m_s.insideShaded);
        } else {
            for (int i = 0; i < fixedSums + scene.channels; ++i)
                std::copy_n(m_s.sums.v[i], blockSize, m_s.insideSums.v[i]);
            m_fill.tile->addInside(block, scene.channels, m_s.insideSums);
            shadeSums(scene, block, m_s.insideSums, eta, m_s.insideShaded);
        }
        if (m_isBare) // Where there is no density, nothing shows.
            std::memset(&out, 0, sizeof out);
        else
            shadeSums(scene, block, m_s.sums, eta, out);
        // Where it covers nothing or all, samples are as in a tile that it does not meet, or in one that lies within
        // it, to the bit. Loops without branches become loops over vectors.
        std::array<float, blockSize> in, left, inverse;
        for (std::size_t at = 0; at < blockSize; ++at) {
            const float covered = m_s.covered[at];
            in[at] = covered * m_s.insideShaded.w[at];
            left[at] = (1 - covered) * out.w[at];
            out.w[at] = in[at] + left[at];
            inverse[at] = 1 / std::max(out.w[at], 1e-30f);
        }
        for (int c = 0; c < 3; ++c)
            for (std::size_t at = 0; at < blockSize; ++at) {
                const float covered = m_s.covered[at], inside = m_s.insideShaded.colour[c][at];
                const float outside = out.colour[c][at];
                const float mixed = (in[at] * inside + left[at] * outside) * inverse[at];
                out.colour[c][at] = covered == 0 ? outside : covered == 1 ? inside : mixed;
            }
    }

    /// The paper at the block's pixels, which is computed once for all strokes.
    const float *eta()
    {
        if (!m_eta && m_frame.paper->isThere())
            m_eta = m_frame.paper->at(m_tile, m_index, {double(m_x), double(m_y), 1}, m_s.eta);
        return m_eta;
    }

    /// Computes opacity and colour of the pixels of levels 0 and 1. Those of level 1 whose samples can be told from
    /// centres become pixels of level 0; the others are left to `supersample`. Returns true if the stroke has been
    /// mixed into the block, since nothing is left to do.
    bool shadeCalm(const SceneStroke &stroke, NodeList listed, const Block &block, const float *paper)
    {
        sum(stroke, listed, block, {});
        addFill(stroke, block);
        const float(*eta)[blockSize] = paper ? etaOfSamples(block) : nullptr;
        const ToldBlock told =
            m_frame.kernels->shadeBent(stroke.shade, stroke.channels, m_s.sums, paper, eta, m_s.levels.marks(),
                                       stroke.keep, backdrop(), m_map, m_s.shaded);
        m_s.levels.settle(told == ToldBlock::SomeLeft);
        return told == ToldBlock::Mixed;
    }

    /// The paper at the four samples of each pixel.
    const float (*etaOfSamples(const Block &block))[blockSize]
    {
        constexpr int half = blockSide / 2;
        for (int part = 0; part < 4; ++part) {
            const int left = part % 2 * half, top = part / 2 * half;
            m_frame.paper->fill({block.x + left, block.y + top, 0.5}, 1, m_s.sampleEta);
            for (int y = 0; y < blockSide; ++y)
                for (int x = 0; x < blockSide; ++x)
                    m_s.quarterEta[y % 2 * 2 + x % 2][(top + y / 2) * blockSide + left + x / 2] =
                        m_s.sampleEta[y * blockSide + x];
        }
        return m_s.quarterEta;
    }

    /// All nodes that meet the block.
    NodeList listWhole(const SceneStroke &stroke)
    {
        const int runs = findRunsOf(stroke);
        m_s.whole.resize(std::max(m_s.whole.size(), std::size_t(runs) * boxRun));
        Meeting meeting;
        m_frame.kernels->listNodes(stroke.boxes.boxes(), int(stroke.nodes.size()), m_s.runs.data(), runs,
                                   inWindow(0, 0), m_s.whole.data(), &meeting);
        return NodeList(m_s.whole.data(), std::size_t(meeting.count));
    }

    /// Replaces opacity and colour of the marked pixels by means over 2^k × 2^k points. `listed` has all nodes that
    /// meet the block.
    void supersample(const SceneStroke &stroke, NodeList listed)
    {
        const int runs = runsOf(listed);
        m_s.group.resize(std::max(m_s.group.size(), std::size_t(runs) * boxRun * gridSide * gridSide));
        for (int level = 1; level <= 6; ++level) {
            if (!m_s.levels.has(level))
                continue;
            const int side = std::max(1, blockSide >> level); // pixels along a side of a group of samples
            const int across = std::min(blockSide / side, gridSide), stride = across * side;
            for (int j = 0; j < blockSide; j += stride)
                for (int i = 0; i < blockSide; i += stride)
                    if (m_s.levels.has(level, i, j, stride))
                        supersampleGroups(stroke, runs, level, i, j, side, across);
        }
    }

    /// Cells from pixel (i, j) of the block on, in pixels from the corner of the window, as boxes of nodes are.
    Grid inWindow(int i, int j, int side = blockSide, int across = 1) const
    {
        const PixelRect &window = m_frame.grid.window;
        return {double(m_x + i - window.x), double(m_y + j - window.y), double(side), across, across};
    }

    int findRunsOf(const SceneStroke &stroke)
    {
        Meeting meeting;
        const Grid block = inWindow(0, 0);
        const Area area = areaOf(Rect::of(block.x, block.y, blockSide, blockSide));
        return findRuns(*m_frame.kernels, stroke, {0, stroke.nodes.size()}, area, m_s.runs, meeting);
    }

    /// The runs of boxes in which the listed nodes lie.
    int runsOf(NodeList listed)
    {
        m_s.runs.resize(std::max(m_s.runs.size(), listed.size()));
        int count = 0;
        for (const std::uint32_t node : listed)
            if (const std::uint32_t run = node / boxRun * boxRun; count == 0 || m_s.runs[std::size_t(count - 1)] != run)
                m_s.runs[std::size_t(count++)] = run;
        return count;
    }

    /// Evaluates `across` × `across` groups of pixels from (i, j) on.
    void supersampleGroups(const SceneStroke &stroke, int runs, int level, int i, int j, int side, int across)
    {
        std::array<Meeting, gridSide * gridSide> cells;
        m_frame.kernels->listNodes(stroke.boxes.boxes(), int(stroke.nodes.size()), m_s.runs.data(), runs,
                                   inWindow(i, j, side, across), m_s.group.data(), cells.data());
        const std::size_t room = std::size_t(runs) * boxRun;
        for (int k = 0; k < across * across; ++k) {
            const int x = i + k % across * side, y = j + k / across * side;
            const Meeting &cell = cells[std::size_t(k)];
            if (m_s.levels.has(level, x, y, side))
                supersampleGroup(stroke, NodeList(m_s.group.data() + std::size_t(k) * room, std::size_t(cell.count)),
                                 m_fill || shows(stroke, cell), level, x, y, side);
        }
    }

    void supersampleGroup(const SceneStroke &stroke, NodeList listed, bool shown, int level, int i, int j, int side)
    {
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
                if (m_s.levels.at(at) != level)
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
    LayerWalk m_walk;
    std::size_t m_open = 0; ///< how many layers are open: the place of the backdrop that is mixed into
    bool m_isRgb = false;   ///< whether that one is RGB
    BlockFill m_fill;       ///< of the stroke in hand
    bool m_isBare = false, m_isLevel = false; ///< whether it has nothing but its fill in the block, and is level within
    OverSteps *m_record = nullptr;            ///< what gets all that follows
    std::size_t m_recorded = 0;               ///< how many layers are open that were so when that began
    OverMap *m_map = nullptr;                 ///< of the stroke in hand
    const float *m_eta = nullptr;
};

/// Adds the strokes [from, to) to a block of the tile.
void addStrokes(BlockPainter &painter, TileStrokes &strokes, std::size_t block, std::size_t from, std::size_t to)
{
    for (std::size_t i = from; i < to; ++i)
        if (const auto nodes = strokes.nodesAt(i, block)) {
            const auto add = [&] {
                painter.add(strokes[i], *nodes, strokes.sumsAt(i, block), strokes.fillAt(i, block));
            };
            painter.goTo(strokes.placeOf(i));
            painter.addPart(strokes.placeOf(i), add);
            add();
        }
}

} // namespace

PaintedBlocks paintTile(const Frame &frame, const PixelRect &tile, TileStrokes &strokes, const TilePlan &plan,
                        const Edited &edited, float *rgba)
{
    thread_local const auto scratch = std::make_unique<Scratch>();
    // If the edited stroke misses this tile, all the rest lies above it.
    const bool isInTile = plan.below < strokes.size() && &strokes[plan.below] == edited.stroke;
    const std::size_t above = plan.below + (isInTile ? 1 : 0);
    PaintedBlocks painted{};
    std::size_t index = 0;
    for (int y = 0; y < tile.height; y += blockSide)
        for (int x = 0; x < tile.width; x += blockSide, ++index) {
            if (plan.storeOver || plan.applyOver) {
                const bool isMet = isInTile && strokes.nodesAt(plan.below, index);
                const bool wasMet = std::exchange(plan.layers->met[index], isMet) != 0;
                if (plan.onlyMet && !(edited.stroke ? isMet || wasMet : plan.layers->over[index].put(edited.layer)))
                    continue;
            }
            painted[index] = true;
            const TileLayers *layers = plan.haveUnder ? plan.layers : nullptr;
            BlockPainter painter(frame, plan.tile, index, tile.x + x, tile.y + y, layers, *scratch);
            addStrokes(painter, strokes, index, 0, plan.below);
            if (plan.storeUnder)
                painter.storeUnder(*plan.layers);
            addStrokes(painter, strokes, index, plan.below, above);
            if (plan.applyOver || plan.storeOver)
                painter.openAround(edited);
            if (plan.applyOver) {
                painter.apply(plan.layers->over[index]);
            } else {
                painter.record(plan.storeOver ? &plan.layers->over[index] : nullptr);
                addStrokes(painter, strokes, index, above, strokes.size());
                painter.goToEnd();
            }
            painter.finish(rgba + (std::size_t(y) * tile.width + x) * 4, tile.width,
                           std::min(blockSide, tile.width - x), std::min(blockSide, tile.height - y));
        }
    return painted;
}

} // namespace suffuse::cpu

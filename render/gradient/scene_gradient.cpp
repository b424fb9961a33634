#include "render/gradient/scene_gradient.h"

#include "render/gradient/tile_kernels.h"
#include "render/gradient/work_pool.h"

#include <algorithm>

namespace suffuse::gradient {

namespace {

constexpr int tilesAtOnce = 4; // A loop hands out so many.

} // namespace

template <class Number>
struct SceneGradient<Number>::Work {
    Threads threads;
    FlatScene scene; ///< drawn last
    NodeRules rules;
    SceneNodes nodes;
    StrokeFinder finder{tileKernels<Number>().findNodes};
    int columns = 0, rows = 0;
    std::vector<TileList> lists;
    std::vector<TileSlopes<Number>> slopes;
    std::vector<Number> picture;
    std::vector<NodeSum> sums;
    FlatGradient gradient;
    WorkPool<Number> pool;

    void prepare(const FlatScene &of);
    TilePlace placeOf(std::size_t tile) const;
    template <class Use>
    void forEachTile(Use use);
    void storePicture(const TilePlace &place, const ColourTile<Number> &rgb);
    void takeSlopes(const TilePlace &place, std::span<const Number> byRgb, ColourTile<Number> &out) const;
    void callLoss(const TilePlace &place, const PixelLoss &loss, ColourTile<Number> &out) const;
    const FlatGradient &addUp();
    void addTile(const TileList &list, const TileSlopes<Number> &tile);
};

template <class Number>
void SceneGradient<Number>::Work::prepare(const FlatScene &of)
{
    scene = of;
    columns = (scene.view.width + tileSide - 1) / tileSide, rows = (scene.view.height + tileSide - 1) / tileSide;
    const auto tiles = std::size_t(columns) * std::size_t(rows);
    lists.resize(tiles), slopes.resize(tiles);
    picture.resize(std::size_t(scene.view.width) * std::size_t(scene.view.height) * 3);
    placeNodes(scene, rules, nodes);
    finder.prepare(scene, nodes, columns, rows);
}

template <class Number>
TilePlace SceneGradient<Number>::Work::placeOf(std::size_t tile) const
{
    const int x = int(tile) % columns * tileSide, y = int(tile) / columns * tileSide;
    return {x, y, std::min(tileSide, scene.view.width - x), std::min(tileSide, scene.view.height - y)};
}

template <class Number>
template <class Use>
void SceneGradient<Number>::Work::forEachTile(Use use)
{
    const std::size_t tiles = lists.size();
    parallelFor((tiles + tilesAtOnce - 1) / tilesAtOnce, threads, [&](std::size_t group) {
        const typename WorkPool<Number>::Loan work(pool);
        for (std::size_t i = group * tilesAtOnce; i < std::min(tiles, (group + 1) * tilesAtOnce); ++i)
            use(i, placeOf(i), *work);
    });
}

template <class Number>
void SceneGradient<Number>::Work::storePicture(const TilePlace &place, const ColourTile<Number> &rgb)
{
    for (int y = 0; y < place.height; ++y) {
        Number *to =
            picture.data() + (std::size_t(place.y + y) * std::size_t(scene.view.width) + std::size_t(place.x)) * 3;
        for (int x = 0; x < place.width; ++x)
            for (int c = 0; c < 3; ++c)
                to[3 * x + c] = rgb.v[c][y * tileSide + x];
    }
}

template <class Number>
void SceneGradient<Number>::Work::takeSlopes(const TilePlace &place, std::span<const Number> byRgb,
                                             ColourTile<Number> &out) const
{
    for (auto &plane : out.v)
        std::fill_n(plane, tileSize, Number(0));
    for (int y = 0; y < place.height; ++y) {
        const Number *from =
            byRgb.data() + (std::size_t(place.y + y) * std::size_t(scene.view.width) + std::size_t(place.x)) * 3;
        for (int x = 0; x < place.width; ++x)
            for (int c = 0; c < 3; ++c)
                out.v[c][y * tileSide + x] = from[3 * x + c];
    }
}

template <class Number>
void SceneGradient<Number>::Work::callLoss(const TilePlace &place, const PixelLoss &loss, ColourTile<Number> &out) const
{
    Number by[3 * tileSide];
    for (auto &plane : out.v)
        std::fill_n(plane, tileSize, Number(0));
    for (int y = 0; y < place.height; ++y) {
        const std::size_t first = std::size_t(place.y + y) * std::size_t(scene.view.width) + std::size_t(place.x);
        loss(first, std::size_t(place.width), picture.data() + first * 3, by);
        for (int x = 0; x < place.width; ++x)
            for (int c = 0; c < 3; ++c)
                out.v[c][y * tileSide + x] = by[3 * x + c];
    }
}

template <class Number>
void SceneGradient<Number>::Work::addTile(const TileList &list, const TileSlopes<Number> &tile)
{
    for (std::size_t i = 0; i < list.nodes.size(); ++i) {
        NodeSum &sum = sums[list.nodes[i]];
        const NodeSlopes<Number> &by = tile.nodes[i];
        sum.weight += double(by.weight), sum.x += double(by.x), sum.y += double(by.y), sum.spread += double(by.spread);
    }
    const auto add = [](auto &to, const Number *by) {
        for (int c = 0; c < 3; ++c)
            to.colour[c] += double(by[c]);
        to.opacity += double(by[3]), to.granulation += double(by[4]);
    };
    for (std::size_t i = 0; i < list.strokes.size(); ++i) {
        const TileStroke &stroke = list.strokes[i];
        const FlatStroke &flat = scene.strokes[stroke.stroke];
        for (int j = 0; j < 3; ++j)
            gradient.strokes[stroke.stroke].xi[j] += double(tile.strokes[i].xi[j]);
        FillNumbers &fill = gradient.strokes[stroke.stroke].fill;
        if (flat.oneColour && flat.filled)
            add(fill, tile.strokes[i].constant);
        else if (flat.oneColour)
            add(gradient.segments[flat.first], tile.strokes[i].constant);
        for (std::uint32_t r = stroke.firstRun; r < stroke.endRun && !flat.oneColour; ++r) {
            const Number *by = tile.values.data() + r * values;
            if (list.runs[r].segment >= scene.segments.size())
                add(fill, by);
            else
                add(gradient.segments[list.runs[r].segment], by);
        }
    }
}

template <class Number>
const FlatGradient &SceneGradient<Number>::Work::addUp()
{
    sums.assign(nodes.nodes.size(), {});
    gradient.segments.assign(scene.segments.size(), {});
    gradient.strokes.assign(scene.strokes.size(), {});
    for (std::size_t i = 0; i < lists.size(); ++i)
        addTile(lists[i], slopes[i]);
    nodesToNumbers(scene, rules, sums, gradient);
    return gradient;
}

template <class Number>
SceneGradient<Number>::SceneGradient(Threads threads) : m(std::make_unique<Work>())
{
    m->threads = threads;
}

template <class Number>
SceneGradient<Number>::~SceneGradient() = default;

template <class Number>
void SceneGradient<Number>::choose(const FlatScene &scene, const Precision &precision)
{
    m->rules = chooseNodes(scene, precision, m->threads);
}

template <class Number>
std::span<const Number> SceneGradient<Number>::draw(const FlatScene &scene)
{
    m->prepare(scene);
    m->forEachTile([this](std::size_t i, const TilePlace &place, TileWork<Number> &work) {
        m->finder.list(place.x / tileSide, place.y / tileSide, m->lists[i]);
        work.begin(m->scene, place);
        work.draw(m->scene, m->nodes, m->lists[i], false);
        m->storePicture(place, work.rgb());
    });
    return m->picture;
}

template <class Number>
const FlatGradient &SceneGradient<Number>::backward(std::span<const Number> lossByRgb)
{
    m->forEachTile([&](std::size_t i, const TilePlace &place, TileWork<Number> &work) {
        work.begin(m->scene, place);
        work.draw(m->scene, m->nodes, m->lists[i], true);
        m->takeSlopes(place, lossByRgb, work.slopes());
        work.back(m->scene, m->nodes, m->lists[i], m->slopes[i]);
    });
    return m->addUp();
}

template <class Number>
const FlatGradient &SceneGradient<Number>::drawAndDifferentiate(const FlatScene &scene, const PixelLoss &loss)
{
    m->prepare(scene);
    m->forEachTile([&](std::size_t i, const TilePlace &place, TileWork<Number> &work) {
        m->finder.list(place.x / tileSide, place.y / tileSide, m->lists[i]);
        work.begin(m->scene, place);
        work.draw(m->scene, m->nodes, m->lists[i], true);
        m->storePicture(place, work.rgb());
        m->callLoss(place, loss, work.slopes());
        work.back(m->scene, m->nodes, m->lists[i], m->slopes[i]);
    });
    return m->addUp();
}

template <class Number>
std::span<const Number> SceneGradient<Number>::picture() const
{
    return m->picture;
}

template class SceneGradient<float>;
template class SceneGradient<double>;

} // namespace suffuse::gradient

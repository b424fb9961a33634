#include "render/reference/band.h"

#include <cmath>
#include <numbers>

namespace suffuse::reference {

namespace {

/// How far a pixel's square reaches from its centre along the canvas axes: px/2 where they are parallel, else px/√2.
double halfPixel(const View &view)
{
    const bool parallel = std::abs(std::remainder(view.rotation, std::numbers::pi / 2)) < 1e-12;
    return view.px() * (parallel ? 0.5 : std::numbers::sqrt2 / 2);
}

/// A rectangle of the canvas as a box in the picture, which may be a little too large.
Rect boxInPixels(const Rect &canvas, const View &view)
{
    Rect box;
    for (Point corner : {Point{canvas.left, canvas.top},
                         {canvas.right, canvas.top},
                         {canvas.left, canvas.bottom},
                         {canvas.right, canvas.bottom}})
        box.include(view.toPixels(corner));
    return box.grown(1);
}

} // namespace

Spot &BandPainter::spotAt(double x, double y)
{
    return m_spots[std::size_t(y - m_first) * std::size_t(m_scene.view.width) + std::size_t(x)];
}

const std::vector<float> &BandPainter::draw(int first, int count, const std::atomic<bool> *cancel)
{
    m_first = first;
    m_count = count;
    m_stored.clear();
    m_spots.assign(std::size_t(m_scene.view.width) * std::size_t(count),
                   bareSpot(m_scene.background, m_scene.transparent));
    const Rgb canvas = rgbOfRyb(bareSpot(m_scene.background, m_scene.transparent).colour);
    for (Spot &spot : m_spots)
        spot.coverage = 0;
    if (!addItems(m_scene.items, m_scene.transparent ? nullptr : &canvas, cancel))
        return m_stored;
    m_stored.reserve(m_spots.size() * 4);
    for (const Spot &spot : m_spots)
        for (double value : storedColour(spot, m_scene.transparent))
            m_stored.push_back(float(value));
    return m_stored;
}

bool BandPainter::addItems(const std::vector<Item> &items, const Rgb *canvas, Cancelled cancel)
{
    for (std::size_t i = 0; i < items.size(); ++i)
        if (!items[i].isMask && !addItem(items, i, canvas, cancel))
            return false;
    return true;
}

bool BandPainter::addItem(const std::vector<Item> &items, std::size_t place, const Rgb *canvas, Cancelled cancel)
{
    if (cancel && cancel->load(std::memory_order_relaxed))
        return false;
    const Item &item = items[place];
    if (!item.isGroup) {
        if (item.stroke != Item::nothing)
            addStroke(m_scene.strokes[item.stroke]);
        return true;
    }
    if (!item.isIsolated)
        return addItems(item.inside, canvas, cancel);
    std::vector<double> share(m_spots.size(), 1);
    if (item.base != Item::nothing && !bound(items, item.base, share, cancel))
        return false;
    for (std::size_t i = 0; i < item.inside.size(); ++i)
        if (item.inside[i].isMask && item.inside[i].isSeen() && !bound(item.inside, i, share, cancel))
            return false;
    std::vector<Spot> below(m_spots.size());
    m_spots.swap(below);
    if (!addItems(item.inside, nullptr, cancel))
        return false;
    for (std::size_t i = 0; i < below.size(); ++i)
        put(item, share[i], m_spots[i], canvas, below[i]);
    m_spots.swap(below);
    return true;
}

bool BandPainter::bound(const std::vector<Item> &items, std::size_t by, std::vector<double> &share, Cancelled cancel)
{
    std::vector<Item> alone(items);
    alone[by].blend = BlendMode::Normal; // How it is put there does not matter, but what it covers.
    std::vector<Spot> spots(m_spots.size());
    m_spots.swap(spots);
    const bool done = addItem(alone, by, nullptr, cancel);
    m_spots.swap(spots);
    for (std::size_t i = 0; i < share.size(); ++i)
        share[i] *= spots[i].coverage;
    return done;
}

void BandPainter::addStroke(const StrokeSource &stroke)
{
    SampleBlock block{{0.5, m_first + 0.5}, 1, m_scene.view.width, m_count};
    const auto columns = block.columns(stroke.box.left - 1, stroke.box.right + 1);
    const auto rows = block.rows(stroke.box.top - 1, stroke.box.bottom + 1);
    if (columns.isEmpty() || rows.isEmpty())
        return;
    block = {{columns.from + 0.5, m_first + rows.from + 0.5}, 1, columns.to - columns.from, rows.to - rows.from};
    if (findLevels(stroke, block))
        mixSupersampled(stroke, block);
    mixPlain(stroke, block);
}

bool BandPainter::findLevels(const StrokeSource &stroke, const SampleBlock &block)
{
    m_levels.assign(std::size_t(block.nx) * std::size_t(block.ny), 0);
    const View &view = m_scene.view;
    const double half = halfPixel(view);
    bool any = false;
    for (const SegmentSource &segment : stroke.segments) {
        if (segment.level == 0)
            continue;
        const Rect reached = segment.influence.grown(half);
        const Rect box = boxInPixels(reached, view);
        const auto columns = block.columns(box.left, box.right);
        const auto rows = block.rows(box.top, box.bottom);
        for (int j = rows.from; j < rows.to; ++j) {
            for (int i = columns.from; i < columns.to; ++i) {
                std::uint8_t &level = m_levels[std::size_t(j) * std::size_t(block.nx) + std::size_t(i)];
                if (level < segment.level &&
                    reached.contains(view.toCanvas(block.first + Point{double(i), double(j)}))) {
                    level = std::uint8_t(segment.level);
                    any = true;
                }
            }
        }
    }
    if (stroke.fill && stroke.fill->level() > 0)
        addFillLevels(*stroke.fill, block, any);
    return any;
}

void BandPainter::addFillLevels(const FillSource &fill, const SampleBlock &block, bool &any)
{
    for (int j = 0; j < block.ny; ++j)
        for (int i = 0; i < block.nx; ++i) {
            const Point centre = block.first + Point{double(i), double(j)};
            std::uint8_t &level = m_levels[std::size_t(j) * std::size_t(block.nx) + std::size_t(i)];
            if (level < fill.level() && fill.isNear(Rect{centre.x, centre.y, centre.x, centre.y}.grown(0.5))) {
                level = std::uint8_t(fill.level());
                any = true;
            }
        }
}

void BandPainter::mixAt(const StrokeSource &stroke, Point pixel, const Paint &paint)
{
    mix(spotAt(pixel.x, pixel.y), stroke.mix, stroke.picture ? stroke.picture->shownAtPixel(pixel, paint) : paint);
}

/// The paint of a sample of size `step`. What a crisp fill covers of it and what it leaves are two kinds of spot.
Paint BandPainter::paintAt(const StrokeSource &stroke, int i, int j, Point pixel, double step) const
{
    const View &view = m_scene.view;
    const auto paintOfPart = [&](bool inside) {
        const LocalDensity local = m_sums.at(stroke, i, j, inside);
        const double eta = local.granulation < 1 ? m_scene.paper.at(view.toCanvas(pixel), view.px() * step) : 1;
        return paintOf(local, eta, step);
    };
    const double covered = m_sums.covered(i, j);
    if (covered <= 0)
        return paintOfPart(false);
    if (covered >= 1)
        return paintOfPart(true);
    const Paint in = paintOfPart(true), out = m_sums.laysOutside(i, j) ? paintOfPart(false) : Paint();
    Paint mean{covered * in.opacity + (1 - covered) * out.opacity, {}};
    for (std::size_t c = 0; c < 3 && mean.opacity > 0; ++c)
        mean.colour[c] =
            (covered * in.opacity * in.colour[c] + (1 - covered) * out.opacity * out.colour[c]) / mean.opacity;
    return mean;
}

void BandPainter::mixPlain(const StrokeSource &stroke, const SampleBlock &block)
{
    if (std::find(m_levels.begin(), m_levels.end(), 0) == m_levels.end())
        return;
    m_sums.evaluate(stroke, block);
    for (int j = 0; j < block.ny; ++j) {
        for (int i = 0; i < block.nx; ++i) {
            if (m_levels[std::size_t(j) * std::size_t(block.nx) + std::size_t(i)] > 0 || m_sums.isEmpty(i, j))
                continue;
            const Point pixel = block.first + Point{double(i), double(j)};
            mixAt(stroke, pixel, paintAt(stroke, i, j, pixel, 1));
        }
    }
}

void BandPainter::mixSupersampled(const StrokeSource &stroke, const SampleBlock &block)
{
    for (int j = 0; j < block.ny; ++j) {
        const std::uint8_t *levels = &m_levels[std::size_t(j) * std::size_t(block.nx)];
        for (int i = 0; i < block.nx;) {
            const int level = levels[i];
            if (level == 0) {
                ++i;
                continue;
            }
            // Neighbours of one level are computed together, at most 8192 samples at once.
            const int longest = std::max(1, 8192 >> (2 * level));
            int run = 1;
            while (run < longest && i + run < block.nx && levels[i + run] == level)
                ++run;
            const int n = 1 << level;
            const Point corner = block.first + Point{i - 0.5, j - 0.5};
            const SampleBlock samples{corner + Point{0.5 / n, 0.5 / n}, 1.0 / n, n * run, n};
            m_sums.evaluate(stroke, samples);
            for (int r = 0; r < run; ++r)
                mixAt(stroke, block.first + Point{double(i + r), double(j)},
                      supersampled(stroke, samples, r * n, level));
            i += run;
        }
    }
}

Paint BandPainter::supersampled(const StrokeSource &stroke, const SampleBlock &samples, int column, int level)
{
    const int n = 1 << level;
    double opacity = 0;
    Ryb colour{};
    for (int j = 0; j < n; ++j) {
        for (int i = column; i < column + n; ++i) {
            if (m_sums.isEmpty(i, j))
                continue;
            const Point at = samples.first + samples.step * Point{double(i), double(j)};
            const Paint paint = paintAt(stroke, i, j, at, samples.step);
            opacity += paint.opacity;
            for (std::size_t c = 0; c < 3; ++c)
                colour[c] += paint.opacity * paint.colour[c];
        }
    }
    for (double &c : colour)
        c = opacity > 0 ? c / opacity : 0;
    return {opacity / (n * n), colour};
}

} // namespace suffuse::reference

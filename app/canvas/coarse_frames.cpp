#include "app/canvas/coarse_frames.h"

#include "app/canvas/view_transform.h"
#include "model/painting/influence.h"
#include "render/threads/parallel.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace suffuse {

namespace {

/// A pixel's four channels in lanes of 16 bits, so that they are scaled together.
using Lanes = std::uint64_t;
constexpr Lanes evenBytes = 0x00FF00FF, allLanes = 0x00FF00FF00FF00FF;

Lanes lanesOf(std::uint32_t argb)
{
    return Lanes(argb & evenBytes) | Lanes((argb >> 8) & evenBytes) << 32;
}

std::uint32_t pixelOf(Lanes lanes)
{
    return std::uint32_t(lanes) | std::uint32_t(lanes >> 32) << 8;
}

/// `weight` of 256 goes to `b`.
Lanes mixed(Lanes a, Lanes b, unsigned weight)
{
    return ((a * (256 - weight) + b * weight) >> 8) & allLanes;
}

/// Between which two pixels of a row a place lies, and how near to the second, of 256.
struct Between {
    int first = 0, second = 0;
    unsigned weight = 0;
};

/// Along one side: `size` pixels of the view, `coarse` of those that were drawn, middle on middle.
Between betweenAt(int pixel, int size, int coarse, int factor)
{
    const double at = (pixel + 0.5 - 0.5 * size) / factor + 0.5 * coarse - 0.5;
    const double first = std::floor(at);
    const auto inside = [coarse](double i) { return int(std::clamp(i, 0.0, coarse - 1.0)); };
    return {inside(first), inside(first + 1), unsigned(256 * (at - first))};
}

/// Of a whole side.
std::vector<Between> betweensOf(int size, int coarse, int factor)
{
    std::vector<Between> places(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i)
        places[std::size_t(i)] = betweenAt(i, size, coarse, factor);
    return places;
}

void enlargeRect(const Picture8 &from, Picture8 &to, const PixelRect &r, std::span<const Between> columns,
                 std::span<const Between> rowPlaces)
{
    columns = columns.subspan(std::size_t(r.x), std::size_t(r.width));
    const int left = columns.front().first, right = columns.back().second;
    std::vector<Lanes> row(std::size_t(right - left + 1));
    for (int y = r.y; y < r.y + r.height; ++y) {
        const Between &rows = rowPlaces[std::size_t(y)];
        const std::uint32_t *upper = from.argb.data() + std::size_t(rows.first) * from.width;
        const std::uint32_t *lower = from.argb.data() + std::size_t(rows.second) * from.width;
        for (int x = left; x <= right; ++x)
            row[std::size_t(x - left)] = mixed(lanesOf(upper[x]), lanesOf(lower[x]), rows.weight);
        std::uint32_t *out = to.argb.data() + std::size_t(y) * to.width + r.x;
        for (const Between &c : columns)
            *out++ = pixelOf(mixed(row[std::size_t(c.first - left)], row[std::size_t(c.second - left)], c.weight));
    }
}

/// A rectangle of the coarse picture in pixels of the view.
PixelRect enlarged(const PixelRect &r, const View &view, const View &coarse, int factor)
{
    const auto edge = [factor](int at, int size, int coarseSize) {
        return std::clamp(int(std::lround((at - 0.5 * coarseSize) * factor + 0.5 * size)), 0, size);
    };
    const int left = edge(r.x, view.width, coarse.width), right = edge(r.x + r.width, view.width, coarse.width);
    const int top = edge(r.y, view.height, coarse.height), bottom = edge(r.y + r.height, view.height, coarse.height);
    return {left, top, right - left, bottom - top};
}

/// Squares of the view, touched or not.
class Squares {
public:
    static constexpr int side = 32;

    explicit Squares(const View &view)
        : m_view(view), m_pixelOf(view, view.centre), m_columns((view.width + side - 1) / side),
          m_rows((view.height + side - 1) / side), m_touched(std::size_t(m_columns) * std::size_t(m_rows))
    {}

    void touch(const Rect &area)
    {
        if (area.isEmpty())
            return;
        Rect pixels;
        for (const Point corner : {Point{area.left, area.top}, Point{area.right, area.top},
                                   Point{area.left, area.bottom}, Point{area.right, area.bottom}})
            pixels.include(m_pixelOf(corner - m_view.centre));
        const auto at = [](double pixel, int count) {
            return int(std::clamp(std::floor(pixel / side), 0.0, count - 1.0));
        };
        if (!pixels.intersects(Rect::of(0, 0, m_view.width, m_view.height)))
            return;
        const int left = at(pixels.left, m_columns), right = at(pixels.right, m_columns);
        for (int y = at(pixels.top, m_rows); y <= at(pixels.bottom, m_rows); ++y)
            std::fill_n(m_touched.begin() + std::ptrdiff_t(y) * m_columns + left, right - left + 1, 1);
    }
    double pixels() const { return double(std::count(m_touched.begin(), m_touched.end(), 1)) * side * side; }

private:
    View m_view;
    PixelMap m_pixelOf;
    int m_columns, m_rows;
    std::vector<char> m_touched;
};

/// Calls visit(stroke) for those of either list that the other lacks, roughly: most stand in the same order.
template <typename Visit>
void forEachThatDiffers(const StrokeList &before, const StrokeList &after, Visit visit)
{
    constexpr std::size_t near = 8; // places that are looked at
    const auto isNear = [&](StrokeId id, std::size_t from) {
        for (std::size_t i = from; i < std::min(from + near, before.size()); ++i)
            if (before[i]->id == id)
                return true;
        return false;
    };
    std::size_t i = 0, j = 0;
    while (i < before.size() || j < after.size()) {
        const Stroke *was = i < before.size() ? before[i].get() : nullptr;
        const Stroke *is = j < after.size() ? after[j].get() : nullptr;
        const bool same = was && is && (was == is || was->id == is->id);
        const bool came = is && (!was || (!same && !isNear(is->id, i)));
        if (same && was == is) {
            ++i, ++j;
            continue;
        }
        if (!came)
            visit(*was), ++i;
        if (came || same)
            visit(*is), ++j;
    }
}

} // namespace

View CoarseFrames::coarseView(const View &view) const
{
    View coarse = view; // the same point in the middle
    coarse.scale = view.scale / m_factor;
    coarse.width = (view.width + m_factor - 1) / m_factor;
    coarse.height = (view.height + m_factor - 1) / m_factor;
    return coarse;
}

bool CoarseFrames::isAt(const RenderRequest &request) const
{
    return m_at && m_at->painting == request.painting && m_at->time == request.time && m_at->view == request.view;
}

Result<RenderStats> CoarseFrames::draw(const RenderRequest &request, const std::atomic<bool> *cancel)
{
    RenderRequest coarse = request;
    coarse.view = coarseView(request.view);
    Result<RenderStats> stats = m_renderer->render(coarse, m_picture, cancel);
    if (!stats)
        return stats;
    if (stats->cancelled)
        m_at.reset();
    else
        m_at = request;
    for (PixelRect &r : stats->dirty)
        r = enlarged(r, request.view, coarse.view, m_factor);
    std::erase_if(stats->dirty, [](const PixelRect &r) { return r.isEmpty(); });
    return stats;
}

void CoarseFrames::enlargeInto(Picture8 &picture, const std::vector<PixelRect> &rects, int threads) const
{
    const std::vector<Between> columns = betweensOf(picture.width, m_picture.width, m_factor);
    const std::vector<Between> rows = betweensOf(picture.height, m_picture.height, m_factor);
    parallelFor(rects.size(), threads,
                [&](std::size_t i) { enlargeRect(m_picture, picture, rects[i], columns, rows); });
}

double reachedPixels(const Painting &painting, const View &view, Microseconds time)
{
    Squares squares(view);
    for (const StrokePtr &stroke : painting.strokes)
        for (const Segment &segment : stroke->segments)
            squares.touch(influenceOf(*stroke, segment, time));
    return squares.pixels();
}

Difference differenceOf(const Painting &before, const Painting &after, const View &view, Microseconds time)
{
    Difference difference;
    Squares squares(view);
    const auto touch = [&](const Stroke &stroke) {
        ++difference.strokes;
        for (const Segment &segment : stroke.segments)
            squares.touch(influenceOf(stroke, segment, time));
    };
    if (before.strokes.size() == after.strokes.size())
        before.strokes.forEachDifference(after.strokes, [&](std::size_t i) {
            touch(*before.strokes[i]);
            touch(*after.strokes[i]);
        });
    else
        forEachThatDiffers(before.strokes, after.strokes, touch);
    difference.pixels = squares.pixels();
    return difference;
}

} // namespace suffuse

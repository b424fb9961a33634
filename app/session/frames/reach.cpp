#include "app/session/frames/reach.h"

#include "model/painting/influence.h"
#include "render/pixel_map.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace suffuse {

namespace {

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

double reachedPixels(const Painting &painting, const View &view, Microseconds time)
{
    Squares squares(view);
    for (const StrokePtr &stroke : painting.strokes) {
        squares.touch(influenceOfFill(*stroke, time));
        for (const Segment &segment : stroke->segments)
            squares.touch(influenceOf(*stroke, segment, time));
    }
    return squares.pixels();
}

Difference differenceOf(const Painting &before, const Painting &after, const View &view, Microseconds time)
{
    Difference difference;
    Squares squares(view);
    const auto touch = [&](const Stroke &stroke) {
        ++difference.strokes;
        squares.touch(influenceOfFill(stroke, time));
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

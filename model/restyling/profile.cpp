#include "model/restyling/profile.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

double profileValueAt(const std::vector<Point> &run, double place)
{
    const auto after = std::ranges::upper_bound(run, place, {}, &Point::x);
    if (after == run.begin())
        return run.front().y;
    if (after == run.end())
        return run.back().y;
    const Point a = *(after - 1), b = *after;
    return std::lerp(a.y, b.y, (place - a.x) / (b.x - a.x));
}

void keepProfile(const std::vector<Point> &points, std::size_t first, std::size_t last, double tolerance,
                 std::vector<bool> &kept)
{
    const Point a = points[first], b = points[last];
    std::size_t farthest = first;
    double greatest = tolerance;
    for (std::size_t k = first + 1; k < last; ++k) {
        const double share = b.x > a.x ? (points[k].x - a.x) / (b.x - a.x) : 0;
        if (const double off = std::abs(points[k].y - std::lerp(a.y, b.y, share)); off > greatest) {
            greatest = off;
            farthest = k;
        }
    }
    if (farthest == first)
        return;
    kept[farthest] = true;
    keepProfile(points, first, farthest, tolerance, kept);
    keepProfile(points, farthest, last, tolerance, kept);
}

} // namespace

std::vector<Point> sampledProfile(const std::vector<std::vector<Point>> &runs, int count)
{
    std::vector<Point> profile;
    for (int i = 0; i < count; ++i) {
        const double place = double(i) / (count - 1);
        double sum = 0;
        int counted = 0;
        for (const std::vector<Point> &run : runs)
            if (!run.empty()) {
                sum += profileValueAt(run, place);
                ++counted;
            }
        profile.push_back({place, counted > 0 ? sum / counted : 0});
    }
    return profile;
}

std::vector<Point> simplifiedProfile(const std::vector<Point> &points, double tolerance)
{
    if (points.size() < 3)
        return points;
    std::vector<bool> kept(points.size());
    kept.front() = kept.back() = true;
    keepProfile(points, 0, points.size() - 1, tolerance, kept);
    std::vector<Point> result;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (kept[k])
            result.push_back(points[k]);
    return result;
}

} // namespace suffuse

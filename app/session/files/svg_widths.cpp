#include "app/session/files/svg_widths.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace suffuse {

namespace {

constexpr int longestWalk = 64; ///< a line is put into the cells of at most so many of its points

using Cell = std::pair<int, int>;

double distance(Point a, Point b)
{
    return std::hypot(a.x - b.x, a.y - b.y);
}

Point along(const SvgLine &line, double share)
{
    return {line.from.x + share * (line.to.x - line.from.x), line.from.y + share * (line.to.y - line.from.y)};
}

Point nearestOn(const SvgLine &line, Point p)
{
    const double dx = line.to.x - line.from.x, dy = line.to.y - line.from.y, square = dx * dx + dy * dy;
    const double share = square > 0 ? ((p.x - line.from.x) * dx + (p.y - line.from.y) * dy) / square : 0;
    return along(line, std::clamp(share, 0.0, 1.0));
}

/// Whether `to` lies beside the line rather than ahead of it, as seen from its middle.
bool isBeside(const SvgLine &line, Point middle, Point to)
{
    const double length = distance(line.from, line.to), away = distance(middle, to);
    const double ahead = (to.x - middle.x) * (line.to.x - line.from.x) + (to.y - middle.y) * (line.to.y - line.from.y);
    return std::abs(ahead) <= 0.5 * length * away; // at most 30° off
}

bool isRightOf(const SvgLine &line, Point middle, Point p)
{
    return (line.to.x - line.from.x) * (p.y - middle.y) > (line.to.y - line.from.y) * (p.x - middle.x);
}

} // namespace

std::vector<double> joinedHalfWidths(const std::vector<SvgLine> &lines)
{
    double cell = 1e-3;
    for (const SvgLine &line : lines)
        cell = std::max(cell, 2 * line.reach);
    const auto cellOf = [cell](Point p) { return Cell(int(std::floor(p.x / cell)), int(std::floor(p.y / cell))); };
    std::map<Cell, std::vector<std::size_t>> grid;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const int steps =
            int(std::clamp(std::ceil(2 * distance(lines[i].from, lines[i].to) / cell), 1.0, double(longestWalk)));
        for (int k = 0; k <= steps; ++k)
            if (auto &there = grid[cellOf(along(lines[i], double(k) / steps))]; there.empty() || there.back() != i)
                there.push_back(i);
    }
    std::vector<double> halves;
    for (const SvgLine &line : lines) {
        const Point middle = along(line, 0.5);
        const Cell at = cellOf(middle);
        double nearest[] = {2 * line.reach, 2 * line.reach}; // distances to the left and to the right
        bool found[] = {false, false};
        for (int x = at.first - 1; x <= at.first + 1; ++x)
            for (int y = at.second - 1; y <= at.second + 1; ++y) {
                const auto there = grid.find({x, y});
                if (there == grid.end())
                    continue;
                for (const std::size_t other : there->second) {
                    const Point to = nearestOn(lines[other], middle);
                    const double away = distance(middle, to);
                    const bool right = isRightOf(line, middle, to);
                    if (away > 0 && away <= nearest[right] && away <= line.reach + lines[other].reach &&
                        isBeside(line, middle, to)) {
                        nearest[right] = away;
                        found[right] = true;
                    }
                }
            }
        double half = line.half;
        for (const bool right : {false, true})
            if (found[right])
                half = std::max(half, 0.5 * nearest[right]);
        halves.push_back(half);
    }
    return halves;
}

} // namespace suffuse

#include "render/drawing/path_coverage.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr double pathFlatness = 0.001; // px

} // namespace

PathCoverage::PathCoverage(int width, int top, int height)
    : m_width(width), m_top(top), m_height(height), m_sums(std::size_t(width + 2) * std::size_t(height))
{
    clear();
}

void PathCoverage::clear()
{
    m_first = m_width, m_last = 0;
}

void PathCoverage::add(const Cubic &curve)
{
    const Rect box = curve.controlBox();
    if (box.bottom <= m_top || box.top >= m_top + m_height)
        return;
    if (box.left >= m_width) { // What lies within may go on up to it.
        m_last = m_width;
        return;
    }
    m_first = std::min(m_first, std::max(0, int(std::floor(std::max(box.left, 0.0)))));
    m_last = std::max(m_last, std::clamp(int(std::ceil(std::clamp(box.right, 0.0, double(m_width)))) + 1, 1, m_width));
    const Point a = curve.p[0] - 2 * curve.p[1] + curve.p[2], b = curve.p[1] - 2 * curve.p[2] + curve.p[3];
    const double bend = 6 * std::sqrt(std::max(dot(a, a), dot(b, b)));
    const int count = int(std::clamp(std::ceil(std::sqrt(bend / (8 * pathFlatness))), 1.0, 1000.0));
    Point from = curve.p[0];
    for (int k = 1; k <= count; ++k) {
        const Point to = k == count ? curve.p[3] : curve.at(double(k) / count);
        addLine(from, to);
        from = to;
    }
}

void PathCoverage::addLine(Point a, Point b)
{
    if (a.y == b.y)
        return;
    const float sign = a.y < b.y ? 1.0f : -1.0f;
    if (a.y > b.y)
        std::swap(a, b);
    const double top = std::max(a.y - m_top, 0.0), bottom = std::min(b.y - m_top, double(m_height));
    if (!(top < bottom))
        return;
    const double slope = (b.x - a.x) / (b.y - a.y);
    double x = a.x + (top + m_top - a.y) * slope;
    for (int row = int(top); row < m_height && double(row) < bottom; ++row) {
        const double height = std::min(row + 1.0, bottom) - std::max(double(row), top), next = x + slope * height;
        const double left = std::clamp(std::min(x, next), 0.0, double(m_width));
        const double right = std::clamp(std::max(x, next), 0.0, double(m_width));
        float *sums = m_sums.data() + std::size_t(row) * std::size_t(m_width + 2);
        const float all = sign * float(height);
        const int from = int(left), to = int(std::ceil(right));
        if (to <= from + 1) {
            const float within = all * float(1 - (0.5 * (left + right) - from));
            sums[from] += within;
            sums[from + 1] += all - within;
        } else {
            // The share of the line in each column counts for that column in part, and for all right of it.
            const double each = 1 / (right - left);
            double before = 0;
            for (int column = from; column < to; ++column) {
                const double l = std::max(left, double(column)), r = std::min(right, column + 1.0);
                const double until = (r - left) * each, share = until - before;
                const float within = all * float(share * (column + 1 - 0.5 * (l + r)));
                sums[column] += within;
                sums[column + 1] += all * float(share) - within;
                before = until;
            }
        }
        x = next;
    }
}

void PathCoverage::takeRow(int row, std::vector<float> &out)
{
    out.resize(std::size_t(m_width));
    float *sums = m_sums.data() + std::size_t(row) * std::size_t(m_width + 2);
    float sum = 0;
    for (int x = m_first; x < m_last; ++x) {
        sum += sums[x];
        out[std::size_t(x)] = std::min(std::abs(sum), 1.0f);
        sums[x] = 0;
    }
    std::fill(sums + m_last, sums + std::min(m_last + 2, m_width + 2), 0.0f);
}

} // namespace suffuse

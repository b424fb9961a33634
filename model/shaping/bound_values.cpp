#include "model/shaping/bound_values.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr std::size_t mostKinds = 256; ///< sets of values that are looked through for one that is the same

bool haveSameValues(Segment a, const Segment &b)
{
    a.bezier = b.bezier;
    a.node = b.node;
    return a == b;
}

/// How far a point is from a curve.
double fromCurve(const Cubic &curve, Point p)
{
    constexpr int steps = 16;
    double best = 0, least = HUGE_VAL;
    for (int i = 0; i <= steps; ++i)
        if (const double far = length(curve.at(double(i) / steps) - p); far < least) {
            least = far;
            best = double(i) / steps;
        }
    double low = std::max(0.0, best - 1.0 / steps), high = std::min(1.0, best + 1.0 / steps);
    for (int i = 0; i < 40; ++i) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        if (length(curve.at(a) - p) < length(curve.at(b) - p))
            high = b;
        else
            low = a;
    }
    return std::min(least, length(curve.at(0.5 * (low + high)) - p));
}

} // namespace

BoundValues::BoundValues(const Stroke &to, const std::vector<StrokePtr> &others)
{
    add(to, to);
    for (const StrokePtr &other : others)
        if (other->id != to.id)
            add(*other, to);
    spread();
}

void BoundValues::add(const Stroke &stroke, const Stroke &to)
{
    const Point shift = stroke.origin - to.origin;
    for (const Segment &segment : stroke.segments) {
        if (segment.takesPaint())
            continue;
        Segment values = segment;
        values.start = false;
        if (!values.style && !(stroke.style == to.style))
            values.style = stroke.style;
        else if (values.style && *values.style == to.style)
            values.style.reset();
        std::size_t number = m_values.size();
        for (std::size_t i = 0; i < std::min(mostKinds, m_values.size()) && number == m_values.size(); ++i)
            if (haveSameValues(values, m_values[i]))
                number = i;
        if (number == m_values.size())
            m_values.push_back(std::move(values));
        Cubic curve = offsetsOf(segment);
        for (Point &p : curve.p)
            p = p + shift;
        m_box = m_box.united(curve.controlBox());
        m_curves.push_back({curve, number});
    }
}

/// Puts samples of all curves into a grid, so many that each place of a curve is near one.
void BoundValues::spread()
{
    double around = 0;
    for (const Source &source : m_curves)
        around += polygonLength(source.curve);
    const double side = std::max(m_box.width(), m_box.height());
    m_step = std::max({around / (4 * double(std::max<std::size_t>(1, m_curves.size()))), side / 4096, 1e-30});
    const double samples = around / m_step + double(m_curves.size());
    m_cell = std::max(m_step, side / std::sqrt(samples + 1));
    m_columns = std::int64_t(m_box.width() / m_cell) + 1;
    m_rows = std::int64_t(m_box.height() / m_cell) + 1;
    for (std::uint32_t k = 0; k < m_curves.size(); ++k) {
        const int pieces = 1 + int(polygonLength(m_curves[k].curve) / m_step);
        for (int i = 0; i <= pieces; ++i) {
            const Point at = m_curves[k].curve.at(double(i) / pieces);
            m_cells[cellOf(at)].push_back({at, k});
        }
    }
}

std::int64_t BoundValues::cellOf(Point p) const
{
    const auto place = [this](double at, double from, std::int64_t count) {
        return std::int64_t(std::clamp((at - from) / m_cell, 0.0, double(count - 1)));
    };
    return place(p.y, m_box.top, m_rows) * m_columns + place(p.x, m_box.left, m_columns);
}

BoundValues::Found BoundValues::valuesAt(const Cubic &curve) const
{
    if (m_values.size() == 1)
        return {};
    const Point middle = curve.at(0.5);
    const std::int64_t cell = cellOf(middle), column = cell % m_columns, row = cell / m_columns;
    std::vector<std::uint32_t> candidates;
    double least = HUGE_VAL;
    // Rings of cells around the middle, until no farther one can hold a nearer curve.
    for (std::int64_t ring = 0; ring <= std::max(m_columns, m_rows); ++ring) {
        if (double(ring - 1) * m_cell > least + m_step)
            break;
        for (std::int64_t y = std::max<std::int64_t>(0, row - ring); y <= std::min(m_rows - 1, row + ring); ++y) {
            const bool isEdge = y == row - ring || y == row + ring;
            for (std::int64_t x = column - ring; x <= column + ring; x += isEdge || ring == 0 ? 1 : 2 * ring) {
                if (x < 0 || x >= m_columns)
                    continue;
                const auto found = m_cells.find(y * m_columns + x);
                if (found == m_cells.end())
                    continue;
                for (const Sample &sample : found->second) {
                    least = std::min(least, length(sample.at - middle));
                    candidates.push_back(sample.curve);
                }
            }
        }
    }
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    // Where outlines lie on each other within rounding, the first one counts.
    const double alike = 1e-6 * std::max({m_box.width(), m_box.height(), std::abs(m_box.left), std::abs(m_box.right),
                                          std::abs(m_box.top), std::abs(m_box.bottom)});
    std::size_t best = 0;
    double farthest = HUGE_VAL;
    for (const std::uint32_t k : candidates) {
        double far = 0;
        for (const double t : {0.5, 0.2, 0.8})
            if ((far = std::max(far, fromCurve(m_curves[k].curve, curve.at(t)))) >= farthest)
                break;
        if (far < farthest - alike) {
            farthest = far;
            best = m_curves[k].values;
        }
    }
    return {best, farthest <= 4 * alike};
}

} // namespace suffuse

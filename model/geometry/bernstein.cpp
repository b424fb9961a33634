#include "model/geometry/bernstein.h"

namespace suffuse {

namespace {

constexpr std::size_t mostCoefficients = 7;
using Coefficients = std::array<double, mostCoefficients>;

/// De Casteljau's algorithm in the middle; `right` gets the upper half.
void halve(Coefficients &left, Coefficients &right, std::size_t n)
{
    right = left;
    for (std::size_t level = 1; level < n; ++level)
        for (std::size_t i = 0; i + level < n; ++i)
            right[i] = 0.5 * (right[i] + right[i + 1]);
    // right[i] now is the polynomial from level n − 1 − i. The left half is on the other side of the triangle.
    Coefficients row = left;
    for (std::size_t level = 0; level < n; ++level) {
        left[level] = row[0];
        for (std::size_t i = 0; i + level + 1 < n; ++i)
            row[i] = 0.5 * (row[i] + row[i + 1]);
    }
}

int signChanges(const Coefficients &f, std::size_t n)
{
    int changes = 0;
    double last = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (f[i] == 0)
            continue;
        changes += last != 0 && (f[i] > 0) != (last > 0);
        last = f[i];
    }
    return changes;
}

class RootFinder {
public:
    explicit RootFinder(std::span<const double> f) : m_f(f) {}

    std::vector<double> find()
    {
        Coefficients f{};
        std::copy(m_f.begin(), m_f.end(), f.begin());
        if (f[0] == 0)
            m_roots.push_back(0);
        search(f, 0, 1);
        if (m_f.back() == 0)
            m_roots.push_back(1);
        std::sort(m_roots.begin(), m_roots.end());
        m_roots.erase(std::unique(m_roots.begin(), m_roots.end()), m_roots.end());
        return std::move(m_roots);
    }

private:
    /// Finds the roots strictly between `from` and `to`, which may be roots themselves.
    void search(Coefficients f, double from, double to)
    {
        const int changes = signChanges(f, m_f.size());
        if (changes == 0)
            return;
        const double middle = 0.5 * (from + to);
        if (changes == 1) {
            m_roots.push_back(bisected(f, from, to));
            return;
        }
        if (to - from < 1e-15) {
            m_roots.push_back(middle);
            return;
        }
        Coefficients right;
        halve(f, right, m_f.size());
        search(f, from, middle);
        if (right[0] == 0)
            m_roots.push_back(middle);
        search(right, middle, to);
    }

    /// Bisects with the whole polynomial, since subdivided coefficients have gathered rounding errors.
    double bisected(const Coefficients &f, double from, double to) const
    {
        double atStart = 0;
        for (std::size_t i = 0; i < m_f.size() && atStart == 0; ++i)
            atStart = f[i];
        for (;;) {
            const double middle = 0.5 * (from + to);
            if (middle <= from || middle >= to)
                return middle;
            const double value = bernsteinAt(m_f, middle);
            if (value == 0)
                return middle;
            ((value > 0) == (atStart > 0) ? from : to) = middle;
        }
    }

    std::span<const double> m_f;
    std::vector<double> m_roots;
};

} // namespace

double bernsteinAt(std::span<const double> f, double p)
{
    Coefficients c{};
    std::copy(f.begin(), f.end(), c.begin());
    for (std::size_t left = f.size() - 1; left > 0; --left)
        for (std::size_t i = 0; i < left; ++i)
            c[i] = (1 - p) * c[i] + p * c[i + 1];
    return c[0];
}

std::vector<double> bernsteinRoots(std::span<const double> f)
{
    if (std::all_of(f.begin(), f.end(), [](double c) { return c == 0; }))
        return {};
    return RootFinder(f).find();
}

std::array<double, 4> distanceFromLine(const Cubic &cubic, Point on, Point normal)
{
    std::array<double, 4> f;
    for (std::size_t i = 0; i < 4; ++i)
        f[i] = dot(normal, cubic.p[i] - on);
    return f;
}

std::array<double, 7> powerOfCircle(const Cubic &cubic, Point centre, double radius)
{
    std::array<Point, 4> v;
    for (std::size_t i = 0; i < 4; ++i)
        v[i] = cubic.p[i] - centre;
    const double r2 = radius * radius;
    return {dot(v[0], v[0]) - r2,
            dot(v[0], v[1]) - r2,
            (3 * dot(v[1], v[1]) + 2 * dot(v[0], v[2])) / 5 - r2,
            (dot(v[0], v[3]) + 9 * dot(v[1], v[2])) / 10 - r2,
            (3 * dot(v[2], v[2]) + 2 * dot(v[1], v[3])) / 5 - r2,
            dot(v[2], v[3]) - r2,
            dot(v[3], v[3]) - r2};
}

std::array<double, 6> distanceSlope(const Cubic &cubic, Point point)
{
    std::array<Point, 4> v;
    for (std::size_t i = 0; i < 4; ++i)
        v[i] = cubic.p[i] - point;
    const Point a = cubic.p[1] - cubic.p[0], b = cubic.p[2] - cubic.p[1], c = cubic.p[3] - cubic.p[2];
    return {dot(v[0], a),
            (2 * dot(v[0], b) + 3 * dot(v[1], a)) / 5,
            (dot(v[0], c) + 6 * dot(v[1], b) + 3 * dot(v[2], a)) / 10,
            (3 * dot(v[1], c) + 6 * dot(v[2], b) + dot(v[3], a)) / 10,
            (3 * dot(v[2], c) + 2 * dot(v[3], b)) / 5,
            dot(v[3], c)};
}

} // namespace suffuse

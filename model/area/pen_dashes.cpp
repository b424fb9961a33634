// Divides lines into dashes.
#include "model/area/offset_curve.h"
#include "model/area/pen_outline.h"
#include "model/area/rising_arc.h"
#include "model/shaping/curves/split.h"

#include <numeric>
#include <optional>

namespace suffuse {

namespace {

/// The length of a curve's part between two parameters, by Gauss's rule of five points.
double lengthBetween(const Cubic &curve, double from, double to)
{
    constexpr double places[] = {0, 0.5384693101056831, 0.9061798459386640};
    constexpr double weights[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    double sum = weights[0] * length(curve.derivative(middle));
    for (const int i : {1, 2})
        sum += weights[i] * (length(curve.derivative(middle - places[i] * half)) +
                             length(curve.derivative(middle + places[i] * half)));
    return half * sum;
}

/// Tells where on a curve a length is reached.
class CurveLength {
public:
    explicit CurveLength(const Cubic &curve) : m_curve(curve)
    {
        for (std::size_t i = 0; i < parts; ++i)
            m_until[i + 1] = m_until[i] + lengthBetween(curve, double(i) / parts, double(i + 1) / parts);
    }

    double whole() const { return m_until[parts]; }
    double parameterAt(double along) const
    {
        std::size_t i = 0;
        while (i + 1 < parts && m_until[i + 1] <= along)
            ++i;
        const double from = double(i) / parts;
        double low = from, high = double(i + 1) / parts;
        for (int k = 0; k < 40; ++k) {
            const double middle = 0.5 * (low + high);
            (m_until[i] + lengthBetween(m_curve, from, middle) < along ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }

private:
    static constexpr std::size_t parts = 16;
    const Cubic &m_curve;
    std::array<double, parts + 1> m_until{};
};

/// Where a line is in its pattern.
class DashPattern {
public:
    DashPattern(std::vector<double> lengths, double offset) : m_lengths(std::move(lengths))
    {
        if (m_lengths.size() % 2 != 0) // Dashes and gaps change places in the second round.
            m_lengths.insert(m_lengths.end(), m_lengths.begin(), m_lengths.end());
        const double sum = std::accumulate(m_lengths.begin(), m_lengths.end(), 0.0);
        double into = std::fmod(offset, sum);
        into += into < 0 ? sum : 0;
        while (into >= m_lengths[m_index] && (into > 0 || m_lengths[m_index] > 0)) {
            into -= m_lengths[m_index];
            m_index = (m_index + 1) % m_lengths.size();
        }
        m_left = m_lengths[m_index] - into;
    }

    bool isDash() const { return m_index % 2 == 0; }
    double left() const { return m_left; }
    void go(double by) { m_left -= by; }
    void next()
    {
        m_index = (m_index + 1) % m_lengths.size();
        m_left = m_lengths[m_index];
    }

private:
    std::vector<double> m_lengths;
    std::size_t m_index = 0;
    double m_left = 0;
};

class DashMaker {
public:
    DashMaker(const PenLine &line, const std::vector<double> &pattern, double offset)
        : m_line(line), m_pattern(pattern, offset)
    {}

    std::vector<PenLine> make()
    {
        const bool beginsAsDash = m_pattern.isDash();
        open(m_line.curves.front().p[0], startDirection(m_line.curves.front()));
        for (const Cubic &curve : m_line.curves)
            walk(curve);
        const bool endsAsDash = m_dash.has_value();
        if (m_dash)
            m_dashes.push_back(std::move(*m_dash));
        else if (!m_line.isClosed && m_pattern.left() <= 1e-9 * polygonLength(m_line.curves.back()))
            addLastDot();
        if (m_line.isClosed && beginsAsDash && endsAsDash && !m_dashes.empty())
            joinEnds();
        return std::move(m_dashes);
    }

private:
    void open(Point at, Point direction)
    {
        if (m_pattern.isDash())
            m_dash = PenLine{{}, false, at, direction};
    }

    void walk(const Cubic &curve)
    {
        const CurveLength measured(curve);
        double done = 0, from = 0;
        // A dash that would end just where the curve does ends there, so that rounding makes none of length 0 of it.
        const double whole = measured.whole();
        while (whole - done > m_pattern.left() + 1e-9 * whole) {
            done += m_pattern.left();
            const double to = m_pattern.left() > 0 ? std::max(from, measured.parameterAt(done)) : from;
            take(curve, from, to);
            if (m_dash)
                m_dashes.push_back(std::move(*m_dash)), m_dash.reset();
            m_pattern.next();
            const Point along = curve.derivative(to);
            const double speed = length(along);
            open(curve.at(to), speed > 0 ? (1 / speed) * along : startDirection(curve));
            from = to;
        }
        take(curve, from, 1);
        m_pattern.go(std::min(m_pattern.left(), whole - done));
    }
    void take(const Cubic &curve, double from, double to)
    {
        if (m_dash && to > from)
            m_dash->curves.push_back(between(curve, from, to));
    }

    /// A dash without length shows at the end of a line, too, if that is its place.
    void addLastDot()
    {
        m_pattern.next();
        if (m_pattern.left() == 0)
            m_dashes.push_back({{}, false, m_line.curves.back().p[3], endDirection(m_line.curves.back())});
    }

    /// The dash that reaches a closed line's end goes on with the one that begins there.
    void joinEnds()
    {
        PenLine &first = m_dashes.front();
        if (m_dashes.size() == 1) { // There is no gap.
            first.isClosed = true;
            return;
        }
        PenLine &last = m_dashes.back();
        last.curves.insert(last.curves.end(), first.curves.begin(), first.curves.end());
        first = std::move(last);
        m_dashes.pop_back();
    }

    const PenLine &m_line;
    DashPattern m_pattern;
    std::optional<PenLine> m_dash;
    std::vector<PenLine> m_dashes;
};

} // namespace

std::vector<PenLine> dashesOf(const PenLine &line, const std::vector<double> &pattern, double offset, std::size_t most,
                              AreaEffort *effort)
{
    const double sum = std::accumulate(pattern.begin(), pattern.end(), 0.0);
    if (line.curves.empty() || !(sum > 0) || !std::isfinite(sum) || !std::isfinite(offset))
        return {line};
    double whole = 0;
    for (const Cubic &curve : line.curves)
        whole += polygonLength(curve);
    const double count = whole / sum * double(pattern.size());
    if (!(count < double(most)) || !spend(effort, 1000 * std::uint64_t(count)))
        return {line};
    return DashMaker(line, pattern, offset).make();
}

} // namespace suffuse

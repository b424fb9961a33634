#include "model/shaping/curves/fairing.h"

#include "model/shaping/curves/split.h"

namespace suffuse {

namespace {

constexpr double stepsInLength = 6;    ///< samples within a standard deviation
constexpr double mostSamples = 60'000; ///< A part has no more samples than these.
constexpr double kernelReach = 3.5;    ///< standard deviations that the kernel reaches
constexpr double longestShare = 0.25;  ///< The standard deviation is at most this share of a part's length.

/// A part of a curve without corners, as points at even distances along its arc.
class EvenPath {
public:
    EvenPath(const RunPath &path, std::size_t first, std::size_t end, double step)
    {
        const double total = path.lengths[end] - path.lengths[first];
        const auto count = std::size_t(std::clamp(std::ceil(total / step), 8.0, mostSamples));
        m_step = total / double(count);
        constexpr int each = 24; // chords for each curve
        m_points.push_back(path.curves[first].p[0]);
        Point last = m_points.front();
        double way = path.lengths[first];
        for (std::size_t k = first; k < end; ++k) {
            // Chords are shorter than the arc, so their sum is stretched to it.
            const Cubic &curve = path.curves[k];
            double sum = 0;
            Point before = curve.p[0];
            for (int i = 1; i <= each; ++i) {
                const Point p = curve.at(double(i) / each);
                sum += suffuse::length(p - before);
                before = p;
            }
            const double stretch = sum > 0 ? (path.lengths[k + 1] - path.lengths[k]) / sum : 1;
            for (int i = 1; i <= each; ++i) {
                const Point p = curve.at(double(i) / each);
                const double next = way + stretch * suffuse::length(p - last);
                while (m_points.size() <= count) {
                    const double wanted = path.lengths[first] + double(m_points.size()) * m_step;
                    if (wanted > next)
                        break;
                    m_points.push_back(last + (next > way ? (wanted - way) / (next - way) : 1) * (p - last));
                }
                way = next;
                last = p;
            }
        }
        m_points.resize(count + 1, path.curves[end - 1].p[3]);
        m_points.back() = path.curves[end - 1].p[3];
    }

    /// This path convolved with a Gaussian. Beyond its ends the path goes on point-symmetrically, which keeps the ends
    /// in their places.
    EvenPath convolved(double deviation) const
    {
        const auto n = std::ptrdiff_t(m_points.size()) - 1;
        const auto reach = std::min(n, std::ptrdiff_t(kernelReach * deviation / m_step));
        std::vector<double> kernel;
        double sum = 0;
        for (std::ptrdiff_t i = 0; i <= reach; ++i) {
            const double x = double(i) * m_step / deviation;
            kernel.push_back(std::exp(-0.5 * x * x));
            sum += (i > 0 ? 2 : 1) * kernel.back();
        }
        const auto at = [&](std::ptrdiff_t i) {
            if (i < 0)
                return 2.0 * m_points.front() - m_points[std::size_t(-i)];
            if (i > n)
                return 2.0 * m_points.back() - m_points[std::size_t(2 * n - i)];
            return m_points[std::size_t(i)];
        };
        EvenPath result = *this;
        for (std::ptrdiff_t i = 0; i <= n; ++i) {
            Point p = kernel[0] * at(i);
            for (std::ptrdiff_t j = 1; j <= reach; ++j)
                p = p + kernel[std::size_t(j)] * (at(i - j) + at(i + j));
            result.m_points[std::size_t(i)] = (1 / sum) * p;
        }
        return result;
    }

    /// The path of differences that the kernel 2g − g∗g takes away from this path.
    EvenPath fairness(double deviation) const
    {
        const EvenPath once = convolved(deviation), twice = once.convolved(deviation);
        EvenPath result = *this;
        for (std::size_t i = 0; i < m_points.size(); ++i)
            result.m_points[i] = 2.0 * once.m_points[i] - twice.m_points[i] - m_points[i];
        return result;
    }

    Point at(double way) const
    {
        const double x = std::clamp(way / m_step, 0.0, double(m_points.size() - 1));
        const auto i = std::min(std::size_t(x), m_points.size() - 2);
        return m_points[i] + (x - double(i)) * (m_points[i + 1] - m_points[i]);
    }
    Point slope(double way) const
    {
        const double total = m_step * double(m_points.size() - 1);
        const double from = std::max(0.0, way - m_step), to = std::min(total, way + m_step);
        return (1 / (to - from)) * (at(to) - at(from));
    }

private:
    std::vector<Point> m_points;
    double m_step = 1;
};

/// Smooths the segments first … end − 1 of a run, which have no corner between them.
void smoothPart(const RunPath &path, std::size_t first, std::size_t end, double deviation, std::vector<Cubic> &result)
{
    const double total = path.lengths[end] - path.lengths[first];
    deviation = std::min(deviation, longestShare * total);
    if (!(deviation > 0))
        return;
    const EvenPath moves = EvenPath(path, first, end, deviation / stepsInLength).fairness(deviation);
    const bool holdsStart = first == 0 && path.joinsBefore, holdsEnd = end == path.curves.size() && path.joinsAfter;
    const double ramp = std::min(2 * deviation, 0.5 * total);
    struct Move {
        Point by, slope;
    };
    const auto moveAt = [&](std::size_t node) {
        const double way = path.lengths[node] - path.lengths[first];
        double share = 1, shareSlope = 0;
        if (holdsStart && way < ramp)
            share = smoothStep(way / ramp), shareSlope = smoothStepSlope(way / ramp) / ramp;
        if (holdsEnd && total - way < ramp)
            share = smoothStep((total - way) / ramp), shareSlope = -smoothStepSlope((total - way) / ramp) / ramp;
        const Point by = node == first || node == end ? Point() : moves.at(way);
        return Move{share * by, share * moves.slope(way) + shareSlope * by};
    };
    for (std::size_t k = first; k < end; ++k) {
        const Cubic &before = path.curves[k];
        const Move a = moveAt(k), b = moveAt(k + 1);
        Cubic &c = result[k];
        c.p[0] = before.p[0] + a.by;
        c.p[3] = before.p[3] + b.by;
        c.p[1] = before.p[1] + a.by + suffuse::length(before.p[1] - before.p[0]) * a.slope;
        c.p[2] = before.p[2] + b.by - suffuse::length(before.p[3] - before.p[2]) * b.slope;
    }
}

} // namespace

Stroke smoothed(const Stroke &stroke, double length, const std::vector<bool> &chosen)
{
    Stroke result = stroke;
    for (const Chain &run : runsOf(stroke, chosen)) {
        const RunPath path(stroke, run);
        std::vector<Cubic> curves = path.curves;
        std::size_t first = 0;
        for (std::size_t k = 1; k <= curves.size(); ++k) {
            const bool isCorner = k == curves.size() ||
                                  dot(endDirection(path.curves[k - 1]), startDirection(path.curves[k])) < smoothCosine;
            if (isCorner) {
                smoothPart(path, first, k, length, curves);
                first = k;
            }
        }
        writeCurves(result, run.first, curves);
    }
    for (std::size_t k = 0; k < result.segments.size(); ++k)
        if (isPoint(result.segments[k]) && !isPoint(stroke.segments[k]))
            return stroke;
    return validOr(std::move(result), stroke);
}

} // namespace suffuse

#include "model/shaping/curves/simplify.h"

#include "model/brush/stroke_fit.h"
#include "model/shaping/curves/curve_fit.h"
#include "model/shaping/curves/merge.h"
#include "model/shaping/curves/runs.h"
#include "model/shaping/curves/split.h"

#include <array>

namespace suffuse {

namespace {

constexpr int samplesEach = 5;        ///< points of a segment for a fit
constexpr double timeShare = 1.0 / 6; ///< of the painting time; births are relative to that at least
constexpr int fitRounds = 4;          ///< rounds that improve the points' parameters

/// A segment's values on scales on which equal steps are equal changes to the eye. Ratios are taken as logarithms.
using SeenValues = std::array<double, 13>;

SeenValues seenValuesOf(const Segment &s, const Style &style)
{
    const auto logarithm = [](double x) { return x > 0 ? std::log(x) : -1e300; };
    // The logarithm of the spread's tensor is (m + d·cos 2θ, d·sin 2θ; d·sin 2θ, m − d·cos 2θ).
    const double t = s.maxAge, angle = 2 * double(s.anisotropyAngle);
    const double d = 0.25 * std::log(double(s.anisotropyRatio)), m = 0.5 * std::log(4 * double(s.diffusion) * t) + d;
    return {m,
            d * std::cos(angle),
            d * std::sin(angle),
            logarithm(s.density) - m, // the logarithm of the peak, but for a constant
            std::log(t),
            s.granulation,
            s.colour.red,
            s.colour.yellow,
            s.colour.blue,
            s.colour.opacity,
            logarithm(style.xi[0]),
            logarithm(style.xi[1]),
            logarithm(style.xi[2])};
}

/// Knows whether the values of a run of segments are near enough to become one value.
class ValueRange {
public:
    /// `atLeast`: seconds to which births are relative if drying takes less.
    ValueRange(const Segment &first, const Style &style, double tolerance, double atLeast)
        : m_low(seenValuesOf(first, style)), m_high(m_low), m_earliest(first.born), m_latest(first.born),
          m_maxAge(first.maxAge), m_tolerance(tolerance), m_atLeast(atLeast)
    {}

    /// Takes another segment. Returns false if it lies too far from the others.
    bool take(const Segment &s, const Style &style)
    {
        constexpr double rounding = 1e-6; // for the rounding of float32
        const SeenValues seen = seenValuesOf(s, style);
        for (std::size_t i = 0; i < seen.size(); ++i) {
            m_low[i] = std::min(m_low[i], seen[i]);
            m_high[i] = std::max(m_high[i], seen[i]);
            if (!(m_high[i] - m_low[i] <= m_tolerance + rounding))
                return false;
        }
        m_earliest = std::min(m_earliest, s.born);
        m_latest = std::max(m_latest, s.born);
        m_maxAge = std::min(m_maxAge, double(s.maxAge));
        return toSeconds(m_latest - m_earliest) <= m_tolerance * std::max(m_maxAge, m_atLeast);
    }

private:
    SeenValues m_low, m_high;
    Microseconds m_earliest, m_latest;
    double m_maxAge;
    double m_tolerance;
    double m_atLeast;
};

/// The time in which a stroke is painted, in seconds. What comes later than the paint before it takes to dry is a pause
/// of that time.
double paintingTime(const Stroke &stroke)
{
    double time = 0;
    for (std::size_t k = 1; k < stroke.segments.size(); ++k) {
        const Segment &a = stroke.segments[k - 1], &b = stroke.segments[k];
        time += std::min(toSeconds(std::abs(b.born - a.born)), double(a.maxAge));
    }
    return time;
}

class Simplifier {
public:
    Simplifier(const Stroke &stroke, const SimplifyTolerance &tolerance, const std::vector<bool> &chosen)
        : m_stroke(stroke), m_tolerance(tolerance), m_chosen(chosen), m_time(paintingTime(stroke))
    {
        m_curves.reserve(stroke.segments.size());
        for (const Segment &s : stroke.segments)
            m_curves.push_back(offsetsOf(s));
    }

    Stroke run(std::vector<int> *sources)
    {
        Stroke result = m_stroke;
        result.segments.clear();
        std::vector<int> from;
        bool afterMerged = false;
        for (std::size_t k = 0; k < m_stroke.segments.size();) {
            auto [next, segment] = longestFrom(k);
            const bool isMerged = next > k + 1;
            if ((isMerged || afterMerged) && segment.node == NodeKind::Symmetric)
                segment.node = NodeKind::Smooth; // Its handles are no longer equally long.
            result.segments.push_back(std::move(segment));
            from.push_back(int(k));
            afterMerged = isMerged;
            k = next;
        }
        if (sources)
            *sources = std::move(from);
        return result;
    }

private:
    struct Merged {
        std::size_t next; ///< the index behind the run
        Segment segment;
    };

    /// Doubles the run while it can be one segment, and then searches in between.
    Merged longestFrom(std::size_t first) const
    {
        const Segment &start = m_stroke.segments[first];
        Merged best{first + 1, start};
        ValueRange range(start, m_stroke.styleOf(start), m_tolerance.values, timeShare * m_time);
        std::size_t reach = first + 1; // how far values allow a run, or more than was asked for
        bool ends = false;
        const auto grow = [&](std::size_t wanted) {
            while (!ends && reach < wanted) {
                ends = !mayGoOn(reach) ||
                       !range.take(m_stroke.segments[reach], m_stroke.styleOf(m_stroke.segments[reach]));
                reach += !ends;
            }
            return std::min(wanted, reach);
        };
        std::size_t good = first + 1, bad = 0; // ends of runs; `bad` is 0 while none is known
        for (std::size_t size = 2; bad == 0; size *= 2) {
            const std::size_t end = grow(first + size);
            if (end <= good)
                return best;
            if (std::optional<Segment> one = merge(first, end)) {
                best = {end, std::move(*one)};
                good = end;
            } else {
                bad = end;
            }
        }
        while (bad - good > 1 + (good - first) / 16) {
            const std::size_t middle = good + (bad - good) / 2;
            if (std::optional<Segment> one = merge(first, middle)) {
                best = {middle, std::move(*one)};
                good = middle;
            } else {
                bad = middle;
            }
        }
        return best;
    }

    /// Whether a segment may be merged with the one before it, apart from its values.
    bool mayGoOn(std::size_t k) const
    {
        if (k >= m_stroke.segments.size() || m_stroke.beginsChain(k))
            return false;
        if (!m_chosen.empty() && !(m_chosen[k - 1] && m_chosen[k]))
            return false;
        const Segment &a = m_stroke.segments[k - 1], &b = m_stroke.segments[k];
        return a.lift == b.lift && a.fade == b.fade && a.rewet == b.rewet &&
               m_stroke.styleOf(a).kind == m_stroke.styleOf(b).kind &&
               dot(endDirection(m_curves[k - 1]), startDirection(m_curves[k])) >= smoothCosine;
    }

    /// The segments first … end − 1 as one, if its curve is near enough to theirs.
    std::optional<Segment> merge(std::size_t first, std::size_t end) const
    {
        const std::vector<Cubic> curves(m_curves.begin() + std::ptrdiff_t(first),
                                        m_curves.begin() + std::ptrdiff_t(end));
        CurveFit fit(curves, samplesEach);
        const Point direction = startDirection(curves.front()), arrival = endDirection(curves.back());
        const double allowed =
            std::max({m_tolerance.distance, resolutionAt(curves.front()), resolutionAt(curves.back())});
        Cubic curve = fit.fitted(direction, arrival);
        for (int round = 0; round < fitRounds && fit.error(curve) > allowed; ++round) {
            fit.reparametrise(curve);
            curve = fit.fitted(direction, arrival);
        }
        if (!(fit.error(curve) <= allowed))
            return std::nullopt;
        const std::vector<Segment> run(m_stroke.segments.begin() + std::ptrdiff_t(first),
                                       m_stroke.segments.begin() + std::ptrdiff_t(end));
        Segment result = withValuesOf(run);
        result.bezier = toOffsets(curve);
        result.bezier[0] = run.front().bezier[0];
        result.bezier[3] = run.back().bezier[3];
        if (isPoint(result))
            return std::nullopt;
        double before = 0;
        for (const Cubic &c : curves)
            before += arcLength(c);
        if (const double after = arcLength(offsetsOf(result)); after > 0)
            result.density = float(std::min(1e12, double(result.density) * before / after));
        return result;
    }

    const Stroke &m_stroke;
    const SimplifyTolerance &m_tolerance;
    const std::vector<bool> &m_chosen;
    std::vector<Cubic> m_curves;
    double m_time; ///< in which the stroke is painted, seconds
};

} // namespace

Stroke simplified(const Stroke &stroke, const SimplifyTolerance &tolerance, const std::vector<bool> &chosen,
                  std::vector<int> *sources)
{
    return Simplifier(stroke, tolerance, chosen).run(sources);
}

} // namespace suffuse

#include "model/stroke_builder.h"

namespace suffuse {

namespace {

/// Derivatives are fixed when this many later knots exist; a knot's influence falls by 0.268 a knot.
constexpr std::size_t knotsAhead = 6;
/// A device that reports no pressure so many times has none.
constexpr int zeroSamplesOfMouse = 32;
constexpr double interval = double(samplingInterval);
/// A gap between samples counts at most this long in the spline's parameter.
constexpr double longestStep = 8 * interval;
constexpr double tapLength = 0.1;     // in s
constexpr double shortestStep = 1e-3; // in s
constexpr double farthestSample = 3.3e11;
constexpr Microseconds latestSample = 1'000'000'000'000'000;

bool isUsable(const PenSample &s)
{
    return std::abs(s.position.x) <= farthestSample && std::abs(s.position.y) <= farthestSample &&
           std::isfinite(s.pressure);
}

/// A nearby point of a grid a little finer than the stroke's spread: offsets stay small, and exact in float32.
Point originFor(Point p, double spread)
{
    const double grid = std::exp2(std::floor(std::log2(spread)));
    return {std::round(p.x / grid) * grid, std::round(p.y / grid) * grid};
}

} // namespace

StrokeBuilder::StrokeBuilder(Brush brush, StrokeId id) : m_brush(std::move(brush))
{
    m_stroke.id = id;
    m_stroke.style = m_brush.style;
    m_stroke.mix = m_brush.mix;
    m_stroke.brush = m_brush.name;
}

void StrokeBuilder::add(const PenSample &sample)
{
    if (m_finished || !isUsable(sample))
        return;
    const double pressure = std::clamp(double(sample.pressure), 0.0, 1.0);
    if (pressure > 0) {
        if (m_pressure == Pressure::Unknown) {
            // What came before was a blip, not a device without pressure.
            m_pressure = Pressure::Real;
            m_knots.clear();
        }
        take(sample, pressure);
        return;
    }
    if (m_pressure == Pressure::Real)
        return;
    if (m_pressure == Pressure::Unknown && ++m_zeroSamples >= zeroSamplesOfMouse)
        m_pressure = Pressure::None;
    take(sample, 1);
}

void StrokeBuilder::finish()
{
    m_finished = true;
}

void StrokeBuilder::start(const PenSample &sample)
{
    m_stroke.origin = originFor(sample.position, m_brush.spread());
    m_stroke.segments.clear();
    m_settledKnot = 0;
    m_settledLength = m_greatestDensity = 0;
    m_nextKnot = interval;
}

void StrokeBuilder::take(const PenSample &sample, double pressure)
{
    const bool isFirst = m_knots.empty();
    if (isFirst)
        start(sample);
    Knot next;
    const Point p = sample.position - m_stroke.origin;
    const Colour &c = m_brush.colour;
    next.value = {p.x, p.y, densityFor(m_brush, pressure), c.red, c.yellow, c.blue, c.opacity};
    next.time = std::clamp(sample.time, -latestSample, latestSample);
    m_greatestDensity = std::max(m_greatestDensity, next.value[knot_column::Density]);
    if (isFirst) {
        m_knots.push_back(next);
        m_last = next;
        return;
    }
    if (!isStep(m_last.position(), next.position()))
        return;
    next.time = std::max(next.time, m_last.time);
    const double step = parameterStep(next);
    next.parameter = m_last.parameter + step;
    if (next.time - m_last.time > samplingInterval) {
        if (m_last.parameter > m_knots.back().parameter + interval / 8)
            addKnot(m_last);
        addKnot(next);
        m_nextKnot = next.parameter + interval;
    } else if (next.parameter >= m_nextKnot) {
        addKnot(interpolated(m_last, next, (m_nextKnot - m_last.parameter) / step));
        m_nextKnot += interval;
    }
    m_last = next;
}

double StrokeBuilder::parameterStep(const Knot &next) const
{
    const double elapsed = double(next.time - m_last.time);
    if (elapsed == 0)
        return interval;
    if (elapsed <= interval)
        return elapsed;
    // A gap: a slow device, a stalled one, or a pen that stood still. Its length is what the way takes at the speed
    // that the pen had.
    const Knot *before = &m_knots.back();
    if (before->parameter == m_last.parameter && m_knots.size() > 1)
        before = &m_knots[m_knots.size() - 2];
    const double way = length(next.position() - m_last.position());
    const double wayBefore = length(m_last.position() - before->position());
    const double needed = wayBefore > 0 ? (m_last.parameter - before->parameter) * (way / wayBefore) : interval;
    return std::max(interval, std::min({needed, elapsed, longestStep}));
}

bool StrokeBuilder::isStep(Point from, Point to) const
{
    const double reach = std::max({std::abs(from.x), std::abs(from.y), std::abs(to.x), std::abs(to.y)});
    return length(to - from) >= std::max(shortestStep * m_brush.spread(), 5e-7 * reach); // 4 float32 steps
}

void StrokeBuilder::addKnot(const Knot &knot)
{
    if (!isStep(m_knots.back().position(), knot.position()))
        return;
    m_knots.push_back(knot);
    while (m_knots.size() >= m_settledKnot + 2 + knotsAhead)
        settle();
}

void StrokeBuilder::settle()
{
    const std::size_t i = m_settledKnot;
    const auto window = std::span(m_knots).subspan(i, 2 + knotsAhead);
    fitSpline(window, i > 0);
    m_settledLength += appendInterval(m_brush, m_knots, i, m_stroke.segments);
    ++m_settledKnot;
}

double StrokeBuilder::appendTail(std::vector<Segment> &segments) const
{
    const std::size_t first = m_settledKnot > 0 ? m_settledKnot - 1 : 0; // the one before limits handles
    std::vector<Knot> tail(m_knots.begin() + std::ptrdiff_t(first), m_knots.end());
    if (m_last.parameter > tail.back().parameter && isStep(tail.back().position(), m_last.position()))
        tail.push_back(m_last);
    const std::size_t start = m_settledKnot - first;
    if (tail.size() < start + 2)
        return 0;
    fitSpline(std::span(tail).subspan(start), m_settledKnot > 0);
    double added = 0;
    for (std::size_t i = start; i + 1 < tail.size(); ++i)
        added += appendInterval(m_brush, tail, i, segments);
    return added;
}

Segment StrokeBuilder::dot() const
{
    const double spread = m_brush.spread(), half = 0.5 * tapLength * spread;
    const Point p = m_knots.front().position();
    Segment s;
    for (std::size_t i = 0; i < 4; ++i)
        s.bezier[i] = {float(p.x + half * (double(i) * 2 / 3 - 1)), float(p.y)};
    s.diffusion = m_brush.diffusion;
    s.density = float(std::min(1e12, m_greatestDensity * shortStrokeRaise(tapLength * spread, spread)));
    s.granulation = m_brush.granulation;
    s.maxAge = m_brush.maxAge;
    s.born = m_knots.front().time;
    s.colour = m_brush.colour;
    return s;
}

StrokePtr StrokeBuilder::stroke() const
{
    if (m_knots.empty())
        return nullptr;
    auto result = std::make_shared<Stroke>(m_stroke);
    const double spread = m_brush.spread();
    const double arc = m_settledLength + appendTail(result->segments);
    if (result->segments.empty() || arc < tapLength * spread) {
        result->segments = {dot()};
    } else if (const double raise = shortStrokeRaise(arc, spread); raise > 1) {
        for (Segment &s : result->segments)
            s.density = float(std::min(1e12, s.density * raise));
    }
    return result;
}

int StrokeBuilder::frozenSegments() const
{
    if (m_knots.empty())
        return 0;
    if (m_finished)
        return int(stroke()->segments.size());
    const bool mayBeRaised = m_settledLength < 2 * m_brush.spread();
    return mayBeRaised || m_pressure == Pressure::Unknown ? 0 : int(m_stroke.segments.size());
}

StrokePtr buildStroke(const Brush &brush, StrokeId id, const std::vector<PenSample> &samples)
{
    StrokeBuilder builder(brush, id);
    for (const PenSample &s : samples)
        builder.add(s);
    builder.finish();
    return builder.stroke();
}

} // namespace suffuse

#include "model/brush/stroke_builder.h"

namespace suffuse {

namespace {

/// Derivatives are fixed when so many later knots exist; the influence of a knot falls to 0.268 with each knot.
constexpr std::size_t knotsAhead = 6;
/// A device that reports no pressure so many times in a row has none.
constexpr int zeroSamplesOfMouse = 32;
/// A gap between samples counts as at most so many intervals in the spline's parameter.
constexpr double longestStep = 8;
/// The pen's speed is averaged over about this time.
constexpr double speedMemory = 40e-3; // s
constexpr double tapLength = 0.1;     // in s
constexpr double shortLength = 2;     // in s; a shorter stroke is raised, and its tips are blunter
constexpr double shortestStep = 1e-3; // in s
constexpr double farthestSample = 3.3e11;
constexpr Microseconds latestSample = 1'000'000'000'000'000;

bool isUsable(const PenSample &s)
{
    return std::abs(s.position.x) <= farthestSample && std::abs(s.position.y) <= farthestSample &&
           std::isfinite(s.pressure);
}

/// A point of a grid near p that is a little finer than the stroke's spread. Offsets from it are small, and exact in
/// float32.
Point originFor(Point p, double spread)
{
    const double grid = std::exp2(std::floor(std::log2(spread)));
    return {std::round(p.x / grid) * grid, std::round(p.y / grid) * grid};
}

} // namespace

StrokeBuilder::StrokeBuilder(Brush brush, StrokeId id) : m_brush(std::move(brush)), m_interval(double(m_brush.interval))
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
            // What came before was an outlier, not a device without pressure.
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
    m_fixedKnot = m_settledKnot = 0;
    m_settledLength = m_speed = 0;
    m_last = {};
    m_nextKnot = m_interval;
}

double StrokeBuilder::speedAt(Microseconds elapsed, double way)
{
    if (elapsed > 0) {
        const double seconds = toSeconds(elapsed);
        m_speed += (way / seconds - m_speed) * (1 - std::exp(-seconds / speedMemory));
    }
    return m_speed;
}

void StrokeBuilder::take(const PenSample &sample, double pressure)
{
    const bool isFirst = m_knots.empty();
    if (isFirst)
        start(sample);
    Knot next;
    const Point p = sample.position - m_stroke.origin;
    next.time = std::clamp(sample.time, -latestSample, latestSample);
    PenState pen{pressure, std::clamp(double(sample.tilt), 0.0, 1.0), m_speed, m_last.distance};
    const bool moves = isFirst || isStep(m_last.position(), p);
    if (moves && !isFirst) {
        next.time = std::max(next.time, m_last.time);
        const double way = length(p - m_last.position()) / m_brush.spread();
        pen.speed = speedAt(next.time - m_last.time, way);
        pen.distance += way;
    }
    next.distance = pen.distance;
    next.value[knot_column::X] = p.x;
    next.value[knot_column::Y] = p.y;
    next.setPaint(paintAt(m_brush, pen, m_stroke.id));
    const auto strength = [](const Knot &k) { return k.value[knot_column::Peak] * k.value[knot_column::Size]; };
    if (isFirst || strength(next) > strength(m_strongest))
        m_strongest = next;
    if (!moves)
        return;
    if (isFirst)
        m_knots.push_back(next);
    else
        addSample(next);
    m_last = next;
}

void StrokeBuilder::addSample(Knot &next)
{
    const double step = parameterStep(next);
    next.parameter = m_last.parameter + step;
    if (next.time - m_last.time > m_brush.interval) {
        if (m_last.parameter > m_knots.back().parameter + m_interval / 8)
            addKnot(m_last);
        addKnot(next);
        m_nextKnot = next.parameter + m_interval;
    } else if (next.parameter >= m_nextKnot) {
        addKnot(interpolated(m_last, next, (m_nextKnot - m_last.parameter) / step));
        m_nextKnot += m_interval;
    }
}

double StrokeBuilder::parameterStep(const Knot &next) const
{
    const double elapsed = double(next.time - m_last.time);
    if (elapsed == 0)
        return m_interval;
    if (elapsed <= m_interval)
        return elapsed;
    // There is a gap: a slow device, a stalled one, or a pen that stood still. It counts as long as the way takes at
    // the speed that the pen had.
    const Knot *before = &m_knots.back();
    if (before->parameter == m_last.parameter && m_knots.size() > 1)
        before = &m_knots[m_knots.size() - 2];
    const double way = length(next.position() - m_last.position());
    const double wayBefore = length(m_last.position() - before->position());
    const double needed = wayBefore > 0 ? (m_last.parameter - before->parameter) * (way / wayBefore) : m_interval;
    return std::max(m_interval, std::min({needed, elapsed, longestStep * m_interval}));
}

bool StrokeBuilder::isStep(Point from, Point to) const
{
    const double reach = std::max({std::abs(from.x), std::abs(from.y), std::abs(to.x), std::abs(to.y)});
    return length(to - from) >= std::max(shortestStep * m_brush.spread(), 5e-7 * reach); // four steps of float32
}

void StrokeBuilder::addKnot(const Knot &knot)
{
    if (!isStep(m_knots.back().position(), knot.position()))
        return;
    m_knots.push_back(knot);
    while (m_knots.size() >= m_fixedKnot + 2 + knotsAhead)
        fix();
    settle();
}

void StrokeBuilder::fix()
{
    fitSpline(std::span(m_knots).subspan(m_fixedKnot, 2 + knotsAhead), m_fixedKnot > 0);
    ++m_fixedKnot;
}

void StrokeBuilder::settle()
{
    const double length = m_knots.back().distance;
    if (length < shortLength)
        return;
    // What is nearer to the end will be tapered when the pen lifts.
    const double farthest = length - double(m_brush.taper.out);
    for (; m_settledKnot < m_fixedKnot && m_knots[m_settledKnot + 1].distance <= farthest; ++m_settledKnot)
        m_settledLength += appendInterval(m_brush, m_knots, m_settledKnot, {m_brush.taper}, m_stroke.segments);
}

double StrokeBuilder::appendTail(std::vector<Segment> &segments) const
{
    const std::size_t first = m_settledKnot > 0 ? m_settledKnot - 1 : 0; // The knot before limits the handles.
    std::vector<Knot> tail(m_knots.begin() + std::ptrdiff_t(first), m_knots.end());
    if (m_last.parameter > tail.back().parameter && isStep(tail.back().position(), m_last.position()))
        tail.push_back(m_last);
    const std::size_t start = m_settledKnot - first;
    if (tail.size() < start + 2)
        return 0;
    fitSpline(std::span(tail).subspan(m_fixedKnot - first), m_fixedKnot > 0);
    TaperedPath path{m_brush.taper};
    // Short strokes are blunter, so that a stroke that grows out of a tap begins with the size of the tap.
    path.taper.tip = float(std::lerp(1.0, double(path.taper.tip), std::min(1.0, tail.back().distance / shortLength)));
    if (m_finished)
        path.length = tail.back().distance;
    double added = 0;
    for (std::size_t i = start; i + 1 < tail.size(); ++i)
        added += appendInterval(m_brush, tail, i, path, segments);
    return added;
}

Segment StrokeBuilder::dot() const
{
    const Paint paint = m_strongest.paint();
    const double spread = spreadOf(m_brush, paint.size, paint.maxAge), half = 0.5 * tapLength * spread;
    const Point p = m_knots.front().position();
    Segment s;
    for (std::size_t i = 0; i < 4; ++i)
        s.bezier[i] = {float(p.x + half * (double(i) * 2 / 3 - 1)), float(p.y)};
    setPaint(s, m_brush, paint, {1, 0});
    s.density = float(std::min(1e12, s.density * shortStrokeRaise(tapLength * spread, spread)));
    s.born = m_knots.front().time;
    return s;
}

bool StrokeBuilder::mayBeRaised() const
{
    return m_settledLength < shortLength * m_brush.spread();
}

StrokePtr StrokeBuilder::stroke() const
{
    if (m_knots.empty())
        return nullptr;
    auto result = std::make_shared<Stroke>(m_stroke);
    const double arc = m_settledLength + appendTail(result->segments);
    if (result->segments.empty() || arc < tapLength * m_brush.spread()) {
        result->segments = {dot()};
    } else if (mayBeRaised()) {
        double widest = 0;
        for (const Segment &s : result->segments)
            widest = std::max(widest, std::sqrt(4.0 * s.diffusion * s.maxAge));
        const double raise = shortStrokeRaise(arc, widest);
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
    return mayBeRaised() || m_pressure == Pressure::Unknown ? 0 : int(m_stroke.segments.size());
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

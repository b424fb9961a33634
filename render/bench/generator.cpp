#include "render/bench/generator.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace suffuse::bench {

namespace {

/// Random numbers. The distributions of the standard library differ between libraries, its engines do not.
class Random {
public:
    explicit Random(std::uint64_t seed) : m_engine(seed) {}
    double unit() { return double(m_engine() >> 11) * 0x1p-53; }
    double in(double low, double high) { return low + (high - low) * unit(); }
    int below(int n) { return int(m_engine() % std::uint64_t(n)); }
    double normal()
    {
        double sum = -6;
        for (int i = 0; i < 12; ++i)
            sum += unit();
        return sum;
    }

private:
    std::mt19937_64 m_engine;
};

std::vector<int> segmentCounts(const PaintingOptions &o, Random &random)
{
    std::vector<double> weights;
    double total = 0;
    for (int i = 0; i < o.strokes; ++i)
        total += weights.emplace_back(std::exp(0.7 * random.normal()));
    std::vector<int> counts;
    int sum = 0;
    for (double w : weights)
        sum += counts.emplace_back(std::max(1, int(o.segments * w / total)));
    const int wanted = std::max(o.segments, o.strokes);
    while (sum != wanted) {
        int &count = counts[std::size_t(random.below(o.strokes))];
        const int step = sum < wanted ? 1 : count > 1 ? -1 : 0;
        count += step;
        sum += step;
    }
    return counts;
}

/// Makes n + 1 samples of a pen around `centre`.
std::vector<Point> penPath(int n, Point centre, double unit, Random &random)
{
    std::vector<Point> points;
    Point at, sum;
    double heading = random.in(0, 2 * std::numbers::pi), curvature = 0;
    const double speed = random.in(6, 10);
    for (int i = 0; i <= n; ++i) {
        points.push_back(at + unit * 0.1 * Point{random.normal(), random.normal()});
        sum = sum + at;
        curvature = 0.85 * curvature + 0.05 * random.normal();
        heading += curvature;
        const double step = unit * std::clamp(speed * std::exp(0.2 * random.normal()), 5.0, 12.0);
        at = at + step * Point{std::cos(heading), std::sin(heading)};
    }
    const Point shift = centre - (1.0 / (n + 1)) * sum;
    for (Point &p : points)
        p = p + shift;
    return points;
}

/// Makes cubics through the points, with handles from the neighbours.
std::vector<Segment> segmentsThrough(const std::vector<Point> &points, Point origin)
{
    std::vector<Segment> out(points.size() - 1);
    const std::size_t last = points.size() - 1;
    for (std::size_t i = 0; i < last; ++i) {
        const Point a = points[i], b = points[i + 1];
        const Point before = points[i > 0 ? i - 1 : 0], after = points[std::min(i + 2, last)];
        out[i].bezier = {toOffset(a, origin), toOffset(a + (1.0 / 6) * (b - before), origin),
                         toOffset(b - (1.0 / 6) * (after - a), origin), toOffset(b, origin)};
    }
    return out;
}

Style randomStyle(Random &random)
{
    const double kind = random.unit();
    if (kind < 0.6)
        return {StyleKind::Uniform, {0.5f, 0.05f, 0}};
    if (kind < 0.84)
        return {StyleKind::Feathering, {1.1f, 1.5f, 0}};
    return {StyleKind::Edge, {0.36f, 0.40f, 0.5f}};
}

Colour randomColour(Random &random)
{
    Colour c;
    c.red = float(random.unit());
    c.yellow = float(random.unit());
    c.blue = float(random.unit());
    c.opacity = float(random.in(0.5, 1));
    return c;
}

Colour between(const Colour &a, const Colour &b, float f)
{
    return {a.red + f * (b.red - a.red), a.yellow + f * (b.yellow - a.yellow), a.blue + f * (b.blue - a.blue),
            a.opacity + f * (b.opacity - a.opacity)};
}

Stroke randomStroke(const PaintingOptions &o, int segments, Microseconds &clock, Random &random)
{
    Stroke stroke;
    const std::vector<Point> points =
        penPath(segments, {random.in(0, o.width), random.in(0, o.height)}, o.unit, random);
    stroke.origin = points.front();
    stroke.style = randomStyle(random);
    if (random.unit() >= 0.75)
        stroke.mix = {MixMode::Beta, float(random.in(0.5, 1))};
    const double spread = random.in(o.spreadLow, o.spreadHigh) * o.unit, peak = random.in(0.9, 1.4);
    const Colour first = randomColour(random);
    const Colour last = random.unit() < 0.3 ? randomColour(random) : first;
    const float granulation = random.unit() < 0.6 ? 1.0f : float(random.in(0.2, 0.9));
    const double phase = random.in(0, 2 * std::numbers::pi);
    stroke.segments = segmentsThrough(points, stroke.origin);
    for (int i = 0; i < segments; ++i) {
        Segment &s = stroke.segments[std::size_t(i)];
        const double along = (i + 0.5) / segments;
        // The pen lands, presses unevenly and lifts.
        const double pressure =
            std::min({1.0, 0.3 + 6 * along, 0.3 + 6 * (1 - along)}) * (0.85 + 0.15 * std::sin(9 * along + phase));
        s.diffusion = float(spread * spread / 4);
        s.density = float(peak * std::sqrt(std::numbers::pi) * spread * (0.6 + 0.4 * pressure));
        s.granulation = granulation;
        s.colour = between(first, last, segments > 1 ? float(i) / float(segments - 1) : 0.0f);
        s.born = clock;
        clock += 16'667;
    }
    clock += 300'000;
    return stroke;
}

} // namespace

std::span<const Table2Size> table2()
{
    static constexpr Table2Size sizes[] = {
        {"figure1", 752, 17065},   {"figure7", 197, 5523},    {"figure8", 590, 5228},    {"figure9", 206, 1696},
        {"figure10", 83, 3780},    {"figure11a", 479, 13560}, {"figure11b", 645, 6938},  {"figure11c", 177, 6033},
        {"figure11d", 183, 13617}, {"figure11e", 597, 7769},  {"figure11f", 778, 17917}, {"figure11g", 431, 14987},
        {"figure11h", 128, 3723}};
    return sizes;
}

Painting makePainting(const PaintingOptions &options)
{
    Random random(options.seed);
    Painting painting;
    painting.canvas.width = options.width;
    painting.canvas.height = options.height;
    Microseconds clock = 0;
    StrokeId id = 0;
    for (int segments : segmentCounts(options, random)) {
        Stroke stroke = randomStroke(options, segments, clock, random);
        stroke.id = ++id;
        painting.strokes.push_back(std::make_shared<const Stroke>(std::move(stroke)));
    }
    return painting;
}

Stroke makeLiveStroke(const Canvas &canvas, double spread, int segments, StrokeId id, Microseconds born)
{
    std::vector<Point> points;
    for (int i = 0; i <= segments; ++i) {
        const double a = std::numbers::pi * i / 200;
        points.push_back({canvas.width * (0.5 + 0.36 * std::cos(a)), canvas.height * (0.5 + 0.36 * std::sin(2.9 * a))});
    }
    Stroke stroke;
    stroke.id = id;
    stroke.origin = points.front();
    stroke.segments = segmentsThrough(points, stroke.origin);
    for (std::size_t i = 0; i < stroke.segments.size(); ++i) {
        Segment &s = stroke.segments[i];
        s.diffusion = float(spread * spread / 4);
        s.density = float(std::sqrt(std::numbers::pi) * spread);
        s.colour = {0.2f, 0.1f, 0.9f, 0.9f};
        s.born = born + Microseconds(i) * 1'000'000 / 60;
    }
    return stroke;
}

namespace {

StrokePtr movedStroke(const Painting &painting, StrokeId id, Random &random)
{
    Stroke stroke = *painting.strokes[std::size_t(random.below(int(painting.strokes.size())))];
    stroke.id = id;
    stroke.group = 0;
    stroke.visible = true;
    stroke.origin = {random.in(0, painting.canvas.width), random.in(0, painting.canvas.height)};
    return std::make_shared<const Stroke>(std::move(stroke));
}

} // namespace

StrokeList repeatedStrokes(const Painting &painting, std::size_t count, StrokeId firstId)
{
    StrokeList out;
    Random random(7);
    for (std::size_t i = 0; i < count && !painting.strokes.empty(); ++i)
        out.push_back(movedStroke(painting, firstId + i, random));
    return out;
}

Painting repeatedPainting(const Painting &painting, std::size_t segments)
{
    Painting out;
    out.canvas = painting.canvas;
    Random random(7);
    std::size_t sum = 0;
    while (sum < segments && !painting.strokes.empty()) {
        out.strokes.push_back(movedStroke(painting, out.strokes.size() + 1, random));
        sum += out.strokes.back()->segments.size();
    }
    if (sum > segments) {
        Stroke last = *out.strokes.back();
        last.segments.resize(last.segments.size() - (sum - segments));
        out.strokes.back() = std::make_shared<const Stroke>(std::move(last));
    }
    return out;
}

} // namespace suffuse::bench

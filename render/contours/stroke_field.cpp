#include "render/contours/stroke_field.h"

#include "model/area/outline.h"
#include "model/painting/tensor.h"
#include "render/nodes/level0.h"

#include <map>
#include <numbers>

namespace suffuse::contours {

namespace {

constexpr double crispSpread = 1.0 / 1024; // of the tolerance 1/256 a quarter: nothing of such a spread is seen
constexpr double coarsestShare = 0x1p-18, finestShare = 0x1p-36; // of a segment's peak
constexpr int mostPanelHalvings = 40;

/// How exact densities must be, as a share of the peak, so that what lies s wide is known to within the tolerance even
/// where it has thinned out a thousandfold.
double epsilonFor(double spread, double tolerance)
{
    return std::clamp(1e-3 * tolerance / spread, finestShare, coarsestShare);
}

struct CurveSource {
    Cubic curve;
    double a, b, c;       // metric, unit⁻²
    double wxx, wxy, wyy; // its square root
    double narrow;        // 1/s of the smaller axis
    double epsilon;
    Gauss node;  // all but place and weight
    double gain; // φˢ √det M / π
};

panels::Curve whitened(const CurveSource &s, const Cubic &c)
{
    const auto white = [&](Point p) {
        const Point d = p - s.curve.p[0];
        return panels::Vector{s.wxx * d.x + s.wxy * d.y, s.wxy * d.x + s.wyy * d.y};
    };
    return {white(c.p[0]), white(c.p[1]), white(c.p[2]), white(c.p[3])};
}

panels::Curve scaled(const CurveSource &s, const Cubic &c)
{
    const auto scale = [&](Point p) {
        const Point d = p - s.curve.p[0];
        return panels::Vector{s.narrow * d.x, s.narrow * d.y};
    };
    return {scale(c.p[0]), scale(c.p[1]), scale(c.p[2]), scale(c.p[3])};
}

void addGausses(const CurveSource &s, const Cubic &curve, double tolerance, int depth, std::vector<Gauss> &out)
{
    int count = panelNodes(whitened(s, curve), scaled(s, curve), tolerance);
    if (count == 0 && depth < mostPanelHalvings && !panels::isTiny(scaled(s, curve), tolerance)) {
        const auto [before, after] = curve.split(0.5);
        addGausses(s, before, 0.5 * tolerance, depth + 1, out);
        addGausses(s, after, 0.5 * tolerance, depth + 1, out);
        return;
    }
    count = count == 0 ? panels::anyRule : count;
    const QuadratureRule &rule = gaussLegendre(count);
    for (std::size_t i = 0; i < std::size_t(count); ++i) {
        Gauss node = s.node;
        node.at = curve.at(rule.x[i]);
        node.weight = s.gain * rule.weight[i] * length(curve.derivative(rule.x[i]));
        if (node.weight > 0)
            out.push_back(node);
    }
}

} // namespace

StrokeField::StrokeField(const Stroke &stroke, Microseconds T, double eta, double tolerance)
    : m_stroke(stroke), m_eta(eta)
{
    std::map<int, std::vector<Gauss>> byOctave;
    for (const Segment &segment : stroke.segments) {
        if (!(segment.spread(T) > 0) || !(segment.density > 0))
            continue;
        const double ratio = double(segment.anisotropyRatio), across = segment.spread(T);
        const double smaller = across * std::sqrt(std::min(1.0, ratio)),
                     larger = across * std::sqrt(std::max(1.0, ratio));
        const Tensor tensor = 4 * segment.age(T) * tensorOf(segment);
        const double determinant = tensor.xx * tensor.yy - tensor.xy * tensor.xy;
        CurveSource s;
        s.curve = offsetsOf(segment);
        s.a = tensor.yy / determinant, s.b = -tensor.xy / determinant, s.c = tensor.xx / determinant;
        const double root = std::sqrt(s.a * s.c - s.b * s.b), trace = std::sqrt(s.a + s.c + 2 * root);
        s.wxx = (s.a + root) / trace, s.wxy = s.b / trace, s.wyy = (s.c + root) / trace;
        s.narrow = 1 / smaller;
        s.epsilon = epsilonFor(larger, tolerance);
        s.gain = double(segment.density) * root / std::numbers::pi;
        s.node.a = s.a, s.node.b = s.b, s.node.c = s.c;
        s.node.cut = -std::log(s.epsilon) + 2;
        s.node.spread = smaller;
        s.node.reach = std::sqrt(s.node.cut) * larger;
        s.node.halfWidth = std::sqrt(s.node.cut * tensor.xx), s.node.halfHeight = std::sqrt(s.node.cut * tensor.yy);
        s.node.row = std::uint32_t(m_rows.size());
        m_rows.push_back({&segment, modulation(segment.granulation, eta), segment.lift, segment.fade,
                          double(segment.granulation), double(segment.colour.opacity), &stroke.styleOf(segment)});
        std::vector<Gauss> &nodes = byOctave[int(std::floor(std::log2(smaller)))];
        addGausses(s, s.curve, s.epsilon, 0, nodes);
    }
    addFill(stroke, T);
    classify();
    if (std::ranges::all_of(m_rows, [](const Row &row) {
            return row.lifts || row.fades;
        })) { // What only takes paint away shows nothing.
        m_box = {};
        return;
    }
    const std::vector<ChannelGains> gains = this->gains();
    for (auto &[octave, nodes] : byOctave) {
        for (const Gauss &g : nodes)
            m_box = m_box.united(
                {g.at.x - g.halfWidth, g.at.y - g.halfHeight, g.at.x + g.halfWidth, g.at.y + g.halfHeight});
        m_bins.emplace_back(std::move(nodes), gains, m_channels);
    }
}

void StrokeField::addFill(const Stroke &stroke, Microseconds T)
{
    if (!stroke.fill || !(stroke.fill->age(T) > 0) || !(stroke.fill->density > 0))
        return;
    const Fill &fill = *stroke.fill;
    m_areaRow = std::uint32_t(m_rows.size());
    m_rows.push_back({nullptr, modulation(double(fill.granulation), m_eta), false, false, double(fill.granulation),
                      double(fill.colour.opacity), &stroke.style});
    const double smaller = fill.spread(T) * std::sqrt(std::min(1.0, double(fill.anisotropyRatio)));
    if (smaller < crispSpread) {
        m_crisp = m_rows.back().gain * double(fill.density);
        return;
    }
    m_area = std::make_unique<AreaField>(stroke, T, 5);
    m_box = m_box.united(m_area->box());
}

void StrokeField::classify()
{
    const Row *first = nullptr;
    bool even = true, hasLift = false, hasFade = false, oneStyle = true, oneOpacity = true, oneColour = true;
    for (const Row &row : m_rows) {
        hasLift = hasLift || row.lifts, hasFade = hasFade || row.fades;
        if (row.lifts || row.fades)
            continue;
        if (!first)
            first = &row;
        const auto colourOf = [this](const Row &r) { return r.segment ? r.segment->colour : m_stroke.fill->colour; };
        oneStyle = oneStyle && *row.style == *first->style;
        even = even && row.gain == first->gain;
        oneColour = oneColour && colourOf(row) == colourOf(*first) && (row.segment || !m_stroke.fill->gradient);
        oneOpacity = oneOpacity && row.opacity == first->opacity &&
                     (row.segment || !m_stroke.fill->gradient ||
                      m_stroke.fill->gradient->colour.opacity == m_stroke.fill->colour.opacity);
        if (oneColour)
            m_evenColour = colourOf(row);
    }
    if (!oneColour)
        m_evenColour.reset();
    if (oneStyle && !hasFade) {
        m_style = first ? *first->style : m_stroke.style;
        m_curve.emplace(*m_style);
    }
    if (oneOpacity)
        m_evenOpacity = first ? first->opacity : 0;
    // Without lifting φ′ is a sum, whatever the granulation; with it only where all have the same.
    m_kind = !oneStyle || hasFade ? Kind::Mixed : hasLift && !even ? Kind::OneStyle : Kind::Even;
    if (m_kind == Kind::Even && first)
        for (Row &row : m_rows)
            if (row.lifts)
                row.gain = -first->gain;
    m_channels = m_kind == Kind::Mixed ? 0 : m_kind == Kind::OneStyle ? 4 : m_evenOpacity ? 1 : 3;
}

std::vector<ChannelGains> StrokeField::gains() const
{
    std::vector<ChannelGains> out;
    for (const Row &row : m_rows) {
        ChannelGains &gains = out.emplace_back();
        gains[Modulated] = row.lifts && m_kind == Kind::OneStyle ? 0 : row.gain;
        gains[Laid] = row.lifts ? 0 : 1;
        gains[Opacity] = row.lifts ? 0 : row.opacity;
        gains[Lifted] = row.lifts ? 1 : 0;
    }
    return out;
}

ChannelSums StrokeField::sumsAt(Point p) const
{
    ChannelSums sums;
    for (const GaussBins &bins : m_bins)
        bins.addSums(p, sums);
    if (!m_area)
        return sums;
    const Sloped area = m_area->at(p);
    sums[Modulated].add(m_rows[m_areaRow].gain, area);
    sums[Laid].add(1, area);
    sums[Opacity].add(m_rows[m_areaRow].opacity, area);
    return sums;
}

Sloped StrokeField::modulated(const ChannelSums &sums) const
{
    if (m_kind == Kind::Even)
        return sums[Modulated];
    // φ′ = γφ, and γ is a mean over what lays paint.
    const Sloped &laid = sums[Laid], &lifted = sums[Lifted];
    if (!(laid.value > 0))
        return {};
    const double left = 1 - lifted.value / laid.value;
    const Point slopeOfLeft =
        (-1 / laid.value) * lifted.slope + (lifted.value / (laid.value * laid.value)) * laid.slope;
    return {sums[Modulated].value * left, left * sums[Modulated].slope + sums[Modulated].value * slopeOfLeft};
}

template <class Use>
void StrokeField::forEach(Point p, Use use) const
{
    for (const GaussBins &bins : m_bins)
        for (const std::uint32_t i : bins.near(p))
            use(bins.all()[i].row, valueAt(bins.all()[i], p));
    if (m_area)
        use(m_areaRow, m_area->at(p));
}

Sloped StrokeField::modulatedAt(Point p) const
{
    return modulated(sumsAt(p));
}

LocalPaint StrokeField::localPaint(const std::vector<Sloped> &rows, Point step, Point p) const
{
    LocalPaint local;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double density = rows[i].value + dot(rows[i].slope, step);
        if (!(density > 0))
            continue;
        const Row &row = m_rows[i];
        if (row.segment) {
            local.add(*row.segment, *row.style, density);
            continue;
        }
        double place = 0;
        if (const auto &gradient = m_stroke.fill->gradient) {
            const Point from = Point{} + gradient->from, way = Point{} + gradient->to - from;
            place = std::clamp(dot(p + step - from, way) / dot(way, way), 0.0, 1.0);
        }
        local.add(*m_stroke.fill, *row.style, density, place);
    }
    return local;
}

Sloped StrokeField::paintAt(Point p, bool withOpacity) const
{
    thread_local std::vector<Sloped> rows;
    rows.assign(m_rows.size(), {});
    double steepest = 0, sum = 0;
    forEach(p, [&](std::uint32_t row, const Sloped &s) {
        rows[row].add(1, s);
        steepest = std::max(steepest, std::abs(s.slope.x) + std::abs(s.slope.y)), sum += s.value;
    });
    if (!(sum > 0))
        return {};
    const auto value = [&](Point step) {
        const LocalPaint local = localPaint(rows, step, p);
        return withOpacity ? local.opacity(m_eta) : local.coverage(m_eta) * std::exp(-local.faded());
    };
    const double h = 1e-5 * sum / std::max(steepest, 1e-300);
    const double here = value({});
    return {here, (0.5 / h) * Point{value({h, 0}) - value({-h, 0}), value({0, h}) - value({0, -h})}};
}

Sloped StrokeField::coverageAt(Point p) const
{
    return paintAt(p, false);
}

Sloped StrokeField::opacityAt(Point p) const
{
    if (!m_style)
        return paintAt(p, true);
    const ChannelSums sums = sumsAt(p);
    const Sloped density = modulated(sums), &laid = sums[Laid], &opacity = sums[Opacity];
    if (!(density.value > 0) || !(laid.value > 0))
        return {};
    const double mean = opacity.value / laid.value;
    const auto [coverage, rise] = m_curve->at(density.value);
    const Point slopeOfMean = (1 / laid.value) * (opacity.slope - mean * laid.slope);
    return {coverage * mean, (rise * mean) * density.slope + coverage * slopeOfMean};
}

std::array<double, 4> StrokeField::colourAt(Point p) const
{
    std::vector<Sloped> rows(m_rows.size());
    forEach(p, [&](std::uint32_t row, const Sloped &s) { rows[row].add(1, s); });
    if (m_crisp > 0) // Inside is where people look at a crisp fill.
        rows[m_areaRow].value = double(m_stroke.fill->density);
    return localPaint(rows, {}, p).colour();
}

FieldPart StrokeField::whole() const
{
    FieldPart part;
    for (std::size_t bins = 0; bins < m_bins.size(); ++bins)
        for (std::size_t i = 0; i < m_bins[bins].all().size(); ++i)
            part.gauss.emplace_back(std::uint32_t(bins), std::uint32_t(i));
    return part;
}

FieldPart StrokeField::within(const FieldPart &part, const Rect &box) const
{
    FieldPart out;
    out.narrowest = std::numeric_limits<double>::infinity();
    for (const auto &[bins, i] : part.gauss) {
        const Gauss &g = m_bins[bins].all()[i];
        const double dx = std::max({box.left - g.at.x, g.at.x - box.right, 0.0});
        const double dy = std::max({box.top - g.at.y, g.at.y - box.bottom, 0.0});
        if (dx > g.halfWidth || dy > g.halfHeight)
            continue;
        out.gauss.emplace_back(bins, i);
        out.narrowest = std::min(out.narrowest, g.spread);
        const Row &row = m_rows[g.row];
        if (row.lifts || row.fades)
            continue;
        // as if it were round, and as wide everywhere as along its longer axis
        out.most += row.gain * g.weight * std::exp(-g.cut * (dx * dx + dy * dy) / (g.reach * g.reach));
    }
    if (m_area && box.intersects(m_area->box())) {
        out.most += m_rows[m_areaRow].gain * m_area->density();
        if (m_area->isNear(box))
            out.narrowest = std::min(out.narrowest, m_area->narrowest());
    }
    return out;
}

} // namespace suffuse::contours

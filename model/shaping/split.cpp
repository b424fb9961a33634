#include "model/shaping/split.h"

#include "model/brush/stroke_fit.h"
#include "model/painting/tensor.h"
#include "model/painting/validate.h"

namespace suffuse {

namespace {

Offset rounded(Point p)
{
    return {float(p.x), float(p.y)};
}

void appendParts(const Segment &segment, int source, const std::vector<double> &ps, std::vector<Piece> &pieces)
{
    const Cubic curve = offsetsOf(segment);
    double from = 0;
    Offset start = segment.bezier[0];
    for (std::size_t i = 0; i <= ps.size(); ++i) {
        const bool isLast = i == ps.size();
        const double to = isLast ? 1 : ps[i];
        Piece piece{source, from, to, segment};
        piece.segment.bezier = toOffsets(partOf(curve, from, to));
        piece.segment.bezier[0] = start;
        if (isLast)
            piece.segment.bezier[3] = segment.bezier[3];
        if (i > 0 || segment.node == NodeKind::Symmetric)
            piece.segment.node = NodeKind::Smooth;
        start = piece.segment.bezier[3];
        from = to;
        pieces.push_back(std::move(piece));
    }
}

struct LengthMean {
    double sum = 0;
    double weight = 0;
    void add(double value, double w) { sum += w * value, weight += w; }
    operator float() const { return float(sum / weight); }
};

} // namespace

Cubic offsetsOf(const Segment &segment)
{
    Cubic c;
    for (std::size_t i = 0; i < 4; ++i)
        c.p[i] = {double(segment.bezier[i].x), double(segment.bezier[i].y)};
    return c;
}

std::array<Offset, 4> toOffsets(const Cubic &cubic)
{
    return {rounded(cubic.p[0]), rounded(cubic.p[1]), rounded(cubic.p[2]), rounded(cubic.p[3])};
}

bool isPoint(const Segment &segment)
{
    const auto &b = segment.bezier;
    return b[0] == b[1] && b[0] == b[2] && b[0] == b[3];
}

double resolutionAt(const Cubic &offsets)
{
    double largest = 0;
    for (const Point &p : offsets.p)
        largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    return 8 * double(std::numeric_limits<float>::epsilon()) * largest;
}

double polygonLength(const Cubic &c)
{
    return length(c.p[1] - c.p[0]) + length(c.p[2] - c.p[1]) + length(c.p[3] - c.p[2]);
}

Point unit(Point vector)
{
    const double l = length(vector);
    return l > 0 ? (1 / l) * vector : Point();
}

Point startDirection(const Cubic &cubic)
{
    for (std::size_t i = 1; i < 4; ++i)
        if (cubic.p[i] != cubic.p[0])
            return unit(cubic.p[i] - cubic.p[0]);
    return {};
}

Point endDirection(const Cubic &cubic)
{
    for (std::size_t i = 3; i-- > 0;)
        if (cubic.p[i] != cubic.p[3])
            return unit(cubic.p[3] - cubic.p[i]);
    return {};
}

Cubic arcBetween(Point from, Point direction, Point to, Point arrival)
{
    const Point chord = to - from;
    const Point along = unit(chord);
    // An arc that leaves its chord at an angle has handles of ⅔·chord/(1 + cos angle).
    const double cosine = 0.5 * (dot(direction, along) + dot(arrival, along));
    const double handle = 2.0 / 3 * length(chord) / std::max(0.5, 1 + cosine);
    return {{from, from + handle * direction, to - handle * arrival, to}};
}

void setMeanValues(Segment &result, const std::vector<const Segment *> &of)
{
    LengthMean diffusion, density, granulation, maxAge, red, yellow, blue, opacity;
    Tensor tensor;
    bool sameTensor = true;
    Microseconds born = of.front()->born;
    for (const Segment *s : of) {
        const double w = std::max(arcLength(offsetsOf(*s)), 1e-300);
        diffusion.add(s->diffusion, w);
        density.add(s->density, w);
        granulation.add(s->granulation, w);
        maxAge.add(s->maxAge, w);
        red.add(s->colour.red, w);
        yellow.add(s->colour.yellow, w);
        blue.add(s->colour.blue, w);
        opacity.add(s->colour.opacity, w);
        born = std::min(born, s->born);
        tensor = tensor + w * tensorOf(*s);
        sameTensor = sameTensor && s->anisotropyRatio == of.front()->anisotropyRatio &&
                     s->anisotropyAngle == of.front()->anisotropyAngle;
    }
    result.diffusion = diffusion;
    result.density = density;
    result.granulation = granulation;
    result.maxAge = maxAge;
    result.colour = {red, yellow, blue, opacity};
    result.born = born;
    result.anisotropyRatio = of.front()->anisotropyRatio;
    result.anisotropyAngle = of.front()->anisotropyAngle;
    if (!sameTensor)
        setTensor(result, (1 / diffusion.weight) * tensor);
}

std::vector<double> distinct(std::vector<double> ps, const Cubic &curve)
{
    std::sort(ps.begin(), ps.end());
    const double shortest = resolutionAt(curve);
    const auto isLong = [&](double from, double to) { return polygonLength(partOf(curve, from, to)) > shortest; };
    std::vector<double> result;
    double last = 0;
    for (double p : ps) {
        if (!(p > last && p < 1) || !isLong(last, p) || !isLong(p, 1))
            continue;
        result.push_back(p);
        last = p;
    }
    return result;
}

std::vector<Piece> piecesOf(const Stroke &stroke, const std::vector<std::vector<double>> &parameters)
{
    std::vector<Piece> pieces;
    pieces.reserve(2 * stroke.segments.size());
    bool afterSplit = false;
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const std::size_t first = pieces.size();
        if (parameters[k].empty())
            pieces.push_back({int(k), 0, 1, stroke.segments[k]});
        else
            appendParts(stroke.segments[k], int(k), parameters[k], pieces);
        // Its handles are no longer equally long.
        if (NodeKind &kind = pieces[first].segment.node; afterSplit && kind == NodeKind::Symmetric)
            kind = NodeKind::Smooth;
        afterSplit = !parameters[k].empty();
    }
    return pieces;
}

std::vector<Piece> piecesOf(const Stroke &stroke, const std::vector<CurvePlace> &places)
{
    std::vector<std::vector<double>> parameters(stroke.segments.size());
    for (const CurvePlace &place : places)
        if (place.segment >= 0 && std::size_t(place.segment) < parameters.size())
            parameters[std::size_t(place.segment)].push_back(place.p);
    for (std::size_t k = 0; k < parameters.size(); ++k)
        if (!parameters[k].empty())
            parameters[k] = distinct(std::move(parameters[k]), offsetsOf(stroke.segments[k]));
    return piecesOf(stroke, parameters);
}

int nodeAt(const Stroke &stroke, const CurvePlace &place)
{
    const Cubic curve = offsetsOf(stroke.segments[std::size_t(place.segment)]);
    if (!distinct({place.p}, curve).empty())
        return -1;
    const bool isStart = polygonLength(partOf(curve, 0, place.p)) <= polygonLength(partOf(curve, place.p, 1));
    return place.segment + (isStart ? 0 : 1);
}

Stroke validOr(Stroke result, const Stroke &before)
{
    return problemOf(result).isEmpty() || !problemOf(before).isEmpty() ? result : before;
}

} // namespace suffuse

#include "model/shaping/curves/split.h"

#include "model/shaping/curves/chains.h"

#include "model/brush/stroke_fit.h"
#include "model/painting/fields.h"
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
        if (i > 0)
            piece.segment.start = false;
        start = piece.segment.bezier[3];
        from = to;
        pieces.push_back(std::move(piece));
    }
}

} // namespace

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
    std::vector<double> lengths;
    double length = 0;
    Tensor tensor;
    bool sameTensor = true;
    Microseconds born = of.front()->born;
    for (const Segment *s : of) {
        lengths.push_back(std::max(arcLength(offsetsOf(*s)), 1e-300));
        length += lengths.back();
        born = std::min(born, s->born);
        tensor = tensor + lengths.back() * tensorOf(*s);
        sameTensor = sameTensor && s->anisotropyRatio == of.front()->anisotropyRatio &&
                     s->anisotropyAngle == of.front()->anisotropyAngle;
    }
    const float ratio = of.front()->anisotropyRatio, angle = of.front()->anisotropyAngle;
    setMeanNumbers(result, of, lengths);
    result.born = born;
    result.anisotropyRatio = ratio;
    result.anisotropyAngle = angle;
    if (!sameTensor)
        setTensor(result, (1 / length) * tensor);
}

Cubic partOf(const Cubic &cubic, double from, double to)
{
    // The control points are the curve's polar form at the ends of the interval, in every mixture.
    const auto mix = [](double t, Point a, Point b) { return (1 - t) * a + t * b; };
    const auto polar = [&](double r, double s, double t) {
        const Point a = mix(r, cubic.p[0], cubic.p[1]), b = mix(r, cubic.p[1], cubic.p[2]);
        const Point c = mix(r, cubic.p[2], cubic.p[3]);
        return mix(t, mix(s, a, b), mix(s, b, c));
    };
    return {{polar(from, from, from), polar(from, from, to), polar(from, to, to), polar(to, to, to)}};
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
        if (NodeKind &kind = pieces[first].segment.node;
            afterSplit && kind == NodeKind::Symmetric && !stroke.beginsChain(k))
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
    return isStart ? place.segment : endNode(stroke, place.segment);
}

Stroke validOr(Stroke result, const Stroke &before)
{
    return problemOf(result).isEmpty() || !problemOf(before).isEmpty() ? result : before;
}

} // namespace suffuse

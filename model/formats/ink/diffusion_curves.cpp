#include "model/formats/ink/diffusion_curves.h"

#include "model/formats/ink/curve_set.h"
#include "model/formats/messages.h"
#include "model/paint/half_width.h"
#include "model/painting/ryb.h"
#include "model/painting/validate.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr int piecesPerCubic = 4;    ///< A cubic becomes so many segments, since colours change within it.
constexpr double widthShare = 0.04;  ///< The stroke of a side is as wide as this share of the picture's greater side.
constexpr double sharpness = 1.5;    ///< the half-width in spreads

Point unit(Point v)
{
    const double size = length(v);
    return size > 0 ? (1 / size) * v : Point{};
}

/// The pieces of a curve: its cubics that are no points, and the places of their middles on the curve.
struct CurvePiece {
    Cubic cubic;
    double place = 0;
};

std::vector<CurvePiece> piecesOf(const DiffusionCurve &curve)
{
    std::vector<CurvePiece> pieces;
    for (std::size_t i = 0; i + 3 < curve.points.size(); i += 3) {
        Cubic rest{{curve.points[i], curve.points[i + 1], curve.points[i + 2], curve.points[i + 3]}};
        for (int k = 0; k < piecesPerCubic; ++k) {
            auto parts = rest.split(1.0 / (piecesPerCubic - k));
            const Cubic piece = k + 1 < piecesPerCubic ? parts[0] : rest;
            rest = parts[1];
            if (length(piece.p[3] - piece.p[0]) > 1e-3)
                pieces.push_back({piece, (double(i / 3) + (k + 0.5) / piecesPerCubic) * curveStopsPerCubic});
        }
    }
    return pieces;
}

/// The directions at the nodes between pieces, halfway between the arriving and the leaving one.
std::vector<Point> directionsAt(const std::vector<CurvePiece> &pieces)
{
    std::vector<Point> directions(pieces.size() + 1);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const auto &p = pieces[k].cubic.p;
        const Point chord = p[3] - p[0];
        const Point first = p[1] == p[0] ? chord : p[1] - p[0], last = p[2] == p[3] ? chord : p[3] - p[2];
        directions[k] = directions[k] + unit(first);
        directions[k + 1] = directions[k + 1] + unit(last);
    }
    for (std::size_t k = 0; k < directions.size(); ++k) {
        const bool turnsBack = length(directions[k]) < 1e-6;
        const auto &p = pieces[std::min(k, pieces.size() - 1)].cubic.p;
        directions[k] = unit(turnsBack ? p[3] - p[0] : directions[k]);
    }
    return directions;
}

/// The softness ξ₂ for which coverage goes from 0 to 1 over `blur` pixels, where density is ξ₁ and falls by 2w/s² ξ₁
/// with each pixel.
float softness(double xi1, double halfWidth, double spread, double blur)
{
    return float(std::clamp(2 * halfWidth / (spread * spread) * xi1 * blur, 0.02, xi1));
}

/// The stroke along one side of a curve. `away` is the distance of the stroke's middle from the curve, with the sign of
/// the side.
StrokePtr sideOf(const DiffusionCurve &curve, const CurveStops<CurveColour> &colours, double away, StrokeId id)
{
    const std::vector<CurvePiece> pieces = piecesOf(curve);
    if (pieces.empty())
        return {};
    const std::vector<Point> directions = directionsAt(pieces);
    const auto moved = [&](Point p, std::size_t node) {
        return p + away * Point{-directions[node].y, directions[node].x};
    };
    const double halfWidth = std::abs(away), spread = halfWidth / sharpness;
    auto stroke = std::make_shared<Stroke>();
    stroke->id = id;
    Segment segment;
    segment.diffusion = float(spread * spread / (4 * double(segment.maxAge)));
    const double xi1 = double(stroke->style.xi[0]);
    segment.density = float(
        valuesForHalfWidth(halfWidth, double(segment.diffusion), double(segment.maxAge), visibleCut(stroke->style))
            .density);
    stroke->origin = moved(pieces.front().cubic.p[0], 0);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const auto &[cubic, place] = pieces[k];
        const Point from = moved(cubic.p[0], k), to = moved(cubic.p[3], k + 1);
        // Handles become longer or shorter as the chord does.
        const double scale = std::min(length(to - from) / length(cubic.p[3] - cubic.p[0]), 4.0);
        const std::array<Point, 4> p{from, from + scale * (cubic.p[1] - cubic.p[0]),
                                     to + scale * (cubic.p[2] - cubic.p[3]), to};
        for (std::size_t i = 0; i < 4; ++i)
            segment.bezier[i] = toOffset(p[i], stroke->origin);
        if (k > 0)
            segment.bezier[0] = stroke->segments.back().bezier[3];
        const CurveColour rgb = colours.at(place);
        segment.colour = rybFromSrgb(rgb[0], rgb[1], rgb[2]);
        const double blur = curve.blurAt(place);
        segment.style.reset();
        if (const float soft = softness(xi1, halfWidth, spread, blur); soft != stroke->style.xi[1])
            segment.style = Style{StyleKind::Uniform, {float(xi1), soft, 0}};
        stroke->segments.push_back(segment);
    }
    return problemOf(*stroke).isEmpty() ? stroke : nullptr;
}

} // namespace

Result<Painting> readDiffusionCurves(const QByteArray &bytes, const QString &fileName)
{
    const Result<CurveSet> picture = readCurveSet(bytes, fileName);
    if (!picture)
        return Error{picture.error()};
    Painting painting;
    painting.canvas.width = picture->width;
    painting.canvas.height = picture->height;
    painting.canvas.background = {0, 0, 0, 1};
    const double away = 0.5 * widthShare * std::max(picture->width, picture->height);
    for (const DiffusionCurve &curve : picture->curves)
        for (const bool left : {true, false})
            if (StrokePtr side = sideOf(curve, left ? curve.left : curve.right, left ? -away : away,
                                        StrokeId(painting.strokes.size() + 1)))
                painting.strokes.push_back(std::move(side));
    if (painting.strokes.empty())
        return fileError(fileName, FileMessages::tr("holds no curves; there is nothing to paint"));
    if (const QString problem = problemOf(painting); !problem.isEmpty())
        return fileError(fileName, problem);
    return painting;
}

} // namespace suffuse

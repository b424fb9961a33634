#include "model/formats/ink/diffusion_curves.h"

#include "model/formats/messages.h"
#include "model/paint/half_width.h"
#include "model/painting/ryb.h"
#include "model/painting/validate.h"

#include <QXmlStreamReader>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr qint64 largestXml = qint64(64) << 20;
constexpr double stopsPerCubic = 10; ///< The positions of colours and blurs ("globalID") count tenths of a cubic.
constexpr int piecesPerCubic = 4;    ///< A cubic becomes so many segments, since colours change within it.
constexpr double widthShare = 0.04;  ///< The stroke of a side is as wide as this share of the picture's greater side.
constexpr double sharpness = 1.5;    ///< the half-width in spreads

/// Values at rising positions along a curve; between them they are linear.
template <typename Value>
class Stops {
public:
    void add(double place, Value value) { m_stops.push_back({place, value}); }
    bool empty() const { return m_stops.empty(); }
    void sort()
    {
        std::stable_sort(m_stops.begin(), m_stops.end(),
                         [](const auto &a, const auto &b) { return a.place < b.place; });
    }
    template <typename Mix>
    Value at(double place, Mix mix) const
    {
        const auto after =
            std::partition_point(m_stops.begin(), m_stops.end(), [&](const auto &stop) { return stop.place < place; });
        if (after == m_stops.begin())
            return m_stops.front().value;
        if (after == m_stops.end())
            return m_stops.back().value;
        const auto before = after - 1;
        return mix(before->value, after->value, (place - before->place) / (after->place - before->place));
    }

private:
    struct Stop {
        double place;
        Value value;
    };
    std::vector<Stop> m_stops;
};

using Rgb = std::array<double, 3>;

double mixed(double a, double b, double t)
{
    return a + t * (b - a);
}

Rgb mixed(const Rgb &a, const Rgb &b, double t)
{
    return {mixed(a[0], b[0], t), mixed(a[1], b[1], t), mixed(a[2], b[2], t)};
}

struct Curve {
    std::vector<Point> points; ///< 3n + 1 points
    Stops<Rgb> left, right;
    Stops<double> blur; ///< pixels
};

struct CurvePicture {
    double width = 0, height = 0;
    std::vector<Curve> curves;
};

class CurveReader {
public:
    explicit CurveReader(const QByteArray &bytes) : m_xml(bytes) {}

    Result<CurvePicture> read()
    {
        if (!m_xml.readNextStartElement() || m_xml.name() != QLatin1String("curve_set"))
            fail(FileMessages::tr("the first element is not curve_set"));
        m_picture.width = number("image_width");
        m_picture.height = number("image_height");
        while (m_xml.readNextStartElement()) {
            if (m_xml.name() == QLatin1String("curve"))
                curve();
            else
                m_xml.skipCurrentElement();
        }
        if (m_xml.hasError())
            return Error{FileMessages::tr("line %1: %2").arg(m_xml.lineNumber()).arg(m_xml.errorString())};
        return std::move(m_picture);
    }

private:
    void fail(const QString &what)
    {
        if (!m_xml.hasError())
            m_xml.raiseError(what);
    }

    /// An attribute of the current element as a finite number.
    double number(const char *name)
    {
        const auto text = m_xml.attributes().value(QLatin1String(name));
        bool ok = false;
        const double value = text.toDouble(&ok);
        if (!ok || !(std::abs(value) <= 1e6))
            fail(FileMessages::tr("%1 of %2 is \"%3\", not a number up to 1e6")
                     .arg(QLatin1String(name), m_xml.name().toString(), text.left(40).toString()));
        return ok ? value : 0;
    }

    /// The colour of the current element. Colours are written in the order of OpenCV's images, so what is called R is
    /// blue.
    Rgb colour()
    {
        Rgb rgb{number("B"), number("G"), number("R")};
        for (double &channel : rgb)
            channel = std::clamp(channel / 255, 0.0, 1.0);
        return rgb;
    }

    void curve()
    {
        Curve curve;
        while (m_xml.readNextStartElement()) {
            while (m_xml.readNextStartElement()) {
                const auto name = m_xml.name();
                if (name == QLatin1String("control_point")) // Rows come first.
                    curve.points.push_back({number("y"), number("x")});
                else if (name == QLatin1String("left_color"))
                    curve.left.add(number("globalID"), colour());
                else if (name == QLatin1String("right_color"))
                    curve.right.add(number("globalID"), colour());
                else if (name == QLatin1String("best_scale") || name == QLatin1String("blur_point"))
                    curve.blur.add(number("globalID"), std::max(0.0, number("value")));
                m_xml.skipCurrentElement();
            }
        }
        if (m_xml.hasError())
            return;
        if (curve.points.size() < 4 || curve.points.size() % 3 != 1)
            return fail(FileMessages::tr("a curve has %1 control points; 3n + 1 make cubics").arg(curve.points.size()));
        if (curve.left.empty() || curve.right.empty())
            return fail(FileMessages::tr("a curve has no colours on one of its sides"));
        curve.left.sort();
        curve.right.sort();
        curve.blur.sort();
        m_picture.curves.push_back(std::move(curve));
    }

    QXmlStreamReader m_xml;
    CurvePicture m_picture;
};

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

std::vector<CurvePiece> piecesOf(const Curve &curve)
{
    std::vector<CurvePiece> pieces;
    for (std::size_t i = 0; i + 3 < curve.points.size(); i += 3) {
        Cubic rest{{curve.points[i], curve.points[i + 1], curve.points[i + 2], curve.points[i + 3]}};
        for (int k = 0; k < piecesPerCubic; ++k) {
            auto parts = rest.split(1.0 / (piecesPerCubic - k));
            const Cubic piece = k + 1 < piecesPerCubic ? parts[0] : rest;
            rest = parts[1];
            if (length(piece.p[3] - piece.p[0]) > 1e-3)
                pieces.push_back({piece, (double(i / 3) + (k + 0.5) / piecesPerCubic) * stopsPerCubic});
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
StrokePtr sideOf(const Curve &curve, const Stops<Rgb> &colours, double away, StrokeId id)
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
        const Rgb rgb = colours.at(place, [](const Rgb &a, const Rgb &b, double t) { return mixed(a, b, t); });
        segment.colour = rybFromSrgb(rgb[0], rgb[1], rgb[2]);
        const double blur =
            curve.blur.empty() ? 0 : curve.blur.at(place, [](double a, double b, double t) { return mixed(a, b, t); });
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
    if (bytes.size() > largestXml)
        return fileError(fileName, FileMessages::tr("has more than 64 MB of XML; that is more than is read"));
    const Result<CurvePicture> picture = CurveReader(bytes).read();
    if (!picture)
        return fileError(fileName, picture.error());
    Painting painting;
    painting.canvas.width = picture->width;
    painting.canvas.height = picture->height;
    painting.canvas.background = {0, 0, 0, 1};
    const double away = 0.5 * widthShare * std::max(picture->width, picture->height);
    for (const Curve &curve : picture->curves)
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

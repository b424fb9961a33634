#include "app/canvas/overlay/assistant_lines.h"

#include "app/canvas/view_transform.h"

#include <cmath>
#include <numbers>
#include <optional>

namespace suffuse {

namespace {

constexpr double bodyWeight = 0.9;  ///< of the lines by which one takes hold of an assistant
constexpr double fanWeight = 0.4;   ///< of those that only show where strokes go
constexpr double trackWeight = 0.6; ///< of the one that a stroke follows
constexpr double parallelGap = 72;  ///< least distance of parallels, logical pixels
constexpr int gridParts = 4;        ///< of a perspective's sides
constexpr int leastRays = 7;        ///< of a vanishing point that are seen in a view beside it
constexpr int raysAround = 24;      ///< of one in the view
constexpr int mostHalvings = 45;    ///< of the angle between rays
constexpr double markRoom = 13;     ///< around a vanishing point, where rays would meet; logical pixels
constexpr int arcsOfEllipse = 8;
constexpr std::size_t mostFans = 12; ///< assistants that show where strokes go; more would hide what is painted

/// Collects lines in device pixels, clipped to what is seen.
class AssistantPaths {
public:
    AssistantPaths(const View &view, double dpr)
        : m_view(view), m_dpr(dpr), m_window(Rect::of(0, 0, view.width, view.height).grown(4 * dpr))
    {}

    QPainterPath body, around; ///< `around`: other ellipses, as weak as the fan
    QList<QLineF> fan;

    void add(const Assistant &assistant);
    void addTrack(const AssistantTrack &track);
    const View &view() const { return m_view; }

private:
    // `Lines`: a path or a list.
    template <class Lines>
    void line(Lines &to, Point a, Point b) const
    {
        pixelLine(to, m_view.toPixels(a), m_view.toPixels(b));
    }
    template <class Lines>
    void pixelLine(Lines &to, Point a, Point b) const
    {
        if (clipLine(a, b, m_window))
            put(to, {a.x, a.y}, {b.x, b.y});
    }
    static void put(QPainterPath &path, QPointF a, QPointF b)
    {
        path.moveTo(a);
        path.lineTo(b);
    }
    static void put(QList<QLineF> &lines, QPointF a, QPointF b) { lines.append({a, b}); }
    template <class Lines>
    void ray(Lines &to, Point from, Point way, bool bothWays) const;
    void ellipse(QPainterPath &path, const AssistantTrack &track) const;
    void addParallels(const Assistant &assistant);
    void addRays(Point vanishing);
    void addMark(Point vanishing);
    void addPerspective(const Assistant &assistant);
    void addRound(const Assistant &assistant);

    const View &m_view;
    double m_dpr;
    Rect m_window;
};

/// A line in the direction `way` (canvas units) through all of the view, or from beside a vanishing point on.
template <class Lines>
void AssistantPaths::ray(Lines &to, Point from, Point way, bool bothWays) const
{
    View turned = m_view; // Differences of places that are far away would be rounded.
    turned.centre = {};
    turned.width = turned.height = 0;
    const Point pixel = turned.toPixels(way), at = m_view.toPixels(from);
    const double size = length(pixel), far = 2.0 * (m_view.width + m_view.height) + length(at);
    if (!(size > 0) || !std::isfinite(far / size))
        return;
    const Point end = (far / size) * pixel;
    pixelLine(to, bothWays ? at - end : at + (markRoom * m_dpr / size) * pixel, at + end);
}

void AssistantPaths::ellipse(QPainterPath &path, const AssistantTrack &track) const
{
    const Point first = track.first * track.along, second = track.second * Point{-track.along.y, track.along.x};
    constexpr double step = 2 * std::numbers::pi / arcsOfEllipse;
    const double handle = 4.0 / 3 * std::tan(step / 4);
    const auto at = [&](double x, double y) { return track.origin + x * first + y * second; };
    for (int i = 0; i < arcsOfEllipse; ++i) {
        const double c = std::cos(i * step), s = std::sin(i * step), c1 = std::cos((i + 1) * step),
                     s1 = std::sin((i + 1) * step);
        addCurve(path,
                 {{at(c, s), at(c - handle * s, s + handle * c), at(c1 + handle * s1, s1 - handle * c1), at(c1, s1)}},
                 m_view);
    }
}

void AssistantPaths::addTrack(const AssistantTrack &track)
{
    if (track.isLine())
        ray(body, track.origin, track.along, true);
    else
        ellipse(body, track);
}

/// Parallels through multiples of a power of two, counted from the assistant's own, so that they stay where they are
/// while the view is moved.
void AssistantPaths::addParallels(const Assistant &assistant)
{
    const std::optional<AssistantTrack> own = assistant.ownTrack();
    if (!own)
        return;
    const double gap = std::exp2(std::ceil(std::log2(parallelGap * m_dpr / m_view.scale)));
    const Point across{-own->along.y, own->along.x};
    const double middle = std::round(dot(across, m_view.centre - own->origin) / gap);
    const int count = int(std::ceil(std::hypot(m_view.width, m_view.height) / (2 * gap * m_view.scale)));
    const double along = dot(own->along, m_view.centre - own->origin); // The points lie near the view.
    for (int i = -count; i <= count; ++i)
        ray(fan, own->origin + along * own->along + ((middle + i) * gap) * across, own->along, true);
}

/// Rays in multiples of an angle that is halved until some of them are seen.
void AssistantPaths::addRays(Point vanishing)
{
    const Point at = m_view.toPixels(vanishing);
    double step = 2 * std::numbers::pi / raysAround;
    if (m_window.contains(at)) {
        for (int i = 0; i < raysAround; ++i)
            ray(fan, vanishing, {std::cos(i * step), std::sin(i * step)}, false);
        return;
    }
    const Point middle = m_view.centre - vanishing;
    double least = 0, most = 0;
    for (const Point corner : {Point{0, 0}, Point{double(m_view.width), 0}, Point{0, double(m_view.height)},
                               Point{double(m_view.width), double(m_view.height)}}) {
        const Point way = m_view.toCanvas(corner) - vanishing;
        const double off = std::atan2(cross(middle, way), dot(middle, way));
        least = std::min(least, off);
        most = std::max(most, off);
    }
    for (int i = 0; i < mostHalvings && most - least < leastRays * step; ++i)
        step /= 2;
    const double base = std::atan2(middle.y, middle.x);
    for (double k = std::ceil((base + least) / step); k * step <= base + most; ++k)
        ray(fan, vanishing, {std::cos(k * step), std::sin(k * step)}, false);
}

void AssistantPaths::addMark(Point vanishing)
{
    const Point at = m_view.toPixels(vanishing);
    const double r = 6 * m_dpr;
    if (!m_window.grown(3 * r).contains(at))
        return;
    body.addEllipse(QPointF(at.x, at.y), r, r);
    for (const Point way : {Point{1, 0}, Point{0, 1}, Point{-1, 0}, Point{0, -1}})
        pixelLine(body, at + r * way, at + 1.9 * r * way);
}

/// Where a point of the unit square lies in a quadrilateral by the projection that maps corners to corners; no value
/// where the square is seen from its side or its back.
std::optional<Point> projected(const std::vector<Point> &corners, double u, double v)
{
    const Point p0 = corners[0], p1 = corners[1], p2 = corners[2], p3 = corners[3];
    const Point sum = p0 - p1 + p2 - p3, a = p1 - p2, b = p3 - p2;
    const double det = cross(a, b);
    if (det == 0)
        return std::nullopt;
    const double g = cross(sum, b) / det, h = cross(a, sum) / det;
    if (!(1 + g > 0 && 1 + h > 0 && 1 + g + h > 0))
        return std::nullopt;
    const double w = 1 + g * u + h * v;
    const Point x = p1 - p0 + g * p1, y = p3 - p0 + h * p3;
    return (1 / w) * (p0 + u * x + v * y);
}

void AssistantPaths::addPerspective(const Assistant &assistant)
{
    const std::vector<Point> &p = assistant.points;
    for (std::size_t i = 0; i < 4; ++i) {
        line(body, p[i], p[(i + 1) % 4]);
        ray(fan, p[i], p[(i + 1) % 4] - p[i], true);
    }
    for (int i = 1; i < gridParts; ++i) {
        const double t = double(i) / gridParts;
        const auto l = projected(p, t, 0), r = projected(p, t, 1), u = projected(p, 0, t), d = projected(p, 1, t);
        if (!l || !r || !u || !d)
            break;
        line(fan, *l, *r);
        line(fan, *u, *d);
    }
    for (const Point &vanishing : assistant.vanishingPoints())
        addMark(vanishing);
}

void AssistantPaths::addRound(const Assistant &assistant)
{
    const Point centre = assistant.points[0];
    for (std::size_t i = 1; i < 3; ++i)
        line(fan, centre - (assistant.points[i] - centre), assistant.points[i]);
    const std::optional<AssistantTrack> own = assistant.ownTrack();
    if (!own)
        return;
    ellipse(body, *own);
    if (assistant.kind != AssistantKind::Concentric)
        return;
    for (const double k : {0.25, 0.5, 0.75, 1.5, 2.0}) {
        AssistantTrack other = *own;
        other.first *= k;
        other.second *= k;
        ellipse(around, other);
    }
}

void AssistantPaths::add(const Assistant &assistant)
{
    switch (assistant.kind) {
    case AssistantKind::Parallel:
        addParallels(assistant);
        [[fallthrough]];
    case AssistantKind::Ruler:
        line(body, assistant.points[0], assistant.points[1]);
        if (assistant.kind == AssistantKind::Ruler)
            ray(fan, assistant.points[0], assistant.points[1] - assistant.points[0], true);
        break;
    case AssistantKind::VanishingPoint:
        addRays(assistant.points[0]);
        addMark(assistant.points[0]);
        break;
    case AssistantKind::Perspective:
        addPerspective(assistant);
        break;
    case AssistantKind::Ellipse:
    case AssistantKind::Concentric:
        addRound(assistant);
        break;
    }
}

} // namespace

void paintAssistants(QPainter &painter, const std::vector<Assistant> &assistants, const View &view,
                     const OverlayColours &colours, double dpr)
{
    const auto stroke = [&](const QPainterPath &path, double weight) {
        strokeTwoTone(painter, path, colours.assistant, dpr, Qt::SolidLine, weight);
    };
    for (const Assistant &assistant : assistants) {
        AssistantPaths paths(view, dpr);
        paths.add(assistant);
        if (assistants.size() <= mostFans) {
            strokeTwoTone(painter, paths.fan, colours.assistant, dpr, fanWeight);
            stroke(paths.around, fanWeight);
        }
        stroke(paths.body, bodyWeight);
    }
}

void paintTrack(QPainter &painter, const AssistantTrack &track, const View &view, const OverlayColours &colours,
                double dpr)
{
    AssistantPaths paths(view, dpr);
    paths.addTrack(track);
    strokeTwoTone(painter, paths.body, colours.assistant, dpr, Qt::SolidLine, trackWeight); // What is painted shows.
}

QPainterPath bodyOf(const Assistant &assistant, const View &view)
{
    AssistantPaths paths(view, 1);
    paths.add(assistant);
    return paths.body;
}

} // namespace suffuse

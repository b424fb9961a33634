#include "app/canvas/selection_outline.h"

#include "app/canvas/view_transform.h"

namespace suffuse {

namespace {

/// Segments in the view from which on lines are thin.
constexpr std::size_t fineSegments = 600;
/// In the view from which on lines are quick ones while they move.
constexpr std::size_t smoothSegments = 120;
/// About so many lines are what a thin picture has at most, and one for each stroke.
constexpr double thinLines = 20'000, movingLines = 7'000;
constexpr double thinOpacity = 0.6;
constexpr double leastSpacing = 5; ///< logical pixels between the points of a thin line
/// Pixels of thin lines around the view, so that it can be moved without drawing them anew.
constexpr int thinMargin = 160;

Rect controlBox(const Stroke &stroke)
{
    Rect box;
    for (const Segment &segment : stroke.segments)
        for (const Offset &offset : segment.bezier)
            box.include(stroke.origin + offset);
    return box;
}

/// What of the canvas the view shows, as a box.
Rect shownBox(const View &view, double beyond)
{
    Rect box;
    const double w = view.width, h = view.height;
    for (const Point corner : {Point{-beyond, -beyond}, Point{w + beyond, -beyond}, Point{w + beyond, h + beyond},
                               Point{-beyond, h + beyond}})
        box.include(view.toCanvas(corner));
    return box;
}

/// Of the control polygon, canvas units.
double polygonLength(const Segment &segment)
{
    double sum = 0;
    for (std::size_t i = 1; i < 4; ++i) {
        const double dx = segment.bezier[i].x - segment.bezier[i - 1].x,
                     dy = segment.bezier[i].y - segment.bezier[i - 1].y;
        sum += std::sqrt(dx * dx + dy * dy);
    }
    return sum;
}

/// Lines of one pixel, not smoothed, that replace what lies below: many times faster than a painter's.
class ThinPen {
public:
    ThinPen(QImage &image, const QColor &colour)
        : m_bits(reinterpret_cast<QRgb *>(image.bits())), m_stride(int(image.bytesPerLine() / 4)),
          m_inside(Rect::of(0, 0, image.width() - 1.0, image.height() - 1.0)), m_colour(qPremultiply(colour.rgba()))
    {}

    void line(Point a, Point b)
    {
        if (!clipLine(a, b, m_inside))
            return;
        constexpr double one = 65536;
        const Point way = b - a;
        const int steps = int(std::max(std::abs(way.x), std::abs(way.y))) + 1;
        int x = int((a.x + 0.5) * one), y = int((a.y + 0.5) * one);
        const int stepX = int(way.x / steps * one), stepY = int(way.y / steps * one);
        for (int i = 0; i <= steps; ++i, x += stepX, y += stepY)
            m_bits[(y >> 16) * m_stride + (x >> 16)] = m_colour;
    }

private:
    QRgb *m_bits;
    int m_stride;
    Rect m_inside;
    QRgb m_colour;
};

/// Lists lines for a painter.
struct ListPen {
    QList<QLineF> lines;
    void line(Point a, Point b) { lines << QLineF(a.x, a.y, b.x, b.y); }
};

/// A polyline through the stroke with points about `spacing` pixels apart.
template <typename Pen>
void drawStroke(Pen &pen, const Stroke &stroke, const PixelMap &pixelOf, double scale, double spacing)
{
    constexpr double mostPieces = 16; // of a segment
    Point last = pixelOf(Point{} + stroke.segments.front().bezier[0]);
    double since = 0; // pixels along the curve
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const Segment &segment = stroke.segments[k];
        const double size = polygonLength(segment) * scale;
        const int pieces = int(std::clamp(size / spacing, 1.0, mostPieces));
        Cubic cubic;
        if (pieces > 1)
            for (std::size_t i = 0; i < 4; ++i)
                cubic.p[i] = Point{} + segment.bezier[i];
        for (int i = 1; i <= pieces; ++i) {
            const bool isEnd = k + 1 == stroke.segments.size() && i == pieces;
            since += size / pieces;
            if (!isEnd && since < spacing)
                continue;
            since = 0;
            const Point p = pixelOf(i == pieces ? Point{} + segment.bezier[3] : cubic.at(double(i) / pieces));
            pen.line(last, p);
            last = p;
        }
    }
}

/// By how many pixels a picture of one view lies off in another that differs from it in its centre alone, if it does.
std::optional<Point> shiftBetween(const View &from, const View &to)
{
    View alike = from;
    alike.centre = to.centre;
    if (!(alike == to))
        return {};
    return to.toPixels(from.centre) - Point{0.5 * to.width, 0.5 * to.height};
}

} // namespace

bool SelectionOutline::isUnchanged(const View &view, const Painting &painting, const Selection &selection) const
{
    const std::optional<Point> shift = shiftBetween(m_view, view);
    const double most = m_thin ? thinMargin : 0;
    if (!shift || std::abs(shift->x) > most || std::abs(shift->y) > most ||
        painting.strokes.size() != m_strokes.size() || selection != m_selection)
        return false;
    bool same = true;
    painting.strokes.forEachDifference(m_strokes, [&same](std::size_t) { same = false; });
    return same;
}

void SelectionOutline::gather(const View &view, const Painting &painting, const Selection &selection)
{
    if (!(view == m_view))
        m_lines.clear();
    m_view = view;
    m_strokes = painting.strokes;
    if (selection != m_selection)
        m_selection = selection;
    m_drawn = false;
    m_shown.clear();
    const Rect window = shownBox(view, thinMargin);
    std::size_t segments = 0;
    for (const StrokePtr &stroke : m_strokes) {
        if (!selection.strokes.contains(stroke->id) || !controlBox(*stroke).intersects(window))
            continue;
        std::set<int> chosen;
        const auto from = selection.segments.lower_bound({stroke->id, 0});
        for (auto it = from; it != selection.segments.end() && it->stroke == stroke->id; ++it)
            chosen.insert(it->segment);
        segments += stroke->segments.size();
        m_shown.emplace_back(stroke, std::move(chosen));
    }
    m_segments = segments;
    m_thin = segments > fineSegments;
    if (m_thin) {
        m_lines.clear();
    } else {
        m_picture = {};
        std::erase_if(m_lines, [&](const auto &line) { return !selection.strokes.contains(line.first); });
    }
}

const SelectionOutline::Line &SelectionOutline::lineOf(const StrokePtr &stroke, std::set<int> chosen)
{
    Line &line = m_lines[stroke->id];
    if (line.stroke == stroke && line.chosen == chosen)
        return line;
    line = {stroke, std::move(chosen), {}, {}, {}};
    const Rect window = Rect::of(0, 0, m_view.width, m_view.height).grown(8);
    for (int k = 0; k < int(stroke->segments.size()); ++k) {
        const Cubic cubic = stroke->cubicOf(stroke->segments[std::size_t(k)]);
        const bool isChosen = line.chosen.contains(k);
        addCurve(isChosen ? line.segments : line.path, cubic, m_view);
        if (!isChosen)
            continue;
        for (const Point &node : {m_view.toPixels(cubic.p[0]), m_view.toPixels(cubic.p[3])})
            if (window.contains(node))
                line.nodes.push_back(node);
    }
    return line;
}

void SelectionOutline::paintFine(QPainter &painter, const OverlayColours &colours, double dpr) const
{
    QColor quiet = colours.accent;
    quiet.setAlpha(m_selection.segments.empty() ? 255 : 150);
    // Stroke by stroke: one path of all would be searched for crossings.
    for (const auto &[stroke, chosen] : m_shown)
        strokeTwoTone(painter, m_lines.at(stroke->id).path, quiet, 1.1 * dpr);
    for (const auto &[stroke, chosen] : m_shown)
        if (!chosen.empty())
            strokeTwoTone(painter, m_lines.at(stroke->id).segments, colours.accent, 2.2 * dpr);
    for (const auto &[stroke, chosen] : m_shown)
        for (const Point &node : m_lines.at(stroke->id).nodes)
            paintNode(painter, node, colours, dpr);
}

void SelectionOutline::drawThin(const QColor &colour, double dpr, bool moving)
{
    m_thinColour = colour;
    m_drawn = true;
    m_rough = moving;
    const QSize size(m_view.width + 2 * thinMargin, m_view.height + 2 * thinMargin);
    if (m_picture.size() != size)
        m_picture = QImage(size, QImage::Format_ARGB32_Premultiplied);
    m_picture.fill(Qt::transparent);
    double total = 0; // pixels
    for (const auto &[stroke, chosen] : m_shown)
        for (const Segment &segment : stroke->segments)
            total += polygonLength(segment) * m_view.scale;
    const double spacing = std::max(leastSpacing * dpr, total / (moving ? movingLines : thinLines));
    QColor veiled = colour; // the paint below is still to be seen
    veiled.setAlphaF(thinOpacity);
    ThinPen pen(m_picture, veiled);
    View around = m_view; // the same middle
    around.width = size.width();
    around.height = size.height();
    for (const auto &[stroke, chosen] : m_shown)
        drawStroke(pen, *stroke, PixelMap(around, stroke->origin), m_view.scale, spacing);
}

void SelectionOutline::paintThin(QPainter &painter, const View &view, double dpr, const QColor &colour, bool moving)
{
    if (!m_drawn || m_thinColour != colour || (m_rough && !moving))
        drawThin(colour, dpr, moving);
    const Point shift = *shiftBetween(m_view, view);
    painter.drawImage(QPointF(std::round(shift.x) - thinMargin, std::round(shift.y) - thinMargin), m_picture);
}

void SelectionOutline::paintQuick(QPainter &painter, const QColor &colour, double dpr) const
{
    ListPen pen;
    for (const auto &[stroke, chosen] : m_shown)
        drawStroke(pen, *stroke, PixelMap(m_view, stroke->origin), m_view.scale, leastSpacing * dpr);
    painter.setPen(QPen(colour, 0)); // one device pixel, not smoothed
    painter.drawLines(pen.lines);
}

void SelectionOutline::paint(QPainter &painter, const View &view, const Painting &painting, const Selection &selection,
                             const OverlayColours &colours, double dpr, bool moving)
{
    if (selection.isEmpty()) {
        *this = {};
        return;
    }
    if (!isUnchanged(view, painting, selection))
        gather(view, painting, selection);
    if (m_thin) {
        paintThin(painter, view, dpr, colours.accent, moving);
        return;
    }
    if (moving && m_segments > smoothSegments) {
        paintQuick(painter, colours.accent, dpr);
        return;
    }
    for (const auto &[stroke, chosen] : m_shown)
        lineOf(stroke, chosen);
    painter.setRenderHint(QPainter::Antialiasing);
    paintFine(painter, colours, dpr);
}

} // namespace suffuse

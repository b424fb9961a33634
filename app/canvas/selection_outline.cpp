#include "app/canvas/selection_outline.h"

#include "app/canvas/view_transform.h"
#include "model/transform.h"

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
/// So many strokes that change are drawn apart.
constexpr std::size_t fewStrokes = 64;

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

/// Where a box of the canvas lies in the view.
Rect pixelBox(const View &view, const Rect &box)
{
    Rect pixels;
    for (const Point corner : {Point{box.left, box.top}, Point{box.right, box.top}, Point{box.right, box.bottom},
                               Point{box.left, box.bottom}})
        pixels.include(view.toPixels(corner));
    return pixels;
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

/// Lines of one pixel, not smoothed: many times faster than a painter's.
class ThinPen {
public:
    explicit ThinPen(PixelMask &mask) : m_mask(mask), m_inside(Rect::of(0, 0, mask.width() - 1.0, mask.height() - 1.0))
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
            m_mask.set(x >> 16, y >> 16);
    }

private:
    PixelMask &m_mask;
    Rect m_inside;
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

/// Finds the selected strokes, unless the same are selected in the same order.
void SelectionOutline::locate(const Painting &painting, const Selection &selection)
{
    if (m_boxes.follow(painting.strokes) && selection == m_selection)
        return;
    m_selection = selection;
    m_stale = true;
    m_places.clear();
    const std::set<StrokeId> &wanted = m_selection.strokes;
    auto next = wanted.begin(); // most often the order is that of the ids
    for (std::size_t i = 0; i < painting.strokes.size() && m_places.size() < wanted.size(); ++i) {
        const StrokeId id = painting.strokes[i]->id;
        if (next == wanted.end() || *next != id)
            next = wanted.find(id);
        if (next == wanted.end())
            continue;
        m_places.push_back(i);
        ++next;
    }
}

Rect SelectionOutline::boxOf(const Painting &painting, const Selection &selection)
{
    locate(painting, selection);
    Rect box;
    for (const std::size_t place : m_places)
        box = box.united(m_boxes[place]);
    return box;
}

Rect SelectionOutline::curveBoxOf(const Painting &painting, const Selection &selection)
{
    locate(painting, selection);
    Rect box;
    for (const std::size_t place : m_places) {
        const Rect &around = m_boxes[place];
        const bool isWithin = box.contains({around.left, around.top}) && box.contains({around.right, around.bottom});
        if (!isWithin && !painting.isLocked(*painting.strokes[place])) // most curves add nothing
            box = box.united(curveBox(*painting.strokes[place]));
    }
    return box;
}

/// True where what was gathered holds, strokes apart that are shown as they are now.
bool SelectionOutline::follow(const View &view, const Painting &painting, bool moving)
{
    const std::optional<Point> shift = shiftBetween(m_view, view);
    const double most = m_thin ? thinMargin : 0;
    if (m_stale || !shift || std::abs(shift->x) > most || std::abs(shift->y) > most ||
        painting.strokes.size() != m_strokes.size())
        return false;
    std::vector<std::size_t> changed;
    painting.strokes.forEachDifference(m_strokes, [&](std::size_t place) {
        if (changed.size() <= fewStrokes)
            changed.push_back(place);
    });
    if (changed.empty())
        return moving || std::none_of(m_shown.begin(), m_shown.end(), [](const Shown &shown) { return shown.apart; });
    return moving && m_thin && changed.size() <= fewStrokes && followApart(painting.strokes, changed);
}

bool SelectionOutline::followApart(const StrokeList &strokes, const std::vector<std::size_t> &changed)
{
    for (const std::size_t place : changed) {
        const StrokePtr &stroke = strokes[place];
        if (std::as_const(m_strokes)[place]->id != stroke->id)
            return false;
        if (!m_selection.strokes.contains(stroke->id))
            continue;
        const auto it = std::lower_bound(m_shown.begin(), m_shown.end(), place,
                                         [](const Shown &shown, std::size_t p) { return shown.place < p; });
        if (it == m_shown.end() || it->place != place)
            return false; // it comes into the view
        it->stroke = stroke;
        if (!std::exchange(it->apart, true))
            m_drawn = false;
    }
    m_strokes = strokes;
    return true;
}

std::set<int> SelectionOutline::chosenOf(StrokeId id) const
{
    std::set<int> chosen;
    const auto from = m_selection.segments.lower_bound({id, 0});
    for (auto it = from; it != m_selection.segments.end() && it->stroke == id; ++it)
        chosen.insert(it->segment);
    return chosen;
}

void SelectionOutline::gather(const View &view, const Painting &painting)
{
    if (!(view == m_view))
        m_lines.clear();
    m_view = view;
    m_strokes = painting.strokes;
    m_stale = m_drawn = false;
    m_shown.clear();
    m_shownBox = {};
    const Rect window = shownBox(view, thinMargin);
    std::size_t segments = 0;
    for (const std::size_t place : m_places) {
        if (!m_boxes[place].intersects(window))
            continue;
        const StrokePtr &stroke = painting.strokes[place];
        segments += stroke->segments.size();
        m_shown.push_back({place, stroke, chosenOf(stroke->id)});
        m_shownBox = m_shownBox.united(m_boxes[place]);
    }
    m_segments = segments;
    m_thin = segments > fineSegments;
    if (m_thin)
        m_lines.clear();
    else
        std::erase_if(m_lines, [&](const auto &line) { return !m_selection.strokes.contains(line.first); });
}

const SelectionOutline::Line &SelectionOutline::lineOf(const Shown &shown)
{
    const StrokePtr &stroke = shown.stroke;
    Line &line = m_lines[stroke->id];
    if (line.stroke == stroke && line.chosen == shown.chosen)
        return line;
    line = {stroke, shown.chosen, {}, {}, {}};
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
    for (const Shown &shown : m_shown)
        strokeTwoTone(painter, m_lines.at(shown.stroke->id).path, quiet, 1.1 * dpr);
    for (const Shown &shown : m_shown)
        if (!shown.chosen.empty())
            strokeTwoTone(painter, m_lines.at(shown.stroke->id).segments, colours.accent, 2.2 * dpr);
    for (const Shown &shown : m_shown)
        for (const Point &node : m_lines.at(shown.stroke->id).nodes)
            paintNode(painter, node, colours, dpr);
}

/// About how many pixels all lines are long.
double SelectionOutline::lengthOfLines() const
{
    constexpr std::size_t most = 64; // strokes that are measured
    const std::size_t step = m_shown.size() / most + 1;
    double sum = 0;
    for (std::size_t i = 0; i < m_shown.size(); i += step)
        for (const Segment &segment : m_shown[i].stroke->segments)
            sum += polygonLength(segment);
    return sum * double(step) * m_view.scale;
}

void SelectionOutline::drawThin(double dpr, bool moving)
{
    m_drawn = true;
    m_rough = moving;
    View around = m_view; // the same middle
    around.width += 2 * thinMargin;
    around.height += 2 * thinMargin;
    const Rect box = pixelBox(around, m_shownBox).grown(2);
    const QRectF inView = QRectF(0, 0, around.width, around.height); // the box may be as large as a deep zoom makes it
    m_inked = (inView & QRectF(QPointF(box.left, box.top), QPointF(box.right, box.bottom))).toAlignedRect();
    m_mask.clear(around.width, around.height);
    const double spacing = std::max(leastSpacing * dpr, lengthOfLines() / (moving ? movingLines : thinLines));
    ThinPen pen(m_mask);
    for (const Shown &shown : m_shown)
        if (!shown.apart)
            drawStroke(pen, *shown.stroke, PixelMap(around, shown.stroke->origin), m_view.scale, spacing);
}

void SelectionOutline::paintThin(QPainter &painter, const View &view, double dpr, const QColor &colour, bool moving)
{
    if (!m_drawn || (m_rough && !moving))
        drawThin(dpr, moving);
    const Point shift = *shiftBetween(m_view, view);
    const QPoint corner(int(std::round(shift.x)) - thinMargin, int(std::round(shift.y)) - thinMargin);
    QColor veiled = colour; // the paint below is still to be seen
    veiled.setAlphaF(thinOpacity);
    m_mask.paint(painter, corner, m_inked, veiled);
    paintQuick(painter, view, colour, dpr, true);
}

void SelectionOutline::paintQuick(QPainter &painter, const View &view, const QColor &colour, double dpr,
                                  bool apart) const
{
    ListPen pen;
    for (const Shown &shown : m_shown)
        if (shown.apart == apart)
            drawStroke(pen, *shown.stroke, PixelMap(view, shown.stroke->origin), view.scale, leastSpacing * dpr);
    painter.setPen(QPen(colour, 0)); // one device pixel, not smoothed
    painter.drawLines(pen.lines);
}

void SelectionOutline::paint(QPainter &painter, const View &view, const Painting &painting, const Selection &selection,
                             const OverlayColours &colours, double dpr, bool moving)
{
    locate(painting, selection);
    if (!follow(view, painting, moving))
        gather(view, painting);
    if (m_shown.empty())
        return;
    if (m_thin) {
        paintThin(painter, view, dpr, colours.accent, moving);
        return;
    }
    if (moving && m_segments > smoothSegments) {
        paintQuick(painter, view, colours.accent, dpr, false);
        return;
    }
    for (const Shown &shown : m_shown)
        lineOf(shown);
    painter.setRenderHint(QPainter::Antialiasing);
    paintFine(painter, colours, dpr);
}

} // namespace suffuse

#include "app/canvas/overlay/selection_outline.h"

#include "app/canvas/view_transform.h"
#include "model/painting/editable.h"
#include "model/shaping/transform.h"

#include <cmath>
#include <map>

namespace suffuse {

namespace {

/// With so many segments in the view, and with more, lines are thin.
constexpr std::size_t fineSegments = 600;
/// And with lines that are so long in the view, all in all, logical pixels: smooth ones that crowd its paint or cross
/// themselves all over take a tenth of a second to draw, each time.
constexpr double fineLength = 30'000;
/// With so many segments in the view, and with more, quick lines are drawn while they move.
constexpr std::size_t smoothSegments = 120;
/// The width of a line, logical pixels.
constexpr double lineWidth = 1.1;
/// Lines are fainter where they cover a larger share than this of the pixels around them, so that together they hide
/// little more than that.
constexpr double crowded = 0.15;
/// Logical pixels at the side of the squares in which that share is measured.
constexpr double crowdSquare = 12;
/// Logical pixels between dots, so that the line is seen between them.
constexpr double nodeDistance = 10;
/// Up to so many strokes that change are drawn apart from the picture of the others.
constexpr std::size_t fewOutlines = 64;

/// The box of what the view shows of the canvas, and of `beyond` pixels around it.
Rect shownBox(const View &view, double beyond)
{
    Rect box;
    const double w = view.width, h = view.height;
    for (const Point corner : {Point{-beyond, -beyond}, Point{w + beyond, -beyond}, Point{w + beyond, h + beyond},
                               Point{-beyond, h + beyond}})
        box.include(view.toCanvas(corner));
    return box;
}

/// About how long the lines of strokes are in the view, logical pixels.
double lengthInView(const std::vector<OutlinedStroke> &strokes, const View &view, double dpr)
{
    const Rect window = shownBox(view, 0);
    const double most = std::hypot(view.width, view.height);
    double sum = 0;
    for (const OutlinedStroke &shown : strokes)
        for (const Segment &segment : shown.stroke->segments) {
            const Cubic cubic = shown.stroke->cubicOf(segment);
            Rect box;
            for (const Point &p : cubic.p)
                box.include(p);
            if (box.grown(1 / view.scale).intersects(window))
                sum += std::min(most, view.scale * (length(cubic.p[1] - cubic.p[0]) + length(cubic.p[2] - cubic.p[1]) +
                                                    length(cubic.p[3] - cubic.p[2])));
        }
    return sum / dpr;
}

/// How much of the pixels the lines of paths cover, by squares.
class Crowd {
public:
    explicit Crowd(double dpr) : m_side(crowdSquare * dpr), m_share(lineWidth * dpr / (m_side * m_side)) {}

    void add(const QPainterPath &path)
    {
        forEachPiece(path, [this](QPointF middle, double length) { m_lengths[squareOf(middle)] += length; });
    }
    /// The share that lines cover around a path, as a mean over its length.
    double around(const QPainterPath &path) const
    {
        double sum = 0, whole = 0;
        forEachPiece(path, [&](QPointF middle, double length) {
            sum += length * m_lengths.at(squareOf(middle));
            whole += length;
        });
        return whole > 0 ? sum / whole * m_share : 0;
    }

private:
    using Square = std::pair<int, int>;

    Square squareOf(QPointF at) const { return {int(std::floor(at.x() / m_side)), int(std::floor(at.y() / m_side))}; }
    /// Calls visit(middle, length) for pieces of a path of lines that are shorter than half of a square.
    template <typename Visit>
    void forEachPiece(const QPainterPath &path, Visit visit) const
    {
        for (int i = 1; i < path.elementCount(); ++i) {
            if (path.elementAt(i).isMoveTo())
                continue;
            const QPointF from = path.elementAt(i - 1), way = QPointF(path.elementAt(i)) - from;
            const double length = std::hypot(way.x(), way.y());
            const int pieces = std::max(1, int(std::ceil(2 * length / m_side)));
            for (int k = 0; k < pieces; ++k)
                visit(from + way * ((k + 0.5) / pieces), length / pieces);
        }
    }

    double m_side, m_share;
    std::map<Square, double> m_lengths;
};

} // namespace

/// Finds the places of the selected strokes, unless the same strokes are selected in the same order.
void SelectionOutline::locate(const Painting &painting, const Selection &selection)
{
    if (m_boxes.follow(painting.strokes) && selection == m_selection)
        return;
    m_selection = selection;
    m_stale = true;
    m_places.clear();
    const std::set<StrokeId> &wanted = m_selection.strokes;
    auto next = wanted.begin(); // Most often the order of strokes is that of their ids.
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
    const Locks isLocked(painting.groups);
    for (const std::size_t place : m_places) {
        const Rect &around = m_boxes[place];
        const bool isWithin = box.contains({around.left, around.top}) && box.contains({around.right, around.bottom});
        // Most curves lie within the box so far, and add nothing to it.
        if (!isWithin && !isLocked(*painting.strokes[place]))
            box = box.united(curveBox(*painting.strokes[place]));
    }
    return box;
}

/// Returns true where what was gathered is still valid. Strokes that are drawn apart are then taken as they are now.
bool SelectionOutline::follow(const View &view, const Painting &painting, bool moving)
{
    const std::optional<Point> shift = shiftBetween(m_shown.view, view);
    const double most = m_thin ? ThinOutline::margin : 0;
    if (m_stale || !shift || std::abs(shift->x) > most || std::abs(shift->y) > most ||
        painting.strokes.size() != m_strokes.size())
        return false;
    std::vector<std::size_t> changed;
    painting.strokes.forEachDifference(m_strokes, [&](std::size_t place) {
        if (changed.size() <= fewOutlines)
            changed.push_back(place);
    });
    if (changed.empty())
        return moving || std::none_of(m_shown.strokes.begin(), m_shown.strokes.end(),
                                      [](const OutlinedStroke &shown) { return shown.apart; });
    return moving && m_thin && changed.size() <= fewOutlines && followApart(painting.strokes, changed);
}

bool SelectionOutline::followApart(const StrokeList &strokes, const std::vector<std::size_t> &changed)
{
    for (const std::size_t place : changed) {
        const StrokePtr &stroke = strokes[place];
        if (std::as_const(m_strokes)[place]->id != stroke->id)
            return false;
        if (!m_selection.strokes.contains(stroke->id))
            continue;
        const auto it = std::lower_bound(m_shown.strokes.begin(), m_shown.strokes.end(), place,
                                         [](const OutlinedStroke &shown, std::size_t p) { return shown.place < p; });
        if (it == m_shown.strokes.end() || it->place != place)
            return false; // The stroke comes into the view.
        it->stroke = stroke;
        if (!it->chosen.empty())
            m_thinLines.forgetChosen();
        if (!std::exchange(it->apart, true))
            m_thinLines.forgetLines();
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

void SelectionOutline::gather(const View &view, const Painting &painting, double dpr)
{
    if (!(view == m_shown.view))
        m_lines.clear();
    m_shown.view = view;
    m_strokes = painting.strokes;
    m_stale = m_weighed = false;
    m_thinLines.forgetLines();
    m_thinLines.forgetChosen();
    m_shown.strokes.clear();
    m_shown.box = {};
    m_shown.anyChosen = !m_selection.segments.empty();
    const Rect window = shownBox(view, ThinOutline::margin);
    std::size_t segments = 0;
    for (const std::size_t place : m_places) {
        if (!m_boxes[place].intersects(window))
            continue;
        const StrokePtr &stroke = painting.strokes[place];
        segments += stroke->segments.size();
        m_shown.strokes.push_back({place, stroke, chosenOf(stroke->id)});
        m_shown.box = m_shown.box.united(m_boxes[place]);
    }
    m_segments = segments;
    m_thin = segments > fineSegments || lengthInView(m_shown.strokes, view, dpr) > fineLength;
    if (m_thin)
        m_lines.clear();
    else
        std::erase_if(m_lines, [&](const auto &line) { return !m_selection.strokes.contains(line.first); });
}

const SelectionOutline::Line &SelectionOutline::lineOf(const OutlinedStroke &shown)
{
    const StrokePtr &stroke = shown.stroke;
    Line &line = m_lines[stroke->id];
    if (line.stroke == stroke && line.chosen == shown.chosen)
        return line;
    line = {stroke, shown.chosen, {}, {}, {}, 1};
    const Rect window = Rect::of(0, 0, m_shown.view.width, m_shown.view.height).grown(8);
    for (int k = 0; k < int(stroke->segments.size()); ++k) {
        const Cubic cubic = stroke->cubicOf(stroke->segments[std::size_t(k)]);
        const bool isChosen = line.chosen.contains(k);
        if (stroke->segments[std::size_t(k)].takesPaint() && !isChosen)
            continue; // it has lines of its own
        addCurve(isChosen ? line.segments : line.path, cubic, m_shown.view);
        if (!isChosen)
            continue;
        for (const Point &node : {m_shown.view.toPixels(cubic.p[0]), m_shown.view.toPixels(cubic.p[3])})
            if (window.contains(node))
                line.nodes.push_back(node);
    }
    return line;
}

/// Makes lines fainter that lie close to others or to themselves.
void SelectionOutline::weigh(double dpr)
{
    Crowd crowd(dpr);
    for (const OutlinedStroke &shown : m_shown.strokes)
        crowd.add(m_lines.at(shown.stroke->id).path);
    for (const OutlinedStroke &shown : m_shown.strokes) {
        Line &line = m_lines.at(shown.stroke->id);
        line.weight = std::min(1.0, crowded / std::max(crowd.around(line.path), 1e-6));
    }
    m_weighed = true;
}

void SelectionOutline::paintFine(QPainter &painter, const OverlayColours &colours, double dpr) const
{
    QColor quiet = colours.accent;
    quiet.setAlpha(m_selection.segments.empty() ? 255 : 150);
    // Each stroke is a path of its own, since one path of all would be searched for crossings.
    for (const OutlinedStroke &shown : m_shown.strokes)
        strokeTwoTone(painter, m_lines.at(shown.stroke->id).path, quiet, lineWidth * dpr, Qt::SolidLine,
                      m_lines.at(shown.stroke->id).weight);
    for (const OutlinedStroke &shown : m_shown.strokes)
        if (!shown.chosen.empty())
            strokeTwoTone(painter, m_lines.at(shown.stroke->id).segments, colours.accent, 2.2 * dpr);
    for (const OutlinedStroke &shown : m_shown.strokes) {
        const Point *last = nullptr;
        for (const Point &node : m_lines.at(shown.stroke->id).nodes)
            if (!last || length(node - *last) >= nodeDistance * dpr) {
                paintNode(painter, node, colours, dpr);
                last = &node;
            }
    }
}

void SelectionOutline::paint(QPainter &painter, const View &view, const Painting &painting, const Selection &selection,
                             const OverlayColours &colours, double dpr, bool moving)
{
    locate(painting, selection);
    if (!follow(view, painting, moving)) {
        const bool mayMend = moving && m_thin && m_thinLines.isDrawn() && view == m_shown.view;
        const std::vector<OutlinedStroke> before = std::exchange(m_shown.strokes, {});
        gather(view, painting, dpr);
        if (mayMend && m_thin)
            m_thinLines.mend(before, m_boxes);
    }
    if (m_shown.strokes.empty())
        return;
    if (m_thin) {
        m_thinLines.paint(painter, view, dpr, colours.accent, moving);
        return;
    }
    if (moving && m_segments > smoothSegments) {
        paintQuickLines(painter, view, m_shown.strokes, false, colours.accent, dpr);
        m_thinLines.paintChosen(painter, colours.accent, dpr, {});
        return;
    }
    for (const OutlinedStroke &shown : m_shown.strokes)
        lineOf(shown);
    if (!m_weighed)
        weigh(dpr);
    painter.setRenderHint(QPainter::Antialiasing);
    paintFine(painter, colours, dpr);
}

} // namespace suffuse

#include "app/canvas/selection_outline.h"

#include <QLineF>

namespace suffuse {

namespace {

/// Segments in the view from which on lines are thin.
constexpr std::size_t fineSegments = 600;
/// About so many lines are what a thin picture has at most, and one for each stroke.
constexpr double thinLines = 20'000;
constexpr double thinOpacity = 0.6;
constexpr double leastSpacing = 5; ///< logical pixels between the points of a thin line

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

/// Offsets from a point of the canvas to pixels, without the sines of View::toPixels each time.
struct OffsetMap {
    Point base, right, down;

    OffsetMap(const View &view, Point origin)
        : base(view.toPixels(origin)), right(unitOf(view, {1, 0})), down(unitOf(view, {0, 1}))
    {}
    QPointF operator()(Point offset) const
    {
        return {base.x + offset.x * right.x + offset.y * down.x, base.y + offset.x * right.y + offset.y * down.y};
    }

private:
    static Point unitOf(View view, Point vector)
    {
        view.centre = {};
        return view.toPixels(vector) - view.toPixels({});
    }
};

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

/// A polyline through the stroke with points about `spacing` pixels apart.
void addThin(QList<QLineF> &lines, const Stroke &stroke, const View &view, double spacing)
{
    constexpr double mostPieces = 16; // of a segment
    const OffsetMap pixelOf(view, stroke.origin);
    QPointF last = pixelOf(Point{} + stroke.segments.front().bezier[0]);
    double since = 0; // pixels along the curve
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const Segment &segment = stroke.segments[k];
        const double size = polygonLength(segment) * view.scale;
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
            const QPointF p = pixelOf(i == pieces ? Point{} + segment.bezier[3] : cubic.at(double(i) / pieces));
            lines << QLineF(last, p);
            last = p;
        }
    }
}

} // namespace

bool SelectionOutline::isUnchanged(const View &view, const Painting &painting, const Selection &selection) const
{
    if (!(view == m_view) || painting.strokes.size() != m_strokes.size() || selection != m_selection)
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
    const Rect window = shownBox(view, 8);
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

void SelectionOutline::drawThin(const QColor &colour, double dpr)
{
    m_thinColour = colour;
    m_drawn = true;
    if (m_picture.size() != QSize(m_view.width, m_view.height))
        m_picture = QImage(m_view.width, m_view.height, QImage::Format_ARGB32_Premultiplied);
    m_picture.fill(Qt::transparent);
    double total = 0; // pixels
    for (const auto &[stroke, chosen] : m_shown)
        for (const Segment &segment : stroke->segments)
            total += polygonLength(segment) * m_view.scale;
    const double spacing = std::max(leastSpacing * dpr, total / thinLines);
    QList<QLineF> lines;
    for (const auto &[stroke, chosen] : m_shown)
        addThin(lines, *stroke, m_view, spacing);
    QPainter painter(&m_picture);
    painter.setPen(QPen(colour, 0)); // one device pixel, not smoothed: many times faster
    painter.drawLines(lines);
}

void SelectionOutline::paint(QPainter &painter, const View &view, const Painting &painting, const Selection &selection,
                             const OverlayColours &colours, double dpr)
{
    if (selection.isEmpty()) {
        *this = {};
        return;
    }
    if (!isUnchanged(view, painting, selection))
        gather(view, painting, selection);
    if (m_thin) {
        if (!m_drawn || m_thinColour != colours.accent)
            drawThin(colours.accent, dpr);
        painter.setOpacity(thinOpacity); // the paint below is still to be seen
        painter.drawImage(QPointF(0, 0), m_picture);
        painter.setOpacity(1);
        return;
    }
    for (const auto &[stroke, chosen] : m_shown)
        lineOf(stroke, chosen);
    painter.setRenderHint(QPainter::Antialiasing);
    paintFine(painter, colours, dpr);
}

} // namespace suffuse

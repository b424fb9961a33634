#include "app/tools/nodes/node_marks.h"

#include "app/canvas/view_transform.h"
#include "model/painting/editable.h"
#include "model/shaping/nodes/coarse_nodes.h"
#include "render/pixel_map.h"

#include <QPixmap>

namespace suffuse {

namespace {

constexpr double leastGap = 24;        ///< logical pixels along the curve between nodes that are shown
constexpr double nodeRadius = 4;       ///< logical pixels
constexpr double handleMarkRadius = 3; ///< logical pixels
constexpr double leastHandle = 6;      ///< logical pixels; shorter handles would lie under their node
constexpr std::size_t manyMarks = 2000;
constexpr std::size_t manySelected = 500;
constexpr double place = 10; ///< logical pixels of a square that shows one mark only, where there are many

void drawNode(QPainter &painter, QPointF at, NodeKind kind, bool selected, double radius, const QColor &accent,
              double dpr)
{
    painter.setPen(QPen(selected ? QColor(Qt::white) : accent, std::max(1.0, std::round(1.2 * dpr))));
    painter.setBrush(selected ? accent : QColor(Qt::white));
    const double r = std::round(radius * dpr), side = r - dpr, tip = r + dpr;
    switch (kind) {
    case NodeKind::Smooth:
        painter.drawRect(QRectF(at.x() - side, at.y() - side, 2 * side, 2 * side));
        break;
    case NodeKind::Symmetric:
        painter.drawEllipse(at, r, r);
        break;
    case NodeKind::Corner:
        painter.drawPolygon(
            QPolygonF{at + QPointF(0, -tip), at + QPointF(tip, 0), at + QPointF(0, tip), at + QPointF(-tip, 0)});
        break;
    }
}

/// The picture of one mark. It is painted at whole pixels, so that straight edges stay sharp.
QPixmap stampOf(NodeKind kind, bool selected, double radius, const QColor &accent, double dpr)
{
    const int half = int(std::ceil((radius + 3) * dpr));
    QPixmap stamp(2 * half + 1, 2 * half + 1);
    stamp.fill(Qt::transparent);
    QPainter painter(&stamp);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool odd = std::fmod(std::max(1.0, std::round(1.2 * dpr)), 2) == 1;
    drawNode(painter, odd ? QPointF(half + 0.5, half + 0.5) : QPointF(half, half), kind, selected, radius, accent, dpr);
    return stamp;
}

} // namespace

NodeMarks::NodeMarks(const Painting &painting, const std::set<StrokeId> &strokes, const std::set<NodeRef> &selected,
                     const View &view, double dpr, ShownNodes &shown)
    : m_view(view), m_dpr(dpr), m_shown(shown)
{
    if (const double now = gap(view, dpr); now != shown.gap)
        shown = {now, {}};
    if (strokes.empty())
        return;
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (strokes.contains(stroke->id) && isEditable(*stroke))
            add(*stroke, selected);
    if (m_nodes.size() > manyMarks)
        thinOut();
}

void NodeMarks::follow(const Painting &painting, const std::vector<StrokeId> &strokes,
                       const std::set<NodeRef> &selected)
{
    const std::set<StrokeId> dragged(strokes.begin(), strokes.end());
    std::erase_if(m_nodes, [&](const NodeMark &mark) { return dragged.contains(mark.node.stroke); });
    std::erase_if(m_handles, [&](const HandleMark &mark) { return dragged.contains(mark.handle.node.stroke); });
    for (const StrokePtr &stroke : painting.strokes)
        if (dragged.contains(stroke->id))
            add(*stroke, selected);
}

void NodeMarks::add(const Stroke &stroke, const std::set<NodeRef> &selected)
{
    addNodes(stroke, selected);
    if (selected.size() <= manySelected)
        addHandles(stroke, selected);
}

Rect NodeMarks::window() const
{
    return Rect::of(0, 0, m_view.width, m_view.height).grown(reach * m_dpr);
}

double NodeMarks::gap(const View &view, double dpr)
{
    return leastGap * dpr / view.scale;
}

/// The coarse nodes and the selected ones. Within a run of selected nodes only the coarse ones are shown.
std::vector<int> NodeMarks::shownNodes(const Stroke &stroke, const std::set<NodeRef> &selected)
{
    auto &[count, coarse] = m_shown.ofStrokes[stroke.id];
    if (const int now = nodeCount(stroke); coarse.empty() || now != count) {
        count = now;
        coarse = coarseNodes(stroke, m_shown.gap);
    }
    std::vector<int> shown = coarse;
    for (auto it = selected.lower_bound({stroke.id, 0}); it != selected.end() && it->stroke == stroke.id; ++it) {
        const int k = it->node;
        if (!selected.contains({stroke.id, k - 1}) || !selected.contains({stroke.id, k + 1}))
            shown.push_back(k);
    }
    std::sort(shown.begin(), shown.end());
    shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
    return shown;
}

void NodeMarks::addNodes(const Stroke &stroke, const std::set<NodeRef> &selected)
{
    const Rect visible = window();
    const PixelMap pixelOf(m_view, stroke.origin);
    const auto isSeen = [&](const Segment &segment) {
        return visible.contains(pixelOf(Point() + segment.bezier[0])) ||
               visible.contains(pixelOf(Point() + segment.bezier[3]));
    };
    if (std::none_of(stroke.segments.begin(), stroke.segments.end(), isSeen))
        return;
    for (const int k : shownNodes(stroke, selected))
        if (const Point pixel = pixelOf(nodePosition(stroke, k) - stroke.origin); visible.contains(pixel))
            m_nodes.push_back({{stroke.id, k}, pixel, nodeKind(stroke, k), selected.contains({stroke.id, k})});
}

void NodeMarks::addHandles(const Stroke &stroke, const std::set<NodeRef> &selected)
{
    std::set<int> nodes;
    for (auto it = selected.lower_bound({stroke.id, 0}); it != selected.end() && it->stroke == stroke.id; ++it)
        for (int k = it->node - 1; k <= it->node + 1; ++k)
            if (k >= 0 && k < nodeCount(stroke))
                nodes.insert(k);
    for (const int k : nodes) {
        const Point nodePixel = m_view.toPixels(nodePosition(stroke, k));
        for (const bool after : {false, true})
            if (const std::optional<Point> handle = handlePosition(stroke, k, after)) {
                const Point pixel = m_view.toPixels(*handle);
                if (length(pixel - nodePixel) >= leastHandle * m_dpr)
                    m_handles.push_back({{{stroke.id, k}, after}, pixel, nodePixel});
            }
    }
}

void NodeMarks::thinOut()
{
    const Rect visible = window();
    const double cell = place * m_dpr;
    const int columns = int(visible.width() / cell) + 1, rows = int(visible.height() / cell) + 1;
    std::vector<bool> taken(std::size_t(columns) * std::size_t(rows));
    std::stable_partition(m_nodes.begin(), m_nodes.end(), [](const NodeMark &mark) { return mark.selected; });
    std::erase_if(m_nodes, [&](const NodeMark &mark) {
        const int x = int((mark.pixel.x - visible.left) / cell), y = int((mark.pixel.y - visible.top) / cell);
        const std::size_t i = std::size_t(y) * std::size_t(columns) + std::size_t(x);
        const bool wasTaken = taken[i];
        taken[i] = true;
        return wasTaken;
    });
}

NodeMarks::Hit NodeMarks::hit(Point pixel, double within) const
{
    Hit hit;
    double nearest = within * m_dpr;
    for (const HandleMark &mark : m_handles)
        if (const double d = length(mark.pixel - pixel); d <= nearest) {
            nearest = d;
            hit.handle = mark.handle;
        }
    for (const NodeMark &mark : m_nodes)
        // On equal distance the node wins, since it lies over its handles.
        if (const double d = length(mark.pixel - pixel); d <= nearest) {
            nearest = d;
            hit = {mark.node, {}};
        }
    return hit;
}

void NodeMarks::paint(QPainter &painter, const OverlayColours &colours, const Hit &hovered) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    const double size = (nodeRadius + reach) * m_dpr;
    const QRectF clip = painter.hasClipping() ? painter.clipBoundingRect() : QRectF(0, 0, m_view.width, m_view.height);
    const QRectF painted = clip.adjusted(-size, -size, size, size);
    QPainterPath lines;
    for (const HandleMark &mark : m_handles) {
        Point a = mark.nodePixel, b = mark.pixel;
        if (!clipLine(a, b, Rect::of(0, 0, m_view.width, m_view.height).grown(reach)))
            continue;
        lines.moveTo(a.x, a.y);
        lines.lineTo(b.x, b.y);
    }
    strokeTwoTone(painter, lines, colours.accent, m_dpr);
    for (const HandleMark &mark : m_handles) {
        const double r = (hovered.handle == mark.handle ? handleMarkRadius + 1.5 : handleMarkRadius) * m_dpr;
        painter.setPen(QPen(Qt::white, m_dpr));
        painter.setBrush(colours.accent);
        painter.drawEllipse(QPointF(mark.pixel.x, mark.pixel.y), r, r);
    }
    const NodeKind kinds[] = {NodeKind::Smooth, NodeKind::Symmetric, NodeKind::Corner};
    for (const bool selected : {false, true}) { // The selected nodes come last, and so lie on top.
        std::array<QPixmap, 3> stamps;
        for (const NodeKind kind : kinds)
            stamps[std::size_t(kind)] = stampOf(kind, selected, nodeRadius, colours.accent, m_dpr);
        for (const NodeMark &mark : m_nodes) {
            if (mark.selected != selected || !painted.contains(mark.pixel.x, mark.pixel.y))
                continue;
            const bool large = hovered.node == mark.node;
            const QPixmap stamp = large ? stampOf(mark.kind, selected, nodeRadius + 1.5, colours.accent, m_dpr)
                                        : stamps[std::size_t(mark.kind)];
            painter.drawPixmap(
                QPointF(std::floor(mark.pixel.x) - stamp.width() / 2, std::floor(mark.pixel.y) - stamp.height() / 2),
                stamp);
        }
    }
    painter.setBrush(Qt::NoBrush);
}

} // namespace suffuse

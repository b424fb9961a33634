#include "app/tools/shaping/knife_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/tools/tool_fields.h"
#include "app/widgets/look/section.h"
#include "model/painting/editable.h"
#include "model/shaping/erasing/erase.h"
#include "model/shaping/erasing/fill_cut.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

#include <numbers>

namespace suffuse {

namespace {

constexpr double cutAngleStep = std::numbers::pi / 12; ///< The line takes angles in steps of this with Ctrl.

} // namespace

KnifeTool::KnifeTool(CanvasWidget &canvas, QObject *parent) : CanvasTool(canvas, parent) {}

QString KnifeTool::hint() const
{
    if (!said().isEmpty())
        return said();
    return tr(
        "Drag a line to insert nodes where it crosses strokes. Shift: cut the strokes apart. Ctrl: steps of 15°.");
}

/// There is nothing to be set, so the row says what the tool does.
QWidget *KnifeTool::options()
{
    if (m_options)
        return m_options;
    m_options = new QWidget;
    QHBoxLayout *row = toolRow(m_options);
    QLabel *what =
        quietLabel(tr("Inserts nodes where a line crosses strokes; with Shift it cuts them apart there."), m_options);
    what->setWordWrap(false);
    row->addWidget(what);
    row->addStretch();
    return m_options;
}

void KnifeTool::press(const PointerEvent &event)
{
    say({});
    m_busy = true;
    m_selected = m_editor.document().selection().strokes;
    m_from = m_to = event.point;
    m_splits = event.modifiers & Qt::ShiftModifier;
}

void KnifeTool::aim(const PointerEvent &event)
{
    m_splits = event.modifiers & Qt::ShiftModifier;
    m_to = event.point;
    if (event.modifiers & Qt::ControlModifier) {
        const View &view = m_canvas.view();
        const Point from = view.toPixels(m_from), arm = event.pixel - from;
        const double angle = cutAngleStep * std::round(std::atan2(arm.y, arm.x) / cutAngleStep);
        m_to = view.toCanvas(from + length(arm) * Point{std::cos(angle), std::sin(angle)});
    }
    m_canvas.updateOverlay();
}

void KnifeTool::move(const PointerEvent &event)
{
    if (m_busy)
        aim(event);
}

void KnifeTool::release(const PointerEvent &event)
{
    if (!m_busy)
        return;
    aim(event);
    cut();
    m_busy = false;
    m_canvas.updateOverlay();
}

void KnifeTool::cut()
{
    bool endsWithin = false;
    const PlacesOfStrokes places = cuts(&endsWithin);
    Document &document = m_editor.document();
    const auto sum = [&](auto count) { // counts over the strokes that are crossed
        int all = 0;
        for (const auto &[id, at] : places)
            if (const StrokePtr stroke = document.painting()->find(id))
                all += int(count(*stroke));
        return all;
    };
    const auto chains = [&] { return sum([](const Stroke &stroke) { return chainsOf(stroke).size(); }); };
    const int nodesBefore = sum(nodeCount), chainsBefore = chains();
    if (m_splits)
        m_editor.push(cutAlong(document, places, m_from, m_to), tr("Cut strokes"));
    else
        m_editor.push(insertNodes(document, places), tr("Insert nodes"));
    const int inserted = sum(nodeCount) - nodesBefore, crossed = int(places.size());
    const int parts = crossed + chains() - chainsBefore;
    if (m_splits && parts > crossed)
        //: what the knife did; %1: "2 strokes", %2: "5 parts"
        say(tr("%1 cut into %2").arg(tr("%Ln stroke(s)", nullptr, crossed), tr("%Ln part(s)", nullptr, parts)));
    else if (!m_splits && inserted > 0)
        //: what the knife did; %1: "3 nodes", %2: "2 strokes"
        say(tr("%1 inserted in %2").arg(tr("%Ln node(s)", nullptr, inserted), tr("%Ln stroke(s)", "in", crossed)));
    else
        say(endsWithin           ? tr("A fill is cut only where the line goes all the way through it.")
            : crossed > 0        ? tr("There are nodes already where the line crosses strokes.")
            : m_selected.empty() ? tr("The line crosses no stroke.")
                                 : tr("The line crosses no selected stroke."));
}

void KnifeTool::cancel()
{
    m_busy = false;
    say({});
    m_canvas.updateOverlay();
}

/// `endsWithin` gets whether the outline of a fill is crossed and not cut.
PlacesOfStrokes KnifeTool::cuts(bool *endsWithin) const
{
    PlacesOfStrokes places;
    Rect line;
    line.include(m_from);
    line.include(m_to);
    const PaintingPtr reached = m_editor.layer().reached();
    const Painting &painting = *reached;
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        const bool isMeant = m_selected.empty() || m_selected.contains(stroke->id);
        if (!isMeant || !isEditable(*stroke))
            continue;
        const auto isNear = [&](const Segment &s) { return stroke->cubicOf(s).controlBox().intersects(line); };
        if (std::none_of(stroke->segments.begin(), stroke->segments.end(), isNear))
            continue;
        std::vector<CurvePlace> found = crossings(*stroke, m_from, m_to);
        if (m_splits && stroke->fill && !found.empty()) {
            found = filledCutPlaces(*stroke, m_from, m_to);
            if (endsWithin)
                *endsWithin = *endsWithin || found.empty();
        }
        std::erase_if(found, [&](const CurvePlace &p) { // Strokes that are not painted yet at this moment are not cut.
            return stroke->segments[std::size_t(p.segment)].born > m_editor.clock().time();
        });
        if (!found.empty())
            places[stroke->id] = std::move(found);
    }
    return places;
}

void KnifeTool::paint(QPainter &painter, const View &view, double dpr) const
{
    if (!m_busy || m_from == m_to)
        return;
    const Rect window = Rect::of(0, 0, view.width, view.height).grown(8 * dpr);
    Point a = view.toPixels(m_from), b = view.toPixels(m_to);
    const Point way = (1 / std::max(length(b - a), 1e-9)) * (b - a);
    const QColor accent = m_canvas.overlayColours().accent;
    if (clipLine(a, b, window)) {
        QPainterPath line(QPointF(a.x, a.y));
        line.lineTo(b.x, b.y);
        strokeTwoTone(painter, line, accent, 1.4 * dpr, m_splits ? Qt::SolidLine : Qt::DashLine);
    }
    const double r = 4 * dpr;
    for (const auto &[id, places] : cuts()) {
        const StrokePtr stroke = m_editor.document().painting()->find(id);
        for (const CurvePlace &place : places) {
            const Point at = view.toPixels(stroke->cubicOf(stroke->segments[std::size_t(place.segment)]).at(place.p));
            if (!window.contains(at))
                continue;
            painter.setPen(QPen(m_splits ? QColor(Qt::white) : accent, 1.2 * dpr));
            painter.setBrush(m_splits ? accent : QColor(Qt::white));
            if (m_splits) { // A cut that splits is shown as two ends with a gap between them.
                for (const double side : {-1.0, 1.0}) {
                    const Point end = at + (1.2 * side * r) * Point{-way.y, way.x};
                    painter.drawEllipse(QPointF(end.x, end.y), 0.65 * r, 0.65 * r);
                }
            } else {
                painter.drawRect(QRectF(at.x - 0.75 * r, at.y - 0.75 * r, 1.5 * r, 1.5 * r));
            }
        }
    }
    painter.setBrush(Qt::NoBrush);
}

} // namespace suffuse

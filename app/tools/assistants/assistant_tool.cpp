#include "app/tools/assistants/assistant_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/canvas/overlay/assistant_lines.h"
#include "app/session/commands/commands.h"
#include "app/session/drawing_aids.h"
#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "model/shaping/nodes/node_path.h"

#include <QKeyEvent>
#include <QLocale>
#include <QPainterPathStroker>

#include <utility>

namespace suffuse {

namespace {

constexpr double assistantReach = 10; ///< logical pixels around a point in which a press takes it
constexpr double bodyReach = 5;       ///< the same beside a line
constexpr double leastDrag = 4;       ///< logical pixels; a shorter one is a click, which changes nothing
constexpr double usualShare = 0.25;   ///< of the view's shorter side to either side of its middle

QString assistantKindKey()
{
    return QStringLiteral("tools/assistants/kind");
}

AssistantKind storedAssistantKind()
{
    const int kind = settings::store().value(assistantKindKey(), int(AssistantKind::VanishingPoint)).toInt();
    return kind >= 0 && kind <= int(AssistantKind::Concentric) ? AssistantKind(kind) : AssistantKind::VanishingPoint;
}

bool isReturnKey(const QKeyEvent &event)
{
    return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

/// Without the smaller one of its coordinates.
Point largerPart(Point by)
{
    (std::abs(by.x) < std::abs(by.y) ? by.x : by.y) = 0;
    return by;
}

} // namespace

AssistantTool::AssistantTool(CanvasWidget &canvas, Commands &commands, QObject *parent)
    : CanvasTool(canvas, parent), m_commands(commands), m_kind(storedAssistantKind())
{
    connect(&m_editor.aids(), &DrawingAids::changed, this, &AssistantTool::follow);
    connect(&m_editor.aids(), &DrawingAids::aboutToReset, this, [this] {
        m_busy = false;
        choose({});
    });
}

QString AssistantTool::hint() const
{
    return tr("Drag for a new assistant; drag its points or lines to change it. Shift: in steps. Tab: next "
              "point. Return: a new one.");
}

QCursor AssistantTool::cursor() const
{
    const Part &part = m_busy ? m_chosen : m_over;
    if (part.assistant < 0)
        return Qt::CrossCursor;
    return part.point < 0 ? Qt::SizeAllCursor : Qt::PointingHandCursor;
}

QWidget *AssistantTool::options()
{
    if (m_row)
        return m_row;
    m_row = new AssistantRow(m_commands);
    m_row->showKind(m_kind);
    connect(m_row, &AssistantRow::kindChosen, this, &AssistantTool::setKind);
    connect(m_row, &AssistantRow::newAsked, this, &AssistantTool::addInMiddle);
    connect(m_row, &AssistantRow::entered, this, &AssistantTool::enter);
    return m_row;
}

void AssistantTool::setKind(AssistantKind kind)
{
    m_kind = kind;
    settings::store().setValue(assistantKindKey(), int(kind));
    if (m_row)
        m_row->showKind(kind);
}

const Assistant *AssistantTool::chosen() const
{
    const std::vector<Assistant> &all = m_editor.aids().assistants();
    return m_chosen.assistant >= 0 && m_chosen.assistant < int(all.size()) ? &all[std::size_t(m_chosen.assistant)]
                                                                           : nullptr;
}

/// Points come before lines, and what is chosen before all else.
AssistantTool::Part AssistantTool::partAt(Point pixel) const
{
    const View &view = m_canvas.view();
    const double dpr = m_canvas.devicePixelRatioF();
    const std::vector<Assistant> &all = m_editor.aids().assistants();
    Part found;
    double least = assistantReach * dpr;
    for (int i = 0; i < int(all.size()); ++i)
        for (int k = 0; k < int(all[std::size_t(i)].points.size()); ++k) {
            const double away = length(view.toPixels(all[std::size_t(i)].points[std::size_t(k)]) - pixel);
            if (away < least || (away == least && i == m_chosen.assistant)) {
                least = away;
                found = {i, k};
            }
        }
    if (found.assistant >= 0)
        return found;
    QPainterPathStroker stroker;
    stroker.setWidth(2 * bodyReach * dpr);
    for (int i = 0; i < int(all.size()); ++i)
        if (stroker.createStroke(bodyOf(all[std::size_t(i)], view)).contains(QPointF(pixel.x, pixel.y)))
            if (found.assistant < 0 || i == m_chosen.assistant)
                found = {i, -1};
    return found;
}

void AssistantTool::choose(const Part &part)
{
    if (std::exchange(m_chosen, part) != part)
        m_commands.update(Command::Delete);
    showNumbers();
    m_canvas.updateOverlay();
}

void AssistantTool::follow()
{
    if (const Assistant *one = chosen(); !one)
        choose({});
    else if (m_chosen.point >= int(one->points.size()))
        choose({m_chosen.assistant, -1});
    m_over = {};
    showNumbers();
}

void AssistantTool::showNumbers()
{
    if (m_row)
        m_row->show(chosen(), std::size_t(std::max(m_chosen.point, 0)));
}

void AssistantTool::add(Assistant assistant)
{
    std::vector<Assistant> all = m_editor.aids().assistants();
    const int number = int(all.size());
    all.push_back(std::move(assistant));
    m_editor.aids().setAssistants(std::move(all));
    choose({number < int(m_editor.aids().assistants().size()) ? number : -1, -1});
}

/// Puts it in the place of the chosen one.
void AssistantTool::replace(const Assistant &assistant)
{
    std::vector<Assistant> all = m_editor.aids().assistants();
    if (!chosen() || !assistant.isSound()) // One that is not would be lost.
        return;
    all[std::size_t(m_chosen.assistant)] = assistant;
    m_editor.aids().setAssistants(std::move(all));
}

void AssistantTool::addInMiddle()
{
    if (m_busy)
        return;
    const View &view = m_canvas.view();
    const double size = usualShare * std::min(view.width, view.height) * view.px();
    const bool isStraight = m_kind == AssistantKind::Ruler || m_kind == AssistantKind::Parallel;
    const bool isPoint = m_kind == AssistantKind::VanishingPoint;
    const Point way{isPoint ? 0 : size, isPoint || isStraight ? 0 : size};
    add(Assistant::between(m_kind, view.centre - way, view.centre + way));
}

Point AssistantTool::snapped(Point point) const
{
    return m_snapping.snap(point, m_canvas.view(), m_canvas.devicePixelRatioF()).point;
}

void AssistantTool::press(const PointerEvent &event)
{
    m_before = m_editor.aids().assistants();
    m_chosenBefore = m_chosen;
    m_snapping = Snapping(*m_editor.document().painting(), m_canvas.aids(), m_editor.aids().guides());
    choose(partAt(event.pixel));
    m_busy = true;
    m_moved = false;
    m_pixel = event.pixel;
    m_makes = !chosen();
    m_from = m_makes ? snapped(event.point) : event.point;
    if (m_makes && m_kind == AssistantKind::VanishingPoint)
        add(made(event));
}

Assistant AssistantTool::made(const PointerEvent &event) const
{
    const bool isBox = Assistant::pointsOf(m_kind) > 2;
    Point to = snapped(event.point);
    if (event.modifiers & Qt::ShiftModifier) {
        const Point way = event.point - m_from;
        const double side = std::max(std::abs(way.x), std::abs(way.y));
        to = isBox ? m_from + Point{std::copysign(side, way.x), std::copysign(side, way.y)}
                   : inSteps(m_from, event.point);
    }
    const bool fromMiddle = isBox && (event.modifiers & Qt::ControlModifier);
    return Assistant::between(m_kind, fromMiddle ? m_from - (to - m_from) : m_from, to);
}

/// What was taken hold of, as it is with the pointer elsewhere.
Assistant AssistantTool::dragged(const PointerEvent &event) const
{
    const Assistant &was = m_before[std::size_t(m_chosen.assistant)];
    const bool steps = event.modifiers & Qt::ShiftModifier;
    const Point by = event.point - m_from;
    if (m_chosen.point < 0)
        return was.movedBy(steps ? largerPart(by) : by);
    const auto number = std::size_t(m_chosen.point);
    const Point from = was.points[number];
    if (!steps)
        return was.withPoint(number, snapped(from + by));
    if (was.isRound() && number == 2) {
        Assistant::Form form = was.form();
        form.second = form.first;
        return was.withForm(form);
    }
    if (was.isRound() && number == 1)
        return was.withPoint(number, inSteps(was.points[0], from + by));
    return was.withPoint(number,
                         was.points.size() == 2 ? inSteps(was.points[1 - number], from + by) : from + largerPart(by));
}

void AssistantTool::move(const PointerEvent &event)
{
    if (!m_busy)
        return;
    m_moved = m_moved || length(event.pixel - m_pixel) >= leastDrag * m_canvas.devicePixelRatioF();
    if (!m_moved)
        return;
    if (m_makes && !chosen())
        add(made(event));
    else if (m_makes)
        replace(made(event));
    else if (m_chosen.assistant < int(m_before.size()))
        replace(dragged(event));
}

void AssistantTool::release(const PointerEvent &event)
{
    move(event);
    m_busy = false;
    hover(event);
}

void AssistantTool::hover(const PointerEvent &event)
{
    if (const Part over = partAt(event.pixel); std::exchange(m_over, over) != over)
        m_canvas.updateOverlay();
    m_canvas.refreshCursor();
}

void AssistantTool::cancel()
{
    if (!std::exchange(m_busy, false))
        return;
    m_editor.aids().setAssistants(m_before);
    choose(m_chosenBefore);
    follow();
}

bool AssistantTool::wantsKey(const QKeyEvent &event) const
{
    const bool tab = event.key() == Qt::Key_Tab || event.key() == Qt::Key_Backtab;
    return (tab || isReturnKey(event)) &&
           !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
}

bool AssistantTool::keyPress(QKeyEvent *event)
{
    if (wantsKey(*event)) { // A drag keeps the keyboard.
        if (m_busy)
            return true;
        if (isReturnKey(*event))
            addInMiddle();
        else
            chooseNext(event->key() == Qt::Key_Backtab || event->modifiers() & Qt::ShiftModifier ? -1 : 1);
        return true;
    }
    const Assistant *one = chosen();
    if (m_busy || !one)
        return false;
    if (event->key() == Qt::Key_Escape) {
        choose({});
        return true;
    }
    const std::optional<Point> way = nudgeOf(*event);
    if (!way)
        return false;
    replace(m_chosen.point < 0
                ? one->movedBy(*way)
                : one->withPoint(std::size_t(m_chosen.point), one->points[std::size_t(m_chosen.point)] + *way));
    return true;
}

void AssistantTool::chooseNext(int step)
{
    const std::vector<Assistant> &all = m_editor.aids().assistants();
    std::vector<Part> parts;
    for (int i = 0; i < int(all.size()); ++i)
        for (int k = 0; k < int(all[std::size_t(i)].points.size()); ++k)
            parts.push_back({i, k});
    if (parts.empty())
        return;
    const Part from{m_chosen.assistant, std::max(m_chosen.point, 0)};
    const auto at = std::ranges::find(parts, from);
    const int count = int(parts.size());
    // From all of an assistant the next one is its first point.
    const int stays = m_chosen.point < 0 && step > 0 ? 0 : step;
    const int next = at == parts.end() ? (step > 0 ? 0 : count - 1) : (int(at - parts.begin()) + stays + count) % count;
    choose(parts[std::size_t(next)]);
    const Assistant &one = *chosen();
    const Point place = one.points[std::size_t(m_chosen.point)];
    m_canvas.bringIntoView(place); // The next key is meant for what is seen.
    const auto number = [](double value) { return QLocale().toString(value, 'f', 1).replace('-', QChar(0x2212)); };
    //: %1: an assistant, as "Vanishing Point"
    emit m_commands.said(tr("%1, point %2 of %3: x %4, y %5")
                             .arg(nameOf(one.kind))
                             .arg(m_chosen.point + 1)
                             .arg(one.points.size())
                             .arg(number(place.x), number(place.y)),
                         8000);
}

bool AssistantTool::deleteSelected()
{
    if (!chosen())
        return false;
    std::vector<Assistant> all = m_editor.aids().assistants();
    all.erase(all.begin() + m_chosen.assistant);
    choose({});
    m_editor.aids().setAssistants(std::move(all));
    return true;
}

void AssistantTool::enter(AssistantRow::Number number, double value)
{
    const Assistant *one = chosen();
    if (!one || m_busy)
        return;
    using enum AssistantRow::Number;
    const auto point = std::size_t(std::max(m_chosen.point, 0));
    if (number == X || number == Y) {
        Point to = one->points[point];
        (number == X ? to.x : to.y) = value;
        replace(m_chosen.point < 0 ? one->movedBy(to - one->points[0]) : one->withPoint(point, to));
    } else if (one->isRound()) {
        Assistant::Form form = one->form();
        (number == Angle ? form.angle : number == First ? form.first : form.second) = value;
        replace(one->withForm(form));
    } else if (number == Angle && one->points.size() == 2) {
        const double size = length(one->points[1] - one->points[0]);
        replace(one->withPoint(1, one->points[0] + size * Point{std::cos(value), std::sin(value)}));
    }
    showNumbers(); // also where nothing has changed
}

void AssistantTool::paint(QPainter &painter, const View &view, double dpr) const
{
    const std::vector<Assistant> &all = m_editor.aids().assistants();
    const OverlayColours &colours = m_canvas.overlayColours();
    if (!m_canvas.aids().showAssistants) // Here they are seen all the same.
        paintAssistants(painter, all, view, colours, dpr);
    if (const Assistant *one = chosen())
        strokeTwoTone(painter, bodyOf(*one, view), colours.assistant, 1.8 * dpr);
    for (int i = 0; i < int(all.size()); ++i)
        for (int k = 0; k < int(all[std::size_t(i)].points.size()); ++k) {
            const Point at = view.toPixels(all[std::size_t(i)].points[std::size_t(k)]);
            if (!Rect::of(0, 0, view.width, view.height).grown(8 * dpr).contains(at))
                continue;
            const bool isChosen = m_chosen == Part{i, k};
            const double r = (m_over == Part{i, k} || isChosen ? 5.5 : 4) * dpr;
            painter.setPen(QPen(isChosen ? QColor(Qt::white) : colours.assistant, 1.4 * dpr));
            painter.setBrush(isChosen ? colours.assistant : QColor(Qt::white));
            painter.drawEllipse(QPointF(at.x, at.y), r, r);
        }
    painter.setBrush(Qt::NoBrush);
}

} // namespace suffuse

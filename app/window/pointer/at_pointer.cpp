#include "app/window/pointer/at_pointer.h"

#include "app/canvas/canvas_widget.h"
#include "app/canvas/handles/rulers.h"
#include "app/session/commands/commands.h"
#include "app/session/commands/session_rows.h"
#include "app/session/open_painting.h"
#include "app/session/selecting/pick.h"
#include "app/tools/brush/brush_palette.h"
#include "app/window/pointer/canvas_menu.h"
#include "app/window/pointer/value_card.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QMainWindow>
#include <QMenu>

#include <algorithm>

namespace suffuse {

AtPointer::AtPointer(const Workplace &place, QObject *parent) : QObject(parent), m_place(place)
{
    m_menu = new QMenu(&place.window);
    m_menu->setObjectName("canvasMenu");
    addRows();
    connect(&place.canvas, &CanvasWidget::asked, this, &AtPointer::ask);
    for (const Tool *tool : place.canvas.findChildren<Tool *>())
        connect(tool, &Tool::valuesAsked, this,
                [this](const PointerEvent &event, const SegmentRef &at) { openValues(event.pixel, at); });
}

AtPointer::~AtPointer()
{
    delete m_menu; // they show the painting, which may go before their window
    delete m_palette;
    delete m_values;
}

void AtPointer::addRows()
{
    Commands &table = m_place.commands;
    table
        .add(Command::CanvasMenu, "canvasMenu", Commands::tr("Menu at t&he Pointer"), "",
             {QKeySequence(Qt::Key_Menu), QKeySequence(Qt::SHIFT | Qt::Key_F10)},
             Commands::tr("What lies under the pointer, and what can be done with it"))
        .runs([this] {
            if (!m_place.canvas.isPressed()) // A release is meant for what is dragged, and not for a row.
                menuByKey();
        });
    table
        .add(Command::BrushPalette, "brushPalette", Commands::tr("Br&ush Palette at the Pointer"), "",
             {QKeySequence(Qt::Key_Q)}, Commands::tr("Brushes, colours, size and zoom where the pointer is"))
        .runs([this] {
            if (!m_place.canvas.isPressed())
                openPalette(here());
        });
    table
        .add(Command::EditHere, "editHere", Commands::tr("Edit Value&s Here…"), "",
             {QKeySequence(Qt::Key_Return), QKeySequence(Qt::Key_Enter)},
             Commands::tr("Width, diffusion, density, colour and opacity of what is selected, at the pointer"))
        .when(anySelected(m_place.open.editor))
        .runs([this] { editHere(); });
}

QPoint AtPointer::onScreen(Point pixel) const
{
    const double ratio = m_place.canvas.devicePixelRatioF();
    return m_place.canvas.mapToGlobal(QPointF(pixel.x / ratio, pixel.y / ratio).toPoint());
}

Point AtPointer::here() const
{
    const CanvasWidget &canvas = m_place.canvas;
    if (const std::optional<Point> pointer = canvas.pointer())
        return *pointer;
    const QRect selected = canvas.selectionOnScreen();
    const QPoint middle = selected.isEmpty() ? canvas.rect().center() : canvas.mapFromGlobal(selected.center());
    return devicePixels(canvas, middle);
}

void AtPointer::ask(const PointerEvent &event)
{
    const bool paints = m_place.commands[Command::Brush].isChecked() && !(event.modifiers & Qt::ShiftModifier);
    if (paints && !isOnRuler(event.pixel))
        openPalette(event.pixel);
    else
        openMenu(event.pixel);
}

/// In a dock the keys mean the dock's own menu.
void AtPointer::menuByKey()
{
    QWidget *focus = QApplication::focusWidget();
    if (focus && focus != &m_place.canvas && focus != &m_place.window) {
        // In a list this is in the middle of the row with the frame.
        const QPoint at = focus->inputMethodQuery(Qt::ImCursorRectangle).toRect().center();
        QContextMenuEvent event(QContextMenuEvent::Keyboard, at, focus->mapToGlobal(at));
        QCoreApplication::sendEvent(focus, &event);
        return;
    }
    openMenu(here());
}

bool AtPointer::isOnRuler(Point pixel) const
{
    return m_place.canvas.aids().showRulers && suffuse::isOnRuler(pixel, m_place.canvas.devicePixelRatioF());
}

void AtPointer::openMenu(Point pixel)
{
    if (isOnRuler(pixel)) {
        fillRulerMenu(*m_menu, m_place);
        m_menu->popup(onScreen(pixel));
        return;
    }
    Editor &editor = m_place.open.editor;
    const Commands &table = m_place.commands;
    const Point point = m_place.canvas.view().toCanvas(pixel);
    const std::vector<SegmentRef> found = strokesAt(m_place, point);
    const bool selects = table[Command::Select].isChecked() || table[Command::Segments].isChecked();
    const bool hitsSelected = std::ranges::any_of(
        found, [&](const SegmentRef &ref) { return editor.selection().strokes.contains(ref.stroke); });
    if (selects && !found.empty() && !hitsSelected) // as a click would
        editor.document().setSelection({withGroup(*editor.document().painting(), found.front().stroke), {}});
    editor.laterChanges().flush(); // the rows tell what can be used now
    fillCanvasMenu(*m_menu, m_place, found, point);
    m_menu->popup(onScreen(pixel));
}

void AtPointer::openPalette(Point pixel)
{
    if (!m_palette) {
        m_palette = new BrushPalette(m_place.canvas, m_place.commands);
        m_palette->addAction(&m_place.commands[Command::BrushPalette]);
    }
    m_palette->openAt(onScreen(pixel));
}

void AtPointer::openValues(Point pixel, std::optional<SegmentRef> at)
{
    if (m_place.open.editor.selection().isEmpty())
        return;
    if (!m_values)
        m_values = new ValueCard(m_place.canvas);
    m_values->openAt(onScreen(pixel), at);
}

void AtPointer::editHere()
{
    const Point pixel = here();
    std::optional<SegmentRef> at;
    for (const SegmentRef &ref : strokesAt(m_place, m_place.canvas.view().toCanvas(pixel)))
        if (!at && m_place.open.editor.selection().strokes.contains(ref.stroke))
            at = ref;
    openValues(pixel, at);
}

} // namespace suffuse

// What the Select tool shows: handles, cursor, and the line that says what clicking will do.
#include "app/canvas/canvas_widget.h"
#include "app/session/commands/commands.h"
#include "app/session/editor.h"
#include "app/tools/select_tool.h"
#include "app/tools/transform_bar.h"

#include <QPainter>

namespace suffuse {

using Kind = TransformHandle::Kind;

QWidget *SelectTool::options()
{
    if (!m_options)
        m_options = new TransformBar(m_editor, m_commands);
    return m_options;
}

void SelectTool::hover(const PointerEvent &event)
{
    const auto handle = handles().at(event.pixel, m_canvas.view(), m_canvas.devicePixelRatioF());
    if (handle == m_hovered)
        return;
    m_hovered = handle;
    m_said.clear();
    m_canvas.refreshCursor();
    m_canvas.updateSelection();
    emit hintChanged();
}

void SelectTool::leave()
{
    if (!m_hovered)
        return;
    m_hovered.reset();
    m_canvas.updateSelection();
    emit hintChanged();
}

QCursor SelectTool::cursor() const
{
    return m_hovered ? Qt::PointingHandCursor : Qt::ArrowCursor;
}

/// On the canvas and in the row over it, while strokes are turned.
void SelectTool::showTurn(std::optional<double> angle, Point pixel)
{
    m_turned = angle;
    m_turnedAt = pixel;
    if (m_options)
        m_options->showTurn(angle);
    m_canvas.updateSelection();
}

void SelectTool::say(const QString &text)
{
    if (text == m_said)
        return;
    m_said = text;
    emit hintChanged();
}

QString SelectTool::handleHint(const TransformHandle &handle) const
{
    switch (handle.kind) {
    case Kind::Scale:
        return tr("Drag: scale. Ctrl: keep the proportions. Shift: about the centre.");
    case Kind::Rotate:
        return tr("Drag: rotate. Ctrl: in steps of 15°. Shift: about the opposite corner.");
    case Kind::Skew:
        return tr("Drag: skew. Ctrl: in steps of 15°. Shift: about the opposite side.");
    case Kind::Centre:
        break;
    }
    return tr("Drag: move the centre of rotation. Shift+click: back into the middle.");
}

QString SelectTool::hint() const
{
    if (!m_said.isEmpty())
        return m_said;
    if (m_hovered)
        return handleHint(*m_hovered);
    const Qt::KeyboardModifiers held = m_canvas.modifiers();
    const bool shift = held & Qt::ShiftModifier;
    if (held & Qt::AltModifier)
        return shift ? tr("Shift+Alt+click: add the next stroke below, with Ctrl within its group. "
                          "Shift+Alt+drag: add what the path touches.")
                     : tr("Alt+click: select the next stroke below, with Ctrl within its group. "
                          "Alt+drag: select what the path touches.");
    if (held & Qt::ControlModifier)
        return shift ? tr("Ctrl+Shift+click: one stroke of a group, in or out. Ctrl+Shift+drag: take away.")
                     : tr("Ctrl+click: one stroke of a group. Ctrl+drag: move along an axis.");
    if (shift)
        return tr("Shift+click: add or take away. Shift+drag: add what the band encloses; while moving: do not snap.");
    if (selection().isEmpty())
        return tr("Click paint to select its stroke. Drag for a band, over paint with Shift. Alt+click: the stroke "
                  "below.");
    return tr("Drag: move. Click again: rotate and skew. Double click: its segment. Shift+click: add. Shift+drag: a "
              "band. Alt+click: the stroke below.");
}

std::optional<double> SelectTool::paintMargin() const
{
    constexpr double marks = 40; // logical pixels: of the handles around the box, and of where it snaps
    const bool centre = m_handle ? m_handle->kind == Kind::Centre : m_handles.mode() == TransformHandles::Mode::Turn;
    if ((centre || m_turned) && !selection().isEmpty())
        return {}; // the centre may lie anywhere, and the angle stands beside the pointer
    return marks * m_canvas.devicePixelRatioF();
}

void SelectTool::paint(QPainter &painter, const View &view, double dpr) const
{
    const OverlayColours &colours = m_canvas.overlayColours();
    SelectionTool::paint(painter, view, dpr);
    const bool movesCentre = m_drag.isActive() && m_handle && m_handle->kind == Kind::Centre;
    if (movesCentre)
        m_handles.paint(painter, view, dpr, colours.accent, m_handle);
    else if (!isBusy() && !selection().isEmpty())
        handles().paint(painter, view, dpr, colours.accent, m_hovered);
    if (m_drag.isActive() && m_snap.to != SnapTo::Nothing)
        paintSnapMark(painter, view.toPixels(m_snap.point), colours, dpr);
    if (m_turned)
        paintBadge(painter, angleText(*m_turned), m_turnedAt, 0, view, dpr);
}

} // namespace suffuse

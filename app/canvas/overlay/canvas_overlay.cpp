#include "app/canvas/overlay/canvas_overlay.h"

#include "app/canvas/canvas_lift.h"
#include "app/canvas/canvas_view.h"
#include "app/canvas/handles/canvas_handles.h"
#include "app/canvas/handles/rulers.h"
#include "app/canvas/input/canvas_input.h"
#include "app/canvas/overlay/assistant_lines.h"
#include "app/canvas/overlay/shown_selection.h"
#include "app/canvas/tool.h"
#include "app/session/drawing_aids.h"
#include "app/session/editor.h"

#include <QPainter>
#include <QPalette>

#include <utility>

namespace suffuse {

namespace {

constexpr int besideChosen = 110; ///< how opaque lines of erasures are that are not selected, where others are
constexpr int mostChosen = 4000;  ///< selected segments up to which those of erasures have lines above nodes

/// A full line along those of some segments that take paint away, as selected segments have it.
void paintChosenErasures(QPainter &painter, const View &view, const Painting &painting,
                         const std::set<SegmentRef> &segments, const OverlayColours &colours, double dpr)
{
    if (segments.empty() || segments.size() > std::size_t(mostChosen))
        return;
    QPainterPath path;
    for (const StrokePtr &stroke : painting.strokes)
        for (auto it = segments.lower_bound({stroke->id, 0}); it != segments.end() && it->stroke == stroke->id; ++it)
            if (it->segment < int(stroke->segments.size()))
                if (const Segment &segment = stroke->segments[std::size_t(it->segment)]; segment.takesPaint())
                    addCurve(path, stroke->cubicOf(segment), view);
    painter.setRenderHint(QPainter::Antialiasing);
    strokeTwoTone(painter, path, colours.accent, 2.2 * dpr);
}

} // namespace

CanvasOverlay::CanvasOverlay(Editor &editor, const CanvasView &view, CanvasInput &input, CanvasHandles &handles,
                             ShownSelection &selected, CanvasLift &lift)
    : m_editor(editor), m_view(view), m_input(input), m_handles(handles), m_selected(selected), m_lift(lift)
{}

Tool *CanvasOverlay::tool() const
{
    return m_input.hand().tool();
}

void CanvasOverlay::paintAround(QPainter &painter, double dpr) const
{
    constexpr int veil = 115; // Paint below this veil is seen as paint, and as no part of the picture.
    OverlayColours colours = m_colours;
    if (m_aids.showBeyond)
        colours.pasteboard.setAlpha(veil);
    painter.save();
    paintPasteboard(painter, m_view.view(), m_editor.unsettled().painting()->canvas.area(), colours, dpr);
    painter.restore();
}

void CanvasOverlay::paint(QPainter &painter, double dpr)
{
    painter.save();
    if (m_aids.showGrid)
        paintGrid(painter, m_view.view(), m_editor.unsettled().painting()->canvas.area(), m_aids.gridStep, dpr);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_aids.showAssistants && !isBare())
        paintAssistants(painter, m_editor.aids().assistants(), m_view.view(), m_colours, dpr);
    m_handles.paint(painter, m_view.view(), m_colours, dpr);
    painter.setRenderHint(QPainter::Antialiasing, false);
    if (!isBare())
        m_missing.paint(painter, m_view.view(), m_editor.unsettled().painting(), m_colours, dpr);
    if (showsOutlines())
        paintSelection(painter, dpr);
    painter.restore();
    painter.setRenderHint(QPainter::Antialiasing);
    if (tool() && !isBare())
        tool()->paint(painter, m_view.view(), dpr);
    painter.save();
    paintErasures(painter, dpr); // above nodes, which hide all that lies below them in lettering
    painter.restore();
    m_input.keyboardPen().paint(painter, dpr);
    paintAngle(painter, dpr);
    if (m_aids.showRulers)
        paintRulers(painter, m_view.view(), rulerUnit(), m_colours, dpr);
    m_note.paint(painter, m_view.view(), dpr);
}

void CanvasOverlay::paintSelection(QPainter &painter, double dpr)
{
    SelectionOutline &outline = m_selected.outline();
    if (m_selected.selection().isEmpty() ||
        m_lift.paintOutline(painter, outline, m_selected.selection(), m_colours, dpr))
        return;
    outline.paint(painter, m_view.view(), *m_editor.unsettled().painting(), m_selected.selection(), m_colours, dpr,
                  m_editor.isDragging() || m_editor.isStepping());
}

/// The command shows those of all strokes. Where something is selected, what is not is paler.
void CanvasOverlay::paintErasures(QPainter &painter, double dpr)
{
    const Selection &selection = m_selected.selection();
    const bool byTool = showsOutlines() && tool() && tool()->showsErasures();
    if (isBare() || m_lift.isFloating())
        return;
    const auto paint = [&](ErasureLines &lines, const std::set<StrokeId> *only, bool isPale) {
        OverlayColours colours = m_colours;
        if (isPale)
            colours.accent.setAlpha(besideChosen);
        lines.paint(painter, m_view.view(), m_editor.unsettled().painting(), m_editor.clock().time(), only, colours,
                    dpr);
    };
    if (m_aids.showErasures)
        paint(m_erasures, nullptr, !selection.isEmpty());
    if (selection.isEmpty() || !(m_aids.showErasures || byTool))
        return;
    paint(m_selectedErasures, &selection.strokes, !selection.segments.empty());
    if (showsOutlines())
        paintChosenErasures(painter, m_view.view(), *m_editor.unsettled().painting(), selection.segments, m_colours,
                            dpr);
}

bool CanvasOverlay::showsErasures() const
{
    return m_aids.showErasures && !isBare();
}

bool CanvasOverlay::isBare() const
{
    return m_input.keys().isBare() || m_editor.compared();
}

bool CanvasOverlay::showsOutlines() const
{
    return m_aids.showOutlines && !isBare() && (m_revealed || !tool() || tool()->showsOutlines());
}

/// Paints the angle beside the pointer while the canvas is turned by hand.
void CanvasOverlay::paintAngle(QPainter &painter, double dpr) const
{
    if (m_input.hand().navigation() == Navigation::Rotate)
        paintBadge(painter, angleText(m_view.view().rotation), m_input.hand().lastPixel(), 0, m_view.view(), dpr);
}

RulerUnit CanvasOverlay::rulerUnit() const
{
    return unitOf(m_aids.rulerUnits, m_editor.resolution());
}

void CanvasOverlay::readPalette(const QPalette &palette)
{
    const bool dark = palette.color(QPalette::Window).lightness() < 128;
    m_colours.pasteboard = dark ? QColor(43, 45, 49) : QColor(209, 211, 215);
    m_colours.border = dark ? QColor(12, 12, 14) : QColor(120, 124, 130);
    m_colours.accent = QColor(4, 46, 124);
    m_colours.guide = QColor(0, 92, 92);
    m_colours.assistant = QColor(112, 18, 88);
}

bool CanvasOverlay::reveal(bool revealed)
{
    return std::exchange(m_revealed, revealed) != revealed && !(tool() && tool()->showsOutlines());
}

} // namespace suffuse

#include "app/tools/brush/match_picker.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/session/selecting/pick.h"
#include "undo/restyle_edits.h"

#include <QCoreApplication>

namespace suffuse {

namespace {

constexpr double matchSlack = 3; ///< logical pixels around the pointer in which hairlines are found

} // namespace

MatchPicker::MatchPicker(CanvasWidget &canvas) : m_canvas(canvas), m_editor(canvas.editor()) {}

void MatchPicker::begin(const PointerEvent &event)
{
    m_before = m_editor.document().painting();
    m_selection = m_editor.selection();
    move(event);
}

void MatchPicker::move(const PointerEvent &event)
{
    if (!m_before || m_selection.isEmpty())
        return;
    const double tolerance = matchSlack * m_canvas.devicePixelRatioF() / m_canvas.view().scale;
    const std::optional<SegmentRef> hit =
        pickSeen(*m_editor.layer().reached(), m_editor.clock().time(), event.point, tolerance);
    const StrokePtr like = hit ? m_before->find(hit->stroke) : nullptr;
    if (!like)
        return;
    if (!m_gesture.isOpen())
        m_gesture = m_editor.begin(QCoreApplication::translate("suffuse::EyedropperTool", "Match"));
    const bool levelled = event.modifiers & Qt::ShiftModifier;
    m_gesture.show(applyAppearance(m_editor.document(), *m_before, m_selection, appearanceOf(*like),
                                   levelled ? Variation::Levelled : Variation::Kept));
}

void MatchPicker::end()
{
    m_before.reset();
    m_gesture.commit();
}

void MatchPicker::giveUp()
{
    m_before.reset();
    m_gesture.giveUp();
}

QString MatchPicker::hint() const
{
    return m_editor.selection().isEmpty()
               ? QCoreApplication::translate("suffuse::EyedropperTool",
                                             "Select strokes first: they get the appearance of the stroke you click.")
               : QCoreApplication::translate("suffuse::EyedropperTool",
                                             "Click a stroke: the selected ones get its appearance, and what varies "
                                             "along them stays. Shift: the same values all along.");
}

} // namespace suffuse

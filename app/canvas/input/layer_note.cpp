#include "app/canvas/input/layer_note.h"

#include "app/canvas/input/hand.h"
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/session/selecting/pick.h"

namespace suffuse {

LayerNote::LayerNote(Editor &editor, Hand &hand, QObject *parent) : QObject(parent), m_editor(editor)
{
    connect(&hand, &Hand::toolPressed, this, &LayerNote::begin);
    connect(&hand, &Hand::toolMoved, this, [this](const PointerEvent &event) {
        if (m_before)
            m_path.push_back(event.point);
    });
    connect(&hand, &Hand::toolReleased, this, &LayerNote::end);
}

void LayerNote::begin(const PointerEvent &event)
{
    m_before = m_editor.layer().reachedGroup() == 0 ? nullptr : m_editor.document().painting();
    m_selected = m_before ? m_editor.selection() : Selection();
    m_path = {event.point};
}

/// Whether paint that can be selected lies under the way of the pointer.
bool LayerNote::meets(const PaintingPtr &painting) const
{
    PathTouch touch(painting, m_editor.clock().time(), m_tolerance, m_path.front());
    for (const Point &point : m_path)
        touch.goOn(point);
    return !touch.touched().empty();
}

void LayerNote::end()
{
    const PaintingPtr before = std::exchange(m_before, nullptr);
    const Selection selected = std::exchange(m_selected, {});
    if (!before || m_editor.document().painting() != before || m_editor.layer().reachedGroup() == 0)
        return;
    const bool chose = !m_editor.selection().isEmpty() && m_editor.selection() != selected;
    if (!chose && !meets(m_editor.layer().reached()) && meets(before))
        m_editor.layer().noteOnly();
}

} // namespace suffuse

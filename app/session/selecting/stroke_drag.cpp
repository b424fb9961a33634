#include "app/session/selecting/stroke_drag.h"

#include "app/session/editor.h"
#include "undo/node_edits.h"

namespace suffuse {

void StrokeDrag::begin(const std::set<StrokeId> &strokes, const QString &name)
{
    m_strokes.clear();
    m_name = name;
    m_run = beginEditRun();
    add(strokes);
}

void StrokeDrag::add(const std::set<StrokeId> &strokes)
{
    const Painting &painting = *m_editor.document().painting();
    for (const StrokePtr &stroke : painting.strokes)
        if (strokes.contains(stroke->id) && painting.isVisible(*stroke) && !painting.isLocked(*stroke))
            m_strokes.try_emplace(stroke->id, Dragged{stroke, stroke});
}

void StrokeDrag::show(const std::function<Stroke(const Stroke &)> &change)
{
    Document &document = m_editor.document();
    std::vector<Stroke> changed;
    changed.reserve(m_strokes.size());
    for (const StrokePtr &stroke : document.painting()->strokes)
        if (const auto it = m_strokes.find(stroke->id); it != m_strokes.end() && it->second.shown == stroke) {
            it->second.kept = true;
            changed.push_back(change(*it->second.before));
        }
    std::erase_if(m_strokes, [](const auto &entry) { return !entry.second.kept; });
    m_editor.push(replaceStrokes(document, std::move(changed)), m_name, m_run);
    for (const StrokePtr &stroke : document.painting()->strokes)
        if (const auto it = m_strokes.find(stroke->id); it != m_strokes.end()) {
            it->second.shown = stroke;
            it->second.kept = false;
        }
}

void StrokeDrag::giveUp()
{
    show([](const Stroke &stroke) { return stroke; });
    end();
}

void StrokeDrag::end()
{
    m_strokes.clear();
}

std::set<StrokeId> StrokeDrag::strokes() const
{
    std::set<StrokeId> ids;
    for (const auto &[id, dragged] : m_strokes)
        ids.insert(ids.end(), id);
    return ids;
}

const Stroke *StrokeDrag::before(StrokeId stroke) const
{
    const auto it = m_strokes.find(stroke);
    return it == m_strokes.end() ? nullptr : it->second.before.get();
}

} // namespace suffuse

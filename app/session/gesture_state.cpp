#include "app/session/gesture_state.h"

#include "app/session/gesture_desk.h"
#include "model/painting/editable.h"
#include "undo/history/back_edit.h"
#include "undo/node_edits.h"
#include "undo/text_edits.h"
#include "undo/text_links.h"

#include <unordered_map>

namespace suffuse {

namespace {

/// What the map makes of the strokes is what it makes of their picture.
bool mapsPicture(const Affine &map, SpreadRule rule)
{
    constexpr double tiny = 1e-9;
    return rule == SpreadRule::Scales || (map.isSimilarity() && std::abs(std::abs(map.determinant()) - 1) < tiny);
}

} // namespace

GestureState::GestureState(GestureDesk &desk, const QString &name, GestureSteps *steps)
    : m_desk(&desk), m_name(name), m_steps(steps)
{}

void GestureState::show(Edit edit)
{
    if (!m_desk || edit.isEmpty())
        return;
    m_desk->take(*this);
    if (!m_back && !edit.selection) // undo brings it back, too
        edit.selection = m_desk->document().selection();
    m_desk->show(edit);
    if (m_back)
        extendBack(*m_back, std::move(edit), *m_desk->document().painting());
    else
        m_back = std::move(edit);
    emit m_desk->undecidedChanged();
}

void GestureState::take(const std::set<StrokeId> &strokes)
{
    if (!m_desk)
        return;
    const Painting &painting = *m_desk->document().painting();
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (strokes.contains(stroke->id) && isEditable(*stroke))
            m_taken.try_emplace(stroke->id, Taken{stroke, stroke});
    const auto isTaken = [this](StrokeId id) { return m_taken.contains(id); };
    m_texts = wholeTexts(painting, isTaken);
    m_leads = leadsOtherTexts(painting, m_texts, isTaken);
}

void GestureState::showEach(const std::function<Stroke(const Stroke &)> &change, const Affine *map)
{
    if (!m_desk)
        return;
    const Document &document = m_desk->document();
    std::vector<Stroke> changed;
    changed.reserve(m_taken.size());
    for (const StrokePtr &stroke : document.painting()->strokes)
        if (const auto it = m_taken.find(stroke->id); it != m_taken.end() && it->second.shown == stroke) {
            it->second.kept = true;
            changed.push_back(change(*it->second.before));
        }
    std::erase_if(m_taken, [](const auto &entry) { return !entry.second.kept; });
    Edit edit = replaceStrokes(document, std::move(changed));
    if (map)
        edit.groups = withTextsMapped(*document.painting(), m_texts, *map);
    show(std::move(edit));
    for (const StrokePtr &stroke : document.painting()->strokes)
        if (const auto it = m_taken.find(stroke->id); it != m_taken.end()) {
            it->second.shown = stroke;
            it->second.kept = false;
        }
}

void GestureState::floatBy(const Affine &map, SpreadRule rule)
{
    if (!m_desk)
        return;
    m_map = map;
    m_rule = rule;
    m_maps = true;
    FloatingView *view = m_desk->floatingView();
    if (!view || !view->isLifted() || !mapsPicture(map, rule) || m_leads) {
        m_afloat = false;
        showMapped();
        return;
    }
    m_desk->take(*this);
    m_afloat = true;
    view->showFloating(sinceLift());
}

void GestureState::showMapped()
{
    std::unordered_map<StrokeId, Stroke> mapped;
    m_isRefused = false;
    for (const auto &[id, taken] : m_taken) { // All of them or none: what belongs together stays together.
        std::optional<Stroke> result = tryTransformed(*taken.before, m_map, m_rule);
        m_isRefused = !result;
        if (m_isRefused)
            break;
        mapped.emplace(id, std::move(*result));
    }
    const Affine map = m_isRefused ? Affine() : m_map;
    showEach([&](const Stroke &stroke) { return m_isRefused ? stroke : std::move(mapped.at(stroke.id)); }, &map);
}

std::set<StrokeId> GestureState::strokes() const
{
    std::set<StrokeId> ids;
    for (const auto &[id, taken] : m_taken)
        ids.insert(ids.end(), id);
    return ids;
}

const Stroke *GestureState::before(StrokeId stroke) const
{
    const auto it = m_taken.find(stroke);
    return it == m_taken.end() ? nullptr : it->second.before.get();
}

void GestureState::settle()
{
    if (!std::exchange(m_afloat, false) || !m_desk)
        return;
    FloatingView *view = m_desk->floatingView();
    const bool floats = view && view->isLifted();
    showMapped();
    if (floats)
        view->settleFloating();
}

void GestureState::liftAnew()
{
    FloatingView *view = m_desk ? m_desk->floatingView() : nullptr;
    if (!view || !m_maps || (view->isLifted() && view->coversFloating(sinceLift())))
        return;
    m_liftedAt = m_map;
    view->lift(strokes());
}

Affine GestureState::sinceLift() const
{
    return m_map * m_liftedAt.inverse().value_or(Affine());
}

std::optional<Edit> GestureState::takeBack()
{
    settle();
    return std::exchange(m_back, std::nullopt);
}

std::optional<Edit> GestureState::takeUndo()
{
    m_afloat = false;
    for (auto &[id, taken] : m_taken)
        taken.shown = taken.before;
    return std::exchange(m_back, std::nullopt);
}

void GestureState::forget()
{
    m_afloat = false;
    m_back.reset();
    m_taken.clear();
    m_texts.clear();
}

void GestureState::rest()
{
    if (m_desk)
        m_desk->rest(*this);
}

void GestureState::commit()
{
    if (m_desk)
        m_desk->commit(*this);
}

void GestureState::giveUp()
{
    if (m_desk)
        m_desk->giveUp(*this);
}

} // namespace suffuse

#include "app/session/gesture.h"

#include "app/session/gesture_state.h"

namespace suffuse {

Gesture::Gesture() = default;
Gesture::Gesture(std::unique_ptr<GestureState> state) : m_state(std::move(state)) {}
Gesture::Gesture(Gesture &&other) noexcept = default;

Gesture &Gesture::operator=(Gesture &&other) noexcept
{
    if (this != &other) {
        giveUp();
        m_state = std::move(other.m_state);
    }
    return *this;
}

Gesture::~Gesture()
{
    giveUp();
}

void Gesture::show(Edit edit)
{
    if (m_state)
        m_state->show(std::move(edit));
}

void Gesture::take(const std::set<StrokeId> &strokes)
{
    if (m_state)
        m_state->take(strokes);
}

void Gesture::show(const std::function<Stroke(const Stroke &)> &change)
{
    if (m_state)
        m_state->showEach(change);
}

void Gesture::floatBy(const Affine &map, SpreadRule rule)
{
    if (m_state)
        m_state->floatBy(map, rule);
}

bool Gesture::isRefused() const
{
    return m_state && m_state->isRefused();
}

std::set<StrokeId> Gesture::strokes() const
{
    return m_state ? m_state->strokes() : std::set<StrokeId>();
}

const Stroke *Gesture::before(StrokeId stroke) const
{
    return m_state ? m_state->before(stroke) : nullptr;
}

void Gesture::rest()
{
    if (m_state)
        m_state->rest();
}

void Gesture::commit()
{
    if (const std::unique_ptr<GestureState> state = std::move(m_state))
        state->commit();
}

void Gesture::giveUp()
{
    if (const std::unique_ptr<GestureState> state = std::move(m_state))
        state->giveUp();
}

} // namespace suffuse

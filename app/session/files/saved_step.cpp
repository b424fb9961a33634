#include "app/session/files/saved_step.h"

namespace suffuse {

SavedStep::SavedStep(QUndoStack &stack) : m_stack(stack) {}

void SavedStep::set(bool isNow)
{
    m_dropped = {.saved = lost, .saving = {}};
    m_steps.saving.clear();
    m_steps.saved = isNow ? m_stack.index() : lost;
    if (isNow)
        m_stack.setClean();
    else
        m_stack.resetClean();
}

void SavedStep::savingBegins(quint64 serial)
{
    m_steps.saving[serial] = m_stack.index();
    m_stack.setClean(); // a stack merges nothing into the step that has its mark
}

bool SavedStep::savingEnds(quint64 serial, bool saved)
{
    const auto it = m_steps.saving.find(serial);
    if (it == m_steps.saving.end())
        return false;
    if (saved)
        m_steps.saved = it->second;
    m_steps.saving.erase(m_steps.saving.begin(), std::next(it)); // the orders before it gave way
    if (!saved && m_steps.saving.empty())
        m_stack.resetClean();
    follow();
    return true;
}

void SavedStep::willPush()
{
    if (m_stack.canRedo())
        m_dropped = m_steps;
    const int now = m_stack.index();
    if (m_steps.saved > now)
        m_steps.saved = lost;
    for (auto &[serial, step] : m_steps.saving)
        if (step > now)
            step = lost;
}

void SavedStep::putBack()
{
    if (m_steps.saved == lost)
        m_steps.saved = m_dropped.saved;
    for (auto &[serial, step] : m_steps.saving)
        if (const auto before = m_dropped.saving.find(serial); step == lost && before != m_dropped.saving.end())
            step = before->second;
}

void SavedStep::follow()
{
    if (m_steps.saving.empty() && isNow() && !m_stack.isClean())
        m_stack.setClean();
}

} // namespace suffuse

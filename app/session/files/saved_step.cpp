#include "app/session/files/saved_step.h"

namespace suffuse {

SavedStep::SavedStep(QUndoStack &stack) : m_stack(stack) {}

void SavedStep::set(bool isNow)
{
    m_saving.clear();
    m_saved = isNow ? m_stack.index() : lost;
    if (isNow)
        m_stack.setClean();
    else
        m_stack.resetClean();
}

void SavedStep::savingBegins(quint64 serial)
{
    m_saving[serial] = m_stack.index();
    m_stack.setClean(); // a stack merges nothing into the step that has its mark
}

bool SavedStep::savingEnds(quint64 serial, bool saved)
{
    const auto it = m_saving.find(serial);
    if (it == m_saving.end())
        return false;
    if (saved)
        m_saved = it->second;
    m_saving.erase(m_saving.begin(), std::next(it)); // the orders before it gave way
    if (!saved && m_saving.empty())
        m_stack.resetClean();
    follow();
    return true;
}

void SavedStep::willPush()
{
    const int now = m_stack.index();
    if (m_saved > now)
        m_saved = lost;
    for (auto &[serial, step] : m_saving)
        if (step > now)
            step = lost;
}

void SavedStep::follow()
{
    if (m_saving.empty() && isNow() && !m_stack.isClean())
        m_stack.setClean();
}

} // namespace suffuse

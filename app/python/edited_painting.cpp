#include "app/python/edited_painting.h"

#include "app/python/fonts.h"
#include "undo/history/back_edit.h"
#include "undo/text_links.h"

#include <stdexcept>

namespace suffuse::python {

EditedPainting::EditedPainting(PaintingPtr painting, std::shared_ptr<const DocumentExtras> extras)
    : m_begun(std::move(painting)), m_extras(std::move(extras))
{
    m_document.reset(m_begun);
}

bool EditedPainting::push(const QString &name, const std::function<Edit(Document &)> &make)
{
    const std::lock_guard lock(m_mutex);
    checkThread();
    Edit edit = make(m_document);
    if (edit.isEmpty())
        return false;
    completeTexts(*m_document.painting(), edit, layByFonts);
    m_document.exchange(edit);
    if (changesNothing(edit, *m_document.painting()))
        return false;
    if (m_open > 0 && m_isBegun) {
        extendBack(m_steps.back().back, std::move(edit), *m_document.painting());
        return true;
    }
    m_steps.resize(m_done);
    m_steps.push_back({m_open > 0 ? m_openName : name, std::move(edit)});
    m_done = m_steps.size();
    m_isBegun = m_open > 0;
    return true;
}

/// To be called with the lock.
void EditedPainting::checkThread() const
{
    if (m_open > 0 && m_owner != std::this_thread::get_id())
        throw std::runtime_error(
            "another thread has begun a step of this document, which is still open; let threads that "
            "edit one document take a lock around their steps, or give each a Document of its own");
}

void EditedPainting::exchange(Step &step)
{
    m_document.exchange(step.back);
}

bool EditedPainting::undo()
{
    const std::lock_guard lock(m_mutex);
    checkThread();
    if (m_done == 0 || m_open > 0)
        return false;
    exchange(m_steps[--m_done]);
    return true;
}

bool EditedPainting::redo()
{
    const std::lock_guard lock(m_mutex);
    checkThread();
    if (m_done == m_steps.size() || m_open > 0)
        return false;
    exchange(m_steps[m_done++]);
    return true;
}

void EditedPainting::beginStep(const QString &name)
{
    const std::lock_guard lock(m_mutex);
    checkThread();
    if (m_open++ > 0)
        return;
    m_owner = std::this_thread::get_id();
    m_openName = name;
    m_isBegun = false;
}

void EditedPainting::endStep(bool keep)
{
    const std::lock_guard lock(m_mutex);
    checkThread();
    if (m_open == 0 || --m_open > 0 || !m_isBegun)
        return;
    m_isBegun = false;
    if (keep && !changesNothing(m_steps.back().back, *m_document.painting()))
        return;
    exchange(m_steps.back());
    m_steps.pop_back();
    m_done = m_steps.size();
}

PaintingPtr EditedPainting::painting() const
{
    const std::lock_guard lock(m_mutex);
    return m_document.painting();
}

Selection EditedPainting::selection() const
{
    const std::lock_guard lock(m_mutex);
    return m_document.selection();
}

void EditedPainting::select(const Selection &selection)
{
    const std::lock_guard lock(m_mutex);
    checkThread();
    m_document.setSelection(selection);
}

EditedPainting::Steps EditedPainting::steps() const
{
    const std::lock_guard lock(m_mutex);
    Steps out;
    for (const Step &step : m_steps)
        out.names.push_back(step.name);
    out.done = m_done;
    return out;
}

} // namespace suffuse::python

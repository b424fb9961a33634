#include "app/session/value_entry.h"

namespace suffuse {

ValueEntry::~ValueEntry()
{
    commitDrag();
}

void ValueEntry::beginDrag()
{
    commitDrag();
    endSteps();
    m_drags = true;
}

void ValueEntry::commitDrag()
{
    m_drags = false;
    m_gesture.commit();
}

const PaintingPtr &ValueEntry::start(const Document &document)
{
    if (!m_start)
        m_start = document.painting();
    return m_start;
}

void ValueEntry::giveUpDrag()
{
    m_drags = false;
    m_gesture.giveUp();
}

} // namespace suffuse

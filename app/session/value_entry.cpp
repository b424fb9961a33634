#include "app/session/value_entry.h"

namespace suffuse {

namespace {

constexpr int stepGapMs = 900; ///< keys and turns of a wheel that come no later are one undo step

} // namespace

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

void ValueEntry::noteStep(bool held)
{
    if (!held && (!m_sinceStep.isValid() || m_sinceStep.elapsed() > stepGapMs))
        endSteps();
    m_sinceStep.start();
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

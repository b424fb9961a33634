#include "app/session/selecting/begun_selection.h"

#include "model/painting/stroke.h"

#include <algorithm>
#include <limits>

namespace suffuse {

const Selection &BegunSelection::at(Microseconds T, const StrokeList &strokes, const Selection &selection)
{
    if (holds(T))
        return m_leftOut.empty() ? selection : m_begun;
    m_births.follow(strokes, [](const Stroke &stroke) { return stroke.born(); });
    m_known = true;
    m_leftOut.clear();
    m_until = std::numeric_limits<Microseconds>::max();
    const auto last = std::max_element(m_births.begin(), m_births.end());
    m_from = last == m_births.end() ? std::numeric_limits<Microseconds>::min() : *last;
    if (T >= m_from)
        return selection; // nothing is left out, as always in the present
    m_from = std::numeric_limits<Microseconds>::min();
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        if (!selection.strokes.contains(strokes[i]->id))
            continue;
        if (m_births[i] <= T) {
            m_from = std::max(m_from, m_births[i]);
        } else {
            m_until = std::min(m_until, m_births[i]);
            m_leftOut.insert(strokes[i]->id);
        }
    }
    if (m_leftOut.empty())
        return selection;
    m_begun = selection;
    for (const StrokeId id : m_leftOut)
        m_begun.strokes.erase(id);
    std::erase_if(m_begun.segments, [&](const SegmentRef &s) { return m_leftOut.contains(s.stroke); });
    return m_begun;
}

} // namespace suffuse

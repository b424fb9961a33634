#include "app/session/painting/assisted_pen.h"

#include <utility>

namespace suffuse {

void AssistedPen::begin(std::vector<Assistant> assistants, double travel, double reach)
{
    m_assistants = std::move(assistants);
    m_travel = travel;
    m_reach = reach;
    m_waiting.clear();
    m_track.reset();
}

std::vector<PenSample> AssistedPen::take(const PenSample &sample)
{
    m_waiting.push_back(sample);
    if (!m_assistants.empty()) {
        const Point start = m_waiting.front().position;
        if (!(length(sample.position - start) >= m_travel))
            return {};
        m_track = trackOf(m_assistants, start, sample.position, m_reach);
        m_assistants.clear();
    }
    std::vector<PenSample> samples = std::exchange(m_waiting, {});
    if (m_track)
        for (PenSample &each : samples)
            each.position = m_track->nearest(each.position);
    return samples;
}

std::vector<PenSample> AssistedPen::finish()
{
    m_assistants.clear();
    return std::exchange(m_waiting, {});
}

} // namespace suffuse

#include "app/session/painting/stabiliser.h"

namespace suffuse {

namespace {

constexpr double longestLag = 0.2;          ///< lag of the weighted mean at full strength, s
constexpr Microseconds shortestStep = 1000; ///< reports of one moment still move the mean

} // namespace

void PenStabiliser::begin(const Stabiliser &settings, const PenSample &first, double stringLength)
{
    m_settings = settings;
    m_at = first;
    m_time = first.time;
    m_length = stringLength;
}

std::optional<PenSample> PenStabiliser::take(const PenSample &pen)
{
    const Point way = pen.position - m_at.position;
    PenSample next = pen;
    if (m_settings.kind == Stabiliser::Kind::Weighted && m_settings.strength > 0) {
        const double elapsed = toSeconds(std::max(pen.time - m_time, shortestStep));
        const double share = 1 - std::exp(-elapsed / (longestLag * double(m_settings.strength)));
        next.position = m_at.position + share * way;
        next.pressure = float(std::lerp(double(m_at.pressure), double(pen.pressure), share));
    } else if (m_settings.kind == Stabiliser::Kind::String && m_length > 0) {
        const double distance = length(way);
        if (distance <= m_length)
            return {};
        next.position = m_at.position + ((distance - m_length) / distance) * way;
    }
    m_time = std::max(m_time, pen.time);
    m_at = next;
    return next;
}

std::optional<PenSample> PenStabiliser::finish(const PenSample &pen) const
{
    if (m_settings.kind == Stabiliser::Kind::String && m_length > 0)
        return {};
    return pen;
}

std::optional<Point> PenStabiliser::anchor() const
{
    if (m_settings.kind != Stabiliser::Kind::String || !(m_length > 0))
        return {};
    return m_at.position;
}

} // namespace suffuse

#include "app/session/settings/pen_input.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {
constexpr double fullPressure = 0.999;
constexpr double jump = 0.4;     ///< no hand adds as much pressure from one report to the next
constexpr double touching = 0.5; ///< taken in place of full pressure in the first report
constexpr double least = 0.001;
constexpr Microseconds drift = 10'000; ///< two clocks drift apart by at most one microsecond in so many
} // namespace

Microseconds ReportLag::take(std::uint64_t stamp, Microseconds now)
{
    if (stamp == 0)
        return 0;
    const Microseconds offset = now - Microseconds(stamp) * 1000;
    const Microseconds known = m_least.value_or(offset) + (now - m_last) / drift;
    m_last = now;
    // An offset that is far off tells of another clock.
    m_least = offset - known > mostLag ? offset : std::min(offset, known);
    return offset - *m_least;
}

double PenPressure::take(double reported, bool press, bool sensitive)
{
    double pressure = std::isfinite(reported) ? std::clamp(reported, 0.0, 1.0) : m_last;
    if (press)
        m_last = touching, m_full = false;
    if (pressure == 0)
        return 0;
    const bool full = pressure >= fullPressure;
    if (sensitive && full && !m_full && pressure - m_last > jump)
        pressure = m_last; // full pressure is believed if the next report has it as well
    m_full = full;
    m_last = pressure;
    return std::clamp(m_curve.at(pressure), least, 1.0);
}

} // namespace suffuse

#include "app/canvas/input/canvas_pen.h"

#include <chrono>

namespace suffuse {

void CanvasPen::setSettings(const PenSettings &settings)
{
    m_settings = settings;
    m_pressure.setCurve(settings.pressure);
}

Microseconds CanvasPen::lateness(std::uint64_t stamp)
{
    using namespace std::chrono;
    const auto now = duration_cast<microseconds>(steady_clock::now().time_since_epoch());
    return m_lag.take(stamp, now.count());
}

} // namespace suffuse

// What the canvas has learned of the pen from its reports.
#pragma once

#include "app/session/settings/pen_input.h"

namespace suffuse {

/// Where the pen is, which end points down, and how its pressures are read.
class CanvasPen {
public:
    const PenSettings &settings() const { return m_settings; }
    void setSettings(const PenSettings &settings);

    bool isDown() const { return m_down; }
    void setDown(bool down) { m_down = down; }
    /// Whether the pen is in reach of the tablet. Fingers on it are then those of the hand that holds the pen.
    bool isNear() const { return m_near; }
    void setNear(bool near) { m_near = near; }
    /// Whether the pen's eraser points down.
    bool isTurned() const { return m_turned; }
    void setTurned(bool turned) { m_turned = turned; }

    /// How long a report has waited before it arrived here, by its stamp (milliseconds of the device's clock).
    Microseconds lateness(std::uint64_t stamp);
    /// The pressure to paint with, as `PenPressure::take` computes it.
    double pressure(double reported, bool press, bool sensitive) { return m_pressure.take(reported, press, sensitive); }

private:
    PenSettings m_settings;
    PenPressure m_pressure;
    ReportLag m_lag;
    bool m_down = false;
    bool m_near = false;
    bool m_turned = false;
};

} // namespace suffuse

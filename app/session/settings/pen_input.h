// What happens to the reports of a pen before a tool sees them (docs/pen.md).
#pragma once

#include "model/brush/response_curve.h"
#include "model/painting/segment.h"

#include <cstdint>
#include <optional>

namespace suffuse {

/// Settings of the user's pen. They are the same for all brushes.
struct PenSettings {
    ResponseCurve pressure;       ///< maps the pressure that the pen reports to the pressure that is painted with
    bool fingersMoveView = false; ///< fingers move the view and never paint
    friend bool operator==(const PenSettings &, const PenSettings &) = default;
};

/// A device time stamp that lies further from our clock than this is not believed.
inline constexpr Microseconds mostLag = 250'000;

/// Tells how late a device's reports come, from their own time stamps. Waiting only ever adds to the difference of the
/// two clocks, so the least difference that was seen is that of a report that did not wait.
class ReportLag {
public:
    /// How late a report comes that has this stamp (milliseconds of the device's clock; 0: it has none) and is heard of
    /// at `now`.
    Microseconds take(std::uint64_t stamp, Microseconds now);

private:
    std::optional<Microseconds> m_least; ///< least difference between the device's clock and ours
    Microseconds m_last = 0;             ///< when a report was heard of last
};

/// Turns the reported pressures of one pen, one after the other, into those that are painted with: blips are held back,
/// and the user's curve is laid on (docs/pen.md).
class PenPressure {
public:
    void setCurve(const ResponseCurve &curve) { m_curve = curve; }

    /// Returns a pressure in [0, 1]; 0 stays 0, and only 0 becomes 0. `press`: this is the first report of a touch;
    /// `sensitive`: the pen measures pressure.
    double take(double reported, bool press, bool sensitive);

private:
    ResponseCurve m_curve;
    double m_last = 0;   ///< the last pressure that was believed
    bool m_full = false; ///< the last report was full pressure
};

} // namespace suffuse

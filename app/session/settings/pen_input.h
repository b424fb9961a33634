// What is done to a pen's reports before they are painted with.
#pragma once

#include "model/brush/response_curve.h"
#include "model/painting/segment.h"

#include <cstdint>
#include <optional>

namespace suffuse {

/// The user's pen; kept in the settings, the same for all brushes.
struct PenSettings {
    ResponseCurve pressure;       ///< pressure that is painted with, over the pressure that the pen reports
    bool fingersMoveView = false; ///< fingers never paint
    friend bool operator==(const PenSettings &, const PenSettings &) = default;
};

/// Device time stamps further than this from our clock are not believed.
inline constexpr Microseconds mostLag = 250'000;

/// How late a device's reports come, by its own stamps: waiting only ever adds, so the least that was seen is none.
class ReportLag {
public:
    /// Of a report with the stamp (milliseconds of the device's clock; 0: it has none) that is heard of at `now`.
    Microseconds take(std::uint64_t stamp, Microseconds now);

private:
    std::optional<Microseconds> m_least; ///< from the device's clock to ours
    Microseconds m_last = 0;             ///< when a report was heard of
};

/// Pressures of one pen, one after the other: blips are held back and the user's curve is laid on (docs/pen.md).
class PenPressure {
public:
    void setCurve(const ResponseCurve &curve) { m_curve = curve; }

    /// In [0, 1]; 0 stays 0, and only 0 becomes 0. `press`: the first report of a touch; `sensitive`: whether the pen
    /// measures pressure at all.
    double take(double reported, bool press, bool sensitive);

private:
    ResponseCurve m_curve;
    double m_last = 0;   ///< last one that was believed
    bool m_full = false; ///< the last report was full pressure
};

} // namespace suffuse

// The fill of a stroke: the area within its outline as a source of the heat equation.
#pragma once

#include "model/painting/segment.h"

#include <memory>
#include <optional>

namespace suffuse {

/// Which points are inside an outline that runs around them several times: those with a winding number that is not 0,
/// or those with an odd one.
enum class FillRule : std::uint8_t { NonZero, EvenOdd };

/// Colour that changes evenly from one point to another: the fill's own colour at `from`, this one at `to`. Beyond the
/// two points it stays as it is there.
struct Gradient {
    Offset from; ///< offset from the stroke's origin, canvas units
    Offset to{100, 0};
    Colour colour;
    friend bool operator==(const Gradient &, const Gradient &) = default;
};

/// The area that the chains of a stroke enclose was wetted at once, and spreads like a segment. Each chain is closed by
/// a straight line; segments that take paint away bound nothing. The style is the stroke's. Domains are checked by
/// `problemOf` (model/painting/validate.h).
struct Fill {
    float diffusion = 12.5f; ///< D, unit²/s, [0, 1e12]; 0 stays crisp at any zoom
    float density = 1;       ///< ρ, far inside the area, [0, 1e12]
    float granulation = 1;   ///< ω, [0, 1]; 1 hides the paper, 0 shows it fully
    float maxAge = 1;        ///< t_max, s, (0, 1e6]
    Microseconds born = 0;   ///< when the area was wetted
    Colour colour;           ///< C, RYB and opacity
    FillRule rule = FillRule::NonZero;
    std::optional<Gradient> gradient;
    float anisotropyRatio = 1; ///< D·ratio along the angle, D across it
    float anisotropyAngle = 0; ///< radians, from the x axis towards the y axis

    friend bool operator==(const Fill &, const Fill &) = default;

    bool isIsotropic() const { return anisotropyRatio == 1; }
    /// The age t in seconds at document time T. Up to 0 the fill is not there yet.
    double age(Microseconds T) const { return std::min(toSeconds(T - born), double(maxAge)); }
    /// The time when it stops spreading, rounded up as a segment's is.
    Microseconds driesAt() const { return born + Microseconds(std::ceil(double(maxAge) * 1e6)); }
    /// The spread s = √(4Dt), canvas units; 0 at age 0. Where it is anisotropic, the spread across the tensor's angle.
    double spread(Microseconds T) const { return std::sqrt(4 * double(diffusion) * std::max(age(T), 0.0)); }
    /// The same fill with a spread of at least 1e-9 units, for who divides by it.
    Fill spreading(Microseconds T) const;
};

inline Fill Fill::spreading(Microseconds T) const
{
    constexpr double least = 1e-9;
    Fill copy = *this;
    copy.diffusion = std::max(copy.diffusion, float(least * least / (4 * age(T))));
    return copy;
}

/// A fill, or none. Most strokes have none, and copies of a stroke share theirs; two are equal if their values are.
class SharedFill {
public:
    SharedFill() = default;
    SharedFill(Fill fill) : m_fill(std::make_shared<const Fill>(std::move(fill))) {}

    explicit operator bool() const { return bool(m_fill); }
    const Fill &operator*() const { return *m_fill; }
    const Fill *operator->() const { return m_fill.get(); }

    friend bool operator==(const SharedFill &a, const SharedFill &b)
    {
        return a.m_fill == b.m_fill || (a.m_fill && b.m_fill && *a.m_fill == *b.m_fill);
    }

private:
    std::shared_ptr<const Fill> m_fill;
};

} // namespace suffuse

// What a stroke is at a point, from the densities that its segments have there (eq 15, 16, 20, 21).
#pragma once

#include "model/paint/style_function.h"
#include "model/painting/fill.h"

#include <array>
#include <cmath>

namespace suffuse {

/// Sums over the segments, and the fill, at a point. Their values are weighted by their densities there. Those that take
/// paint away count only by their density.
class LocalPaint {
public:
    /// Adds the density φ_k of a segment with its values and its style.
    void add(const Segment &segment, const Style &style, double density);
    /// Adds the density of a fill, which comes from this place between the colours of its gradient.
    void add(const Fill &fill, const Style &style, double density, double place);

    /// φ = max(0, φ⁺ − φ⁻) (14).
    double density() const { return std::max(0.0, m_laid - m_lifted); }
    /// φ⁺, the density of the segments that lay paint.
    double laid() const { return m_laid; }
    /// φ⁻, the density of the segments that take paint away.
    double lifted() const { return m_lifted; }
    /// φ_f, the density of the segments that make paint paler.
    double faded() const { return m_faded; }
    /// ω̄ (15); 1 where no paint is laid.
    double granulation() const;
    /// C̄ (20): R, Y, B, opacity; 0 where no paint is laid.
    std::array<double, 4> colour() const;
    /// F(φ′) = Σ share·F_kind(φ′; ξ̄_kind), φ′ = γφ (16), where the paper's texture is η; 0 where there is no paint.
    double coverage(double eta) const;
    /// w = F·C̄_opacity·e^−φ_f (21).
    double opacity(double eta) const { return coverage(eta) * colour()[3] * std::exp(-m_faded); }

private:
    void addLaid(const Colour &colour, float granulation, const Style &style, double density);

    struct KindSum {
        double density = 0;
        std::array<double, 3> xi{};
    };
    double m_laid = 0;
    double m_lifted = 0;
    double m_faded = 0;
    double m_granulation = 0;
    std::array<double, 4> m_colour{};
    std::array<KindSum, styleKinds.size()> m_kinds{};
};

/// γ = (1 − ω̄)η + ω̄ (16).
double modulation(double granulation, double eta);

} // namespace suffuse

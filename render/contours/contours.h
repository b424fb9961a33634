// The contours of a stroke: where it covers so much, as closed paths of cubics, exactly.
#pragma once

#include "model/painting/painting.h"
#include "render/contours/contour_cells.h"

namespace suffuse::contours {

/// Closed loops of cubics in canvas units. The winding number is 1 inside and 0 outside.
using Loops = std::vector<std::vector<Cubic>>;

/// What of a stroke is so opaque, in steps: each lies within the one before it and takes its place there.
struct Band {
    double opacity = 0; ///< w within
    Loops loops;
};

struct ContourOptions {
    double tolerance = 1.0 / 256; ///< how far paths may lie from where they belong, canvas units
    double eta = 1;               ///< the paper's mean: grain is not drawn
    const std::atomic<bool> *cancel = nullptr;
};

/// The contours of a stroke at a moment. Once it is cancelled they may be anything.
class StrokeContours {
public:
    StrokeContours(const Stroke &stroke, Microseconds T, const ContourOptions &options);

    /// What is covered at least so much: F ≥ level, level in (0, 1].
    Loops outline(double level) const;
    /// w in steps of at most 1/count, so that no band is farther than half a step from what it shows. The last step of
    /// an evenly opaque stroke is its opacity itself.
    std::vector<Band> bands(int count) const;

    /// Whether it is nothing but a fill that does not spread: one band, as opaque as it is at most.
    bool isCrisp() const { return m_field.crispDensity() > 0 && m_field.box().isEmpty(); }
    const StrokeField &field() const { return m_field; }
    const Stroke &stroke() const { return m_stroke; }

private:
    /// What lies above each of the levels of a field.
    std::vector<Loops> above(const Field &field, const std::vector<double> &levels, double lowest) const;
    /// φ′ at these densities and above, crisp fills included.
    std::vector<Loops> aboveDensities(const std::vector<double> &densities) const;
    std::vector<Band> evenBands(int count, double opacity) const;
    std::vector<Band> opacityBands(int count, double most) const;
    double lowestDensity(double coverage) const;
    Loops placed(Loops loops) const;

    Stroke m_stroke;
    ContourOptions m_options;
    StrokeField m_field;
};

/// The paper's mean η.
double meanOf(const Paper &paper);

} // namespace suffuse::contours

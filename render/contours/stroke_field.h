// What a stroke is at any point, in double precision and with slopes, at one moment: what its contours are drawn
// through.
#pragma once

#include "model/paint/local_paint.h"
#include "model/painting/stroke.h"
#include "render/contours/area_field.h"
#include "render/contours/gauss_bins.h"
#include "render/contours/style_levels.h"

#include <memory>
#include <optional>

namespace suffuse::contours {

/// A part of the plane, with what counts in it.
struct FieldPart {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> gauss; ///< bins, and which of theirs
    double narrowest = 0; ///< the smallest spread of all that counts there; infinite if nothing changes there
    double most = 0;      ///< a bound of φ′
};

/// A stroke's densities are sums of Gaussians, and of the density of its fill unless that does not spread. Points are
/// offsets from the stroke's origin. η is the paper's mean (docs/exchange.md, "Granulation").
class StrokeField {
public:
    /// `tolerance`: how far contours may lie from where they are, canvas units.
    StrokeField(const Stroke &stroke, Microseconds T, double eta, double tolerance);

    /// Whether coverage depends on φ′ alone: all that lays paint has one style, and nothing makes it paler.
    bool hasOneStyle() const { return m_style.has_value(); }
    const Style &style() const { return *m_style; }
    /// Whether opacity is the coverage times this.
    std::optional<double> evenOpacity() const { return m_evenOpacity; }
    std::optional<Colour> evenColour() const { return m_evenColour; }
    /// The fill that does not spread, with what it adds to φ′ inside; 0: none.
    double crispDensity() const { return m_crisp; }

    /// φ′ (16), without a crisp fill.
    Sloped modulatedAt(Point p) const;
    /// F times what is left of it where paint is made paler, and w (21).
    Sloped coverageAt(Point p) const;
    Sloped opacityAt(Point p) const;
    /// R, Y, B and opacity (20); 0 where there is no paint.
    std::array<double, 4> colourAt(Point p) const;

    /// Around all that counts; empty if nothing does.
    Rect box() const { return m_box; }
    FieldPart whole() const;
    /// What of a part counts in a box within it.
    FieldPart within(const FieldPart &part, const Rect &box) const;

private:
    struct Row {
        const Segment *segment = nullptr; ///< null: the fill
        double gain = 1;                  ///< γ, negative where paint is taken away
        bool lifts = false, fades = false;
        double granulation = 1, opacity = 1;
        const Style *style = nullptr;
    };
    enum class Kind { Even, OneStyle, Mixed };
    /// φ′ of what lays paint (where all is even, less what takes it away), φ⁺, the sum of opacities, and φ⁻.
    enum Channel : std::size_t { Modulated, Laid, Opacity, Lifted };

    void addSegment(const Segment &segment, Microseconds T, double tolerance,
                    std::vector<std::vector<Gauss>> &byOctave);
    void addFill(const Stroke &stroke, Microseconds T);
    void classify();
    std::vector<ChannelGains> gains() const;
    ChannelSums sumsAt(Point p) const;
    Sloped modulated(const ChannelSums &sums) const;
    template <class Use>
    void forEach(Point p, Use use) const;
    Sloped paintAt(Point p, bool withOpacity) const;
    LocalPaint localPaint(const std::vector<Sloped> &rows, Point step, Point p) const;

    const Stroke &m_stroke;
    double m_eta;
    Kind m_kind = Kind::Even;
    std::optional<Style> m_style;
    std::optional<CoverageCurve> m_curve; ///< of that style
    std::optional<double> m_evenOpacity;
    std::optional<Colour> m_evenColour;
    double m_crisp = 0;
    std::vector<Row> m_rows;
    int m_channels = 1; ///< how many of the first are summed; 0: each row by itself
    std::vector<GaussBins> m_bins;
    std::unique_ptr<AreaField> m_area;
    std::uint32_t m_areaRow = 0;
    Rect m_box;
};

} // namespace suffuse::contours

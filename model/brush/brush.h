#pragma once

#include "model/brush/response_curve.h"
#include "model/painting/segment.h"

#include <QString>

#include <vector>

namespace suffuse {

/// What a curve of a brush can change: the spread, the peak density, ω, the colour's opacity, t_max, and how far the
/// colour is from the brush's own towards its second one.
enum class BrushQuantity : std::uint8_t { Size, Density, Granulation, Opacity, MaxAge, ColourMix };
inline constexpr int brushQuantities = 6;

/// The inputs with which it can change, each in [0, 1] (docs/brushes.md). Random values are drawn once a stroke, or
/// drift smoothly along it.
enum class BrushInput : std::uint8_t { Pressure, Tilt, Speed, Distance, StrokeRandom, Drift };
inline constexpr int brushInputs = 6;

/// One curve: the quantity is the brush's own value times the value of the curve at the input.
struct BrushDynamic {
    BrushQuantity quantity = BrushQuantity::Density;
    BrushInput input = BrushInput::Pressure;
    ResponseCurve curve;
    friend bool operator==(const BrushDynamic &, const BrushDynamic &) = default;
};

/// How strokes grow from a point and run out into one. Lengths are in spreads; 0 means blunt.
struct Taper {
    float in = 0;
    float out = 0;     ///< painted when the pen lifts
    float tip = 0.05f; ///< the size at the very end, as a share of the brush's
    friend bool operator==(const Taper &, const Taper &) = default;
};

/// How far the colour strays from the brush's own in both directions, by stroke or drifting along it.
struct ColourJitter {
    float red = 0;
    float yellow = 0;
    float blue = 0;
    float lightness = 0; ///< red, yellow and blue together
    bool along = false;
    friend bool operator==(const ColourJitter &, const ColourJitter &) = default;
};

/// A tip that is not round: it spreads `ratio` times as fast along an angle, in radians, which turns with the path or
/// keeps its direction on the canvas.
struct TipShape {
    float ratio = 1;
    float angle = 0;
    bool followsPath = true;
    friend bool operator==(const TipShape &, const TipShape &) = default;
};

/// What smooths the way of the pen before it becomes a stroke.
struct Stabiliser {
    enum class Kind : std::uint8_t { Off, Weighted, String };
    Kind kind = Kind::Off;
    float strength = 0.5f; ///< of the kind Weighted, [0, 1]
    float length = 30;     ///< of the kind String, logical pixels
    friend bool operator==(const Stabiliser &, const Stabiliser &) = default;
};

/// The time between the knots of a stroke, unless the brush has another one.
inline constexpr Microseconds samplingInterval = 1'000'000 / 60;

/// What a new stroke is painted with. The density is given as the peak of a long straight line at full age, pk = φˢ/(√π
/// s), since the style's ξ are compared with that. The builder turns it into φˢ.
struct Brush {
    QString name;  ///< of the preset; a built-in one has an id
    QString group; ///< the group of the preset in lists; a built-in one has an id
    Style style;
    Mix mix;
    float diffusion = 12.5f; ///< D, unit²/s
    float peak = 1.2f;       ///< pk where no curve makes it smaller
    float granulation = 1;   ///< ω
    float maxAge = 1;        ///< t_max, s
    Colour colour{0.85f, 0.75f, 0.9f, 1};
    Colour secondColour{0, 0, 0, 1}; ///< for BrushQuantity::ColourMix
    ColourJitter jitter;
    TipShape tip;
    Taper taper;
    Stabiliser stabiliser;
    /// At most one for each quantity and input, in their order.
    std::vector<BrushDynamic> dynamics{{BrushQuantity::Density, BrushInput::Pressure, {{{0, 0.5f}, {1, 1}}}}};
    float fullSpeed = 60;    ///< the speed at which the input Speed is 1, spreads a second
    float fullDistance = 40; ///< the distance at which the input Distance is 1, spreads
    float driftLength = 4;   ///< the length over which what drifts takes another value, spreads
    Microseconds interval = samplingInterval;

    /// s = √(4 D t_max)
    double spread() const { return std::sqrt(4.0 * diffusion * maxAge); }
    /// Sets D so that the spread is s. All else stays, also the peak.
    void setSpread(double s) { diffusion = float(s * s / (4 * double(maxAge))); }

    /// The curve of a quantity and an input; null if there is none.
    const ResponseCurve *curve(BrushQuantity quantity, BrushInput input) const;
    void setCurve(BrushQuantity quantity, BrushInput input, const ResponseCurve &curve);
    void removeCurve(BrushQuantity quantity, BrushInput input);

    friend bool operator==(const Brush &, const Brush &) = default;
};

/// Empty if every value is in its domain. Otherwise it is a text like that of problemOf(Segment), with the member's
/// path in the brush file.
QString problemOf(const Brush &brush);

/// The brushes that come with the program, by groups ("ink", "watercolour", "dry", "flat", "air"). The first is the
/// default, with which recordings are converted, too.
const std::vector<Brush> &builtinBrushes();
/// The built-in one that people begin with in the window.
const Brush &firstBrush();
/// The built-in one with this id; null if there is none.
const Brush *findBrush(const QString &name);

} // namespace suffuse

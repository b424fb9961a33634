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

/// What it can change with, each in [0, 1] (docs/brushes.md): random values are drawn once a stroke, or drift smoothly
/// along it.
enum class BrushInput : std::uint8_t { Pressure, Tilt, Speed, Distance, StrokeRandom, Drift };
inline constexpr int brushInputs = 6;

/// One curve: the quantity is the brush's own value times the curve of the input.
struct BrushDynamic {
    BrushQuantity quantity = BrushQuantity::Density;
    BrushInput input = BrushInput::Pressure;
    ResponseCurve curve;
    friend bool operator==(const BrushDynamic &, const BrushDynamic &) = default;
};

/// Strokes grow from a point and run out into one: lengths in spreads, 0: blunt.
struct Taper {
    float in = 0;
    float out = 0;     ///< laid on when the pen lifts
    float tip = 0.05f; ///< size at the very end, a share of the brush's
    friend bool operator==(const Taper &, const Taper &) = default;
};

/// How far the colour strays from the brush's own, each way; by stroke, or drifting along it.
struct ColourJitter {
    float red = 0;
    float yellow = 0;
    float blue = 0;
    float lightness = 0; ///< all three together
    bool along = false;
    friend bool operator==(const ColourJitter &, const ColourJitter &) = default;
};

/// The tip is not round: it spreads ratio times as fast along an angle, radians, which turns with the path or stands
/// still on the canvas.
struct TipShape {
    float ratio = 1;
    float angle = 0;
    bool followsPath = true;
    friend bool operator==(const TipShape &, const TipShape &) = default;
};

/// What smooths the pen's way before it becomes a stroke.
struct Stabiliser {
    enum class Kind : std::uint8_t { Off, Weighted, String };
    Kind kind = Kind::Off;
    float strength = 0.5f; ///< of Weighted, [0, 1]
    float length = 30;     ///< of String, logical pixels
    friend bool operator==(const Stabiliser &, const Stabiliser &) = default;
};

/// Interval at which the knots of a stroke are taken along its time, unless the brush says otherwise.
inline constexpr Microseconds samplingInterval = 1'000'000 / 60;

/// What a new stroke is painted with. Density is given as the peak of a long straight line at full age,
/// pk = φˢ/(√π s), because that is what the style's ξ are compared with; the builder turns it into φˢ.
struct Brush {
    QString name;  ///< of the preset; built-in ones have ids
    QString group; ///< where the preset stands in lists; built-in ones have ids
    Style style;
    Mix mix;
    float diffusion = 12.5f; ///< D, unit²/s
    float peak = 1.2f;       ///< pk where no curve takes away
    float granulation = 1;   ///< ω
    float maxAge = 1;        ///< t_max, s
    Colour colour{0.85f, 0.75f, 0.9f, 1};
    Colour secondColour{0, 0, 0, 1}; ///< for BrushQuantity::ColourMix
    ColourJitter jitter;
    TipShape tip;
    Taper taper;
    Stabiliser stabiliser;
    /// At most one of a quantity and input, in their order.
    std::vector<BrushDynamic> dynamics{{BrushQuantity::Density, BrushInput::Pressure, {{{0, 0.5f}, {1, 1}}}}};
    float fullSpeed = 60;    ///< at which the input Speed is 1, spreads a second
    float fullDistance = 40; ///< at which the input Distance is 1, spreads
    float driftLength = 4;   ///< over which what drifts becomes another, spreads
    Microseconds interval = samplingInterval;

    /// s = √(4 D t_max)
    double spread() const { return std::sqrt(4.0 * diffusion * maxAge); }
    /// Sets D so that the spread is s; all else stays, the peak among it.
    void setSpread(double s) { diffusion = float(s * s / (4 * double(maxAge))); }

    /// The curve of a quantity and input, or null.
    const ResponseCurve *curve(BrushQuantity quantity, BrushInput input) const;
    void setCurve(BrushQuantity quantity, BrushInput input, const ResponseCurve &curve);
    void removeCurve(BrushQuantity quantity, BrushInput input);

    friend bool operator==(const Brush &, const Brush &) = default;
};

/// Empty if every value is in its domain, else as problemOf(Segment) says it, with the member's path in the brush file.
QString problemOf(const Brush &brush);

/// The brushes that come with the program, by groups ("ink", "watercolour", "dry", "flat", "air"); the first is the
/// default, which recordings are converted with.
const std::vector<Brush> &builtinBrushes();
/// The built-in one that people begin with in the window.
const Brush &firstBrush();
/// The built-in one with this id; null if there is none.
const Brush *findBrush(const QString &name);

} // namespace suffuse

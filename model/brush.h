#pragma once

#include "model/segment.h"

#include <QString>

#include <vector>

namespace suffuse {

/// What a new stroke is painted with. Density is given as the peak of a long straight line at full age,
/// pk = φˢ/(√π s), because that is what the style's ξ are compared with; the builder turns it into φˢ.
struct Brush {
    QString name;
    Style style;
    Mix mix;
    float diffusion = 12.5f;   ///< D, unit²/s
    float peak = 1.2f;         ///< pk at full pressure
    float pressureFloor = 0.5f;///< share of pk that zero pressure leaves; 1: pressure does not matter
    float granulation = 1;     ///< ω
    float maxAge = 1;          ///< t_max, s
    Colour colour{0.85f, 0.75f, 0.9f, 1};

    /// s = √(4 D t_max)
    double spread() const { return std::sqrt(4.0 * diffusion * maxAge); }
    friend bool operator==(const Brush &, const Brush &) = default;
};

/// The brushes that come with the program; the first is the default, which recordings are converted with.
/// Names are ids ("ink-wash", "watercolour-edge", "soft-airbrush", "flat-marker", "dry-chalk", "pencil").
const std::vector<Brush> &builtinBrushes();
/// Null if there is none of that name.
const Brush *findBrush(const QString &name);

} // namespace suffuse

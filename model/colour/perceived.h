// How far apart colours look.
#pragma once

#include "model/painting/style.h"

#include <array>
#include <vector>

namespace suffuse {

/// A colour where people see it, opacity aside: OKLab, that is lightness in [0, 1], green to red, blue to yellow.
/// Distances in it are about as large as they look.
using Perceived = std::array<double, 3>;
Perceived perceivedOf(const Colour &colour);

/// The distance between two of them; 1 from black to white.
double distanceOf(const Perceived &a, const Perceived &b);

/// Whether people call two of them one colour.
bool looksLike(const Perceived &a, const Perceived &b);

/// Colours of which the one is asked that looks nearest to another.
class ColourPalette {
public:
    explicit ColourPalette(std::vector<Colour> colours);

    bool isEmpty() const { return m_colours.empty(); }
    /// Of several as near, the first. There must be one.
    const Colour &nearest(const Colour &colour) const;

private:
    std::vector<Colour> m_colours;
    std::vector<Perceived> m_perceived;
};

} // namespace suffuse

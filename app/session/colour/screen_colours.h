// The picture's colours as the screen has to be given them.
#pragma once

#include "render/image_io/colour_conversion.h"
#include "render/pages.h"

#include <cstdint>
#include <memory>

namespace suffuse {

/// Converts pixels of 8 bits a channel. Each colour is converted once, in floating point, and then known: a picture has
/// few of the 16.8 million colours that 8 bits can tell, and a frame mostly those of the frame before. So pixels are
/// what lcms2 makes of them, rounded once, and cost little. The table takes up to 64 MB, as far as colours were looked
/// up. Copies share it; to be used on one thread.
class ScreenColours {
public:
    /// Changes nothing.
    ScreenColours() = default;
    explicit ScreenColours(const ColourConversion &conversion);

    bool changesNothing() const { return !m_known; }
    /// Converts opaque pixels, 0xFFRRGGBB, in place. What the conversion marks becomes `mark`.
    void convert(std::uint32_t *pixels, std::size_t count) const;

    /// What colours outside a gamut become: nothing that is painted often.
    static constexpr std::uint32_t mark = 0xFFFF00FF;

private:
    ColourConversion m_conversion;
    std::shared_ptr<Pixels<std::uint32_t>> m_known; ///< by red, green and blue; 0: not yet
};

} // namespace suffuse

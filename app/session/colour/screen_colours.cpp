#include "app/session/colour/screen_colours.h"

#include <algorithm>
#include <vector>

namespace suffuse {

namespace {

constexpr std::uint32_t opaque = 0xFF000000, colour = 0x00FFFFFF;

std::uint32_t level(float v)
{
    return std::uint32_t(std::clamp(v, 0.0f, 1.0f) * 255 + 0.5f);
}

} // namespace

ScreenColours::ScreenColours(const ColourConversion &conversion) : m_conversion(conversion)
{
    if (!conversion.changesNothing())
        m_known = std::make_shared<Pixels<std::uint32_t>>(std::size_t(1) << 24);
}

void ScreenColours::convert(std::uint32_t *pixels, std::size_t count) const
{
    if (!m_known)
        return;
    Pixels<std::uint32_t> &known = *m_known;
    std::vector<std::uint32_t> unknown;
    for (std::size_t i = 0; i < count; ++i)
        if (std::uint32_t &found = known[pixels[i] & colour]; found == 0) {
            found = opaque; // It is in the list now.
            unknown.push_back(pixels[i] & colour);
        }
    std::vector<float> values;
    values.reserve(4 * unknown.size());
    for (const std::uint32_t c : unknown)
        values.insert(values.end(), {float(c >> 16) / 255, float(c >> 8 & 255) / 255, float(c & 255) / 255, 1});
    m_conversion.apply(values.data(), unknown.size());
    for (std::size_t i = 0; i < unknown.size(); ++i) {
        const float *v = &values[4 * i];
        const bool marked = v[0] < -0.5f && v[1] < -0.5f && v[2] < -0.5f;
        known[unknown[i]] = marked ? mark : opaque | level(v[0]) << 16 | level(v[1]) << 8 | level(v[2]);
    }
    for (std::size_t i = 0; i < count; ++i)
        pixels[i] = known[pixels[i] & colour];
}

} // namespace suffuse

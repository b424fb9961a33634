#include "render/reference/paper.h"

#include <algorithm>
#include <cmath>

namespace suffuse::reference {

namespace {

constexpr int octaves = 48;

std::uint32_t scramble(std::uint32_t z)
{
    z ^= z >> 16;
    z *= 0x7FEB352Du;
    z ^= z >> 15;
    z *= 0x846CA68Bu;
    z ^= z >> 16;
    return z;
}

/// A whole number modulo 2³².
std::uint32_t lowBits(double whole)
{
    const double wrapped = std::fmod(whole, 4294967296.0);
    return std::uint32_t(std::int64_t(wrapped < 0 ? wrapped + 4294967296.0 : wrapped));
}

double fade(double f)
{
    return f * f * f * (f * (6 * f - 15) + 10);
}

double valueNoise(double u, double v, std::uint32_t octave, std::uint32_t seed)
{
    const double left = std::floor(u), top = std::floor(v);
    const double a = fade(u - left), b = fade(v - top);
    const std::uint32_t x = lowBits(left), y = lowBits(top);
    const double above = (1 - a) * paperCorner(x, y, octave, seed) + a * paperCorner(x + 1, y, octave, seed);
    const double below = (1 - a) * paperCorner(x, y + 1, octave, seed) + a * paperCorner(x + 1, y + 1, octave, seed);
    return (1 - b) * above + b * below;
}

/// i modulo n, in [0, n).
int wrapped(double i, int n)
{
    const double r = std::fmod(i, n);
    return int(r < 0 ? r + n : r);
}

} // namespace

double paperCorner(std::uint32_t x, std::uint32_t y, std::uint32_t octave, std::uint32_t seed)
{
    std::uint32_t h = seed * 0x9E3779B9u + octave * 0x85EBCA6Bu;
    h = scramble(h ^ (x * 0xC2B2AE35u));
    h = scramble(h ^ (y * 0x27D4EB2Fu));
    return double(h) / 2147483648.0 - 1;
}

PaperField::PaperField(const Paper &paper, std::shared_ptr<const PaperTexture> texture)
    : m_paper(paper), m_texture(std::move(texture))
{}

double PaperField::at(Point canvas, double px) const
{
    if (m_paper.strength == 0)
        return 1;
    switch (m_paper.kind) {
    case PaperKind::Procedural:
        return procedural(canvas, px);
    case PaperKind::Image:
        return image(canvas);
    case PaperKind::None:
        break;
    }
    return 1;
}

double PaperField::procedural(Point canvas, double px) const
{
    double sum = 0;
    for (int i = 0; i < octaves; ++i) {
        const double wavelength = std::ldexp(double(m_paper.scale), -i);
        const double share = px > 0 ? std::clamp((wavelength / px - 2) / 2, 0.0, 1.0) : 1.0;
        if (share == 0)
            break; // finer octaves have none either
        sum += share * std::pow(2.0, -0.5 * i) *
               valueNoise(canvas.x / wavelength, canvas.y / wavelength, std::uint32_t(i), m_paper.seed);
    }
    return 1 - double(m_paper.strength) * std::clamp(0.5 + 0.5 * (1.5 * sum), 0.0, 1.0);
}

double PaperField::image(Point canvas) const
{
    if (!m_texture || m_texture->width <= 0 || m_texture->height <= 0)
        return 1;
    const double u = canvas.x / double(m_paper.scale) - 0.5, v = canvas.y / double(m_paper.scale) - 0.5;
    const double left = std::floor(u), top = std::floor(v);
    const double a = u - left, b = v - top;
    const auto texel = [&](double i, double j) {
        const int x = wrapped(i, m_texture->width), y = wrapped(j, m_texture->height);
        return double(m_texture->grey[std::size_t(y) * std::size_t(m_texture->width) + std::size_t(x)]);
    };
    const double grey = (1 - b) * ((1 - a) * texel(left, top) + a * texel(left + 1, top)) +
                        b * ((1 - a) * texel(left, top + 1) + a * texel(left + 1, top + 1));
    return 1 - double(m_paper.strength) * (1 - grey);
}

} // namespace suffuse::reference

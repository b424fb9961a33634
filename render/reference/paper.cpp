#include "render/reference/paper.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::reference {

namespace {

constexpr int octaveCount = 48;

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

double gradientNoise(Point at, std::uint32_t layer, std::uint32_t seed)
{
    const double left = std::floor(at.x), top = std::floor(at.y);
    double sum = 0;
    for (int corner = 0; corner < 4; ++corner) {
        const int i = corner % 2, j = corner / 2;
        const Point gradient =
            paperGradient(lowBits(left) + std::uint32_t(i), lowBits(top) + std::uint32_t(j), layer, seed);
        const Point from{at.x - left - i, at.y - top - j};
        const double across = fade(at.x - left), down = fade(at.y - top);
        sum += dot(gradient, from) * (i ? across : 1 - across) * (j ? down : 1 - down);
    }
    return sum;
}

/// R^times of docs/paper.md.
Point turned(Point p, int times)
{
    for (int k = 0; k < times; ++k)
        p = {(3 * p.x - 4 * p.y) / 5, (4 * p.x + 3 * p.y) / 5};
    return p;
}

double bandLimit(double samples)
{
    const double t = std::clamp((samples - 2) / 3, 0.0, 1.0);
    return 3 * t * t - 2 * t * t * t;
}

/// i modulo n, in [0, n).
int wrapped(double i, int n)
{
    const double r = std::fmod(i, n);
    return int(r < 0 ? r + n : r);
}

} // namespace

Point paperGradient(std::uint32_t x, std::uint32_t y, std::uint32_t layer, std::uint32_t seed)
{
    std::uint32_t h = seed * 0x9E3779B9u + layer * 0x85EBCA6Bu;
    h = scramble(h ^ (x * 0xC2B2AE35u));
    h = scramble(h ^ (y * 0x27D4EB2Fu));
    return {double(h % 65536) / 32768 - 1, double(h / 65536) / 32768 - 1};
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

double PaperField::octaves(Point cell, double samples) const
{
    double sum = 0;
    for (int i = 0; i < octaveCount; ++i) {
        const double share = bandLimit(std::ldexp(samples, -i));
        if (share == 0)
            break; // Finer octaves have no part in it, either.
        const Point lattice = std::ldexp(1.0, i) * turned(cell, i + 1) + Point{0.5, 0.5};
        sum += share * std::pow(2.0, -0.5 * i) * gradientNoise(lattice, std::uint32_t(i), m_paper.seed);
    }
    return sum;
}

double PaperField::fibres(Point cell) const
{
    double sum = 0;
    for (int j = 1; j <= 5; ++j) {
        const Point p = turned(cell, j);
        const double away = std::abs(gradientNoise({p.x / 8, p.y}, std::uint32_t(49 + j), m_paper.seed));
        sum += std::max(0.0, 1 - 12 * away) - 0.19;
    }
    return sum;
}

double PaperField::weave(Point cell) const
{
    const Point quarter = 0.25 * cell;
    const double s = cell.x + 0.35 * gradientNoise(quarter, 48, m_paper.seed);
    const double t = cell.y + 0.35 * gradientNoise(quarter, 49, m_paper.seed);
    const auto back = [](double r) { return 1 - std::pow(2 * (r - std::floor(r)) - 1, 2); };
    const bool odd = std::fmod(std::floor(s) + std::floor(t), 2) != 0;
    const double a = back(s), b = back(t);
    const double warp = odd ? a * (1 + b) : a * (1 - b), weft = odd ? b * (1 - a) : b * (1 + a);
    return std::max(warp, weft) / 2 - 0.58;
}

double PaperField::procedural(Point canvas, double px) const
{
    const double scale = double(m_paper.scale);
    const Point cell{canvas.x / scale, canvas.y / scale};
    const double samples = px > 0 ? scale / px : std::numeric_limits<double>::infinity();
    double n = octaves(cell, samples);
    switch (m_paper.grain) {
    case PaperGrain::Tooth:
        n *= 2.5;
        break;
    case PaperGrain::Fibres:
        n -= bandLimit(0.4 * samples) * fibres(cell);
        break;
    case PaperGrain::Weave:
        n = 0.75 * n - 2.2 * bandLimit(samples) * weave(cell);
        break;
    }
    const double t = std::clamp(n / 1.5, -1.0, 1.0);
    return 1 - double(m_paper.strength) * (0.5 + 0.25 * (3 * t - t * t * t));
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

#include "model/paint/local_paint.h"

namespace suffuse {

void LocalPaint::add(const Segment &segment, const Style &style, double density)
{
    if (segment.takesPaint()) {
        (segment.lift ? m_lifted : m_faded) += density;
        return;
    }
    addLaid(segment.colour, segment.granulation, style, density);
}

void LocalPaint::add(const Fill &fill, const Style &style, double density, double place)
{
    Colour colour = fill.colour;
    if (fill.gradient) {
        const Colour &to = fill.gradient->colour;
        const auto between = [place](float a, float b) { return float(double(a) + place * double(b - a)); };
        colour = {between(colour.red, to.red), between(colour.yellow, to.yellow), between(colour.blue, to.blue),
                  between(colour.opacity, to.opacity)};
    }
    addLaid(colour, fill.granulation, style, density);
}

void LocalPaint::addLaid(const Colour &paint, float granulation, const Style &style, double density)
{
    m_laid += density;
    m_granulation += density * double(granulation);
    const std::array<float, 4> colour{paint.red, paint.yellow, paint.blue, paint.opacity};
    for (std::size_t i = 0; i < 4; ++i)
        m_colour[i] += density * double(colour[i]);
    KindSum &kind = m_kinds[std::size_t(style.kind)];
    kind.density += density;
    for (std::size_t i = 0; i < 3; ++i)
        kind.xi[i] += density * double(style.xi[i]);
}

double LocalPaint::granulation() const
{
    return m_laid > 0 ? m_granulation / m_laid : 1;
}

std::array<double, 4> LocalPaint::colour() const
{
    std::array<double, 4> mean{};
    for (std::size_t i = 0; i < 4 && m_laid > 0; ++i)
        mean[i] = m_colour[i] / m_laid;
    return mean;
}

double LocalPaint::coverage(double eta) const
{
    const double density = modulation(granulation(), eta) * this->density();
    double sum = 0;
    for (const StyleKind kind : styleKinds) {
        const KindSum &own = m_kinds[std::size_t(kind)];
        if (!(own.density > 0))
            continue;
        const std::array<double, 3> xi{own.xi[0] / own.density, own.xi[1] / own.density, own.xi[2] / own.density};
        sum += own.density / m_laid * densityFunction(kind, xi, density);
    }
    return sum;
}

double modulation(double granulation, double eta)
{
    return (1 - granulation) * eta + granulation;
}

} // namespace suffuse

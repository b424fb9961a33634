#include "model/formats/svg/svg_shingles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse {

namespace {

constexpr int overEachOther = 6;
constexpr double mostOpaque = 1 - 1.0 / 256; ///< that logarithms are taken of
constexpr double infinite = std::numeric_limits<double>::infinity();

double changeBetween(const SvgColour &a, const SvgColour &b)
{
    double change = 0;
    for (std::size_t c = 0; c < 4; ++c)
        change = std::max(change, std::abs(b[c] - a[c]));
    return change;
}

/// A part of a gradient without jumps, in steps across which no channel changes much.
class SmoothPart {
public:
    SmoothPart(double begin, const SvgColour &colour) : m_ends{begin}, m_colours{colour} {}

    /// Goes on to a stop behind the end, in equal steps.
    void goOn(const SvgStop &stop, int steps)
    {
        const double from = m_ends.back();
        const SvgColour before = m_colours.back();
        for (int k = 1; k <= steps; ++k) {
            const double share = double(k) / steps;
            m_ends.push_back(k < steps ? from + share * (stop.offset - from) : stop.offset);
            SvgColour colour;
            for (std::size_t c = 0; c < 4; ++c)
                colour[c] = before[c] + share * (stop.colour[c] - before[c]);
            m_colours.push_back(colour);
        }
    }

    /// Goes on with its last colour.
    void goOn(double end)
    {
        m_ends.push_back(end);
        m_colours.push_back(m_colours.back());
    }

    void addShingles(std::vector<SvgShingle> &all) const
    {
        const int steps = int(m_ends.size()) - 1;
        for (int k = 1 - overEachOther; steps > 0 && k < steps; ++k) {
            const int first = std::max(k, 0), behind = std::min(k + overEachOther, steps);
            SvgShingle ring{m_ends[std::size_t(first)], m_ends[std::size_t(behind)], {}};
            // Above it lie those that begin farther outside, and let its colour through less and less.
            const double opacity = opacityOf(k, first, behind);
            double weight = 1, sum = 0, shift = 0;
            for (int i = 0; i < overEachOther; ++i, weight *= 1 - opacity)
                sum += weight, shift += i * weight;
            ring.colour = at(k + 0.5 + shift / sum);
            ring.colour[3] = opacity;
            all.push_back(ring);
        }
    }

private:
    /// The opacity of which six make that of the gradient. Each is that in the ring's middle, since opacities are
    /// multiplied as their logarithms are added.
    double opacityOf(int k, int first, int behind) const
    {
        const bool isOpaque = std::all_of(m_colours.begin() + first, m_colours.begin() + behind + 1,
                                          [](const SvgColour &colour) { return colour[3] == 1; });
        const double whole = at(k + 0.5 * overEachOther)[3];
        return isOpaque ? 1 : 1 - std::pow(1 - std::min(whole, mostOpaque), 1.0 / overEachOther);
    }

    /// The colour at a place that counts in steps.
    SvgColour at(double place) const
    {
        const double inside = std::clamp(place, 0.0, double(m_colours.size() - 1));
        const auto step = std::min(std::size_t(inside), m_colours.size() - 2);
        SvgColour colour;
        for (std::size_t c = 0; c < 4; ++c)
            colour[c] = m_colours[step][c] + (inside - double(step)) * (m_colours[step + 1][c] - m_colours[step][c]);
        return colour;
    }

    std::vector<double> m_ends;       ///< where steps begin and end
    std::vector<SvgColour> m_colours; ///< the colours there
};

} // namespace

std::vector<SvgShingle> svgShingles(const std::vector<SvgStop> &stops, int finest)
{
    std::vector<SvgShingle> all;
    SmoothPart part(-infinite, stops.front().colour);
    part.goOn(stops.front().offset);
    for (std::size_t i = 1; i < stops.size(); ++i) {
        const SvgStop &a = stops[i - 1], &b = stops[i];
        const double change = changeBetween(a.colour, b.colour);
        if (b.offset > a.offset) {
            part.goOn(b, std::clamp(int(std::ceil(finest * change)), 1, finest));
        } else if (change > 0) { // A jump stays one.
            part.addShingles(all);
            part = SmoothPart(a.offset, b.colour);
        }
    }
    part.goOn(infinite);
    part.addShingles(all);
    return all;
}

} // namespace suffuse

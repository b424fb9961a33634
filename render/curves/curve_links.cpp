#include "render/curves/curve_links.h"

#include <algorithm>
#include <cmath>

namespace suffuse::curves {

namespace {

constexpr double flatness = 0.02;      ///< pixels: so near to their curves lines stay
constexpr int mostLines = 512;         ///< for one cubic
constexpr double leastDistance = 0.01; ///< pixels: a nearer curve would weigh too much for floating point

using Values = std::array<float, curveValues>;

/// A curve across the link of a pixel to its right or lower neighbour.
struct Cut {
    std::size_t pixel = 0;
    float place = 0;      ///< on the link, [0, 1)
    Values before, after; ///< on the side of the pixel, and of its neighbour
};

/// A point of a curve, and its place among the stops.
struct Station {
    Point at;
    double place = 0;
};

class Cutter {
public:
    Cutter(const CurveSet &set, int width, int height)
        : m_width(width), m_height(height), m_x(width / set.width), m_y(height / set.height)
    {}

    void add(const DiffusionCurve &curve)
    {
        for (std::size_t i = 0; i + 3 < curve.points.size(); i += 3) {
            Cubic cubic;
            std::array<Point, 4> &p = cubic.p;
            for (std::size_t k = 0; k < 4; ++k)
                p[k] = {curve.points[i + k].x * m_x, curve.points[i + k].y * m_y};
            if (isBeside(p))
                continue;
            const int lines = linesFor(p);
            Station from{p[0], double(i / 3) * curveStopsPerCubic};
            for (int k = 1; k <= lines; ++k) {
                const double t = double(k) / lines;
                const Station to{k == lines ? p[3] : cubic.at(t), (double(i / 3) + t) * curveStopsPerCubic};
                cut<false>(curve, from, to);
                cut<true>(curve, from, to);
                from = to;
            }
        }
    }

    std::vector<Cut> right, down; ///< of links to the right and downwards

private:
    /// Whether a cubic lies wholly on one side of the picture, and so cuts nothing.
    bool isBeside(const std::array<Point, 4> &p) const
    {
        const auto all = [&p](auto test) { return std::all_of(p.begin(), p.end(), test); };
        return all([](Point q) { return q.x < 0; }) || all([](Point q) { return q.y < 0; }) ||
               all([this](Point q) { return q.x > m_width; }) || all([this](Point q) { return q.y > m_height; });
    }

    /// A chord over 1/n of a cubic is at most |B″|/(8n²) away from it, and |B″| at most six times the second
    /// difference.
    static int linesFor(const std::array<Point, 4> &p)
    {
        const double bend = std::max(length(p[0] - 2 * p[1] + p[2]), length(p[1] - 2 * p[2] + p[3]));
        return std::clamp(int(std::ceil(std::sqrt(6 * bend / (8 * flatness)))), 1, mostLines);
    }

    /// Cuts links to the right, or with `Down` downwards: at each line of centres that the step crosses. A line belongs
    /// to the step that comes to it or leaves it, never to both.
    template <bool Down>
    void cut(const DiffusionCurve &curve, const Station &from, const Station &to)
    {
        const double a = Down ? from.at.x : from.at.y, b = Down ? to.at.x : to.at.y;
        const double across = Down ? from.at.y : from.at.x, acrossStep = (Down ? to.at.y : to.at.x) - across;
        const int lines = Down ? m_width : m_height, links = (Down ? m_height : m_width) - 1;
        const double least = std::max(std::ceil(std::min(a, b) - 0.5), 0.0);
        for (double line = least; line < lines && line + 0.5 < std::max(a, b); ++line) {
            const double t = (line + 0.5 - a) / (b - a);
            const double where = across + t * acrossStep - 0.5, link = std::floor(where);
            if (!(link >= 0 && link < links))
                continue;
            const auto x = std::size_t(Down ? line : link), y = std::size_t(Down ? link : line);
            // Seen with y downwards, the left hand of a line that goes down points to the right.
            const bool leftIsAfter = Down ? b < a : b > a;
            const double place = from.place + t * (to.place - from.place);
            const Values left = valuesAt(curve, curve.left, place), other = valuesAt(curve, curve.right, place);
            (Down ? down : right)
                .push_back({y * std::size_t(m_width) + x, float(where - link), leftIsAfter ? other : left,
                            leftIsAfter ? left : other});
        }
    }

    Values valuesAt(const DiffusionCurve &curve, const CurveStops<CurveColour> &side, double place) const
    {
        const CurveColour colour = side.at(place);
        return {float(colour[0]), float(colour[1]), float(colour[2]),
                float(curve.blurAt(place) * std::sqrt(m_x * m_y))};
    }

    int m_width, m_height;
    double m_x, m_y; ///< pixels for each of the file's
};

void anchor(CurveLinks &links, std::size_t pixel, double distance, const Values &values)
{
    const auto weight = float(1 / std::max(distance, leastDistance));
    links.anchors[pixel] += weight;
    for (std::size_t v = 0; v < curveValues; ++v)
        links.sources[v][pixel] += weight * values[v];
}

/// Takes the cuts of links whose ends are `step` pixels apart: of several, each end sees the nearest.
void apply(std::vector<Cut> &cuts, std::size_t step, std::vector<std::uint8_t> &open, CurveLinks &links)
{
    std::stable_sort(cuts.begin(), cuts.end(), [](const Cut &a, const Cut &b) {
        return a.pixel != b.pixel ? a.pixel < b.pixel : a.place < b.place;
    });
    for (std::size_t i = 0; i < cuts.size();) {
        std::size_t last = i;
        while (last + 1 < cuts.size() && cuts[last + 1].pixel == cuts[i].pixel)
            ++last;
        anchor(links, cuts[i].pixel, double(cuts[i].place), cuts[i].before);
        anchor(links, cuts[i].pixel + step, 1 - double(cuts[last].place), cuts[last].after);
        open[cuts[i].pixel] = 0;
        i = last + 1;
    }
    links.isCut = links.isCut || !cuts.empty();
}

void findMean(const CurveSet &set, const Cutter &cutter, CurveLinks &links)
{
    double count = 0;
    for (const std::vector<Cut> *cuts : {&cutter.right, &cutter.down})
        for (const Cut &cut : *cuts) {
            for (std::size_t v = 0; v < curveValues; ++v)
                links.mean[v] += 0.5 * double(cut.before[v] + cut.after[v]);
            ++count;
        }
    if (count == 0)
        for (const DiffusionCurve &curve : set.curves) {
            const CurveColour left = curve.left.at(0), other = curve.right.at(0);
            for (std::size_t c = 0; c < 3; ++c)
                links.mean[c] += 0.5 * (left[c] + other[c]);
            ++count;
        }
    for (double &v : links.mean)
        v /= std::max(count, 1.0);
}

} // namespace

CurveLinks linksOf(const CurveSet &set, int width, int height, const std::atomic<bool> *cancel)
{
    CurveLinks links;
    links.width = width, links.height = height;
    const std::size_t pixels = std::size_t(width) * std::size_t(height);
    links.right.assign(pixels, 1), links.down.assign(pixels, 1);
    for (int y = 0; y < height; ++y)
        links.right[std::size_t(y + 1) * std::size_t(width) - 1] = 0;
    std::fill(links.down.end() - width, links.down.end(), std::uint8_t(0));
    links.anchors.assign(pixels, 0);
    for (std::vector<float> &source : links.sources)
        source.assign(pixels, 0);
    Cutter cutter(set, width, height);
    for (const DiffusionCurve &curve : set.curves) {
        if (cancel && *cancel)
            return links;
        cutter.add(curve);
    }
    findMean(set, cutter, links);
    apply(cutter.right, 1, links.right, links);
    apply(cutter.down, std::size_t(width), links.down, links);
    return links;
}

} // namespace suffuse::curves

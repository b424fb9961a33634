#include "render/contours/contours.h"

#include "model/area/area_sets.h"
#include "model/area/outline.h"
#include "render/contours/contour_fit.h"
#include "render/contours/style_levels.h"
#include "render/image_io/image_io.h"

#include <cmath>

namespace suffuse::contours {

namespace {

/// A crisp fill whose paint goes with other paint of another style or opacity is taken for one of this spread.
constexpr double softened = 1.0 / 32;

/// Whether all that lays paint has the style and the opacity of the fill.
bool isEven(const Stroke &stroke)
{
    return std::all_of(stroke.segments.begin(), stroke.segments.end(), [&](const Segment &s) {
        return s.takesPaint() || !(s.density > 0) ||
               (stroke.styleOf(s) == stroke.style && s.colour.opacity == stroke.fill->colour.opacity);
    });
}

/// The greatest opacity of all that lays paint.
double mostOpacity(const Stroke &stroke)
{
    double most = 0;
    if (stroke.fill)
        most = double(stroke.fill->colour.opacity);
    if (stroke.fill && stroke.fill->gradient)
        most = std::max(most, double(stroke.fill->gradient->colour.opacity));
    for (const Segment &segment : stroke.segments)
        if (!segment.takesPaint() && segment.density > 0)
            most = std::max(most, double(segment.colour.opacity));
    return most;
}

Stroke prepared(const Stroke &stroke, Microseconds T)
{
    Stroke copy = stroke;
    if (!stroke.fill || !(stroke.fill->age(T) > 0))
        return copy;
    const bool fades = stroke.fill->gradient && stroke.fill->gradient->colour.opacity != stroke.fill->colour.opacity;
    if (!stroke.hasFade() && (isFillAlone(stroke) || (isEven(stroke) && !stroke.hasErasure() && !fades)))
        return copy;
    Fill fill = *stroke.fill;
    fill.diffusion = std::max(fill.diffusion, float(softened * softened / (4 * fill.age(T))));
    copy.fill = fill;
    return copy;
}

/// Loops that run around what is left out of the outer ones the other way.
void appendReversed(const Loops &loops, Loops &out)
{
    for (const std::vector<Cubic> &loop : loops) {
        std::vector<Cubic> back(loop.rbegin(), loop.rend());
        for (Cubic &c : back)
            std::reverse(c.p.begin(), c.p.end());
        out.push_back(std::move(back));
    }
}

} // namespace

StrokeContours::StrokeContours(const Stroke &stroke, Microseconds T, const ContourOptions &options)
    : m_stroke(prepared(stroke, T)), m_options(options), m_field(m_stroke, T, options.eta, options.tolerance)
{}

Loops StrokeContours::placed(Loops loops) const
{
    for (std::vector<Cubic> &loop : loops)
        for (Cubic &c : loop)
            for (Point &p : c.p)
                p = m_stroke.origin + p;
    return loops;
}

double StrokeContours::lowestDensity(double coverage) const
{
    double lowest = std::numeric_limits<double>::infinity();
    const auto take = [&](const Style &style) {
        const std::vector<double> crossings = crossingsOf(style, coverage);
        if (!crossings.empty())
            lowest = std::min(lowest, crossings.front());
    };
    if (m_field.hasOneStyle()) {
        take(m_field.style());
        return 0.999 * lowest;
    }
    take(m_stroke.style);
    for (const Segment &segment : m_stroke.segments)
        if (segment.style)
            take(*segment.style);
    return 0.5 * lowest; // Between styles F is none of theirs.
}

std::vector<Loops> StrokeContours::above(const Field &field, const std::vector<double> &levels, double lowest) const
{
    CellOptions options{m_options.tolerance, lowest, m_options.cancel};
    const auto chains = contourChains(m_field, field, levels, options);
    std::vector<Loops> out(levels.size());
    for (std::size_t k = 0; k < levels.size(); ++k)
        for (const ContourChain &chain : chains[k]) {
            if (m_options.cancel && m_options.cancel->load(std::memory_order_relaxed))
                return out;
            std::vector<Cubic> loop = fittedLoop(chain, field, levels[k], m_options.tolerance);
            if (!loop.empty())
                out[k].push_back(std::move(loop));
        }
    return out;
}

std::vector<Loops> StrokeContours::aboveDensities(const std::vector<double> &densities) const
{
    if (densities.empty())
        return {};
    // Where paint lies level exactly at a density, it is above it.
    constexpr double below = 1 - 1e-9;
    const double crisp = m_field.crispDensity();
    std::vector<double> levels;
    for (const double density : densities)
        levels.push_back(below * density);
    for (std::size_t k = 0; k < densities.size() && crisp > 0; ++k)
        if (densities[k] > crisp)
            levels.push_back(below * densities[k] - crisp);
    std::sort(levels.begin(), levels.end());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    const auto field = [this](Point p) { return m_field.modulatedAt(p); };
    const std::vector<Loops> all = above(field, levels, levels.front());
    const auto at = [&](double level) {
        return all[std::size_t(std::lower_bound(levels.begin(), levels.end(), level) - levels.begin())];
    };
    std::vector<Loops> out;
    Area area;
    if (crisp > 0)
        area = areaOf(closedOutline(m_stroke), m_stroke.fill->rule);
    for (const double density : densities) {
        Loops loops = at(below * density);
        if (crisp > 0) {
            const Area within = below * density <= crisp ? area : intersection(area, {at(below * density - crisp)});
            loops = loops.empty() ? within.loops : united({loops}, within).loops;
        }
        out.push_back(placed(std::move(loops)));
    }
    return out;
}

Loops StrokeContours::outline(double level) const
{
    if (!m_field.hasOneStyle()) {
        const auto field = [this](Point p) { return m_field.coverageAt(p); };
        return placed(above(field, {level}, lowestDensity(level)).front());
    }
    const std::vector<Loops> parts = aboveDensities(crossingsOf(m_field.style(), level));
    Loops out;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (k % 2 == 0)
            out.insert(out.end(), parts[k].begin(), parts[k].end());
        else
            appendReversed(parts[k], out);
    }
    return out;
}

std::vector<Band> StrokeContours::bands(int count) const
{
    const double most = mostOpacity(m_stroke);
    if (!(most > 0))
        return {};
    if (isCrisp()) { // It is evenly covered: as it is.
        const double density = m_field.crispDensity();
        Loops loops = aboveDensities({density}).front();
        const double coverage = densityFunction(m_field.style(), density);
        return loops.empty() || !(coverage > 0) ? std::vector<Band>() : std::vector<Band>{{coverage * most, loops}};
    }
    return m_field.hasOneStyle() && m_field.evenOpacity() ? evenBands(count, *m_field.evenOpacity())
                                                          : opacityBands(count, most);
}

std::vector<Band> StrokeContours::evenBands(int count, double opacity) const
{
    const std::vector<CoverageStep> levels =
        stepsOf(m_field.style(), std::max(1, int(std::ceil(count * opacity - 1e-9))));
    std::vector<double> densities;
    for (const CoverageStep &step : levels)
        densities.push_back(step.density);
    std::vector<Loops> loops = aboveDensities(densities);
    std::vector<Band> out;
    for (std::size_t k = 0; k < loops.size(); ++k)
        if (!loops[k].empty())
            out.push_back({levels[k].coverage * opacity, std::move(loops[k])});
    return out;
}

std::vector<Band> StrokeContours::opacityBands(int count, double most) const
{
    const int steps = std::max(1, int(std::ceil(count * most - 1e-9)));
    std::vector<double> levels;
    for (int k = 0; k < steps; ++k)
        levels.push_back((k + 0.5) * most / steps);
    const auto field = [this](Point p) { return m_field.opacityAt(p); };
    std::vector<Loops> loops = above(field, levels, lowestDensity(levels.front() / most));
    std::vector<Band> out;
    for (std::size_t k = 0; k < loops.size(); ++k)
        if (!loops[k].empty())
            out.push_back({(double(k) + 1) * most / steps, placed(std::move(loops[k]))});
    return out;
}

double meanOf(const Paper &paper)
{
    switch (paper.kind) {
    case PaperKind::None:
        break;
    case PaperKind::Procedural:
        return 1 - 0.5 * double(paper.strength); // as far away as it looks (docs/paper.md)
    case PaperKind::Image: {
        if (!paper.image)
            break;
        const Result<FloatPicture> image = readImage(*paper.image, QStringLiteral("paper"));
        if (!image || image->rgba.empty())
            break;
        double sum = 0;
        const std::size_t pixels = std::size_t(image->width) * std::size_t(image->height);
        for (std::size_t i = 0; i < pixels; ++i) {
            const float *rgba = image->rgba.data() + 4 * i;
            sum += 0.2126 * double(rgba[0]) + 0.7152 * double(rgba[1]) + 0.0722 * double(rgba[2]);
        }
        return 1 - double(paper.strength) * (1 - sum / double(pixels));
    }
    }
    return 1;
}

} // namespace suffuse::contours

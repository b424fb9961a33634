#include "model/shaping/erasing/paint_samples.h"

#include "model/area/outline.h"
#include "model/brush/stroke_fit.h"
#include "model/paint/style_function.h"
#include "model/shaping/curves/split.h"

#include <algorithm>

namespace suffuse {

namespace {

/// A grid meets each strip of paint that has spread so many of its spacings.
constexpr double surelyMet = 1.5;
constexpr int mostPlaces = 64; ///< on a segment

double excessOf(const Style *style, double density, double opacity)
{
    if (!style || !(density > 0) || densityFunction(*style, density) * opacity < visibleOpacity)
        return 0;
    return std::max(density - visibleCut(*style), density / 4);
}

/// A gradient may begin transparent.
float mostOpacity(const Fill &fill)
{
    return fill.gradient ? std::max(fill.colour.opacity, fill.gradient->colour.opacity) : fill.colour.opacity;
}

} // namespace

PaintSamples::PaintSamples(StrokePtr stroke, Microseconds T, Point corner, double spacing)
    : m_stroke(std::move(stroke)), m_present(m_stroke), m_time(T), m_corner(corner - m_stroke->origin),
      m_spacing(spacing)
{
    const auto comesLater = [T](const Segment &segment) { return segment.born > T; };
    if (std::ranges::any_of(m_stroke->segments, comesLater)) {
        auto present = std::make_shared<Stroke>(*m_stroke);
        std::erase_if(present->segments, comesLater);
        m_present = std::move(present);
    }
    m_sights.emplace_back(*m_present, T);
    if (!m_present->segments.empty() && m_present->driesAt() > T)
        m_sights.emplace_back(*m_present, m_present->driesAt());
}

void PaintSamples::placeOnHairlines()
{
    if (std::exchange(m_isPlaced, true))
        return;
    for (const Segment &segment : m_present->segments) {
        if (segment.takesPaint() || segment.spread(m_time) > surelyMet * m_spacing)
            continue;
        const Cubic curve = offsetsOf(segment);
        const int count = int(std::clamp(std::ceil(arcLength(curve) / m_spacing), 1.0, double(mostPlaces)));
        for (int i = 0; i < count; ++i)
            m_places.push_back({curve.at((i + 0.5) / count), {}});
    }
}

PaintSamples::PaintAt PaintSamples::look(Point fromOrigin) const
{
    PaintAt sample;
    const Point at = m_present->origin + fromOrigin;
    for (const PaintSight &sight : m_sights) {
        const SeenPaint seen = sight.at(at);
        if (seen.segment >= 0 && seen.density > sample.density) {
            const auto k = std::size_t(seen.segment);
            const Segment &segment = m_present->segments[k];
            const float opacity = onlyBounds(*m_present, k) ? mostOpacity(*m_present->fill) : segment.colour.opacity;
            sample = {&m_present->styleOf(segment), seen.density, double(opacity) * seen.left, 0};
        }
    }
    for (const DensityOfSegment &lift : m_taken)
        sample.taken += lift(fromOrigin);
    return sample;
}

Point PaintSamples::pointOf(const Cell &cell) const
{
    return m_corner + m_spacing * Point{double(cell.first), double(cell.second)};
}

PaintSamples::PaintAt &PaintSamples::sampleOf(const Cell &cell)
{
    const auto it = m_grid.find(cell);
    return it != m_grid.end() ? it->second : m_grid.emplace(cell, look(pointOf(cell))).first->second;
}

double PaintSamples::excessWithin(Point centre, double radius)
{
    constexpr double farthestCell = 1e9; // so that cells are whole numbers
    placeOnHairlines();
    std::vector<double> seen;
    const auto add = [&seen](const PaintAt &sample) {
        if (const double excess = excessOf(sample.style, sample.density - sample.taken, sample.opacity); excess > 0)
            seen.push_back(excess);
    };
    const Point at = centre - m_present->origin, in = (1 / m_spacing) * (at - m_corner);
    const double reach = radius / m_spacing;
    if (std::max(std::abs(in.x), std::abs(in.y)) + reach < farthestCell)
        for (int y = int(std::ceil(in.y - reach)); y <= int(std::floor(in.y + reach)); ++y) {
            const double half = std::sqrt(std::max(0.0, reach * reach - (y - in.y) * (y - in.y)));
            for (int x = int(std::ceil(in.x - half)); x <= int(std::floor(in.x + half)); ++x)
                add(sampleOf({x, y}));
        }
    for (HairlinePoint &place : m_places) {
        if (length(place.at - at) > radius)
            continue;
        if (!place.sample)
            place.sample = look(place.at);
        add(*place.sample);
    }
    if (seen.empty())
        return 0;
    const auto quartile = seen.begin() + std::ptrdiff_t(seen.size() * 3 / 4);
    std::ranges::nth_element(seen, quartile);
    return *quartile;
}

void PaintSamples::take(const Segment &lift)
{
    const DensityOfSegment &taken = m_taken.emplace_back(lift, lift.spread(lift.driesAt()), CurveDetail::Rough);
    for (auto &[cell, sample] : m_grid)
        sample.taken += taken(pointOf(cell));
    for (HairlinePoint &place : m_places)
        if (place.sample)
            place.sample->taken += taken(place.at);
}

} // namespace suffuse

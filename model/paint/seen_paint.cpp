#include "model/paint/seen_paint.h"

#include "model/paint/local_paint.h"
#include "model/painting/influence.h"

namespace suffuse {

namespace {

/// Sums what the segments have at a point.
class Sum {
public:
    explicit Sum(const Stroke &stroke) : m_stroke(stroke) {}
    void add(std::size_t k, double density)
    {
        const Segment &segment = m_stroke.segments[k];
        m_paint.add(segment, m_stroke.styleOf(segment), density);
        if (density > m_largest && !segment.takesPaint()) {
            m_largest = density;
            m_segment = int(k);
        }
    }
    void addFill(const DensityOfFill &fill, Point fromOrigin)
    {
        const DensityOfFill::Value value = fill(fromOrigin);
        if (!(value.density > 0))
            return;
        m_paint.add(*m_stroke.fill, m_stroke.style, value.density, value.place);
        if (m_segment < 0)
            m_segment = nearestBound(fromOrigin);
    }
    SeenPaint seen() const
    {
        const std::array<double, 4> c = m_paint.colour();
        return {m_paint.density(),
                m_paint.opacity(1),
                m_segment,
                std::exp(-m_paint.faded()),
                {float(c[0]), float(c[1]), float(c[2]), float(c[3])}};
    }

private:
    /// The segment of the outline that comes nearest to a point, as far as a few of its points tell.
    int nearestBound(Point fromOrigin) const
    {
        int nearest = -1;
        double least = 0;
        for (std::size_t k = 0; k < m_stroke.segments.size(); ++k) {
            const Segment &segment = m_stroke.segments[k];
            for (int i = 0; i <= 4 && !segment.takesPaint(); ++i) {
                const Point away = offsetsOf(segment).at(i / 4.0) - fromOrigin;
                if (const double square = dot(away, away); nearest < 0 || square < least)
                    least = square, nearest = int(k);
            }
        }
        return nearest;
    }

    const Stroke &m_stroke;
    LocalPaint m_paint;
    double m_largest = 0;
    int m_segment = -1;
};

} // namespace

PaintSight::PaintSight(const Stroke &stroke, Microseconds T) : m_stroke(&stroke)
{
    for (std::size_t k = 0; k < stroke.segments.size(); ++k)
        if (const double spread = stroke.segments[k].spread(T); spread > 0)
            m_sources.push_back({int(k), DensityOfSegment(stroke.segments[k], spread, CurveDetail::Rough)});
    if (stroke.fill && stroke.fill->age(T) > 0)
        m_fill.emplace(stroke, T);
}

SeenPaint PaintSight::at(Point point) const
{
    const Point fromOrigin = point - m_stroke->origin;
    Sum sum(*m_stroke);
    for (const Source &source : m_sources)
        if (source.density.reaches(fromOrigin))
            sum.add(std::size_t(source.segment), source.density(fromOrigin));
    if (m_fill)
        sum.addFill(*m_fill, fromOrigin);
    return sum.seen();
}

SeenPaint seenPaint(const Stroke &stroke, Microseconds T, Point point)
{
    const Point at = point - stroke.origin;
    Sum sum(stroke);
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const Segment &segment = stroke.segments[k];
        if (const double spread = segment.spread(T); spread > 0 && reaches(segment, spread, at))
            sum.add(k, segmentDensity(segment, spread, at, CurveDetail::Rough));
    }
    if (influenceOfFill(stroke, T).contains(point))
        sum.addFill(DensityOfFill(stroke, T, at), at);
    return sum.seen();
}

} // namespace suffuse

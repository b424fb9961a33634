#include "model/area/pen_outline.h"

#include "model/area/offset_curve.h"
#include "model/shaping/curves/split.h"

#include <numbers>

namespace suffuse {

namespace {

bool isPoint(const Cubic &c)
{
    return c.p[1] == c.p[0] && c.p[2] == c.p[0] && c.p[3] == c.p[0];
}

Cubic reversed(const Cubic &c)
{
    return {{c.p[3], c.p[2], c.p[1], c.p[0]}};
}

/// Goes along one line and draws its two sides. Together they are the sum of loops all of which run the same way round:
/// one around each part of the line, and one around each join. Parts that turn too sharply for their inner side are
/// short straight lines with round joins.
class SidesOfLine {
public:
    SidesOfLine(const Pen &pen, double tolerance, AreaEffort *effort)
        : m_pen(pen), m_half(0.5 * pen.width), m_tolerance(tolerance), m_effort(effort)
    {}

    std::vector<std::vector<Cubic>> outline(const PenLine &line)
    {
        for (const Cubic &curve : line.curves) {
            m_isCorner = true;
            if (!isPoint(curve))
                draw(curve, 16);
        }
        if (!m_begun)
            return aroundPoint(line);
        if (line.isClosed) {
            m_isCorner = true;
            join(m_firstDirection);
            return {welded(m_sides[0]), welded(backward())};
        }
        std::vector<Cubic> &loop = m_sides[0];
        cap(loop, m_at, m_direction);
        for (const Cubic &curve : backward())
            loop.push_back(curve);
        cap(loop, m_first, -1 * m_firstDirection);
        return {welded(loop)};
    }

private:
    static constexpr double rounding = 1e-9;     ///< a share of the width
    static constexpr double sideOf[2] = {1, -1}; ///< the line's sides: towards `turned` of its direction, and opposite

    void draw(const Cubic &curve, int depth)
    {
        if (!spend(m_effort, 300))
            return;
        if (isGentle(curve, m_half)) {
            begin(curve.p[0], startDirection(curve));
            for (const int side : {0, 1})
                appendOffset(curve, sideOf[side] * m_half, 0.5 * m_tolerance, m_sides[side]);
            m_at = curve.p[3], m_direction = endDirection(curve);
        } else if (isFlat(curve) || depth == 0) {
            if (curve.p[0] == curve.p[3])
                return;
            const Point direction = startDirection(straightCubic(curve.p[0], curve.p[3]));
            begin(curve.p[0], direction);
            for (const int side : {0, 1}) {
                const Point aside = (sideOf[side] * m_half) * turned(direction);
                m_sides[side].push_back(straightCubic(curve.p[0] + aside, curve.p[3] + aside));
            }
            m_at = curve.p[3], m_direction = direction;
        } else {
            const auto [first, second] = curve.split(0.5);
            draw(first, depth - 1);
            m_isCorner = false;
            draw(second, depth - 1);
        }
        m_isCorner = false;
    }

    /// Whether a curve is its chord within the tolerance, along which it never runs back.
    bool isFlat(const Cubic &curve) const
    {
        const Point chord = curve.p[3] - curve.p[0];
        const double size = length(chord), most = 0.25 * m_tolerance;
        const auto off = [&](const Point &p) {
            return size > 0 ? std::abs(cross(p - curve.p[0], chord)) / size : length(p - curve.p[0]);
        };
        if (off(curve.p[1]) > most || off(curve.p[2]) > most)
            return false;
        const auto along = [&](const Point &p) { return dot(p - curve.p[0], chord); };
        const double a = along(curve.p[1]), b = along(curve.p[2]), end = size * size;
        return (0 <= a && a <= b && b <= end) || polygonLength(curve) <= m_tolerance;
    }

    void begin(Point at, Point direction)
    {
        if (m_begun)
            join(direction);
        else
            m_begun = true, m_first = at, m_firstDirection = direction;
    }

    /// Turns both sides from the direction in which the line came to another one.
    void join(Point to)
    {
        const double angle = std::atan2(cross(m_direction, to), dot(m_direction, to));
        const int outer = angle > 0 ? 1 : 0;
        for (const int side : {0, 1}) {
            const double aside = sideOf[side] * m_half;
            const Point a = m_at + aside * turned(m_direction), b = m_at + aside * turned(to);
            std::vector<Cubic> &out = m_sides[side];
            if (std::abs(angle) * m_half <= 0.5 * m_tolerance)
                line(out, a, b);
            else if (side != outer)
                line(out, a, m_at), line(out, m_at, b);
            else
                turnOutside(out, a, b, angle);
        }
    }
    void turnOutside(std::vector<Cubic> &out, Point a, Point b, double angle) const
    {
        if (!m_isCorner || m_pen.join == LineJoin::Round) {
            for (Cubic &arc : arcAround(m_at, a, angle))
                out.push_back(arc);
            return;
        }
        const double shorter = std::cos(0.5 * angle); // the width by the length of a miter
        if (m_pen.join == LineJoin::Miter && shorter > 0 && 1 <= m_pen.miterLimit * shorter) {
            const Point tip = m_at + (0.5 / (shorter * shorter)) * ((a - m_at) + (b - m_at));
            line(out, a, tip), line(out, tip, b);
        } else {
            line(out, a, b);
        }
    }

    /// From the first side to the second one, around the end of a line that leads in a direction.
    void cap(std::vector<Cubic> &out, Point at, Point direction) const
    {
        const Point a = at + m_half * turned(direction), b = at - m_half * turned(direction);
        const Point ahead = m_half * direction;
        if (m_pen.cap == LineCap::Round) {
            for (Cubic &arc : arcAround(at, a, -std::numbers::pi))
                out.push_back(arc);
        } else if (m_pen.cap == LineCap::Square) {
            line(out, a, a + ahead), line(out, a + ahead, b + ahead), line(out, b + ahead, b);
        } else {
            line(out, a, b);
        }
    }

    std::vector<std::vector<Cubic>> aroundPoint(const PenLine &point) const
    {
        if (m_pen.cap == LineCap::Butt)
            return {};
        const Point at = point.curves.empty() ? point.point : point.curves.front().p[0];
        std::vector<Cubic> loop;
        cap(loop, at, point.direction);
        cap(loop, at, -1 * point.direction);
        return {welded(loop)};
    }

    void line(std::vector<Cubic> &out, Point a, Point b) const
    {
        if (length(b - a) > rounding * m_half)
            out.push_back(straightCubic(a, b));
    }
    /// Curves that meet but for rounding meet in the same numbers.
    static std::vector<Cubic> welded(std::vector<Cubic> loop)
    {
        for (std::size_t k = 0; k < loop.size(); ++k)
            loop[k].p[0] = loop[k > 0 ? k - 1 : loop.size() - 1].p[3];
        return loop;
    }

    std::vector<Cubic> backward() const
    {
        std::vector<Cubic> back;
        for (auto it = m_sides[1].rbegin(); it != m_sides[1].rend(); ++it)
            back.push_back(reversed(*it));
        return back;
    }

    const Pen &m_pen;
    const double m_half, m_tolerance;
    AreaEffort *m_effort;
    std::vector<Cubic> m_sides[2];
    bool m_begun = false;
    bool m_isCorner = false; ///< whether the pen's join is due, or we are within a curve
    Point m_first, m_firstDirection, m_at, m_direction;
};

} // namespace

std::vector<std::vector<Cubic>> penOutline(const std::vector<PenLine> &lines, const Pen &pen, double tolerance,
                                           AreaEffort *effort)
{
    std::vector<std::vector<Cubic>> loops;
    if (!(pen.width > 0))
        return loops;
    for (const PenLine &line : lines) {
        const std::vector<PenLine> dashes = dashesOf(line, pen.dashes, pen.dashOffset, 100'000, effort);
        if (effort && effort->isSpent())
            return loops;
        for (const PenLine &dash : dashes)
            for (std::vector<Cubic> &loop : SidesOfLine(pen, tolerance, effort).outline(dash)) {
                if (!spend(effort, 200 * loop.size()))
                    return loops;
                loops.push_back(std::move(loop));
            }
    }
    return loops;
}

} // namespace suffuse

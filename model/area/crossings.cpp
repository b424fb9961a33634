#include "model/area/crossings.h"

namespace suffuse {

namespace {

/// How far a part of an arc is from its chord, at most, in x at the same height. A curve lies within the hull of its
/// control points, so this misses nothing, not even what bends both ways and meets its chord in the middle.
double bendOf(const Cubic &part)
{
    const auto &p = part.p;
    const double height = p[3].y - p[0].y;
    if (!(height > 0))
        return std::abs(p[3].x - p[0].x);
    const double slope = (p[3].x - p[0].x) / height;
    const auto off = [&](Point q) { return std::abs(q.x - p[0].x - slope * (q.y - p[0].y)); };
    // A cubic is nearer to its chord than the farther one of its control points by a quarter at least.
    return 0.75 * std::max(off(p[1]), off(p[2]));
}

/// Finds the heights at which two arcs cross, as those where the difference of their x changes its sign.
class PairFinder {
public:
    PairFinder(const RisingArc &a, const RisingArc &b, double tolerance, AreaEffort *effort)
        : m_a(a), m_b(b), m_tolerance(tolerance), m_effort(effort)
    {}

    template <class Use>
    void find(double top, double bottom, Use use) const
    {
        search(at(top), at(bottom), 0, use);
    }

private:
    /// Both arcs at a height: their parameters and x.
    struct Level {
        double y, s, t, a, b;
        double difference() const { return a - b; }
    };

    Level at(double y) const
    {
        const double s = m_a.parameterAtY(y), t = m_b.parameterAtY(y);
        return {y, s, t, m_a.xAtParameter(s), m_b.xAtParameter(t)};
    }

    /// Whether the arcs are near to each other between two heights, as far as four more that lie unevenly tell.
    bool areNear(const Level &top, const Level &bottom, double near) const
    {
        for (const double share : {0.11, 0.37, 0.58, 0.83})
            if (!(std::abs(at(top.y + share * (bottom.y - top.y)).difference()) <= near))
                return false;
        return true;
    }

    template <class Use>
    void search(const Level &top, const Level &bottom, int depth, Use &use) const
    {
        constexpr int enough = 16; // halvings towards a place where both begin or end
        const auto apart = [](double a0, double a1, double b0, double b1) {
            return std::max(a0, a1) < std::min(b0, b1) || std::max(b0, b1) < std::min(a0, a1);
        };
        if (apart(top.a, bottom.a, top.b, bottom.b) || !spend(m_effort, 50))
            return;
        const bool atEnd = depth > enough && (top.difference() == 0 || bottom.difference() == 0);
        if (!(bottom.y - top.y > m_tolerance) || depth > 48 || atEnd)
            return addIfChanged(top, bottom, use);
        const double near = nearness(bottom.a - top.a, bottom.y - top.y, m_tolerance);
        if (std::max(std::abs(top.difference()), std::abs(bottom.difference())) <= near && areNear(top, bottom, near))
            return depth > 0 ? addIfChanged(top, bottom, use) : void(); // All of them lies on each other.
        const double bend = bendOf(between(m_a.curve, top.s, bottom.s)) + bendOf(between(m_b.curve, top.t, bottom.t));
        if (std::min(std::abs(top.difference()), std::abs(bottom.difference())) > bend)
            return addIfChanged(top, bottom, use);
        const Level middle = at(0.5 * (top.y + bottom.y));
        search(top, middle, depth + 1, use);
        search(middle, bottom, depth + 1, use);
    }

    template <class Use>
    void addIfChanged(Level top, Level bottom, Use &use) const
    {
        if ((top.difference() < 0) == (bottom.difference() < 0) || top.difference() == 0 || bottom.difference() == 0) {
            // A crossing just at a height that was looked at belongs to what lies above it.
            if (bottom.difference() == 0 && top.difference() != 0)
                use(bottom.y);
            return;
        }
        for (int i = 0; i < 60 && bottom.y - top.y > 0.25 * m_tolerance; ++i) {
            const double share = top.difference() / (top.difference() - bottom.difference());
            const double guess = top.y + (bottom.y - top.y) * (i % 3 == 2 ? 0.5 : std::clamp(share, 0.01, 0.99));
            const Level middle = at(guess);
            ((middle.difference() < 0) == (top.difference() < 0) ? top : bottom) = middle;
        }
        use(0.5 * (top.y + bottom.y));
    }

    const RisingArc &m_a;
    const RisingArc &m_b;
    double m_tolerance;
    AreaEffort *m_effort;
};

/// An outline of which every line crosses every other one is drawn in part only, so that none takes minutes.
constexpr std::size_t mostCuts = 4'000'000, mostLooks = 2'000'000'000;

class MeetingFinder {
public:
    MeetingFinder(const std::vector<RisingPart> &parts, const std::vector<LoopRange> &loops, AreaEffort *effort)
        : m_parts(parts), m_effort(effort)
    {
        m_next.resize(parts.size());
        for (const auto &[first, end] : loops)
            for (std::uint32_t k = first; k < end; ++k)
                m_next[k] = k + 1 < end ? k + 1 : first;
        m_out.touched.resize(parts.size());
        m_chords.reserve(parts.size());
        for (const RisingPart &part : parts) {
            m_box = m_box.united(part.arc.box());
            m_chords.emplace_back(part.arc);
        }
        const double farthest =
            std::max({std::abs(m_box.left), std::abs(m_box.right), std::abs(m_box.top), std::abs(m_box.bottom)});
        m_out.tolerance = 1e-12 * std::max(m_box.width(), m_box.height()) + 4e-16 * farthest;
    }

    Meetings find(const std::vector<LevelWay> &levels)
    {
        makeGrid();
        for (const LevelWay &level : levels)
            cutBy(level);
        for (std::size_t cell = 0; cell < m_cells.size(); ++cell)
            for (std::size_t i = 0; i < m_cells[cell].size() && m_out.cuts.size() < mostCuts && m_looks < mostLooks &&
                                    spend(m_effort, 2 * i);
                 ++i, m_looks += i)
                for (std::size_t j = 0; j < i; ++j)
                    visit(m_cells[cell][j], m_cells[cell][i], cell);
        return std::move(m_out);
    }

private:
    /// Arcs lie in all cells of a grid that their boxes meet, and two arcs are compared in the first cell of both.
    void makeGrid()
    {
        m_side = std::clamp<std::size_t>(std::size_t(std::sqrt(double(m_parts.size()))), 1, 1024);
        const auto entries = [this] {
            std::size_t count = 0;
            for (const RisingPart &part : m_parts) {
                const Rect box = part.arc.box().grown(m_out.tolerance);
                count += (row(box.bottom) - row(box.top) + 1) * (column(box.right) - column(box.left) + 1);
            }
            return count;
        };
        while (m_side > 1 && entries() > 16 * m_parts.size()) // Long arcs lie in many cells.
            m_side /= 2;
        m_cells.resize(m_side * m_side);
        for (std::uint32_t k = 0; k < m_parts.size(); ++k) {
            const Rect box = m_parts[k].arc.box().grown(m_out.tolerance);
            for (std::size_t y = row(box.top); y <= row(box.bottom); ++y)
                for (std::size_t x = column(box.left); x <= column(box.right); ++x)
                    m_cells[y * m_side + x].push_back(k);
        }
    }
    std::size_t place(double from, double size, double at) const
    {
        const double share = size > 0 ? (at - from) / size : 0;
        return std::size_t(std::clamp(share * double(m_side), 0.0, double(m_side - 1)));
    }
    std::size_t column(double x) const { return place(m_box.left, m_box.width(), x); }
    std::size_t row(double y) const { return place(m_box.top, m_box.height(), y); }

    void cutBy(const LevelWay &level)
    {
        const double tolerance = m_out.tolerance;
        for (std::size_t x = column(level.left - tolerance); x <= column(level.right + tolerance); ++x)
            for (const std::uint32_t k : m_cells[row(level.y) * m_side + x]) {
                if (!spend(m_effort, 2))
                    return;
                const RisingArc &arc = m_parts[k].arc;
                if (level.y < arc.top() - tolerance || level.y > arc.bottom() + tolerance)
                    continue;
                const double at = arc.xAt(level.y);
                if (at < level.left - 4 * tolerance || at > level.right + 4 * tolerance)
                    continue;
                const bool atTop = level.y <= arc.top() + tolerance, atBottom = level.y >= arc.bottom() - tolerance;
                if (!atTop && !atBottom)
                    m_out.cuts.emplace_back(k, level.y);
                else
                    (atTop != m_parts[k].falls ? m_out.touched[k].begin : m_out.touched[k].end) = true;
            }
    }

    void visit(std::uint32_t a, std::uint32_t b, std::size_t cell)
    {
        const Rect boxA = m_parts[a].arc.box().grown(m_out.tolerance);
        const Rect boxB = m_parts[b].arc.box().grown(m_out.tolerance);
        if (boxA.intersects(boxB) &&
            cell == row(std::max(boxA.top, boxB.top)) * m_side + column(std::max(boxA.left, boxB.left)))
            meet(a, b);
    }

    void meet(std::uint32_t a, std::uint32_t b)
    {
        const RisingArc &A = m_parts[a].arc, &B = m_parts[b].arc;
        if (!spend(m_effort, 100))
            return;
        for (const bool ofA : {true, false})
            for (const bool top : {true, false})
                touch(ofA ? a : b, ofA ? b : a, top);
        const double top = std::max(A.top(), B.top()), bottom = std::min(A.bottom(), B.bottom());
        if (m_chords[a].isApartFrom(m_chords[b], top, bottom))
            spend(m_effort, 50); // as the search would
        else if (bottom - top > m_out.tolerance)
            PairFinder(A, B, m_out.tolerance, m_effort).find(top, bottom, [&](double y) {
                spend(m_effort, 200);
                m_out.cuts.emplace_back(a, y);
                m_out.cuts.emplace_back(b, y);
            });
    }

    /// Looks whether an end of `one` lies on `other`.
    void touch(std::uint32_t one, std::uint32_t other, bool top)
    {
        const RisingArc &A = m_parts[one].arc, &B = m_parts[other].arc;
        const Point end = top ? A.curve.p[0] : A.curve.p[3];
        const double tolerance = m_out.tolerance;
        if (end.y < B.top() - tolerance || end.y > B.bottom() + tolerance)
            return;
        // At a turn the height says little about x.
        const auto meets = [&](Point p) {
            return std::max(std::abs(p.x - end.x), std::abs(p.y - end.y)) <= 4 * tolerance;
        };
        if (!meets(B.curve.p[0]) && !meets(B.curve.p[3]) &&
            (m_chords[other].sideOf(end.x, std::clamp(end.y, B.top(), B.bottom()), 4 * tolerance) != 0 ||
             std::abs(B.xAt(end.y) - end.x) > 4 * tolerance))
            return;
        const bool atBegin = top != m_parts[one].falls; // of the way along the loop
        const bool isNeighbour = atBegin ? m_next[other] == one : m_next[one] == other;
        const bool inside = end.y > B.top() + tolerance && end.y < B.bottom() - tolerance;
        if (inside)
            m_out.cuts.emplace_back(other, end.y);
        if (inside || !isNeighbour)
            (atBegin ? m_out.touched[one].begin : m_out.touched[one].end) = true;
    }

    const std::vector<RisingPart> &m_parts;
    std::vector<ArcChord> m_chords;    ///< of the parts
    std::vector<std::uint32_t> m_next; ///< of each arc the one behind it in its loop
    Rect m_box;
    std::size_t m_looks = 0;
    AreaEffort *m_effort;
    std::size_t m_side = 1;
    std::vector<std::vector<std::uint32_t>> m_cells;
    Meetings m_out;
};

} // namespace

Meetings meetingsOf(const std::vector<RisingPart> &parts, const std::vector<LoopRange> &loops,
                    const std::vector<LevelWay> &levels, AreaEffort *effort)
{
    return MeetingFinder(parts, loops, effort).find(levels);
}

} // namespace suffuse

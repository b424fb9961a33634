#include "model/area/boundary.h"

#include "model/area/crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

namespace suffuse {

namespace {

/// Which winding numbers are inside.
struct InsideRule {
    std::optional<FillRule> fill;
    int least = 1; ///< where there is no rule of a fill

    bool isInside(int winding) const
    {
        if (!fill)
            return winding >= least;
        return *fill == FillRule::NonZero ? winding != 0 : winding % 2 != 0;
    }
};

/// An arc that is lower than this in proportion to its width may be so low that it has no section.
constexpr double levelness = 1e-6;

/// A part of an arc between two heights, along which no other arc is met.
struct Section {
    std::uint32_t arc = 0;
    double top = 0, bottom = 0;
    int enters = 0;
};

/// Arcs of about the same width that cross a band of height from top to bottom.
class ArcsAcross {
public:
    struct Arc {
        double left, right;
        std::uint32_t arc;
        int before = 0; ///< what those further left add to the winding number
    };

    void clear() { m_arcs.clear(), m_widest = 0, m_sum = 0; }
    /// They come by their left ends.
    void add(std::uint32_t k, const RisingPart &part)
    {
        m_arcs.push_back({part.arc.left(), part.arc.right(), k, m_sum});
        m_sum += part.falls ? -1 : 1;
        m_widest = std::max(m_widest, part.arc.right() - part.arc.left());
    }
    /// Those that may be between two places, and what those further left add to the winding number.
    std::pair<std::span<const Arc>, int> at(double from, double to) const
    {
        const auto isLeft = [](const Arc &arc, double x) { return arc.left < x; };
        const auto isRight = [](double x, const Arc &arc) { return x < arc.left; };
        const auto first = std::lower_bound(m_arcs.begin(), m_arcs.end(), from - m_widest, isLeft);
        const auto end = std::upper_bound(first, m_arcs.end(), to, isRight);
        return {{first, end}, first == m_arcs.end() ? m_sum : first->before};
    }

private:
    std::vector<Arc> m_arcs;
    double m_widest = 0;
    int m_sum = 0; ///< what all of them add to the winding number
};

/// The arcs that come into a band of height.
class Band {
public:
    /// An arc that begins or ends in the band.
    struct Within {
        double top, bottom, left, right;
        std::uint32_t arc;
    };

    /// Begins a band without arcs.
    void clear()
    {
        m_within.clear();
        for (ArcsAcross &arcs : m_across)
            arcs.clear();
    }
    void addWithin(std::uint32_t k, const RisingArc &arc)
    {
        m_within.push_back({arc.top(), arc.bottom(), arc.left(), arc.right(), k});
    }
    /// `shares`: how wide the arc is, usual ones being 1.
    void addAcross(std::uint32_t k, const RisingPart &part, double shares)
    {
        const int kind = shares > 1 ? std::min(std::ilogb(shares) + 1, int(m_across.size()) - 1) : 0;
        m_across[std::size_t(kind)].add(k, part);
    }

    const std::vector<Within> &within() const { return m_within; }
    /// By their widths, each twice the one before: one wide arc would have all others looked at that begin as far away.
    const std::array<ArcsAcross, 12> &across() const { return m_across; }

private:
    std::vector<Within> m_within;
    std::array<ArcsAcross, 12> m_across;
};

/// Divides the height of arcs into bands, and makes one after the other. All of them at once would take more memory the
/// more often the arcs cross.
class Bands {
public:
    /// `count`: of the questions that bands will be asked, of which each looks at all arcs that begin or end in one.
    Bands(const std::vector<RisingPart> &parts, std::size_t count) : m_parts(parts)
    {
        m_top = parts[0].arc.top();
        double bottom = parts[0].arc.bottom(), heights = 0;
        for (const RisingPart &part : parts) {
            m_top = std::min(m_top, part.arc.top()), bottom = std::max(bottom, part.arc.bottom());
            heights += part.arc.bottom() - part.arc.top();
            m_width += (part.arc.right() - part.arc.left()) / double(parts.size());
        }
        const double each = 1 + heights / (bottom - m_top); // arcs that cross a level line
        m_count = std::size_t(std::clamp(std::sqrt(double(parts.size()) * double(count) / each), 1.0, 1e6));
        m_height = (bottom - m_top) / double(m_count);
        m_byTop.resize(parts.size());
        std::iota(m_byTop.begin(), m_byTop.end(), 0);
        std::sort(m_byTop.begin(), m_byTop.end(), [&](std::uint32_t a, std::uint32_t b) {
            return parts[a].arc.top() != parts[b].arc.top() ? parts[a].arc.top() < parts[b].arc.top() : a < b;
        });
    }

    std::size_t at(double y) const { return std::min(m_count - 1, std::size_t(std::max(0.0, (y - m_top) / m_height))); }
    /// The band of a number; no smaller number may be asked for later.
    const Band &operator[](std::size_t number)
    {
        if (number == m_number)
            return m_band;
        m_number = number;
        std::erase_if(m_open, [number](const Open &open) { return open.last < number; });
        const std::size_t before = m_open.size();
        for (; m_next < m_byTop.size(); ++m_next) {
            const std::uint32_t k = m_byTop[m_next];
            const RisingArc &arc = m_parts[k].arc;
            if (at(arc.top()) > number)
                break;
            if (const std::size_t last = at(arc.bottom()); last >= number)
                m_open.push_back({arc.left(), k, at(arc.top()), last});
        }
        const auto isLeft = [](const Open &a, const Open &b) {
            return a.left != b.left ? a.left < b.left : a.arc < b.arc;
        };
        std::sort(m_open.begin() + std::ptrdiff_t(before), m_open.end(), isLeft);
        std::inplace_merge(m_open.begin(), m_open.begin() + std::ptrdiff_t(before), m_open.end(), isLeft);
        m_band.clear();
        for (const Open &open : m_open)
            if (open.first < number && open.last > number)
                m_band.addAcross(open.arc, m_parts[open.arc], widthOf(m_parts[open.arc].arc));
            else
                m_band.addWithin(open.arc, m_parts[open.arc].arc);
        return m_band;
    }

private:
    double widthOf(const RisingArc &arc) const { return m_width > 0 ? (arc.right() - arc.left()) / m_width : 0; }

    /// An arc that comes into the band, with the numbers of the bands in which it begins and ends.
    struct Open {
        double left;
        std::uint32_t arc;
        std::size_t first, last;
    };

    const std::vector<RisingPart> &m_parts;
    std::vector<std::uint32_t> m_byTop;
    std::size_t m_next = 0;   ///< of those, the first one that has not come yet
    std::vector<Open> m_open; ///< by their left ends
    Band m_band;
    std::size_t m_count = 1, m_number = std::size_t(-1);
    double m_top = 0, m_height = 0, m_width = 0; ///< the width is that of all arcs in the mean
};

class BoundaryFinder {
public:
    BoundaryFinder(const std::vector<std::vector<Cubic>> &loops, InsideRule rule, AreaEffort *effort)
        : m_rule(rule), m_effort(effort)
    {
        for (const std::vector<Cubic> &loop : loops)
            if (spend(m_effort, 500 * loop.size()))
                addLoop(loop);
    }

    AreaBoundary find()
    {
        AreaBoundary out;
        if (m_parts.empty())
            return out;
        m_meetings = meetingsOf(m_parts, m_loops, levelWays(), m_effort);
        // Each section takes time and memory until it is a piece of the boundary, however soon its winding number is
        // known.
        if (!spend(m_effort, 256 * (m_parts.size() + m_meetings.cuts.size())))
            return out;
        cut();
        classify();
        if (isSpent())
            return out;
        join(out);
        addFlats(out);
        return out;
    }

private:
    bool isSpent() const { return m_effort && m_effort->isSpent(); }

    void addLoop(const std::vector<Cubic> &loop)
    {
        const std::size_t first = m_parts.size();
        for (const Cubic &curve : loop) {
            const std::size_t before = m_parts.size();
            appendRisingParts(curve, m_parts);
            // A level curve is no arc. What comes behind it may lie on another side of what crosses it.
            m_interrupted.resize(m_parts.size(), 0);
            if (m_parts.size() == before || curve.p[0].y == curve.p[3].y)
                m_level = true;
            if (m_parts.size() > before && m_level)
                m_interrupted[before] = 1, m_level = false;
        }
        if (m_parts.size() > first) {
            m_interrupted[first] = 1;
            m_loops.push_back({std::uint32_t(first), std::uint32_t(m_parts.size())});
        }
        m_level = false;
    }

    std::vector<LevelWay> levelWays() const
    {
        std::vector<LevelWay> ways;
        const auto add = [&ways](Point a, Point b) {
            if (a.x != b.x)
                ways.push_back({a.y, std::min(a.x, b.x), std::max(a.x, b.x)});
        };
        for (const auto &[first, end] : m_loops)
            for (std::uint32_t k = first; k < end; ++k) {
                const RisingPart &part = m_parts[k], &next = m_parts[k + 1 < end ? k + 1 : first];
                const auto &p = part.arc.curve.p, &q = next.arc.curve.p;
                add(part.falls ? p[0] : p[3], next.falls ? q[3] : q[0]);
                if (part.arc.bottom() - part.arc.top() <= levelness * (part.arc.right() - part.arc.left()))
                    add(p[0], p[3]);
            }
        return ways;
    }

    /// Divides arcs into sections. Heights that differ by no more than rounding become one.
    void cut()
    {
        std::vector<double> heights;
        for (const auto &[arc, y] : m_meetings.cuts)
            heights.push_back(y);
        for (const RisingPart &part : m_parts) {
            heights.push_back(part.arc.top());
            heights.push_back(part.arc.bottom());
        }
        std::sort(heights.begin(), heights.end());
        std::vector<double> kept;
        for (const double y : heights)
            if (kept.empty() || y - kept.back() > m_meetings.tolerance)
                kept.push_back(y);
        const auto rounded = [&](double y) { return *std::prev(std::upper_bound(kept.begin(), kept.end(), y)); };
        std::sort(m_meetings.cuts.begin(), m_meetings.cuts.end());
        auto next = m_meetings.cuts.begin();
        m_firstSection.reserve(m_parts.size() + 1);
        m_sections.reserve(m_parts.size() + m_meetings.cuts.size());
        for (std::uint32_t k = 0; k < m_parts.size(); ++k) {
            const double end = rounded(m_parts[k].arc.bottom());
            double from = rounded(m_parts[k].arc.top());
            m_firstSection.push_back(std::uint32_t(m_sections.size()));
            for (; next != m_meetings.cuts.end() && next->first == k; ++next) {
                const double y = rounded(next->second);
                if (y <= from || y >= end)
                    continue;
                m_sections.push_back({k, from, y});
                from = y;
            }
            if (end > from)
                m_sections.push_back({k, from, end});
        }
        m_firstSection.push_back(std::uint32_t(m_sections.size()));
        m_meetings.cuts = {};
    }

    static double middleOf(const Section &section) { return 0.5 * (section.top + section.bottom); }

    /// The winding number left of a section.
    int windingLeftOf(const Section &section, Bands &bands) const
    {
        const RisingArc &own = m_parts[section.arc].arc;
        const double y = middleOf(section), t = own.parameterAtY(y), x = own.xAtParameter(t);
        const Point way = own.curve.derivative(t);
        const double near = nearness(way.x, way.y, m_meetings.tolerance);
        const Band &band = bands[bands.at(y)];
        int winding = 0;
        const auto add = [&](std::uint32_t k, double right) {
            // Of arcs that lie on each other the first ones count as lying further left, wherever that is asked.
            const int side = right < x - near ? -1 : m_chords[k].sideOf(x, y, near);
            if (k == section.arc || side > 0)
                return;
            const double other = side < 0 ? right : m_parts[k].arc.xAt(y);
            if (side < 0 || other < x - near || (other <= x + near && k < section.arc))
                winding += m_parts[k].falls ? -1 : 1;
        };
        for (const Band::Within &arc : band.within())
            if (arc.top <= y && y < arc.bottom && arc.left <= x + near)
                add(arc.arc, arc.right);
        std::size_t looks = band.within().size();
        for (const ArcsAcross &arcs : band.across()) { // Those that end further left are counted already.
            const auto [close, before] = arcs.at(x - 2 * near, x + near);
            winding += before;
            looks += close.size();
            for (const ArcsAcross::Arc &arc : close)
                add(arc.arc, arc.right);
        }
        spend(m_effort, 4 * looks);
        return winding;
    }

    /// Sections [first, end) that follow each other along a loop.
    struct Run {
        double y = 0;              ///< of the middle of the longest of them
        std::uint32_t longest = 0; ///< its number
        std::uint32_t first = 0, end = 0;
    };

    /// Along a loop the winding number on either side stays the same until something is met, so it is counted once for
    /// each such run, at its longest section.
    void classify()
    {
        m_chords.reserve(m_parts.size());
        for (const RisingPart &part : m_parts)
            m_chords.emplace_back(part.arc);
        std::vector<std::uint32_t> order; // of sections along the loops
        std::vector<Run> runs;
        order.reserve(m_sections.size());
        const auto endRun = [&] { addRun(order, runs); };
        for (const auto &[first, end] : m_loops) {
            for (std::uint32_t k = first; k < end; ++k) {
                if (m_interrupted[k] || m_meetings.touched[k].begin)
                    endRun();
                const std::uint32_t from = m_firstSection[k], to = m_firstSection[k + 1];
                if (from == to) // It is as good as level.
                    endRun();
                for (std::uint32_t i = 0; i < to - from; ++i) {
                    if (i > 0)
                        endRun();
                    order.push_back(m_parts[k].falls ? to - 1 - i : from + i);
                }
                if (m_meetings.touched[k].end)
                    endRun();
            }
            endRun();
        }
        std::sort(runs.begin(), runs.end(), [](const Run &a, const Run &b) { return a.y < b.y; });
        Bands bands(m_parts, runs.size());
        for (const Run &run : runs) {
            if (isSpent())
                return;
            classifyRun(run, order, bands);
        }
    }
    /// Adds what comes behind the last run as another one.
    void addRun(const std::vector<std::uint32_t> &order, std::vector<Run> &runs) const
    {
        const std::uint32_t first = runs.empty() ? 0 : runs.back().end, end = std::uint32_t(order.size());
        if (first == end)
            return;
        const auto height = [this](std::uint32_t i) { return m_sections[i].bottom - m_sections[i].top; };
        const std::uint32_t longest =
            *std::max_element(order.begin() + first, order.end(),
                              [&](std::uint32_t a, std::uint32_t b) { return height(a) < height(b); });
        runs.push_back({middleOf(m_sections[longest]), longest, first, end});
    }
    void classifyRun(const Run &run, const std::vector<std::uint32_t> &order, Bands &bands)
    {
        const Section &longest = m_sections[run.longest];
        // On the side that lies left of an arc that rises, which is right of one that falls.
        const int side = windingLeftOf(longest, bands) + (m_parts[longest.arc].falls ? -1 : 0);
        for (std::uint32_t k = run.first; k < run.end; ++k) {
            Section &section = m_sections[order[k]];
            const bool falls = m_parts[section.arc].falls;
            const int before = falls ? side + 1 : side, after = falls ? side : side + 1;
            section.enters = int(m_rule.isInside(after)) - int(m_rule.isInside(before));
        }
    }

    /// Puts neighbouring sections of an arc together where they bound alike.
    void join(AreaBoundary &out) const
    {
        // As much memory as it takes: there may be millions.
        out.arcs.reserve(
            std::size_t(std::ranges::count_if(m_sections, [](const Section &s) { return s.enters != 0; })));
        for (std::size_t i = 0; i < m_sections.size();) {
            std::size_t end = i + 1;
            while (end < m_sections.size() && m_sections[end].arc == m_sections[i].arc &&
                   m_sections[end].enters == m_sections[i].enters)
                ++end;
            if (m_sections[i].enters != 0) {
                const RisingArc &whole = m_parts[m_sections[i].arc].arc;
                const double top = m_sections[i].top, bottom = m_sections[end - 1].bottom;
                BoundaryArc part{whole, m_sections[i].enters};
                const double from = top <= whole.top() + m_meetings.tolerance ? 0 : whole.parameterAtY(top);
                const double to = bottom >= whole.bottom() - m_meetings.tolerance ? 1 : whole.parameterAtY(bottom);
                part.arc.curve = between(whole.curve, from, to);
                part.arc.curve.p[0].y = top;
                part.arc.curve.p[3].y = bottom;
                out.arcs.push_back(part);
            }
            i = end;
        }
    }

    static void addFlats(AreaBoundary &out)
    {
        struct End {
            double y, x;
            int jump;
        };
        std::vector<End> ends;
        ends.reserve(2 * out.arcs.size());
        for (const BoundaryArc &part : out.arcs) {
            ends.push_back({part.arc.top(), part.arc.curve.p[0].x, part.enters});
            ends.push_back({part.arc.bottom(), part.arc.curve.p[3].x, -part.enters});
        }
        std::sort(ends.begin(), ends.end(),
                  [](const End &a, const End &b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
        int jump = 0;
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            jump = (i > 0 && ends[i - 1].y == ends[i].y ? jump : 0) + ends[i].jump;
            if (jump != 0 && ends[i + 1].y == ends[i].y && ends[i + 1].x > ends[i].x)
                out.flats.push_back({ends[i].y, ends[i].x, ends[i + 1].x, jump});
        }
    }

    InsideRule m_rule;
    AreaEffort *m_effort;
    std::vector<RisingPart> m_parts;
    std::vector<ArcChord> m_chords;  ///< of the parts
    std::vector<char> m_interrupted; ///< whether something level lies between a part and the one before it
    bool m_level = false;
    std::vector<LoopRange> m_loops;
    Meetings m_meetings;
    std::vector<Section> m_sections;
    std::vector<std::uint32_t> m_firstSection; ///< of each arc, and the end
};

} // namespace

AreaBoundary boundaryOf(const std::vector<std::vector<Cubic>> &loops, FillRule rule, AreaEffort *effort)
{
    return BoundaryFinder(loops, {rule, 1}, effort).find();
}

AreaBoundary boundaryWhere(const std::vector<std::vector<Cubic>> &loops, int least, AreaEffort *effort)
{
    return BoundaryFinder(loops, {std::nullopt, least}, effort).find();
}

} // namespace suffuse

#include "model/area/boundary.h"

#include "model/area/crossings.h"

#include <algorithm>
#include <numeric>
#include <optional>

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

/// The arcs that come into a band of height.
class Band {
public:
    /// An arc that begins or ends in the band.
    struct Within {
        double top, bottom, left, right;
        std::uint32_t arc;
    };
    /// An arc that crosses the band from top to bottom.
    struct Across {
        double left;
        std::uint32_t arc;
        int before = 0; ///< what those further left add to the winding number
    };

    void addWithin(std::uint32_t k, const RisingArc &arc)
    {
        m_within.push_back({arc.top(), arc.bottom(), arc.left(), arc.right(), k});
    }
    void addAcross(std::uint32_t k, const RisingArc &arc)
    {
        m_across.push_back({arc.left(), k});
        m_widest = std::max(m_widest, arc.right() - arc.left());
    }
    void sort(const std::vector<RisingPart> &parts)
    {
        std::sort(m_across.begin(), m_across.end(),
                  [](const Across &a, const Across &b) { return a.left != b.left ? a.left < b.left : a.arc < b.arc; });
        for (Across &across : m_across) {
            across.before = m_sum;
            m_sum += parts[across.arc].falls ? -1 : 1;
        }
    }

    const std::vector<Within> &within() const { return m_within; }
    /// The first of the arcs across whose right end may be at x or beyond, and the first one that begins beyond `end`.
    std::pair<std::size_t, std::size_t> acrossAt(double x, double end) const
    {
        const auto isLeft = [](const Across &across, double at) { return across.left < at; };
        const auto isRight = [](double at, const Across &across) { return at < across.left; };
        const auto from = std::lower_bound(m_across.begin(), m_across.end(), x - m_widest, isLeft);
        const auto to = std::upper_bound(from, m_across.end(), end, isRight);
        return {std::size_t(from - m_across.begin()), std::size_t(to - m_across.begin())};
    }
    const Across &across(std::size_t i) const { return m_across[i]; }
    /// What the arcs across before this one add to the winding number.
    int windingBefore(std::size_t i) const { return i < m_across.size() ? m_across[i].before : m_sum; }

private:
    std::vector<Within> m_within;
    std::vector<Across> m_across; ///< by their left ends
    double m_widest = 0;          ///< of those across
    int m_sum = 0;                ///< what all of those across add to the winding number
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
        if (isSpent())
            return out;
        cut();
        indexByHeight();
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

    /// Lists arcs by bands of height, so that those which meet a level line are found soon.
    void indexByHeight()
    {
        m_top = m_parts[0].arc.top();
        double bottom = m_parts[0].arc.bottom(), heights = 0;
        for (const RisingPart &part : m_parts) {
            m_top = std::min(m_top, part.arc.top()), bottom = std::max(bottom, part.arc.bottom());
            heights += part.arc.bottom() - part.arc.top();
        }
        // An arc is in as many bands as it is high; all in all in a few for each.
        const double each = 1 + heights / (bottom - m_top), count = double(m_parts.size());
        m_bands.resize(std::size_t(std::clamp(8 * count / each, 1.0, count)));
        m_bandHeight = (bottom - m_top) / double(m_bands.size());
        for (std::uint32_t k = 0; k < m_parts.size(); ++k) {
            const RisingArc &arc = m_parts[k].arc;
            const std::size_t first = bandOf(arc.top()), last = bandOf(arc.bottom());
            for (std::size_t band = first + 1; band < last; ++band)
                m_bands[band].addAcross(k, arc);
            m_bands[first].addWithin(k, arc);
            if (last != first)
                m_bands[last].addWithin(k, arc);
        }
        for (Band &band : m_bands)
            band.sort(m_parts);
    }
    std::size_t bandOf(double y) const
    {
        return std::min(m_bands.size() - 1, std::size_t(std::max(0.0, (y - m_top) / m_bandHeight)));
    }

    /// The winding number left of a section.
    int windingLeftOf(const Section &section) const
    {
        const RisingArc &own = m_parts[section.arc].arc;
        const double y = 0.5 * (section.top + section.bottom), t = own.parameterAtY(y), x = own.xAtParameter(t);
        const Point way = own.curve.derivative(t);
        const double near = nearness(way.x, way.y, m_meetings.tolerance);
        const Band &band = m_bands[bandOf(y)];
        int winding = 0;
        const auto add = [&](std::uint32_t k, double right) {
            // Of arcs that lie on each other the first ones count as lying further left, wherever that is asked.
            const double other = right < x - near ? right : m_parts[k].arc.xAt(y);
            if (k != section.arc && (other < x - near || (other <= x + near && k < section.arc)))
                winding += m_parts[k].falls ? -1 : 1;
        };
        for (const Band::Within &arc : band.within())
            if (arc.top <= y && y < arc.bottom && arc.left <= x + near)
                add(arc.arc, arc.right);
        // Those that end further left are counted already.
        const auto [from, to] = band.acrossAt(x - 2 * near, x + near);
        winding += band.windingBefore(from);
        for (std::size_t i = from; i < to; ++i)
            add(band.across(i).arc, m_parts[band.across(i).arc].arc.right());
        spend(m_effort, 4 * (band.within().size() + to - from));
        return winding;
    }

    /// Along a loop the winding number on either side stays the same until something is met, so it is counted once for
    /// each such run, at its longest section.
    void classify()
    {
        for (const auto &[first, end] : m_loops) {
            std::vector<std::uint32_t> run;
            for (std::uint32_t k = first; k < end; ++k) {
                if (m_interrupted[k] || m_meetings.touched[k].begin)
                    classifyRun(run);
                const std::uint32_t from = m_firstSection[k], to = m_firstSection[k + 1];
                if (from == to) // It is as good as level.
                    classifyRun(run);
                for (std::uint32_t i = 0; i < to - from; ++i) {
                    if (i > 0)
                        classifyRun(run);
                    run.push_back(m_parts[k].falls ? to - 1 - i : from + i);
                }
                if (m_meetings.touched[k].end)
                    classifyRun(run);
            }
            classifyRun(run);
        }
    }
    void classifyRun(std::vector<std::uint32_t> &run)
    {
        if (run.empty() || isSpent())
            return;
        const auto height = [this](std::uint32_t i) { return m_sections[i].bottom - m_sections[i].top; };
        const auto longest = *std::max_element(run.begin(), run.end(),
                                               [&](std::uint32_t a, std::uint32_t b) { return height(a) < height(b); });
        const int left = windingLeftOf(m_sections[longest]);
        // On the side that lies left of an arc that rises, which is right of one that falls.
        const int side = left + (m_parts[m_sections[longest].arc].falls ? -1 : 0);
        for (const std::uint32_t i : run) {
            const bool falls = m_parts[m_sections[i].arc].falls;
            const int before = falls ? side + 1 : side, after = falls ? side : side + 1;
            m_sections[i].enters = int(m_rule.isInside(after)) - int(m_rule.isInside(before));
        }
        run.clear();
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
    std::vector<char> m_interrupted; ///< whether something level lies between a part and the one before it
    bool m_level = false;
    std::vector<LoopRange> m_loops;
    Meetings m_meetings;
    std::vector<Section> m_sections;
    std::vector<std::uint32_t> m_firstSection; ///< of each arc, and the end
    std::vector<Band> m_bands;
    double m_top = 0, m_bandHeight = 0;
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

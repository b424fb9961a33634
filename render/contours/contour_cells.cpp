#include "render/contours/contour_cells.h"

#include <bit>

namespace suffuse::contours {

namespace {

constexpr int depths = 28;          // A root is 2^28 units of the grid wide.
constexpr double widestCell = 0.75; // of the spread of what counts in it
constexpr double narrowestCell = 1.0 / 64;
constexpr int enoughPoints = 12; // of a chain

struct Corner {
    std::int32_t x = 0, y = 0;
    std::uint64_t key() const { return std::uint64_t(std::uint32_t(x)) << 32 | std::uint32_t(y); }
};

struct Side {
    std::uint64_t a, b; // a < b
    friend bool operator==(const Side &, const Side &) = default;
};
struct SideHash {
    std::size_t operator()(const Side &side) const
    {
        return std::size_t((side.a * 0x9E3779B97F4A7C15u) ^ std::rotl(side.b * 0xC2B2AE3D27D4EB4Fu, 31));
    }
};
struct KeyHash {
    std::size_t operator()(std::uint64_t key) const { return std::size_t(key * 0x9E3779B97F4A7C15u >> 7); }
};

class Cells {
public:
    Cells(const StrokeField &stroke, const Field &field, const std::vector<double> &levels, const CellOptions &options)
        : m_stroke(stroke), m_field(field), m_levels(levels), m_options(options)
    {
        const Rect box = stroke.box();
        const double side = 1.01 * std::max({box.width(), box.height(), 1e-9});
        m_unit = side / double(1 << depths);
        m_origin = box.centre() - Point{0.503 * side, 0.507 * side}; // so that no line of the grid is one of symmetry
    }

    bool refine()
    {
        divide({0, 0}, depths, m_stroke.whole());
        return !isCancelled();
    }
    /// The chains of all levels.
    std::vector<std::vector<ContourChain>> chains()
    {
        m_next.resize(m_levels.size());
        for (const auto &[corner, depth] : m_leaves) {
            if (isCancelled())
                break;
            cutLeaf(corner, depth);
        }
        std::vector<std::vector<ContourChain>> out(m_levels.size());
        for (std::size_t k = 0; k < m_levels.size() && !isCancelled(); ++k)
            out[k] = chainsOf(k);
        return out;
    }

private:
    bool isCancelled() const { return m_options.cancel && m_options.cancel->load(std::memory_order_relaxed); }
    Point placeOf(Corner c) const { return m_origin + Point{c.x * m_unit, c.y * m_unit}; }
    static Corner cornerOf(std::uint64_t key) { return {std::int32_t(key >> 32), std::int32_t(std::uint32_t(key))}; }
    const Sloped &at(Corner c)
    {
        const auto [known, isNew] = m_values.try_emplace(c.key());
        if (isNew)
            known->second = m_field(placeOf(c));
        return known->second;
    }

    /// Whether a cell need not be divided although it may be crossed: the field is nearly a plane in it.
    bool isPlain(Corner c, int depth, double narrowest)
    {
        const int size = 1 << depth, half = size / 2;
        const Corner middle{c.x + half, c.y + half};
        const Sloped centre = at(middle);
        double low = centre.value, high = low, bend = 0;
        bool turns = false;
        for (int k = 0; k < 4; ++k) {
            const Corner corner{c.x + k % 2 * size, c.y + k / 2 * size};
            const Sloped &s = at(corner);
            low = std::min(low, s.value), high = std::max(high, s.value);
            bend =
                std::max(bend, std::abs(centre.value + dot(centre.slope, placeOf(corner) - placeOf(middle)) - s.value));
            const double along = dot(centre.slope, s.slope);
            turns =
                turns || !(along > 0 && along * along > 0.5 * dot(centre.slope, centre.slope) * dot(s.slope, s.slope));
        }
        const auto level = std::lower_bound(m_levels.begin(), m_levels.end(), low - bend);
        if (level == m_levels.end() || *level > high + bend)
            return true;
        // A plane is crossed by a line; where the slope turns a level may be met again.
        return !turns && bend < 0.5 * (high - low + 1e-300) && size * m_unit <= widestCell * narrowest;
    }

    void divide(Corner c, int depth, const FieldPart &around)
    {
        if (isCancelled())
            return;
        const int size = 1 << depth;
        const Point from = placeOf(c), to = placeOf({c.x + size, c.y + size});
        const FieldPart part = m_stroke.within(around, {from.x, from.y, to.x, to.y});
        if (part.most < m_options.lowest || part.narrowest == std::numeric_limits<double>::infinity())
            return;
        const double width = size * m_unit;
        const double least =
            std::max(part.narrowest * narrowestCell, std::min(0.25 * part.narrowest, m_options.tolerance));
        if (depth > 1 &&
            (width > widestCell * part.narrowest || (width > least && !isPlain(c, depth, part.narrowest)))) {
            const int half = size / 2;
            for (int k = 0; k < 9; ++k) // so that who shares a side finds what divides it
                at({c.x + k % 3 * half, c.y + k / 3 * half});
            for (int k = 0; k < 4; ++k)
                divide({c.x + k % 2 * half, c.y + k / 2 * half}, depth - 1, part);
            return;
        }
        for (int k = 0; k < 4; ++k)
            at({c.x + k % 2 * size, c.y + k / 2 * size});
        at({c.x + size / 2, c.y + size / 2});
        m_leaves.emplace_back(c, depth);
    }

    /// Appends what lies on a side of a cell from a corner, which is part of it, to another one, which is not.
    void appendSide(Corner from, Corner to, std::vector<Corner> &out)
    {
        const Corner middle{from.x + (to.x - from.x) / 2, from.y + (to.y - from.y) / 2};
        if (std::abs(to.x - from.x) + std::abs(to.y - from.y) > 1 && m_values.contains(middle.key())) {
            appendSide(from, middle, out);
            appendSide(middle, to, out);
        } else {
            out.push_back(from);
        }
    }

    void cutLeaf(Corner c, int depth)
    {
        const int size = 1 << depth;
        const Corner corners[4] = {c, {c.x + size, c.y}, {c.x + size, c.y + size}, {c.x, c.y + size}};
        m_ring.clear();
        for (int k = 0; k < 4; ++k)
            appendSide(corners[k], corners[(k + 1) % 4], m_ring);
        const Corner middle{c.x + size / 2, c.y + size / 2};
        const double centre = at(middle).value;
        for (std::size_t i = 0; i < m_ring.size(); ++i)
            cutTriangle(middle, m_ring[i], m_ring[(i + 1) % m_ring.size()], centre);
    }

    void cutTriangle(Corner a, Corner b, Corner c, double atA)
    {
        const double atB = m_values.find(b.key())->second.value, atC = m_values.find(c.key())->second.value;
        const double low = std::min({atA, atB, atC}), high = std::max({atA, atB, atC});
        // Above a level is what is at it or higher.
        for (auto k = std::size_t(std::upper_bound(m_levels.begin(), m_levels.end(), low) - m_levels.begin());
             k < m_levels.size() && m_levels[k] <= high; ++k) {
            const bool in[3] = {atA >= m_levels[k], atB >= m_levels[k], atC >= m_levels[k]};
            const std::uint64_t keys[3] = {a.key(), b.key(), c.key()};
            Side leaves{}, enters{};
            for (int i = 0; i < 3; ++i) {
                const int next = (i + 1) % 3;
                if (in[i] != in[next])
                    (in[i] ? leaves : enters) = {std::min(keys[i], keys[next]), std::max(keys[i], keys[next])};
            }
            m_next[k].emplace(leaves, enters);
        }
    }

    /// Whether a side goes from the middle of a square to its border: squares' sides are level or upright.
    static bool isSpoke(const Side &side)
    {
        const Corner a = cornerOf(side.a), b = cornerOf(side.b);
        return a.x != b.x && a.y != b.y;
    }

    std::vector<ContourChain> chainsOf(std::size_t k)
    {
        auto &next = m_next[k];
        std::vector<ContourChain> out;
        while (!next.empty() && !isCancelled()) {
            std::vector<Side> sides;
            for (auto at = next.begin(); at != next.end(); at = next.find(at->second), next.erase(sides.back()))
                sides.push_back(at->first);
            // Where chains cross the squares' sides is enough, unless they are short.
            const auto isOfSquare = [this](const Side &side) { return !isSpoke(side); };
            const bool some = std::ranges::count_if(sides, isOfSquare) >= enoughPoints;
            ContourChain chain;
            for (const Side &side : sides)
                if (!some || isOfSquare(side))
                    chain.push_back(crossing(side, m_levels[k]));
            if (chain.size() > 2)
                out.push_back(std::move(chain));
        }
        return out;
    }

    /// Where a side is crossed: guessed from the values and slopes at its ends, then one step of Newton's method along
    /// the slope; by halving where that leads astray.
    ContourPoint crossing(const Side &side, double level)
    {
        const Sloped &a = m_values.find(side.a)->second, &b = m_values.find(side.b)->second;
        const Point from = placeOf(cornerOf(side.a)), way = placeOf(cornerOf(side.b)) - from;
        double low = 0, high = 1;
        const double f0 = a.value - level, f1 = b.value - level, d0 = dot(a.slope, way), d1 = dot(b.slope, way);
        const auto hermite = [&](double t) {
            const double u = 1 - t;
            return u * u * (1 + 2 * t) * f0 + t * u * u * d0 + t * t * (1 + 2 * u) * f1 - t * t * u * d1;
        };
        for (int i = 0; i < 24; ++i) {
            const double t = 0.5 * (low + high);
            ((hermite(t) >= 0) == (f0 >= 0) ? low : high) = t;
        }
        Point p = from + 0.5 * (low + high) * way;
        const double most = 0.1 * length(way);
        for (int round = 0; round < 4; ++round) {
            const Sloped s = m_field(p);
            const double steep = dot(s.slope, s.slope);
            const Point step = (steep > 0 ? (level - s.value) / steep : 0) * s.slope;
            const double size = length(step);
            if (!(steep > 0) || size > most)
                break;
            p = p + step;
            if (size < 0.02 * m_options.tolerance)
                return {p, s.slope};
        }
        low = 0, high = 1;
        while ((high - low) * length(way) > 0.1 * m_options.tolerance) {
            const double t = 0.5 * (low + high);
            ((m_field(from + t * way).value >= level) == (f0 >= 0) ? low : high) = t;
        }
        p = from + 0.5 * (low + high) * way;
        return {p, m_field(p).slope};
    }

    const StrokeField &m_stroke;
    const Field &m_field;
    const std::vector<double> &m_levels;
    const CellOptions &m_options;
    double m_unit = 1;
    Point m_origin;
    std::unordered_map<std::uint64_t, Sloped, KeyHash> m_values;
    std::vector<std::pair<Corner, int>> m_leaves;
    std::vector<Corner> m_ring;
    std::vector<std::unordered_map<Side, Side, SideHash>> m_next; ///< of each level, from side to side
};

} // namespace

std::vector<std::vector<ContourChain>> contourChains(const StrokeField &stroke, const Field &field,
                                                     const std::vector<double> &levels, const CellOptions &options)
{
    if (stroke.box().isEmpty() || levels.empty())
        return std::vector<std::vector<ContourChain>>(levels.size());
    Cells cells(stroke, field, levels, options);
    return cells.refine() ? cells.chains() : std::vector<std::vector<ContourChain>>(levels.size());
}

} // namespace suffuse::contours

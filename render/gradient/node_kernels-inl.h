// The loops of tile_data.h over nodes: sums from nodes, and derivatives by nodes from those by sums. V holds one or
// more pixels of a row. docs/solver.md, "The gradient of the picture".
#if defined(SUFFUSE_RENDER_GRADIENT_NODE_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_GRADIENT_NODE_KERNELS_INL_H
#undef SUFFUSE_RENDER_GRADIENT_NODE_KERNELS_INL_H
#else
#define SUFFUSE_RENDER_GRADIENT_NODE_KERNELS_INL_H
#endif

#include "render/gradient/tile_data.h"
#include "render/math/style.h"

#include <algorithm>

SUFFUSE_MATH_BEGIN
namespace suffuse::SUFFUSE_MATH {

using namespace suffuse::gradient;

/// Says how V is read and written: `Number`, count(), mostCount, load, store, ramp() (0, 1, 2, …), total,
/// halfErfc (of u, with e^(−u²)); and findNodes, which is in float in any case.
template <class V>
struct Pixels;

/// A node along one axis: X(u), u the distance in spreads, and what its derivatives are made of.
template <class V>
struct NodeAxis {
    V u;
    V inside;    ///< X
    V once;      ///< −½ dX/du
    V onceSlope; ///< its derivative by u

    SUFFUSE_INLINE NodeAxis() {} // It is compiled for the target, while the implicit one is not.
    SUFFUSE_INLINE V twice() const { return u * once; }
    /// Of `once`/s, by s, times s².
    SUFFUSE_INLINE V onceBySpread() const { return V(0) - mulAdd_(u, onceSlope, once); }
};

/// e^(−u²) − cut, cut off at 0.
template <class V, class Number>
SUFFUSE_INLINE NodeAxis<V> gaussAxis(Number place, int from, const TileNode<Number> &node)
{
    NodeAxis<V> a;
    a.u = ((Pixels<V>::ramp() + V(Number(from))) - V(place)) * V(node.inverse);
    const V all = exp2_(V(-log2e) * a.u * a.u), cut(node.cut);
    const auto there = less_(cut, all);
    const V e = select_(there, all, V(0));
    a.inside = select_(there, all - cut, V(0));
    a.once = a.u * e;
    a.onceSlope = mulAdd_(V(-2) * a.u, a.u, V(1)) * e;
    return a;
}

/// ½erfc(−u).
template <class V, class Number>
SUFFUSE_INLINE NodeAxis<V> outlineAxis(Number place, int from, const TileNode<Number> &node)
{
    NodeAxis<V> a;
    a.u = ((Pixels<V>::ramp() + V(Number(from))) - V(place)) * V(node.inverse);
    const V e = exp2_(V(-log2e) * a.u * a.u), slope = V(0.56418958354775629) * e; // 1/√π
    a.inside = Pixels<V>::halfErfc(a.u, e);
    a.once = V(-0.5) * slope;
    a.onceSlope = a.u * slope;
    return a;
}

template <Source source, class V, class Number>
SUFFUSE_INLINE NodeAxis<V> columnAxis(int from, const TileNode<Number> &node)
{
    if constexpr (source == Source::Outline)
        return outlineAxis<V>(node.x, from, node);
    else
        return gaussAxis<V>(node.x, from, node);
}

/// Nodes whose tables are in the cache at once.
inline constexpr int tablesAtOnce = 32;

/// X and −½X′/s in each column, w Y and −½w Y′/s in each row.
template <class Number>
struct alignas(64) AxisTables {
    Number row[tablesAtOnce][tileSide], rowSlope[tablesAtOnce][tileSide];
    Number column[tablesAtOnce][tileSide], columnSlope[tablesAtOnce][tileSide];
};

/// sums[y][x] += Σ left[node][x] · right[node][y] for three pairs of tables.
template <class V, class Number>
SUFFUSE_INLINE void addTables(const AxisTables<Number> &t, int count, bool add, Number (*sums)[tileSize])
{
    using P = Pixels<V>;
    constexpr int rows = P::mostCount >= tileSide ? 8 : 4;
    for (int x = 0; x < tileSide; x += P::count())
        for (int y = 0; y < tileSide; y += rows) {
            V s0[rows], s1[rows], s2[rows];
            for (int r = 0; r < rows; ++r) {
                const int at = (y + r) * tileSide + x;
                s0[r] = add ? P::load(sums[0] + at) : V(0);
                s1[r] = add ? P::load(sums[1] + at) : V(0);
                s2[r] = add ? P::load(sums[2] + at) : V(0);
            }
            for (int n = 0; n < count; ++n) {
                const V c = P::load(t.column[n] + x), cs = P::load(t.columnSlope[n] + x);
                for (int r = 0; r < rows; ++r) {
                    const V row(t.row[n][y + r]);
                    s0[r] = mulAdd_(c, row, s0[r]);
                    s1[r] = mulAdd_(cs, row, s1[r]);
                    s2[r] = mulAdd_(c, V(t.rowSlope[n][y + r]), s2[r]);
                }
            }
            for (int r = 0; r < rows; ++r) {
                const int at = (y + r) * tileSide + x;
                P::store(s0[r], sums[0] + at);
                P::store(s1[r], sums[1] + at);
                P::store(s2[r], sums[2] + at);
            }
        }
}

template <Source source, class V, class Number>
void accumulateOf(const TileNode<Number> *nodes, int count, bool add, Number (*sums)[tileSize])
{
    using P = Pixels<V>;
    AxisTables<Number> t;
    do {
        const int n = std::min(count, tablesAtOnce);
        for (int i = 0; i < n; ++i)
            for (int at = 0; at < tileSide; at += P::count()) {
                const TileNode<Number> &node = nodes[i];
                const NodeAxis<V> x = columnAxis<source, V>(at, node), y = gaussAxis<V>(node.y, at, node);
                const V weight(node.weight), inverse(node.inverse);
                P::store(x.inside, t.column[i] + at);
                P::store(x.once * inverse, t.columnSlope[i] + at);
                P::store(y.inside * weight, t.row[i] + at);
                P::store(y.once * (inverse * weight), t.rowSlope[i] + at);
            }
        addTables<V>(t, n, add, sums);
        add = true, nodes += n, count -= n;
    } while (count > 0);
}

template <class V, class Number>
void accumulate(Source source, const TileNode<Number> *nodes, int count, bool add, Number (*sums)[tileSize])
{
    source == Source::Outline ? accumulateOf<Source::Outline, V>(nodes, count, add, sums)
                              : accumulateOf<Source::Segment, V>(nodes, count, add, sums);
}

/// The density of nodes alone.
template <class V, class Number>
SUFFUSE_INLINE void densityOf(Source source, const TileNode<Number> *nodes, int count, Number *density)
{
    using P = Pixels<V>;
    std::fill(density, density + tileSize, Number(0));
    for (int i = 0; i < count; ++i) {
        const TileNode<Number> &node = nodes[i];
        alignas(64) Number row[tileSide];
        for (int y = 0; y < tileSide; y += P::count())
            P::store(gaussAxis<V>(node.y, y, node).inside * V(node.weight), row + y);
        for (int x = 0; x < tileSide; x += P::count()) {
            const V column = source == Source::Outline ? outlineAxis<V>(node.x, x, node).inside
                                                       : gaussAxis<V>(node.x, x, node).inside;
            for (int y = 0; y < tileSide; ++y)
                P::store(mulAdd_(column, V(row[y]), P::load(density + y * tileSide + x)), density + y * tileSide + x);
        }
    }
}

/// What a node's derivatives need along y.
template <class Number>
struct alignas(64) RowTables {
    Number inside[tileSide], once[tileSide], twice[tileSide]; // the last two over s
    Number slope[tileSide], bySpread[tileSide];               // half of those of `once`
};

template <class V, class Number>
SUFFUSE_INLINE void fillRows(const TileNode<Number> &node, RowTables<Number> &t)
{
    using P = Pixels<V>;
    const V inverse(node.inverse), half = V(0.5) * inverse * inverse;
    for (int y = 0; y < tileSide; y += P::count()) {
        const NodeAxis<V> axis = gaussAxis<V>(node.y, y, node);
        P::store(axis.inside, t.inside + y);
        P::store(axis.once * inverse, t.once + y);
        P::store(axis.twice() * inverse, t.twice + y);
        P::store(V(0) - axis.onceSlope * half, t.slope + y);
        P::store(axis.onceBySpread() * half, t.bySpread + y);
    }
}

/// The same for `many` nodes at once, so that no sum waits for its own last term.
template <Source source, int many, class V, class Number>
SUFFUSE_INLINE void someNodesBack(const TileNode<Number> *nodes, const Number (*bySums)[tileSize], int firstRow,
                                  int endRow, NodeSlopes<Number> *out)
{
    using P = Pixels<V>;
    RowTables<Number> rows[many];
    Number top = nodes[0].y - nodes[0].reach, bottom = nodes[0].y + nodes[0].reach;
    for (int i = 0; i < many; ++i) {
        fillRows<V>(nodes[i], rows[i]);
        top = std::min(top, nodes[i].y - nodes[i].reach), bottom = std::max(bottom, nodes[i].y + nodes[i].reach);
    }
    firstRow = std::max(firstRow, int(std::max(top, Number(0))));
    endRow = std::min(endRow, int(std::max(std::min(bottom, Number(tileSide)), Number(-1))) + 1);
    V byWeight[many], byX[many], byY[many], bySpread[many];
    for (int i = 0; i < many; ++i)
        byWeight[i] = byX[i] = byY[i] = bySpread[i] = V(0);
    for (int x = 0; x < tileSide; x += P::count()) {
        // Of sums over y, those that the same function of x multiplies are one.
        V a[many], c[many], d[many], e[many], f1[many], f2[many];
        for (int i = 0; i < many; ++i)
            a[i] = c[i] = d[i] = e[i] = f1[i] = f2[i] = V(0);
        for (int y = firstRow; y < endRow; ++y) {
            const int at = y * tileSide + x;
            const V g = P::load(bySums[0] + at), gx = P::load(bySums[1] + at), gy = P::load(bySums[2] + at);
            for (int i = 0; i < many; ++i) {
                const V inside(rows[i].inside[y]), once(rows[i].once[y]), second(rows[i].twice[y]);
                a[i] = mulAdd_(g, inside, mulAdd_(gy, once, a[i]));
                c[i] = mulAdd_(g, once, mulAdd_(gy, V(rows[i].slope[y]), c[i]));
                d[i] = mulAdd_(g, second, mulAdd_(gy, V(rows[i].bySpread[y]), d[i]));
                e[i] = mulAdd_(gx, inside, e[i]);
                f1[i] = mulAdd_(gx, once, f1[i]);
                f2[i] = mulAdd_(gx, second, f2[i]);
            }
        }
        for (int i = 0; i < many; ++i) {
            const V inverse(nodes[i].inverse), twice = V(2) * inverse, square = inverse * inverse;
            const NodeAxis<V> axis = columnAxis<source, V>(x, nodes[i]);
            const V once = axis.once, perSpread = once * twice;
            byWeight[i] = mulAdd_(axis.inside, a[i], mulAdd_(once * inverse, e[i], byWeight[i]));
            byX[i] = mulAdd_(perSpread, a[i], negMulAdd_(axis.onceSlope * square, e[i], byX[i]));
            byY[i] = mulAdd_(V(2) * axis.inside, c[i], mulAdd_(perSpread, f1[i], byY[i]));
            bySpread[i] = mulAdd_(axis.twice() * twice, a[i], mulAdd_(V(2) * axis.inside, d[i], bySpread[i]));
            bySpread[i] = mulAdd_(axis.onceBySpread() * square, e[i], mulAdd_(perSpread, f2[i], bySpread[i]));
        }
    }
    for (int i = 0; i < many; ++i) {
        const Number weight = nodes[i].weight;
        out[i] = {P::total(byWeight[i]), weight * P::total(byX[i]), weight * P::total(byY[i]),
                  weight * P::total(bySpread[i])};
    }
}

template <Source source, class V, class Number>
void nodesBackOf(const TileNode<Number> *nodes, int count, const Number (*bySums)[tileSize], int firstRow, int endRow,
                 NodeSlopes<Number> *out)
{
    constexpr int many = Pixels<V>::mostCount >= tileSide ? 2 : 1;
    int i = 0;
    for (; i + many <= count; i += many)
        someNodesBack<source, many, V>(nodes + i, bySums, firstRow, endRow, out + i);
    for (; i < count; ++i)
        someNodesBack<source, 1, V>(nodes + i, bySums, firstRow, endRow, out + i);
}

template <class V, class Number>
void nodesBack(Source source, const TileNode<Number> *nodes, int count, const Number (*bySums)[tileSize], int firstRow,
               int endRow, NodeSlopes<Number> *out)
{
    source == Source::Outline ? nodesBackOf<Source::Outline, V>(nodes, count, bySums, firstRow, endRow, out)
                              : nodesBackOf<Source::Segment, V>(nodes, count, bySums, firstRow, endRow, out);
}

} // namespace suffuse::SUFFUSE_MATH
SUFFUSE_MATH_END

#endif

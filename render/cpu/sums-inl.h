// Sums of density, slopes and channels over nodes, at the samples of a block. It is included once for each Highway
// target.
#if defined(SUFFUSE_RENDER_CPU_SUMS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_CPU_SUMS_INL_H
#undef SUFFUSE_RENDER_CPU_SUMS_INL_H
#else
#define SUFFUSE_RENDER_CPU_SUMS_INL_H
#endif

#include "render/cpu/block-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace suffuse::HWY_NAMESPACE {

using namespace suffuse::cpu;

inline constexpr int chunk = 32; // nodes whose tables are in the cache at once

struct alignas(64) Tables {
    float column[chunk][blockSide];      // e^(−a dx²) − cut
    float columnSlope[chunk][blockSide]; // −½ of its derivative: a dx e^(−a dx²)
    float row[chunk][blockSide];         // weight · (e^(−c dy²) − cut)
    float rowSlope[chunk][blockSide];
    float scaledRow[chunk][blockSide]; // row · channel value
    // of the node, relative to the centres of the first cell (x, y) and of the last one
    float place[chunk][4];
};

/// The distances from a node to the block's 16 sample columns (or rows), for lanes from `from` on. `first` and `last`
/// are the places of the node relative to the centres of the block's cells.
HWY_INLINE Lanes distances(float first, float last, const float *offsets, int from)
{
    const Lanes offset = load(offsets + from);
    if (hn::Lanes(tag) > cellSide) // Both cells are in one vector.
        return offset - Lanes(hn::IfThenElse(hn::FirstN(tag, cellSide), Lanes(first).v, Lanes(last).v));
    return offset - Lanes(from < cellSide ? first : last);
}

/// The offsets of a block's samples from the centres of their cells.
HWY_INLINE void cellOffsets(double step, float *out)
{
    for (int i = 0; i < blockSide; ++i)
        out[i] = (float(i % cellSide) - 3.5f) * float(step);
}

/// The cut Gaussian along one axis and −½ of its slope, times `weight` if there is one.
template <bool weighted>
HWY_INLINE void axisTable(float first, float last, const float *offsets, float metric, float cut, float weight,
                          float *value, float *slope)
{
    for (int i = 0; i < blockSide; i += int(hn::Lanes(tag))) {
        const Lanes d = distances(first, last, offsets, i), rise = Lanes(metric) * d;
        const Lanes e = exp2Down(Lanes(-log2e) * (rise * d));
        Lanes inside = e - Lanes(cut), fall = rise * e;
        if (weighted) {
            inside = inside * Lanes(weight);
            fall = fall * Lanes(weight);
        }
        const Mask there = less_(Lanes(cut), e);
        store(Lanes(hn::IfThenElseZero(there, inside.v)), value + i);
        store(Lanes(hn::IfThenElseZero(there, fall.v)), slope + i);
    }
}

/// How many rows of a block have their sums in registers at once: for one product, and for two.
inline constexpr int tallRows = hn::MaxLanes(tag) >= blockSide ? 16 : 8, pairRows = tallRows / 2;

/// The sums of `rows` rows of one vector of columns.
template <int rows>
struct Accumulators {
    Vec v[rows];

    HWY_INLINE void load(const float *sums, bool add)
    {
        for (int r = 0; r < rows; ++r)
            v[r] = add ? hn::Load(tag, sums + r * blockSide) : hn::Zero(tag);
    }
    HWY_INLINE void store(float *sums) const
    {
        for (int r = 0; r < rows; ++r)
            hn::Store(v[r], tag, sums + r * blockSide);
    }
};

/// sums[row][column] = Σ left[node][column] · right[node][row], or += if `add`.
HWY_INLINE void addOuter(const float (*left)[blockSide], const float (*right)[blockSide], int nodes, bool add,
                         float *sums)
{
    for (int x = 0; x < blockSide; x += int(hn::Lanes(tag)))
        for (int y = 0; y < blockSide; y += tallRows) {
            Accumulators<tallRows> s;
            s.load(sums + y * blockSide + x, add);
            for (int n = 0; n < nodes; ++n) {
                const Vec l = hn::Load(tag, left[n] + x);
                for (int r = 0; r < tallRows; ++r)
                    s.v[r] = hn::MulAdd(l, hn::Set(tag, right[n][y + r]), s.v[r]);
            }
            s.store(sums + y * blockSide + x);
        }
}

/// The same for two products that share `right`.
HWY_INLINE void addOuterPair(const float (*left0)[blockSide], const float (*left1)[blockSide],
                             const float (*right)[blockSide], int nodes, bool add, float *sums0, float *sums1)
{
    for (int x = 0; x < blockSide; x += int(hn::Lanes(tag)))
        for (int y = 0; y < blockSide; y += pairRows) {
            Accumulators<pairRows> s0, s1;
            s0.load(sums0 + y * blockSide + x, add);
            s1.load(sums1 + y * blockSide + x, add);
            for (int n = 0; n < nodes; ++n) {
                const Vec l0 = hn::Load(tag, left0[n] + x), l1 = hn::Load(tag, left1[n] + x);
                for (int r = 0; r < pairRows; ++r) {
                    const Vec value = hn::Set(tag, right[n][y + r]);
                    s0.v[r] = hn::MulAdd(l0, value, s0.v[r]);
                    s1.v[r] = hn::MulAdd(l1, value, s1.v[r]);
                }
            }
            s0.store(sums0 + y * blockSide + x);
            s1.store(sums1 + y * blockSide + x);
        }
}

/// Finds the places of nodes, subtracting in double.
HWY_INLINE void fillPlaces(const Block &block, const ViewNode *nodes, const std::uint32_t *listed, int count, Tables &t)
{
    const double toCell = block.step * (cellSide / 2);
    const double firstCell[2] = {block.x + toCell, block.y + toCell};
    const double lastCell[2] = {block.x + 3 * toCell, block.y + 3 * toCell};
    const hn::CappedTag<double, 2> pairTag;
    const hn::Rebind<float, decltype(pairTag)> pairOut;
    for (int i = 0; i < count; ++i) {
        const ViewNode &node = nodes[listed[i]];
        for (int axis = 0; axis < 2; axis += int(hn::Lanes(pairTag))) {
            const auto at = hn::LoadU(pairTag, &node.x + axis);
            hn::StoreU(hn::DemoteTo(pairOut, hn::Sub(at, hn::LoadU(pairTag, firstCell + axis))), pairOut,
                       t.place[i] + axis);
            hn::StoreU(hn::DemoteTo(pairOut, hn::Sub(at, hn::LoadU(pairTag, lastCell + axis))), pairOut,
                       t.place[i] + 2 + axis);
        }
    }
}

/// Multiplies tables by the nodes' values of a channel.
HWY_INLINE void scaleRows(const float (*rows)[blockSide], const ViewNode *nodes, const std::uint32_t *listed, int count,
                          const float *values, int channels, int channel, float (*out)[blockSide])
{
    for (int i = 0; i < count; ++i) {
        const Lanes value(values[std::size_t(nodes[listed[i]].row) * channels + channel]);
        for (int y = 0; y < blockSide; y += int(hn::Lanes(tag)))
            store(load(rows[i] + y) * value, out[i] + y);
    }
}

/// Fills the tables of `n` nodes, the `first`-th and those behind it.
HWY_INLINE void fillTables(const Block &block, const ListedNodes &listed, int first, int n, const float *offsets,
                           Tables &t)
{
    const std::uint32_t *at = listed.at + first;
    fillPlaces(block, listed.nodes, at, n, t);
    for (int i = 0; i < n; ++i) {
        const ViewNode &node = listed.nodes[at[i]];
        const float *place = t.place[i];
        axisTable<false>(place[0], place[2], offsets, node.a, node.cut, 1, t.column[i], t.columnSlope[i]);
        axisTable<true>(place[1], place[3], offsets, node.c, node.cut, node.weight, t.row[i], t.rowSlope[i]);
    }
}

/// Adds separable nodes, and of channels the first ones. With `begin` the sums begin.
HWY_INLINE void addSeparable(const Block &block, const ListedNodes &listed, int from, int to, int channels, bool begin,
                             Sums &sums)
{
    Tables t;
    alignas(64) float offsets[blockSide];
    cellOffsets(block.step, offsets);
    for (int first = from; first < to || (first == from && begin); first += chunk) {
        const int n = std::min(chunk, to - first);
        const std::uint32_t *at = listed.at + first;
        fillTables(block, listed, first, n, offsets, t);
        const bool add = !begin || first > from;
        addOuterPair(t.column, t.columnSlope, t.row, n, add, sums.v[0], sums.v[1]);
        addOuter(t.column, t.rowSlope, n, add, sums.v[2]);
        for (int c = 0; c < channels; ++c) {
            scaleRows(t.row, listed.nodes, at, n, listed.values, listed.channels, c, t.scaledRow);
            addOuter(t.column, t.scaledRow, n, add, sums.v[fixedSums + c]);
        }
    }
}

/// Adds nodes that make paint paler to their one sum, which is the last channel.
HWY_INLINE void addFading(const Block &block, const ListedNodes &listed, bool begin, Sums &sums)
{
    float *sum = sums.v[fixedSums + listed.painting];
    if (begin && listed.painted == listed.separable)
        std::memset(sum, 0, sizeof sums.v[0]);
    Tables t;
    alignas(64) float offsets[blockSide];
    cellOffsets(block.step, offsets);
    for (int first = listed.painted; first < listed.separable; first += chunk) {
        const int n = std::min(chunk, listed.separable - first);
        fillTables(block, listed, first, n, offsets, t);
        scaleRows(t.row, listed.nodes, listed.at + first, n, listed.values, listed.channels, listed.painting,
                  t.scaledRow);
        addOuter(t.column, t.scaledRow, n, !begin || first > listed.painted, sum);
    }
}

/// Adds nodes whose axes are oblique, and so are no product of two tables.
void addOblique(const Block &block, const ListedNodes &listed, Sums &sums)
{
    const int channels = listed.channels;
    alignas(64) float dx[blockSide], dy[blockSide], offsets[blockSide];
    cellOffsets(block.step, offsets);
    const double toCell = block.step * (cellSide / 2);
    for (int n = listed.separable; n < listed.count; ++n) {
        const ViewNode &node = listed.nodes[listed.at[n]];
        const double x = node.x - block.x - toCell, y = node.y - block.y - toCell;
        for (int i = 0; i < blockSide; i += int(hn::Lanes(tag))) {
            store(distances(float(x), float(x - 2 * toCell), offsets, i), dx + i);
            store(distances(float(y), float(y - 2 * toCell), offsets, i), dy + i);
        }
        const float *value = listed.values + std::size_t(node.row) * channels;
        for (int y = 0; y < blockSide; ++y)
            for (int x = 0; x < blockSide; x += int(hn::Lanes(tag))) {
                const Lanes X = load(dx + x), Y(dy[y]);
                const Lanes ax = Lanes(node.a) * X + Lanes(node.b) * Y, cy = Lanes(node.b) * X + Lanes(node.c) * Y;
                const Lanes e = exp2Down(Lanes(-log2e) * (X * ax + Y * cy)), inside = e - Lanes(node.cut);
                const auto there = less_(Lanes(0), inside);
                const Lanes density = select_(there, inside * Lanes(node.weight), Lanes(0));
                const Lanes slope = select_(there, Lanes(node.weight) * e, Lanes(0)); // −½ of the slope, as above
                const int at = y * blockSide + x;
                store(load(sums.v[0] + at) + density, sums.v[0] + at);
                store(load(sums.v[1] + at) + slope * ax, sums.v[1] + at);
                store(load(sums.v[2] + at) + slope * cy, sums.v[2] + at);
                for (int c = 0; c < channels; ++c)
                    store(load(sums.v[fixedSums + c] + at) + density * Lanes(value[c]), sums.v[fixedSums + c] + at);
            }
    }
}

/// Calls `add(from, to, channels, begin)` for the separable nodes that lay paint, then for those that lift it.
/// These have no channels, so φ⁺ is what φ is between them; `keepLaid` takes it then.
template <class Add, class KeepLaid>
HWY_INLINE void addBySign(const ListedNodes &listed, bool begin, Add add, KeepLaid keepLaid)
{
    add(0, listed.laying, listed.laid ? listed.painting - 1 : listed.painting, begin);
    if (listed.laid && (begin || listed.laying > 0)) // else φ⁺ is what it was
        keepLaid();
    if (listed.laying < listed.painted)
        add(listed.laying, listed.painted, 0, false);
}

void accumulate(const Block &block, const ListedNodes &listed, bool add, Sums &sums)
{
    addBySign(
        listed, !add,
        [&](int from, int to, int channels, bool begin) {
            addSeparable(block, listed, from, to, channels, begin, sums);
        },
        [&] { std::memcpy(sums.v[fixedSums + listed.painting - 1], sums.v[0], sizeof sums.v[0]); });
    if (listed.painting < listed.channels)
        addFading(block, listed, !add, sums);
    addOblique(block, listed, sums);
}

} // namespace suffuse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

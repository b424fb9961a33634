// The density of a fill at the samples of a cell. It is included once for each Highway target.
#if defined(SUFFUSE_RENDER_CPU_FILL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_CPU_FILL_INL_H
#undef SUFFUSE_RENDER_CPU_FILL_INL_H
#else
#define SUFFUSE_RENDER_CPU_FILL_INL_H
#endif

#include "render/cpu/block-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace suffuse::HWY_NAMESPACE {

using namespace suffuse::cpu;

HWY_INLINE Lanes gaussianOf(Lanes u)
{
    return exp2Down(Lanes(-log2e) * (u * u));
}

/// Places of nodes that are in the cache at once.
struct alignas(64) FillTables {
    float entered[chunk][2 * cellSide]; // ½erfc(−u) of each column; of vectors of 16 lanes twice
    float across[chunk][2 * cellSide];  // e^(−u²)
    float row[chunk + 2][cellSide];     // weight · e^(−v²)
    float fall[chunk + 2][cellSide];    // its slope by v
};

/// A row's number for each sample of a vector that begins at sample `at` of a cell.
HWY_INLINE Lanes ofRow(const float *rows, int at)
{
    const Lanes first(rows[at / cellSide]);
    if (hn::Lanes(tag) <= cellSide)
        return first;
    return Lanes(hn::IfThenElse(hn::FirstN(tag, cellSide), first.v, Lanes(rows[at / cellSide + 1]).v));
}

/// e^(−v²) times a weight in each row of a cell, and its slope.
HWY_INLINE void fillRows(const float *offsets, float c, float y, float weight, float *row, float *fall)
{
    for (int i = 0; i < cellSide; i += std::min(int(hn::Lanes(tag)), cellSide)) {
        const Lanes v = Lanes(c) * (load(offsets + i) - Lanes(y)), e = Lanes(weight) * gaussianOf(v);
        alignas(64) float values[2][boxRun];
        store(e, values[0]);
        store(Lanes(-2) * v * e, values[1]);
        std::copy_n(values[0], std::min(int(hn::Lanes(tag)), cellSide), row + i);
        std::copy_n(values[1], std::min(int(hn::Lanes(tag)), cellSide), fall + i);
    }
}

/// What events add in each row: the inside of a level line left of the cell.
HWY_INLINE void fillBase(const FillCell &cell, const float *offsets, float *inside, float *slope)
{
    std::fill_n(inside, cellSide, float(cell.entered));
    std::fill_n(slope, cellSide, 0.0f);
    for (int k = 0; k < cell.events; ++k)
        for (int i = 0; i < cellSide; i += std::min(int(hn::Lanes(tag)), cellSide)) {
            const Lanes v = Lanes(cell.c) * (load(offsets + i) - Lanes(cell.eventY[k]));
            alignas(64) float values[2][boxRun];
            const Lanes e = gaussianOf(v);
            store(Lanes(cell.eventJump[k]) * halfErfc(v, e), values[0]);
            store(Lanes(cell.eventJump[k] * 0.56418958f) * e, values[1]);
            for (int j = 0; j < std::min(int(hn::Lanes(tag)), cellSide); ++j) {
                inside[i + j] += values[0][j];
                slope[i + j] += values[1][j];
            }
        }
}

/// Fills tables of nodes [first, first + n) for vectors of 16 lanes: those of two nodes at once. Behind an odd number
/// there is a node of weight 0.
HWY_INLINE void fillPairs(const FillCell &cell, const float *offsets, int first, int n, FillTables &t)
{
    alignas(64) static constexpr std::int32_t low[16] = {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7};
    alignas(64) static constexpr std::int32_t high[16] = {8, 9, 10, 11, 12, 13, 14, 15, 8, 9, 10, 11, 12, 13, 14, 15};
    const auto lower = hn::SetTableIndices(tag, low), upper = hn::SetTableIndices(tag, high);
    const Mask isFirst = hn::FirstN(tag, cellSide);
    const Lanes offset = load(offsets);
    for (int k = 0; k < n; k += 2) {
        const int one = first + k, other = k + 1 < n ? one + 1 : one;
        const auto both = [&](const float *values) {
            return Lanes(hn::IfThenElse(isFirst, Lanes(values[one]).v, Lanes(values[other]).v));
        };
        const Lanes u = Lanes(cell.a) * (offset - both(cell.x)), v = Lanes(cell.c) * (offset - both(cell.y));
        const Lanes across = gaussianOf(u), entered = halfErfc(u, across);
        store(Lanes(hn::TableLookupLanes(entered.v, lower)), t.entered[k]);
        store(Lanes(hn::TableLookupLanes(across.v, lower)), t.across[k]);
        const float weight = k + 1 < n ? cell.weight[other] : 0.0f;
        const Lanes row = Lanes(hn::IfThenElse(isFirst, Lanes(cell.weight[one]).v, Lanes(weight).v)) * gaussianOf(v);
        store(row, t.row[k]);
        store(Lanes(-2) * v * row, t.fall[k]);
        if (k + 1 < n) {
            store(Lanes(hn::TableLookupLanes(entered.v, upper)), t.entered[k + 1]);
            store(Lanes(hn::TableLookupLanes(across.v, upper)), t.across[k + 1]);
        }
    }
}

/// Adds nodes whose tables fillPairs has filled. Sums of all rows stay in registers.
HWY_INLINE void addPairs(const FillTables &t, int n, FillCellSums &out)
{
    constexpr int vectors = cellSize / (2 * cellSide);
    Lanes density[vectors], along[vectors], down[vectors];
    for (int m = 0; m < vectors; ++m) {
        density[m] = load(out.density + m * 2 * cellSide);
        along[m] = load(out.slopeX + m * 2 * cellSide);
        down[m] = load(out.slopeY + m * 2 * cellSide);
    }
    const Mask isFirst = hn::FirstN(tag, cellSide);
    for (int k = 0; k < n; ++k) {
        const Lanes entered = load(t.entered[k]), across = load(t.across[k]);
        for (int m = 0; m < vectors; ++m) {
            const auto two = [&](const float *rows) {
                return Lanes(hn::IfThenElse(isFirst, Lanes(rows[2 * m]).v, Lanes(rows[2 * m + 1]).v));
            };
            const Lanes row = two(t.row[k]), fall = two(t.fall[k]);
            density[m] = mulAdd_(entered, row, density[m]);
            along[m] = mulAdd_(across, row, along[m]);
            down[m] = mulAdd_(entered, fall, down[m]);
        }
    }
    for (int m = 0; m < vectors; ++m) {
        store(density[m], out.density + m * 2 * cellSide);
        store(along[m], out.slopeX + m * 2 * cellSide);
        store(down[m], out.slopeY + m * 2 * cellSide);
    }
}

void fillCell(const FillCell &cell, FillCellSums &out)
{
    constexpr float inverseRootPi = 0.56418958f;
    alignas(64) float offsets[2 * cellSide], inside[cellSide], slope[cellSide];
    for (int i = 0; i < 2 * cellSide; ++i)
        offsets[i] = (float(i % cellSide) - 3.5f) * cell.step;
    fillBase(cell, offsets, inside, slope);
    const int lanes = int(hn::Lanes(tag));
    for (int at = 0; at < cellSize; at += lanes) {
        store(ofRow(inside, at), out.density + at);
        store(Lanes(0), out.slopeX + at);
        store(ofRow(slope, at), out.slopeY + at);
    }
    FillTables t;
    for (int first = 0; first < cell.nodes; first += chunk) {
        const int n = std::min(chunk, cell.nodes - first);
        if (cell.b == 0 && lanes == 2 * cellSide) {
            fillPairs(cell, offsets, first, n, t);
            addPairs(t, n, out);
            continue;
        }
        for (int k = 0; k < n; ++k) {
            const float x = cell.x[first + k], y = cell.y[first + k];
            fillRows(offsets, cell.c, y, cell.weight[first + k], t.row[k], t.fall[k]);
            for (int i = 0; i < cellSide && cell.b == 0; i += lanes) {
                const Lanes u = Lanes(cell.a) * (load(offsets + i) - Lanes(x)), across = gaussianOf(u);
                store(halfErfc(u, across), t.entered[k] + i);
                store(across, t.across[k] + i);
            }
        }
        for (int at = 0; at < cellSize; at += lanes) {
            Lanes density = load(out.density + at), along = load(out.slopeX + at), down = load(out.slopeY + at);
            const Lanes column = load(offsets + at % cellSide), line = ofRow(offsets, at);
            for (int k = 0; k < n; ++k) {
                const Lanes row = ofRow(t.row[k], at), fall = ofRow(t.fall[k], at);
                Lanes entered, across;
                if (cell.b == 0) {
                    entered = load(t.entered[k] + at % cellSide);
                    across = load(t.across[k] + at % cellSide);
                } else {
                    const Lanes u = Lanes(cell.a) * (column - Lanes(cell.x[first + k])) +
                                    Lanes(cell.b) * (line - Lanes(cell.y[first + k]));
                    across = gaussianOf(u);
                    entered = halfErfc(u, across);
                }
                density = mulAdd_(entered, row, density);
                along = mulAdd_(across, row, along);
                down = mulAdd_(entered, fall, down);
            }
            store(density, out.density + at);
            store(along, out.slopeX + at);
            store(down, out.slopeY + at);
        }
    }
    for (int at = 0; at < cellSize; at += lanes) { // from slopes by u and v to slopes by x and y
        const Lanes along = Lanes(inverseRootPi) * load(out.slopeX + at), down = load(out.slopeY + at);
        store(Lanes(cell.a) * along, out.slopeX + at);
        store(mulAdd_(Lanes(cell.b), along, Lanes(cell.c) * down), out.slopeY + at);
        store(min_(max_(load(out.density + at), Lanes(0)), Lanes(1)), out.density + at);
    }
}

} // namespace suffuse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

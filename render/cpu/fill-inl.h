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

/// ½erfc(−u), with a relative error of 1.2e-7 for u < 0: Chebyshev's fit of ln(erfc·e^(u²)/t), t = 1/(1 + |u|/2).
HWY_INLINE Lanes halfErfc(Lanes u)
{
    const Lanes size = abs_(u), t = reciprocal_(mulAdd_(Lanes(0.5), size, Lanes(1)));
    Lanes p(0.17087277);
    for (const double c :
         {-0.82215223, 1.48851587, -1.13520398, 0.27886807, -0.18628806, 0.09678418, 0.37409196, 1.00002368, -1.26551223})
        p = mulAdd_(p, t, Lanes(c));
    const Lanes tail = Lanes(0.5) * t * exp2Down(Lanes(log2e) * (p - size * size));
    return select_(less_(u, Lanes(0)), tail, Lanes(1) - tail);
}

/// Places of nodes that are in the cache at once.
struct alignas(64) FillTables {
    float entered[chunk][2 * cellSide]; // ½erfc(−u) of each column, twice
    float across[chunk][2 * cellSide];  // e^(−u²)
    float row[chunk][cellSide];         // weight · e^(−v²)
    float fall[chunk][cellSide];        // its slope by v
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
        const Lanes v = Lanes(c) * (load(offsets + i) - Lanes(y)), e = Lanes(weight) * exp2Down(Lanes(-log2e) * (v * v));
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
            store(Lanes(cell.eventJump[k]) * halfErfc(v), values[0]);
            store(Lanes(cell.eventJump[k] * 0.56418958f) * exp2Down(Lanes(-log2e) * (v * v)), values[1]);
            for (int j = 0; j < std::min(int(hn::Lanes(tag)), cellSide); ++j) {
                inside[i + j] += values[0][j];
                slope[i + j] += values[1][j];
            }
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
        for (int k = 0; k < n; ++k) {
            const float x = cell.x[first + k], y = cell.y[first + k];
            fillRows(offsets, cell.c, y, cell.weight[first + k], t.row[k], t.fall[k]);
            for (int i = 0; i < 2 * cellSide && cell.b == 0; i += lanes) {
                const Lanes u = Lanes(cell.a) * (load(offsets + i) - Lanes(x));
                store(halfErfc(u), t.entered[k] + i);
                store(exp2Down(Lanes(-log2e) * (u * u)), t.across[k] + i);
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
                    entered = halfErfc(u);
                    across = exp2Down(Lanes(-log2e) * (u * u));
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

// The procedural paper at blocks of samples. It is included once for each Highway target.
#if defined(SUFFUSE_RENDER_CPU_PAPER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_CPU_PAPER_INL_H
#undef SUFFUSE_RENDER_CPU_PAPER_INL_H
#else
#define SUFFUSE_RENDER_CPU_PAPER_INL_H
#endif

#include "render/cpu/block-inl.h"
#include "render/cpu/paper_plan.h"

HWY_BEFORE_NAMESPACE();
namespace suffuse::HWY_NAMESPACE {

using namespace suffuse::cpu;

inline constexpr hn::RebindToUnsigned<Tag> hashTag;
inline constexpr hn::RebindToSigned<Tag> latticeTag;
using Hash = hn::Vec<hn::RebindToUnsigned<Tag>>;

/// Where the samples in the columns of a block lie on a layer's lattice, in the first row of one of its two rows of
/// cells. They are measured in double from the first sample of their cell, so that floats have digits enough for the
/// rest, and a sample's bits do not depend on the block.
struct PaperColumns {
    alignas(64) float u[blockSide];
    alignas(64) float v[blockSide];
    alignas(64) std::uint32_t x[blockSide]; // the lattice point from which u and v count
    alignas(64) std::uint32_t y[blockSide];
    float nextU, nextV; // what they change by from row to row

    HWY_INLINE PaperColumns(const PaperLayer &layer, const Block &block, int firstRow)
        : nextU(float(layer.uy * block.step)), nextV(float(layer.vy * block.step))
    {
        const float columnU = float(layer.ux * block.step), columnV = float(layer.vx * block.step);
        for (int i = 0; i < blockSide; i += cellSide) {
            const double px = block.x + (i + 0.5) * block.step, py = block.y + (firstRow + 0.5) * block.step;
            const double atU = layer.u0 + layer.ux * px + layer.uy * py, wholeU = std::floor(atU);
            const double atV = layer.v0 + layer.vx * px + layer.vy * py, wholeV = std::floor(atV);
            for (int k = 0; k < cellSide; ++k) {
                u[i + k] = float(atU - wholeU) + float(k) * columnU;
                v[i + k] = float(atV - wholeV) + float(k) * columnV;
                x[i + k] = std::uint32_t(std::int64_t(wholeU));
                y[i + k] = std::uint32_t(std::int64_t(wholeV));
            }
        }
    }
    HWY_INLINE Vec rowU(int at, int row) const { return (load(u + at) + Lanes(float(row) * nextU)).v; }
    HWY_INLINE Vec rowV(int at, int row) const { return (load(v + at) + Lanes(float(row) * nextV)).v; }
};

HWY_INLINE Hash paperMixed(Hash z)
{
    z = hn::Xor(z, hn::ShiftRight<16>(z));
    z = hn::Mul(z, hn::Set(hashTag, 0x7FEB352Du));
    z = hn::Xor(z, hn::ShiftRight<15>(z));
    z = hn::Mul(z, hn::Set(hashTag, 0x846CA68Bu));
    return hn::Xor(z, hn::ShiftRight<16>(z));
}

/// What a lattice point adds at the offset (f, g) from it.
HWY_INLINE Vec paperCornerOf(Hash column, Hash row, Vec f, Vec g)
{
    const Hash h = paperMixed(hn::Xor(column, row));
    const auto gradient = [](Hash bits) {
        const Vec number = hn::ConvertTo(tag, hn::BitCast(latticeTag, bits));
        return hn::MulAdd(number, hn::Set(tag, 1.0f / 32768), hn::Set(tag, -1.0f));
    };
    const Vec a = gradient(hn::And(h, hn::Set(hashTag, 0xFFFFu))), b = gradient(hn::ShiftRight<16>(h));
    return hn::MulAdd(a, f, hn::Mul(b, g));
}

HWY_INLINE Vec paperFadeOf(Vec f)
{
    const Vec p = hn::MulAdd(f, hn::MulAdd(f, hn::Set(tag, 6.0f), hn::Set(tag, -15.0f)), hn::Set(tag, 10.0f));
    return hn::Mul(hn::Mul(hn::Mul(f, f), f), p);
}

/// The noise of a layer at a vector of samples.
HWY_INLINE Vec paperNoiseAt(const PaperLayer &layer, const PaperColumns &columns, int at, int row)
{
    const Vec u = columns.rowU(at, row), v = columns.rowV(at, row), left = hn::Floor(u), above = hn::Floor(v);
    const Vec one = hn::Set(tag, 1.0f), f = hn::Sub(u, left), g = hn::Sub(v, above);
    const auto whole = [](Vec n) { return hn::BitCast(hashTag, hn::ConvertTo(latticeTag, n)); };
    const Hash across = hn::Set(hashTag, 0xC2B2AE35u), down = hn::Set(hashTag, 0x27D4EB2Fu);
    const Hash x0 = hn::Mul(hn::Add(hn::Load(hashTag, columns.x + at), whole(left)), across);
    const Hash y0 = hn::Mul(hn::Add(hn::Load(hashTag, columns.y + at), whole(above)), down), y1 = hn::Add(y0, down);
    const Hash base = hn::Set(hashTag, layer.base);
    const Hash column0 = paperMixed(hn::Xor(base, x0)), column1 = paperMixed(hn::Xor(base, hn::Add(x0, across)));
    const Vec a = paperFadeOf(f), b = paperFadeOf(g), f1 = hn::Sub(f, one), g1 = hn::Sub(g, one);
    const Vec n00 = paperCornerOf(column0, y0, f, g), n10 = paperCornerOf(column1, y0, f1, g);
    const Vec n01 = paperCornerOf(column0, y1, f, g1), n11 = paperCornerOf(column1, y1, f1, g1);
    const Vec top = hn::MulAdd(hn::Sub(n10, n00), a, n00), bottom = hn::MulAdd(hn::Sub(n11, n01), a, n01);
    return hn::MulAdd(hn::Sub(bottom, top), b, top);
}

/// Calls use(at, row) for each vector of eight rows.
template <class Use>
HWY_INLINE void forEachInCells(Use use)
{
    for (int row = 0; row < cellSide; ++row)
        for (int at = 0; at < blockSide; at += int(hn::Lanes(tag)))
            use(at, row);
}

/// Threads over and under each other, less their mean.
HWY_INLINE void addWeave(const PaperPlan &plan, const Block &block, int firstRow, float *sum)
{
    const PaperColumns across(plan.weave[0], block, firstRow), along(plan.weave[1], block, firstRow);
    const PaperColumns threads(plan.weave[2], block, firstRow);
    const Vec one = hn::Set(tag, 1.0f), two = hn::Set(tag, 2.0f), waves = hn::Set(tag, plan.weave[0].share);
    forEachInCells([&](int at, int row) {
        const Vec s = hn::MulAdd(waves, paperNoiseAt(plan.weave[0], across, at, row), threads.rowU(at, row));
        const Vec t = hn::MulAdd(waves, paperNoiseAt(plan.weave[1], along, at, row), threads.rowV(at, row));
        const Vec column = hn::Floor(s), line = hn::Floor(t);
        const Vec p = hn::MulSub(two, hn::Sub(s, column), one), q = hn::MulSub(two, hn::Sub(t, line), one);
        const auto whole = [](Vec n) { return hn::BitCast(hashTag, hn::ConvertTo(latticeTag, n)); };
        const Hash place = hn::Add(hn::Add(hn::Load(hashTag, threads.x + at), whole(column)),
                                   hn::Add(hn::Load(hashTag, threads.y + at), whole(line)));
        // The lowest bit becomes the sign of ±1: odd places have the warp above.
        const Hash sign = hn::Xor(hn::ShiftLeft<31>(place), hn::Set(hashTag, 0x80000000u));
        const Vec over = hn::Or(hn::BitCast(tag, sign), one);
        const Vec a = hn::NegMulAdd(p, p, one), b = hn::NegMulAdd(q, q, one);
        const Vec warp = hn::Mul(a, hn::MulAdd(over, b, one)), weft = hn::Mul(b, hn::NegMulAdd(over, a, one));
        const Vec higher = hn::MulSub(hn::Set(tag, 0.5f), hn::Max(warp, weft), hn::Set(tag, 0.58f));
        float *out = sum + row * blockSide + at;
        store(Lanes(hn::NegMulAdd(hn::Set(tag, plan.weaveFactor), higher, load(out).v)), out);
    });
}

/// Long hairs, less their mean.
HWY_INLINE void addFibres(const PaperLayer &layer, const Block &block, int firstRow, float *sum)
{
    const PaperColumns columns(layer, block, firstRow);
    forEachInCells([&](int at, int row) {
        const Vec distance = hn::Abs(paperNoiseAt(layer, columns, at, row));
        const Vec hair = hn::Max(hn::NegMulAdd(hn::Set(tag, 12.0f), distance, hn::Set(tag, 1.0f)), hn::Zero(tag));
        float *out = sum + row * blockSide + at;
        store(Lanes(hn::NegMulAdd(hn::Set(tag, layer.share), hn::Sub(hair, hn::Set(tag, 0.19f)), load(out).v)), out);
    });
}

/// Writes η at the samples of a block.
void paper(const PaperPlan &plan, const Block &block, float *eta)
{
    for (int firstRow = 0; firstRow < blockSide; firstRow += cellSide) {
        float *rows = eta + firstRow * blockSide;
        forEachInCells([&](int at, int row) { store(Lanes(0), rows + row * blockSide + at); });
        for (const PaperLayer &layer : plan.octaves) {
            const PaperColumns columns(layer, block, firstRow);
            const Vec share = hn::Set(tag, plan.octavesFactor * layer.share);
            forEachInCells([&](int at, int row) {
                float *out = rows + row * blockSide + at;
                store(Lanes(hn::MulAdd(share, paperNoiseAt(layer, columns, at, row), load(out).v)), out);
            });
        }
        for (const PaperLayer &layer : plan.fibres)
            addFibres(layer, block, firstRow, rows);
        if (!plan.weave.empty())
            addWeave(plan, block, firstRow, rows);
        forEachInCells([&](int at, int row) {
            float *out = rows + row * blockSide + at;
            const Vec n = hn::Mul(load(out).v, hn::Set(tag, 1 / 1.5f));
            const Vec t = hn::Min(hn::Max(n, hn::Set(tag, -1.0f)), hn::Set(tag, 1.0f));
            const Vec hill = hn::MulAdd(hn::Mul(t, hn::NegMulAdd(t, t, hn::Set(tag, 3.0f))), hn::Set(tag, 0.25f),
                                        hn::Set(tag, 0.5f));
            store(Lanes(hn::NegMulAdd(hill, hn::Set(tag, plan.strength), hn::Set(tag, 1.0f))), out);
        });
    }
}

} // namespace suffuse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

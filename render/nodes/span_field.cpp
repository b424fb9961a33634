// Highway's foreach_target compiles this file once for each SIMD instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/nodes/span_field.cpp"
// Vectors have at most eight floats here, so these instruction sets would bring nothing.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3 | HWY_AVX3_DL)
#include "hwy/foreach_target.h" // It comes first, since it includes this file again for each set.

#include "hwy/highway.h"
#include "render/nodes/span_field.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace suffuse::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<float, 8>;
using Vec = hn::Vec<Tag>;
constexpr Tag tag;
using spans::reach;
// Products and sums are rounded one by one. Where a machine fused them into one instruction, its nodes would differ
// from those of others.

/// Writes out[i] = spans::gaussian(i, step, at) for i < count, a multiple of 4. Up to 8 are written at once, so
/// `out` must have room up to a multiple of 8.
HWY_INLINE void gaussians(float at, float step, int count, float *out)
{
    const hn::RebindToSigned<Tag> ints;
    const Vec half = hn::Set(tag, -0.5f);
    for (int i = 0; i < count; i += int(hn::Lanes(tag))) {
        // Nothing is computed where all would be left out below.
        if (float(i) * step - at > reach || at - float(i + int(hn::Lanes(tag)) - 1) * step > reach) {
            hn::Store(hn::Zero(tag), tag, out + i);
            continue;
        }
        const Vec d = hn::Sub(hn::Mul(hn::Iota(tag, float(i)), hn::Set(tag, step)), hn::Set(tag, at));
        const Vec x = hn::Max(hn::Mul(hn::Mul(hn::Set(tag, -1.44269504f), d), d), hn::Set(tag, -60.0f));
        const auto whole = hn::ConvertTo(ints, hn::Add(x, half)); // 2^x = 2^whole 2^f with |f| ≤ ½
        const Vec f = hn::Sub(x, hn::ConvertTo(tag, whole));
        Vec p = hn::Set(tag, 1.32647425e-3f);
        for (const float c : {9.671518e-3f, 5.55073376e-2f, 2.4022242e-1f, 6.93146978e-1f, 1.0f})
            p = hn::Add(hn::Mul(p, f), hn::Set(tag, c));
        const auto power = hn::ShiftLeft<23>(hn::Add(whole, hn::Set(ints, 127)));
        const Vec value = hn::Mul(p, hn::BitCast(tag, power));
        hn::Store(hn::IfThenElseZero(hn::Le(hn::Abs(d), hn::Set(tag, reach)), value), tag, out + i);
    }
}

/// Writes the Gaussians of nodes at the places `x` and `y`.
void fillAxes(const float *x, const float *y, int nodes, float step, int columns, int rows, SpanField::Table &column,
              SpanField::Table &row)
{
    for (int n = 0; n < nodes; ++n) {
        gaussians(x[n], step, columns, column[n]);
        gaussians(y[n], step, rows, row[n]);
    }
}

/// Calls use(row, column, sum) for each vector of the grid, where sum is start(row, column) + Σ_n row[n]·column[n].
/// Four rows are taken at a time.
template <class Start, class Use>
HWY_INLINE void forEachVector(const SpanField::Table &column, const SpanField::Table &row, int nodes, int columns,
                              int rows, Start start, Use use)
{
    for (int y = 0; y < rows; y += 4)
        for (int x = 0; x < columns; x += int(hn::Lanes(tag))) {
            Vec s0 = start(y, x), s1 = start(y + 1, x), s2 = start(y + 2, x), s3 = start(y + 3, x);
            for (int n = 0; n < nodes; ++n) {
                const Vec c = hn::Load(tag, column[n] + x);
                const float *r = row[n] + y;
                s0 = hn::Add(s0, hn::Mul(c, hn::Set(tag, r[0])));
                s1 = hn::Add(s1, hn::Mul(c, hn::Set(tag, r[1])));
                s2 = hn::Add(s2, hn::Mul(c, hn::Set(tag, r[2])));
                s3 = hn::Add(s3, hn::Mul(c, hn::Set(tag, r[3])));
            }
            use(y, x, s0), use(y + 1, x, s1), use(y + 2, x, s2), use(y + 3, x, s3);
        }
}

/// Adds Σ_n row[n]·column[n] to the plane or, if `first`, makes the plane that sum.
void addProducts(const SpanField::Table &column, const SpanField::Table &row, int nodes, int columns, int rows,
                 bool first, SpanField::Plane &plane)
{
    forEachVector(
        column, row, nodes, columns, rows,
        [&](int y, int x) { return first ? hn::Zero(tag) : hn::Load(tag, plane[y] + x); },
        [&](int y, int x, Vec sum) { hn::Store(sum, tag, plane[y] + x); });
}

/// Returns the greatest |plane + Σ_n row[n]·column[n]|.
float greatestRest(const SpanField::Table &column, const SpanField::Table &row, int nodes, int columns, int rows,
                   const SpanField::Plane &plane)
{
    Vec worst = hn::Zero(tag);
    forEachVector(
        column, row, nodes, columns, rows, [&](int y, int x) { return hn::Load(tag, plane[y] + x); },
        [&](int, int, Vec sum) { worst = hn::Max(worst, hn::Abs(sum)); });
    return hn::GetLane(hn::MaxOfLanes(tag, worst));
}

} // namespace suffuse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace suffuse {

HWY_EXPORT(fillAxes);
HWY_EXPORT(addProducts);
HWY_EXPORT(greatestRest);

void SpanField::fillTables(const SpanNode *nodes, int count)
{
    float x[batch], y[batch];
    for (int n = 0; n < count; ++n) {
        const double dx = nodes[n].x - m_x, dy = nodes[n].y - m_y;
        x[n] = float(dx * m_cos + dy * m_sin - m_left);
        y[n] = float(dy * m_cos - dx * m_sin - m_top);
    }
    HWY_DYNAMIC_DISPATCH(fillAxes)(x, y, count, m_step, m_columns, m_rows, m_column, m_row);
}

void SpanField::scaleRows(const SpanNode *nodes, int count, int sum)
{
    for (int n = 0; n < count; ++n) {
        const double value = sum == 0 ? 1 : 0.5 * nodes[n].values[m_varying.which[std::size_t(sum - 1)]];
        const float factor = float(nodes[n].weight * value);
        for (int i = 0; i < m_rows; ++i)
            m_scaled[n][i] = factor * m_row[n][i];
    }
}

void SpanField::start(const SpanNode *nodes, int count, const VaryingValues &varying)
{
    // A grid along the chord is smaller.
    m_x = nodes[0].x, m_y = nodes[0].y;
    const double chordX = nodes[count - 1].x - m_x, chordY = nodes[count - 1].y - m_y;
    const double chord = std::sqrt(chordX * chordX + chordY * chordY);
    m_cos = chord > 0 ? chordX / chord : 1;
    m_sin = chord > 0 ? chordY / chord : 0;
    double left = 0, right = 0, top = 0, bottom = 0;
    for (int i = 1; i < count; ++i) {
        const double dx = nodes[i].x - m_x, dy = nodes[i].y - m_y;
        const double x = dx * m_cos + dy * m_sin, y = dy * m_cos - dx * m_sin;
        left = std::min(left, x), right = std::max(right, x);
        top = std::min(top, y), bottom = std::max(bottom, y);
    }
    const spans::Grid grid(left, top, right, bottom);
    m_left = grid.left, m_top = grid.top;
    m_step = grid.step;
    m_columns = grid.columns, m_rows = grid.rows;
    m_sums = 1 + varying.count;
    m_varying = varying;
    for (int first = 0; first < count; first += batch) {
        const int n = std::min(batch, count - first);
        fillTables(nodes + first, n);
        for (int s = 0; s < m_sums; ++s) {
            scaleRows(nodes + first, n, s);
            HWY_DYNAMIC_DISPATCH(addProducts)(m_column, m_scaled, n, m_columns, m_rows, first == 0, m_field[s]);
        }
    }
}

float SpanField::difference(const SpanNode *nodes, int count)
{
    fillTables(nodes, count);
    float worst = 0;
    for (int s = 0; s < m_sums; ++s) {
        scaleRows(nodes, count, s);
        for (int n = 0; n < count; ++n)
            for (int i = 0; i < m_rows; ++i)
                m_scaled[n][i] = -m_scaled[n][i];
        worst = std::max(worst,
                         HWY_DYNAMIC_DISPATCH(greatestRest)(m_column, m_scaled, count, m_columns, m_rows, m_field[s]));
    }
    return worst;
}

} // namespace suffuse
#endif

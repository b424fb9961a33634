// Draws pixels with four samples each that are told from sums at the centres around (docs/solver.md, "Four samples from
// one"). It is included once for each Highway target.
#if defined(SUFFUSE_RENDER_CPU_TOLD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_CPU_TOLD_INL_H
#undef SUFFUSE_RENDER_CPU_TOLD_INL_H
#else
#define SUFFUSE_RENDER_CPU_TOLD_INL_H
#endif

#include "render/cpu/shading-inl.h"
// It has templates over the lanes, which must be declared before.
#include "render/math/bends.h"

HWY_BEFORE_NAMESPACE();
namespace suffuse::HWY_NAMESPACE {

using namespace suffuse::cpu;

/// Weights of density and of its slopes along x and y at nine pixels, which give a derivative at the first column of
/// the first (or middle) row. Exact for polynomials of fifth order, with the least sum of squares.
struct Stencil {
    float density[9], alongX[9], alongY[9];
};
/// Columns 0, 1, 2 of rows −1, 0, 1: at the side of a cell.
inline constexpr Stencil xySide = {
    {0.1388889f, -0.1666667f, 0.02777778f, 0, 0, 0, -0.1388889f, 0.1666667f, -0.02777778f},
    {-0.4907407f, 0.03703704f, 0.009259259f, 0, 0, 0, 0.4907407f, -0.03703704f, -0.009259259f},
    {0.287037f, -0.3888889f, 0.1018519f, -0.3518519f, 0.4444444f, -0.09259259f, 0.287037f, -0.3888889f, 0.1018519f}};
inline constexpr Stencil xxySide = {
    {1.083333f, -1.833333f, 0.75f, 0, 0, 0, -1.083333f, 1.833333f, -0.75f},
    {1.861111f, -0.5555556f, -0.6388889f, 0, 0, 0, -1.861111f, 0.5555556f, 0.6388889f},
    {-0.5833333f, 1.055556f, -0.4722222f, -1.333333f, 2.222222f, -0.8888889f, -0.5833333f, 1.055556f, -0.4722222f}};
inline constexpr Stencil xyySide = {
    {-0.3733333f, 0.08f, 0.2933333f, 0.7466667f, -0.16f, -0.5866667f, -0.3733333f, 0.08f, 0.2933333f},
    {0.7955556f, 0.2222222f, 0.3155556f, -1.591111f, -0.4444444f, -0.6311111f, 0.7955556f, 0.2222222f, 0.3155556f},
    {-0.01f, -0.48f, 0.49f, 0, 0, 0, 0.01f, 0.48f, -0.49f}};
/// Columns 0, 1, 2 of rows 0, 1, 2: in its corner.
inline constexpr Stencil xyCorner = {
    {-0.3211111f, 0.2533333f, 0.06777778f, 0.2533333f, 0.16f, -0.4133333f, 0.06777778f, -0.4133333f, 0.3455556f},
    {-1.091852f, 0.5925926f, -0.1118519f, 1.257778f, -0.8888889f, 0.2977778f, -0.1659259f, 0.2962963f, -0.1859259f},
    {-1.091852f, 1.257778f, -0.1659259f, 0.5925926f, -0.8888889f, 0.2962963f, -0.1118519f, 0.2977778f, -0.1859259f}};
inline constexpr Stencil xxyCorner = {
    {1.793333f, -2.253333f, 0.46f, -0.92f, -0.16f, 1.08f, -0.8733333f, 2.413333f, -1.54f},
    {3.267778f, -1.888889f, 0.2877778f, -2.813333f, 2.666667f, -1.853333f, -0.4544444f, -0.7777778f, 1.565556f},
    {0.24f, -0.5911111f, 0.3511111f, -2, 3.555556f, -1.555556f, -0.24f, 0.3688889f, -0.1288889f}};
inline constexpr Stencil xyyCorner = {
    {1.793333f, -0.92f, -0.8733333f, -2.253333f, -0.16f, 2.413333f, 0.46f, 1.08f, -1.54f},
    {0.24f, -2, -0.24f, -0.5911111f, 3.555556f, 0.3688889f, 0.3511111f, -1.555556f, -0.1288889f},
    {3.267778f, -2.813333f, -0.4544444f, -1.888889f, 2.666667f, -0.7777778f, 0.2877778f, -1.853333f, 1.565556f}};

/// Rows of the sums of a block, with room on both sides. Differences between neighbours are only taken within a cell,
/// so that they depend on no tile; what is computed across the sides is not used.
struct Plane {
    alignas(64) float v[boxRun + blockSize + boxRun];

    HWY_INLINE Plane() {}
    HWY_INLINE explicit Plane(const float *sums) { take(sums); }
    HWY_INLINE void take(const float *sums)
    {
        for (int at = 0; at < int(boxRun); at += int(hn::Lanes(tag))) {
            store(Lanes(0), v + at);
            store(Lanes(0), v + boxRun + blockSize + at);
        }
        for (int at = 0; at < blockSize; at += int(hn::Lanes(tag)))
            store(load(sums + at), v + boxRun + at);
    }
    HWY_INLINE Lanes at(int sample) const { return Lanes(hn::LoadU(tag, v + boxRun + sample)); }
};

/// The vector of samples that begins at the `at`-th of a block, and where they lie in their cells.
struct Place {
    int at;
    Mask first, last, side; ///< whether they lie in the first or the last column of their cell, or in one of both
    bool edge;              ///< whether in its first or its last row; the next rows within it are then
    int toNext;             ///< so many samples away each; else those below

    HWY_INLINE explicit Place(int from) : at(from)
    {
        const hn::RebindToSigned<Tag> intTag;
        const auto column = hn::And(hn::Iota(intTag, from), hn::Set(intTag, cellSide - 1));
        first = hn::RebindMask(tag, hn::Eq(column, hn::Zero(intTag)));
        last = hn::RebindMask(tag, hn::Eq(column, hn::Set(intTag, cellSide - 1)));
        side = or_(first, last);
        const int row = from / blockSide % cellSide;
        edge = row == 0 || row == cellSide - 1;
        toNext = row == cellSide - 1 ? -blockSide : blockSide;
    }
    /// 1 at the beginning of a cell, −1 at its end.
    HWY_INLINE float down() const { return toNext > 0 ? 1.0f : -1.0f; }
    HWY_INLINE Lanes right() const { return select_(last, Lanes(-1), Lanes(1)); }
    /// The sample one (or two) further into the cell.
    HWY_INLINE Lanes beside(const Plane &p, int steps) const
    {
        return select_(last, p.at(at - steps), p.at(at + steps));
    }
};

/// The slope along x at a cell's samples, to second order, and along y.
HWY_INLINE Lanes slopeAlongX(const Plane &p, const Place &place)
{
    const Lanes within = p.at(place.at + 1) - p.at(place.at - 1);
    const Lanes ahead = Lanes(4) * place.beside(p, 1) - Lanes(3) * p.at(place.at) - place.beside(p, 2);
    return Lanes(0.5) * select_(place.side, place.right() * ahead, within);
}
HWY_INLINE Lanes slopeAlongY(const Plane &p, const Place &place)
{
    const int at = place.at, next = place.toNext;
    if (!place.edge)
        return Lanes(0.5) * (p.at(at + blockSide) - p.at(at - blockSide));
    return Lanes(0.5f * place.down()) * (Lanes(4) * p.at(at + next) - Lanes(3) * p.at(at) - p.at(at + 2 * next));
}

/// Density and its slopes at nine pixels, as a stencil wants them.
struct Nine {
    Lanes density[9], alongX[9], alongY[9];

    HWY_INLINE Nine() {} // It is compiled for the target, while the implicit one is not.
    HWY_INLINE Lanes operator()(const Stencil &s) const
    {
        Lanes sum(0);
        for (int k = 0; k < 9; ++k) {
            sum = s.density[k] == 0 ? sum : mulAdd_(Lanes(s.density[k]), density[k], sum);
            sum = s.alongX[k] == 0 ? sum : mulAdd_(Lanes(s.alongX[k]), alongX[k], sum);
            sum = s.alongY[k] == 0 ? sum : mulAdd_(Lanes(s.alongY[k]), alongY[k], sum);
        }
        return sum;
    }
};

/// Density and its slopes (−½∂φ/∂x, −½∂φ/∂y) at the pixels of a block, and how they bend. Polynomials of fifth order
/// through the densities and slopes of three pixels in a row are exact to φ⁽⁶⁾/90 at the sides of a cell.
struct Bending {
    Plane density, slopeX, slopeY;

    HWY_INLINE explicit Bending(const Sums &sums) : density(sums.v[0]), slopeX(sums.v[1]), slopeY(sums.v[2]) {}

    HWY_INLINE Bent<Lanes> at(const Place &place) const
    {
        const Lanes zero(0);
        const Lanes alongY = slopeAlongY(slopeX, place), alongX = slopeAlongX(slopeY, place);
        // Where one of the two is less exact the other one counts.
        const Lanes mean = Lanes(0.5) * (alongX + alongY);
        const Lanes twist = place.edge ? select_(place.side, mean, alongX) : select_(place.side, alongY, mean);
        return {density.at(place.at),
                slopeX.at(place.at),
                slopeY.at(place.at),
                xx(place),
                Lanes(-0.5) * twist,
                yy(place),
                zero,
                zero,
                zero,
                zero};
    }
    /// Finds the third derivatives, and the mixed second one anew, to third order everywhere.
    HWY_INLINE void refine(const Place &place, Bent<Lanes> &bent) const
    {
        bent.xxx = xxx(place), bent.yyy = yyy(place);
        Lanes xy, xxy, xyy;
        if (place.edge) {
            const Lanes sign(place.down());
            const Nine side = acrossRows(place), corner = ahead(place, place.toNext, 0);
            const auto choose = [&](Lanes atSide, Lanes within) { return select_(place.side, atSide, within); };
            xy = sign * choose(place.right() * corner(xyCorner), side(xySide));
            xxy = sign * choose(corner(xxyCorner), side(xyySide));
            xyy = choose(place.right() * corner(xyyCorner), side(xxySide));
        } else {
            const int at = place.at, up = at - blockSide, down = at + blockSide;
            const Nine side = ahead(place, blockSide, -blockSide);
            const Lanes crossed = density.at(down + 1) - density.at(down - 1) - density.at(up + 1) + density.at(up - 1);
            const Lanes within =
                slopeX.at(up) - slopeX.at(down) + slopeY.at(at - 1) - slopeY.at(at + 1) - Lanes(0.25) * crossed;
            const auto bend = [at](const Plane &p, int by) {
                return Lanes(4) * p.at(at) - Lanes(2) * (p.at(at + by) + p.at(at - by));
            };
            xy = select_(place.side, place.right() * side(xySide), within);
            xxy = select_(place.side, side(xxySide), bend(slopeY, 1));
            xyy = select_(place.side, place.right() * side(xyySide), bend(slopeX, blockSide));
        }
        bent.xy = Lanes(0.25) * xy, bent.xxy = xxy, bent.xyy = xyy;
    }

private:
    /// Three columns into the cell, of the three rows that begin at `first` rows' samples from the place, `step` apart.
    HWY_INLINE Nine ahead(const Place &place, int step, int first) const
    {
        Nine nine;
        const Lanes right = Lanes(-2) * place.right(), down(step > 0 ? -2.0f : 2.0f);
        for (int k = 0; k < 9; ++k) {
            const int by = first + k / 3 * step, steps = k % 3;
            const auto value = [&](const Plane &p) {
                return select_(place.last, p.at(place.at + by - steps), p.at(place.at + by + steps));
            };
            nine.density[k] = value(density);
            nine.alongX[k] = right * value(slopeX);
            nine.alongY[k] = down * value(slopeY);
        }
        return nine;
    }
    /// Three rows into the cell, of the columns before, at and behind the place; x and y are exchanged.
    HWY_INLINE Nine acrossRows(const Place &place) const
    {
        Nine nine;
        const Lanes down(place.toNext > 0 ? -2.0f : 2.0f);
        for (int k = 0; k < 9; ++k) {
            const int from = place.at + k / 3 - 1 + k % 3 * place.toNext;
            nine.density[k] = density.at(from);
            nine.alongX[k] = down * slopeY.at(from);
            nine.alongY[k] = Lanes(-2) * slopeX.at(from);
        }
        return nine;
    }
    static HWY_INLINE Lanes weighted(Lanes a, float ka, Lanes b, float kb, Lanes c, float kc)
    {
        return mulAdd_(Lanes(ka), a, mulAdd_(Lanes(kb), b, Lanes(kc) * c));
    }
    HWY_INLINE Lanes xx(const Place &place) const
    {
        const int at = place.at;
        const Plane &f = density, &g = slopeX;
        const Lanes own = f.at(at), right = f.at(at + 1), left = f.at(at - 1);
        const Lanes within = mulAdd_(Lanes(0.5), g.at(at + 1) - g.at(at - 1), right + left - Lanes(2) * own);
        const Lanes slopes = weighted(g.at(at), 6, place.beside(g, 1), 8, place.beside(g, 2), 1);
        const Lanes ahead = weighted(own, -5.75f, place.beside(f, 1), 4, place.beside(f, 2), 1.75f);
        return select_(place.side, mulAdd_(place.right(), slopes, ahead), within);
    }
    HWY_INLINE Lanes yy(const Place &place) const
    {
        const int at = place.at, next = place.toNext;
        const Plane &f = density, &g = slopeY;
        if (!place.edge)
            return mulAdd_(Lanes(0.5), g.at(at + blockSide) - g.at(at - blockSide),
                           f.at(at + blockSide) + f.at(at - blockSide) - Lanes(2) * f.at(at));
        const Lanes slopes = weighted(g.at(at), 6, g.at(at + next), 8, g.at(at + 2 * next), 1);
        return mulAdd_(Lanes(place.down()), slopes,
                       weighted(f.at(at), -5.75f, f.at(at + next), 4, f.at(at + 2 * next), 1.75f));
    }
    HWY_INLINE Lanes xxx(const Place &place) const
    {
        const int at = place.at;
        const Plane &f = density, &g = slopeX;
        const Lanes within =
            mulAdd_(Lanes(7.5), f.at(at + 1) - f.at(at - 1), weighted(g.at(at - 1), 3, g.at(at), 24, g.at(at + 1), 3));
        const Lanes slopes = weighted(g.at(at), -39, place.beside(g, 1), -96, place.beside(g, 2), -15);
        const Lanes ahead = weighted(f.at(at), 49.5f, place.beside(f, 1), -24, place.beside(f, 2), -25.5f);
        return select_(place.side, mulAdd_(place.right(), ahead, slopes), within);
    }
    HWY_INLINE Lanes yyy(const Place &place) const
    {
        const int at = place.at, next = place.toNext;
        const Plane &f = density, &g = slopeY;
        if (!place.edge)
            return mulAdd_(Lanes(7.5), f.at(at + blockSide) - f.at(at - blockSide),
                           weighted(g.at(at - blockSide), 3, g.at(at), 24, g.at(at + blockSide), 3));
        const Lanes slopes = weighted(g.at(at), -39, g.at(at + next), -96, g.at(at + 2 * next), -15);
        return mulAdd_(Lanes(place.down()),
                       weighted(f.at(at), 49.5f, f.at(at + next), -24, f.at(at + 2 * next), -25.5f), slopes);
    }
};

/// Pixels of a block that are shaded by four samples each: their places, their sums and how these bend, side by side.
struct Told {
    int count = 0;
    alignas(64) std::int32_t at[blockSize + boxRun];
    alignas(64) float sums[fixedSums + maxChannels][blockSize + boxRun];
    alignas(64) float bends[7][blockSize + boxRun];                ///< xx, xy, yy, xxx, xxy, xyy, yyy
    alignas(64) float slopes[2 * maxChannels][blockSize + boxRun]; ///< −½ of the slopes of each channel
    alignas(64) float eta[4][blockSize + boxRun];
    int vectors = 0;
    Mask which[blockSize]; ///< the pixels of each vector from which some are taken,
    int from[blockSize];   ///< and where that begins

    /// Adds pixels of the vector at a place.
    HWY_INLINE void add(Mask added, const Place &place, const Bending &bending, Bent<Lanes> bent,
                        const float (*etaOfSamples)[blockSize])
    {
        bending.refine(place, bent);
        const hn::RebindToSigned<Tag> intTag;
        hn::StoreU(hn::Compress(hn::Iota(intTag, place.at), hn::RebindMask(intTag, added)), intTag, at + count);
        const Lanes fixed[fixedSums] = {bent.density, bent.slopeX, bent.slopeY};
        for (int i = 0; i < fixedSums; ++i)
            pack(fixed[i], added, sums[i]);
        const Lanes higher[7] = {bent.xx, bent.xy, bent.yy, bent.xxx, bent.xxy, bent.xyy, bent.yyy};
        for (int i = 0; i < 7; ++i)
            pack(higher[i], added, bends[i]);
        for (int i = 0; i < 4 && etaOfSamples; ++i)
            pack(load(etaOfSamples[i] + place.at), added, eta[i]);
        which[vectors] = added, from[vectors++] = place.at;
        count += int(hn::CountTrue(tag, added));
    }
    /// Adds the channels of all pixels that were added.
    HWY_INLINE void addChannels(const Sums &of, int channels)
    {
        const int all = count;
        for (int c = 0; c < channels; ++c) {
            const Plane channel(of.v[fixedSums + c]);
            count = 0;
            for (int i = 0; i < vectors; ++i) {
                const Place place(from[i]);
                pack(channel.at(place.at), which[i], sums[fixedSums + c]);
                pack(Lanes(-0.5) * slopeAlongX(channel, place), which[i], slopes[2 * c]);
                pack(Lanes(-0.5) * slopeAlongY(channel, place), which[i], slopes[2 * c + 1]);
                count += int(hn::CountTrue(tag, which[i]));
            }
        }
        count = all;
    }

private:
    HWY_INLINE void pack(Lanes v, Mask added, float *to) const
    {
        hn::StoreU(hn::Compress(v.v, added), tag, to + count);
    }
};

/// What γ is at the samples of pixels.
HWY_INLINE Range<Lanes> gammaOf(const ShadeParams &params, const float (*eta)[blockSize], int at)
{
    if (!eta)
        return {Lanes(1), Lanes(1)};
    const auto sample = [&](int i) { return load(eta[i] + at); };
    const Lanes low = min_(min_(sample(0), sample(1)), min_(sample(2), sample(3)));
    if (params.grainChannel >= 0)
        return {low, Lanes(1)};
    const Lanes high = max_(max_(sample(0), sample(1)), max_(sample(2), sample(3)));
    const Lanes grain(params.grain), rest = Lanes(1) - grain;
    return {mulAdd_(rest, low, grain), mulAdd_(rest, high, grain)};
}

/// Finds the pixels of level 1 that can be told from centres, and sets their marks to 0. For those that one sample does
/// for it raises the density in `sums` as that needs, and the others go to `out`. Where the sums are not to be shaded
/// as they are then, the density becomes 0. Returns whether marks are left.
template <class Style>
HWY_INLINE bool tell(const Style &style, const ShadeParams &params, int channels, Sums &sums,
                     const float (*eta)[blockSize], std::uint8_t *marks, Told &out)
{
    constexpr float most = 5e-4f, mostOfOne = 3e-4f; // of opacity; they are bounds, and most pixels lie far below
    // One sample does not tell how the paper changes, or a colour.
    const Lanes limitOfOne(eta || params.colourChannel >= 0 || params.lineChannel >= 0 ? -1.0f : mostOfOne);
    const hn::Rebind<std::uint8_t, Tag> byteTag;
    const hn::RebindToSigned<Tag> intTag;
    const Bending bending(sums);
    bool left = false;
    for (int at = 0; at < blockSize; at += int(hn::Lanes(tag))) {
        const Lanes mark(hn::ConvertTo(tag, hn::PromoteTo(intTag, hn::LoadU(byteTag, marks + at))));
        const Mask marked = less_(Lanes(0), mark);
        if (hn::AllFalse(tag, marked))
            continue;
        const Mask first = and_(less_(Lanes(levelQuarters - 0.5f), mark), less_(mark, Lanes(2 * levelQuarters - 0.5f)));
        const Place place(at);
        const Bent<Lanes> bent = bending.at(place);
        // s ≥ 4·2^(−(quarter + 1)/4)
        const Lanes spread = exp2_(Lanes(3 - 1.0f / levelQuarters) - Lanes(1.0f / levelQuarters) * mark);
        const Doubt<Lanes> doubt = doubtAbout(style, bent, spread, gammaOf(params, eta, at));
        const Mask shows = less_(Lanes(style.level()), doubt.high);
        Mask told = and_(first, or_(not_(shows), less_(doubt.four, Lanes(most))));
        if (params.fadeChannel >= 0) // Where paint is made paler each sample is looked at.
            told = and_(told, not_(less_(Lanes(0), load(sums.v[fixedSums + params.fadeChannel] + at))));
        const Mask one = and_(told, and_(shows, less_(doubt.one, limitOfOne)));
        const Mask four = and_(told, and_(shows, not_(one)));
        if (!hn::AllFalse(tag, four))
            out.add(four, place, bending, bent, eta);
        Lanes lifted(0);
        if (params.laidChannel >= 0) {
            const Lanes laid = load(sums.v[fixedSums + params.laidChannel] + at);
            lifted = min_(max_(Lanes(2) * (laid - bent.density) * inverseDensity(laid), Lanes(0)), Lanes(1));
        }
        const Lanes raised = select_(one, bent.density + riseOf(style, bent, lifted), Lanes(0));
        store(select_(marked, raised, bent.density), sums.v[0] + at);
        const Mask kept = or_(one, not_(marked));
        store(select_(kept, bent.slopeX, Lanes(0)), sums.v[1] + at);
        store(select_(kept, bent.slopeY, Lanes(0)), sums.v[2] + at);
        const auto leftMarks = hn::IfThenZeroElse(told, mark.v);
        hn::StoreU(hn::DemoteTo(byteTag, hn::ConvertTo(intTag, leftMarks)), byteTag, marks + at);
        left |= !hn::AllFalse(tag, hn::AndNot(told, marked));
    }
    if (out.count > 0)
        out.addChannels(sums, channels);
    return left;
}

/// Puts the sums at one of the four samples of each pixel into `out`.
HWY_INLINE void sampleOf(const Told &told, int channels, float right, float down, Sums &out)
{
    const Lanes x(right), y(down);
    for (int at = 0; at < told.count; at += int(hn::Lanes(tag))) {
        const auto sum = [&](int i) { return load(told.sums[i] + at); };
        const auto bend = [&](int i) { return load(told.bends[i] + at); };
        const Bent<Lanes> bent{sum(0), sum(1), sum(2), bend(0), bend(1), bend(2), bend(3), bend(4), bend(5), bend(6)};
        store(bent.densityAt(x, y), out.v[0] + at);
        store(bent.slopeXAt(x, y), out.v[1] + at);
        store(bent.slopeYAt(x, y), out.v[2] + at);
        for (int c = 0; c < channels; ++c) {
            const Lanes centre = sum(fixedSums + c);
            const Lanes slope = x * load(told.slopes[2 * c] + at) + y * load(told.slopes[2 * c + 1] + at);
            // A quarter of it is left at least, of all channels, where Gaussians are cut off.
            store(max_(mulAdd_(Lanes(-0.5), slope, centre), Lanes(0.25) * centre), out.v[fixedSums + c] + at);
        }
    }
}

/// Computes opacity and colour of the pixels as means over their samples.
HWY_INLINE void shadeTold(const ShadeParams &params, int channels, const Told &told, bool paper, Shaded &out)
{
    alignas(64) Sums sample;
    alignas(64) Shaded total;
    std::memset(&total, 0, sizeof total);
    for (int i = 0; i < 4; ++i) {
        sampleOf(told, channels, i % 2 ? 1.0f : -1.0f, i / 2 ? 1.0f : -1.0f, sample);
        shadeBlock(
            params, sample, paper ? told.eta[i] : nullptr, 0.5f,
            [&](int at, const Paint<Lanes> &paint) {
                const Lanes colour[3] = {paint.red, paint.yellow, paint.blue};
                store(load(total.w + at) + paint.w, total.w + at);
                for (int c = 0; c < 3; ++c)
                    store(mulAdd_(paint.w, colour[c], load(total.colour[c] + at)), total.colour[c] + at);
            },
            told.count);
    }
    for (int i = 0; i < told.count; ++i) {
        const float w = total.w[i], inverse = w > 0 ? 1 / w : 0;
        out.w[told.at[i]] = 0.25f * w;
        for (int c = 0; c < 3; ++c)
            out.colour[c][told.at[i]] = total.colour[c][i] * inverse;
    }
}

} // namespace suffuse::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

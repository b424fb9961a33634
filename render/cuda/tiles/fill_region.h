// Which parts of a fill's boundary count around some samples (docs/cuda.md, "Fills").
#pragma once

#include "render/cuda/tiles/tile_nodes.h"

namespace suffuse::cuda {

/// The rectangle in which parts of the boundary are summed up by their nodes, in 1/fillUnits px of the picture. What
/// lies right of it, above or below adds nothing, and what lies left of it adds a function of y alone.
struct FillRegion {
    std::int32_t left, top, right, bottom;
};

/// Returns the region of a block of samples that is side·step px wide around (x, y), seen from a tile's centre.
SUFFUSE_PROGRAM FillRegion fillRegion(const FillValues &fill, std::int32_t cellX, std::int32_t cellY, float x = 0,
                                      float y = 0, float step = 1)
{
    constexpr std::int32_t cell = tileSide * fillUnits, half = cell / 2;
    const std::int32_t middleX = cellX * cell + half + std::int32_t(x * float(fillUnits));
    const std::int32_t middleY = cellY * cell + half + std::int32_t(y * float(fillUnits));
    const std::int32_t side = std::int32_t(step * float(half)) + 1;
    return {middleX - side - fill.reachX, middleY - side - fill.reachY, middleX + side + fill.reachX,
            middleY + side + fill.reachY};
}

/// The ends of a panel or flat, as in FillRecord.
struct FillEnds {
    std::int32_t x0, y0, x1, y1, kind;
};
SUFFUSE_PROGRAM FillEnds endsOf(const FillRecord &r)
{
    return {r.x0, r.y0, r.x1, r.y1, r.kind};
}

/// What a record is for a region; some of these together.
enum FillUse : std::uint32_t {
    besideFill = 1,   ///< It lies at the region's heights, and not right of it.
    metFill = 2,      ///< It meets the region.
    listedFill = 4,   ///< It is a node that is summed.
    fillEvent = 8,    ///< Its panel ends left of the region: there begins or ends what other panels tell,
    fillFalls = 16,   ///< at the lower end instead of the upper one.
    enteredFill = 32, ///< Its panel lies left of the region, and crosses its upper border: the area begins,
    leftFill = 64     ///< or ends there.
};

/// Says what a record is for a region. A level line is crossed by panels left of the region, and by those that meet it.
/// The first are counted on the region's upper border alone. Further down their number changes only where a panel of
/// the others takes over, or hands over: at its end, if that lies left of the region. Flats that cross the left border
/// change it, too. Panels that follow each other have the same ends, and so all of this holds whatever becomes of it.
SUFFUSE_PROGRAM std::uint32_t useOf(const FillEnds &r, const FillRegion &g)
{
    const std::int32_t least = r.x0 < r.x1 ? r.x0 : r.x1, most = r.x0 < r.x1 ? r.x1 : r.x0;
    if ((r.kind & 255) == 0 || r.y1 <= g.top || r.y0 > g.bottom || least > g.right)
        return 0;
    const bool tells = (r.kind & fillTells) != 0, flat = (r.kind & fillFlat) != 0;
    if (most < g.left) {
        if (!tells || flat || r.y0 > g.top)
            return besideFill;
        return besideFill | (r.kind > 0 ? enteredFill : leftFill);
    }
    std::uint32_t use = besideFill | metFill;
    if (r.kind & fillNode)
        use |= listedFill;
    if (tells && r.x0 < g.left && (flat || r.y0 > g.top))
        use |= fillEvent;
    else if (tells && !flat && r.x1 < g.left)
        use |= fillEvent | fillFalls;
    return use;
}

/// What begins (+1) or ends at a record's event.
SUFFUSE_PROGRAM float jumpOf(std::int32_t kind, std::uint32_t use)
{
    const float jump = float(kind >> 8); // It is negative where the kind is, whose lower bits are its flags.
    return (kind & fillFlat) || (use & fillFalls) ? jump : -jump;
}

/// Tells whether a stroke needs several samples at some pixels.
SUFFUSE_PROGRAM bool isSupersampled(const StrokeRecord &stroke)
{
    return stroke.small != 0 || (stroke.fill & thinFill) != 0;
}

/// Reads a record of a fill from where nodes lie.
SUFFUSE_PROGRAM FillRecord readFillRecord(const NodeRecord *from)
{
    FillRecord record;
    const auto *parts = reinterpret_cast<const Float4 *>(from);
    SUFFUSE_UNROLL
    for (int part = 0; part < int(sizeof(FillRecord) / sizeof(Float4)); ++part)
        reinterpret_cast<Float4 *>(&record)[part] = parts[part];
    return record;
}

} // namespace suffuse::cuda

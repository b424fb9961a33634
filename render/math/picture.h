// A picture seen at a pixel (docs/solver.md, "Pictures").
#pragma once

#include "render/math/picture_view.h"
#include "render/math/scalar.h"
// It has templates over the numbers, which must be declared before.
#include "render/math/blend.h"

namespace suffuse {

namespace math {

/// Premultiplied values.
struct PictureSum {
    float c[4] = {0, 0, 0, 0};
};

/// Adds a share of a level's value at a place, bilinear between the centres of its pixels. Beyond its edge it is as at
/// the edge.
SUFFUSE_INLINE void addLevel(const PictureLevel &level, double u, double v, float share, PictureSum &sum)
{
    const double x = min_(max_(u - 0.5, -1.0), double(level.width));
    const double y = min_(max_(v - 0.5, -1.0), double(level.height));
    const int column = int(x + 1) - 1, row = int(y + 1) - 1; // rounded down: both are at least −1
    const float fx = float(x - column), fy = float(y - row);
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            const int atX = column + i < 0 ? 0 : column + i < level.width ? column + i : level.width - 1;
            const int atY = row + j < 0 ? 0 : row + j < level.height ? row + j : level.height - 1;
            const std::uint16_t *from = level.rgba + 4 * (std::int64_t(atY) * level.width + atX);
            const float weight = share * (i ? fx : 1 - fx) * (j ? fy : 1 - fy);
            for (int c = 0; c < 4; ++c)
                sum.c[c] = mulAdd_(weight, float(from[c]), sum.c[c]);
        }
}

/// What a stroke of opacity w shows of its picture at the pixel around (x, y).
struct PicturePaint {
    float w, red, yellow, blue;
};
SUFFUSE_INLINE PicturePaint shown(const PictureView &picture, double x, double y, float w)
{
    const double u = picture.u + picture.ux * x + picture.uy * y, v = picture.v + picture.vx * x + picture.vy * y;
    PictureSum sum;
    addLevel(picture.finer, u, v, 1 - picture.share, sum);
    if (picture.share > 0)
        addLevel(picture.coarser, 0.5 * u, 0.5 * v, picture.share, sum);
    const float most = 65535, alpha = sum.c[3], inverse = 1 / max_(alpha, 1e-3f);
    float rgb[3];
    for (int c = 0; c < 3; ++c)
        rgb[c] = min_(1.0f, sum.c[c] * inverse);
    const Triple<float> ryb = rybFromRgb(rgb[0], rgb[1], rgb[2]);
    return {w * min_(1.0f, alpha / most), ryb.x, ryb.y, ryb.z};
}

} // namespace math
} // namespace suffuse

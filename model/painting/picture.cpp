#include "model/painting/picture.h"

namespace suffuse {

Affine mapOf(const Picture &picture)
{
    const Point corner = Point() + picture.corner;
    const Point across = (1.0 / picture.width) * (Point() + picture.right - corner);
    const Point down = (1.0 / picture.height) * (Point() + picture.down - corner);
    return {across.x, down.x, across.y, down.y, corner};
}

Picture mapped(Picture picture, const Affine &map)
{
    for (Offset *o : {&picture.corner, &picture.right, &picture.down})
        *o = toOffset(map(Point() + *o), {});
    return picture;
}

} // namespace suffuse

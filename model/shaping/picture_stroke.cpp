#include "model/shaping/picture_stroke.h"

namespace suffuse {

Stroke pictureStroke(Picture picture, const Affine &place, Microseconds seen)
{
    constexpr float age = 1e-3f; // It does not spread, so any age will do.
    const double w = picture.width, h = picture.height;
    const std::array<Point, 4> corners{place({0, 0}), place({w, 0}), place({w, h}), place({0, h})};
    Stroke stroke;
    stroke.origin = corners[0];
    const auto offset = [&](std::size_t corner) { return toOffset(corners[corner % 4], stroke.origin); };
    Fill fill;
    fill.diffusion = 0;
    fill.density = 4; // far above where the style lets anything through
    fill.maxAge = age;
    fill.born = seen - toMicroseconds(double(age));
    for (std::size_t k = 0; k < 4; ++k) {
        Segment side;
        const Point from = Point() + offset(k), to = Point() + offset(k + 1);
        side.bezier = {offset(k), toOffset(from + (1.0 / 3) * (to - from), {}),
                       toOffset(from + (2.0 / 3) * (to - from), {}), offset(k + 1)};
        side.density = 0; // It bounds the fill, and lays no paint.
        side.maxAge = age;
        side.born = fill.born;
        side.node = NodeKind::Corner;
        stroke.segments.push_back(side);
    }
    stroke.fill = fill;
    picture.corner = offset(0), picture.right = offset(1), picture.down = offset(3);
    stroke.picture = std::move(picture);
    return stroke;
}

Stroke pictureStroke(Picture picture, const Rect &area, Microseconds seen)
{
    const Affine place{area.width() / picture.width, 0, 0, area.height() / picture.height, {area.left, area.top}};
    return pictureStroke(std::move(picture), place, seen);
}

Picture embeddedPicture(EncodedImage image, int width, int height)
{
    Picture picture;
    picture.sha256 = sha256Of(*image);
    picture.image = std::move(image);
    picture.width = std::uint32_t(width), picture.height = std::uint32_t(height);
    picture.right = {float(width), 0}, picture.down = {0, float(height)};
    return picture;
}

Picture inProportion(Picture picture)
{
    const Affine map = mapOf(picture);
    const Point across = map.turned({1, 0});
    const double side = map.determinant() < 0 ? -1 : 1; // A mirrored one stays mirrored.
    picture.down = toOffset(Point() + picture.corner + side * picture.height * Point{-across.y, across.x}, {});
    return picture;
}

} // namespace suffuse

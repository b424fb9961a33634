#include "render/picture_grid.h"

#include <cmath>

namespace suffuse {

namespace {

/// The greatest coordinate, in pixels, for which doubles have digits enough for steps of 2^-20 pixels and some more.
constexpr double farthest = (1 << 30) - 2 * PictureGrid::windowStep;
constexpr double stepsPerPixel = 1 << 20;

/// One coordinate of the picture's corner: a whole number of pixels, and the rest in steps.
struct Corner {
    double whole, rest;

    explicit Corner(double at) : whole(std::floor(at)), rest(std::round((at - whole) * stepsPerPixel) / stepsPerPixel)
    {
        if (rest == 1)
            ++whole, rest = 0;
    }
};

/// The multiple of `windowStep` below.
int below(int pixel)
{
    const int step = PictureGrid::windowStep;
    return pixel >= 0 ? pixel / step * step : -((-pixel + step - 1) / step * step);
}

PixelRect windowAround(const PixelRect &picture)
{
    const int left = below(picture.x), top = below(picture.y);
    return {left, top, -below(-picture.x - picture.width) - left, -below(-picture.y - picture.height) - top};
}

} // namespace

PictureGrid PictureGrid::ofPicture(const View &view)
{
    const PixelRect picture{0, 0, view.width, view.height};
    return {view, picture, picture};
}

PictureGrid PictureGrid::ofDocument(const View &view)
{
    View grid = view;
    grid.centre = {};
    grid.width = grid.height = 0;
    const Point corner = grid.toPixels(view.centre) - Point{0.5 * view.width, 0.5 * view.height};
    // Both corners must be whole numbers with some room around them.
    if (!(std::abs(corner.x) < farthest && std::abs(corner.y) < farthest && corner.x + view.width < 2 * farthest &&
          corner.y + view.height < 2 * farthest))
        return ofPicture(view);
    const Corner x(corner.x), y(corner.y);
    grid.centre = grid.toCanvas({x.rest, y.rest});
    const PixelRect picture{int(x.whole), int(y.whole), view.width, view.height};
    return {grid, picture, windowAround(picture)};
}

PictureGrid PictureGrid::part(const PixelRect &pixels, const PixelRect &near) const
{
    const auto inGrid = [this](const PixelRect &r) {
        return PixelRect{picture.x + r.x, picture.y + r.y, r.width, r.height};
    };
    return {view, inGrid(pixels), windowAround(inGrid(near.isEmpty() ? pixels : near))};
}

} // namespace suffuse

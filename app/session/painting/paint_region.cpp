#include "app/session/painting/paint_region.h"

#include "model/area/mask.h"
#include "render/backends.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr double mostPixels = 2e6;
constexpr double leastScale = 1; ///< pixels a unit: a view from afar does not make the bounds coarse

/// The pixels whose channels differ by at most `most` levels from those of one of them.
Mask pixelsLike(const Picture8 &picture, int x, int y, int most)
{
    Mask mask(picture.width, picture.height);
    const std::uint32_t wanted = picture.argb[mask.index(x, y)];
    for (std::size_t i = 0; i < mask.pixels.size(); ++i) {
        bool isLike = true;
        for (int shift = 0; shift < 32; shift += 8)
            isLike = isLike && std::abs(int(picture.argb[i] >> shift & 255) - int(wanted >> shift & 255)) <= most;
        mask.pixels[i] = isLike;
    }
    return mask;
}

/// How far a region grows, in pixels. Those that its bounds cover in part are unlike it and lie around it, so what is
/// to reach under the bounds at all takes them, however few pixels a unit has.
double growthOf(double units, double pixelsPerUnit)
{
    return units > 0 ? std::max(1.0, units * pixelsPerUnit + 0.5) : units * pixelsPerUnit;
}

} // namespace

std::vector<std::vector<Cubic>> paintRegion(const PaintingPtr &painting, Microseconds T, Point at,
                                            const RegionWish &wish, double scale, const std::atomic<bool> *cancel)
{
    const auto isCancelled = [cancel] { return cancel && *cancel; };
    const Rect sheet = painting->canvas.area();
    scale = std::min(std::max(scale, leastScale), std::sqrt(mostPixels / (sheet.width() * sheet.height())));
    const int width = std::max(1, int(std::lround(sheet.width() * scale)));
    const int height = std::max(1, int(std::lround(sheet.height() * scale)));
    RenderRequest request;
    request.painting = painting;
    request.time = T;
    request.view = View::ofArea(sheet, width, height);
    const Point pixel = request.view.toPixels(at);
    const int x = int(std::floor(pixel.x)), y = int(std::floor(pixel.y));
    auto renderer = makeRenderer({.backend = Backend::Cpu});
    Picture8 picture;
    if (x < 0 || y < 0 || x >= width || y >= height || !renderer || !(*renderer)->render(request, picture, cancel) ||
        isCancelled())
        return {};
    const double pixels = request.view.scale; // a unit
    const Mask like = pixelsLike(picture, x, y, int(std::lround(255 * wish.tolerance)));
    Mask region = regionAround(like, x, y, wish.gap * pixels);
    if (isCancelled())
        return {};
    region = grown(region, growthOf(wish.grow, pixels));
    if (isCancelled())
        return {};
    std::vector<std::vector<Cubic>> outlines = outlinesOf(region);
    for (std::vector<Cubic> &loop : outlines)
        for (Cubic &curve : loop)
            for (Point &p : curve.p)
                p = request.view.toCanvas(p);
    return outlines;
}

} // namespace suffuse

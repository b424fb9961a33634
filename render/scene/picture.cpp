#include "render/scene/picture.h"

#include "render/image_io/image_io.h"

#include <QCoreApplication>

#include <algorithm>
#include <list>
#include <mutex>

namespace suffuse {

namespace {

/// What is known of an image. Failures are remembered, too.
struct CachedLevels {
    QString sha256;
    PictureLevelsPtr levels;
    QString problem;
};

/// Decoded images, the most recent one first. An image that is shown somewhere stays; of the others the oldest ones go.
class LevelsCache {
public:
    Result<PictureLevelsPtr> of(const Picture &picture, const QString &name)
    {
        const std::lock_guard lock(m_mutex);
        const auto known = std::ranges::find(m_known, picture.sha256, &CachedLevels::sha256);
        if (known != m_known.end())
            m_known.splice(m_known.begin(), m_known, known);
        else
            m_known.push_front(decoded(picture, name));
        drop();
        const CachedLevels &found = m_known.front();
        if (!found.levels)
            return Error{found.problem};
        return found.levels;
    }

    std::size_t bytes() const
    {
        const std::lock_guard lock(m_mutex);
        std::size_t sum = 0;
        for (const CachedLevels &known : m_known)
            sum += known.levels ? known.levels->bytes() : 0;
        return sum;
    }

private:
    static constexpr std::size_t mostKnown = 4096; ///< images, be they decoded or not

    static CachedLevels decoded(const Picture &picture, const QString &name)
    {
        std::shared_ptr<PictureLevels> levels;
        ImageRows rows;
        rows.begin = [&](int width, int height) { levels = std::make_shared<PictureLevels>(width, height); };
        rows.row = [&](const ImageRun &run) {
            run.forEach([&](int x, int y, const float *rgba) { levels->set(x, y, rgba); });
        };
        if (const Result<void> read = readImageRows(*picture.image, name, rows); !read)
            return {picture.sha256, nullptr, read.error()};
        levels->reduce();
        return {picture.sha256, std::move(levels), {}};
    }

    void drop()
    {
        std::size_t idle = 0;
        for (auto it = std::next(m_known.begin()); it != m_known.end();) {
            const bool isIdle = !it->levels || it->levels.use_count() == 1;
            idle += isIdle && it->levels ? it->levels->bytes() : 0;
            it = isIdle && (idle > mostIdlePictures || m_known.size() > mostKnown) ? m_known.erase(it) : std::next(it);
        }
    }

    mutable std::mutex m_mutex;
    std::list<CachedLevels> m_known;
};

LevelsCache &decodedImages()
{
    static LevelsCache all;
    return all;
}

} // namespace

PictureLevels::PictureLevels(int width, int height)
{
    std::size_t size = 0;
    for (;; width = (width + 1) / 2, height = (height + 1) / 2) {
        m_levels.push_back({width, height, size});
        size += 4 * std::size_t(width) * std::size_t(height);
        if (width == 1 && height == 1)
            break;
    }
    m_values.resize(size);
}

PictureLevel PictureLevels::level(std::size_t k) const
{
    const Place &place = m_levels[k];
    return {m_values.data() + place.from, place.width, place.height};
}

void PictureLevels::set(int x, int y, const float *rgba)
{
    std::uint16_t *to = m_values.data() + 4 * (std::size_t(y) * std::size_t(m_levels.front().width) + std::size_t(x));
    const float alpha = std::clamp(rgba[3], 0.0f, 1.0f);
    for (int c = 0; c < 3; ++c)
        to[c] = std::uint16_t(std::clamp(rgba[c], 0.0f, 1.0f) * alpha * 65535 + 0.5f);
    to[3] = std::uint16_t(alpha * 65535 + 0.5f);
}

void PictureLevels::reduce()
{
    for (std::size_t k = 1; k < m_levels.size(); ++k) {
        const PictureLevel from = level(k - 1);
        std::uint16_t *to = m_values.data() + m_levels[k].from;
        for (int y = 0; y < m_levels[k].height; ++y)
            for (int x = 0; x < m_levels[k].width; ++x, to += 4) {
                std::uint32_t sum[4] = {};
                std::uint32_t count = 0;
                for (int j = 2 * y; j < std::min(2 * y + 2, from.height); ++j)
                    for (int i = 2 * x; i < std::min(2 * x + 2, from.width); ++i, ++count)
                        for (std::size_t c = 0; c < 4; ++c)
                            sum[c] += from.rgba[4 * (std::size_t(j) * std::size_t(from.width) + std::size_t(i)) + c];
                for (std::size_t c = 0; c < 4; ++c)
                    to[c] = std::uint16_t((sum[c] + count / 2) / count);
            }
    }
}

Result<PictureLevelsPtr> pictureLevels(const Picture &picture, const QString &name)
{
    if (!picture.image)
        return Error{picture.isLinked()
                         ? QCoreApplication::translate("ScenePicture", "%1: the linked picture is missing or has "
                                                                       "changed. Put it back, or link it anew in the "
                                                                       "Inspector.")
                               .arg(picture.link)
                         : QCoreApplication::translate("ScenePicture", "the image of a picture is missing")};
    const QString usual = picture.isLinked() ? picture.link : QCoreApplication::translate("ScenePicture", "picture");
    return decodedImages().of(picture, name.isEmpty() ? usual : name);
}

std::size_t pictureBytes()
{
    return decodedImages().bytes();
}

std::shared_ptr<const ScenePicture> scenePicture(const Stroke &stroke, const PictureGrid &grid)
{
    const Picture &picture = *stroke.picture;
    const auto levels = pictureLevels(picture);
    const std::optional<Affine> inverse = mapOf(picture).inverse();
    if (!levels || !inverse)
        return nullptr;
    auto placed = std::make_shared<ScenePicture>();
    placed->levels = *levels;
    const PictureLevel image = (*levels)->level(0);
    // From pixels of the grid to the image's, whose file may have another size than the painting says.
    const double across = double(image.width) / picture.width, down = double(image.height) / picture.height;
    const auto inImage = [&](Point offset) {
        const Point p = (*inverse)(offset);
        return Point{across * p.x, down * p.y};
    };
    const auto offsetAt = [&](Point pixel) { return grid.view.toCanvas(pixel) - stroke.origin; };
    const Point first = inImage(offsetAt({}));
    // Directions are those of the view by themselves, so that far from the canvas' corner they lose no digits.
    View unplaced = grid.view;
    unplaced.centre = {};
    const auto direction = [&](Point step) {
        const Point d = unplaced.toCanvas(step) - unplaced.toCanvas({});
        const Point p = inverse->turned(d);
        return Point{across * p.x, down * p.y};
    };
    const Point x = direction({1, 0}), y = direction({0, 1});
    // The greatest number of the image's pixels along a pixel, in any direction.
    const double squares = dot(x, x) + dot(y, y), determinant = cross(x, y);
    const double ratio =
        std::sqrt(0.5 * (squares + std::sqrt(std::max(0.0, squares * squares - 4 * determinant * determinant))));
    const double level = std::clamp(std::log2(std::max(ratio, 1.0)), 0.0, double((*levels)->count() - 1));
    const auto finer = std::size_t(level);
    const double scale = std::ldexp(1.0, -int(finer));
    PictureView &view = placed->view;
    view.finer = (*levels)->level(finer);
    view.coarser = (*levels)->level(std::min(finer + 1, (*levels)->count() - 1));
    view.share = float(level - double(finer));
    view.u = scale * first.x, view.ux = scale * x.x, view.uy = scale * y.x;
    view.v = scale * first.y, view.vx = scale * x.y, view.vy = scale * y.y;
    return placed;
}

bool isSamePicture(const ScenePicture *a, const ScenePicture *b)
{
    if (!a || !b)
        return a == b;
    const PictureView &p = a->view, &q = b->view;
    return a->levels == b->levels && p.finer.rgba == q.finer.rgba && p.share == q.share && p.u == q.u && p.ux == q.ux &&
           p.uy == q.uy && p.v == q.v && p.vx == q.vx && p.vy == q.vy;
}

} // namespace suffuse

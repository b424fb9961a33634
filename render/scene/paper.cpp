#include "render/scene/paper.h"

#include "render/image_io/image_io.h"

#include <QCoreApplication>

#include <list>
#include <mutex>

namespace suffuse {

namespace {

using Texture = std::shared_ptr<const PaperTexture>;

struct CacheEntry {
    std::weak_ptr<const QByteArray> image; ///< identifies the image; an expired one never matches
    Texture texture;
};

constexpr std::size_t cachedPapers = 4;
std::mutex cacheMutex;
std::list<CacheEntry> cache; ///< the most recent entry first

/// The texture of an image; null if it is not in the cache.
Texture cached(const EncodedImage &image)
{
    const std::lock_guard lock(cacheMutex);
    cache.remove_if([](const CacheEntry &e) { return e.image.expired(); });
    for (auto it = cache.begin(); it != cache.end(); ++it)
        if (it->image.lock() == image) {
            cache.splice(cache.begin(), cache, it);
            return cache.front().texture;
        }
    return {};
}

void remember(const EncodedImage &image, const Texture &texture)
{
    const std::lock_guard lock(cacheMutex);
    cache.push_front({image, texture});
    if (cache.size() > cachedPapers)
        cache.pop_back();
}

} // namespace

Result<std::shared_ptr<const PaperTexture>> paperTexture(const Paper &paper)
{
    if (paper.kind != PaperKind::Image)
        return Texture();
    const QString name = QCoreApplication::translate("Paper", "paper image");
    if (!paper.image || paper.image->isEmpty())
        return Error{QCoreApplication::translate(
            "Paper", "paper image: there is none. Choose an image, or another kind of paper.")};
    if (Texture known = cached(paper.image))
        return known;
    auto texture = std::make_shared<PaperTexture>();
    ImageRows rows;
    rows.begin = [&](int width, int height) {
        texture->width = width;
        texture->height = height;
        texture->grey.resize(std::size_t(width) * height);
    };
    rows.row = [&](const ImageRun &run) {
        run.forEach([&](int x, int y, const float *rgba) {
            texture->grey[std::size_t(y) * texture->width + x] =
                float(0.2126 * rgba[0] + 0.7152 * rgba[1] + 0.0722 * rgba[2]);
        });
    };
    if (Result<void> read = readImageRows(*paper.image, name, rows); !read)
        return Error{read.error()};
    remember(paper.image, texture);
    return Texture(texture);
}

} // namespace suffuse

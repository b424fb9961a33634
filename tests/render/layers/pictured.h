// Pictures as paint for the render tests.
#pragma once

#include "model/shaping/picture_stroke.h"
#include "render/image_io/image_io.h"
#include "tests/render/filled.h"

namespace suffuse::test {

/// An image of soft colours with some sharp pixels, of 8 or 16 bits, some with parts that can be seen through.
inline EncodedImage randomImage(std::mt19937_64 &random, int width, int height)
{
    std::uniform_real_distribution<double> u(0, 1);
    FloatPicture image;
    image.resize(width, height);
    const double a = 6 * u(random), b = 6 * u(random), turn = 0.4 * u(random);
    const bool alpha = random() % 2;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            float *to = image.rgba.data() + 4 * (std::size_t(y) * std::size_t(width) + std::size_t(x));
            for (int c = 0; c < 3; ++c)
                to[c] = float(random() % 9 ? 0.5 + 0.5 * std::sin(a + c + turn * x) * std::cos(b - c + turn * y)
                                           : double(random() % 2));
            to[3] = alpha ? float(std::clamp(0.5 + std::sin(b + 0.3 * x) * std::cos(a + 0.2 * y), 0.0, 1.0)) : 1;
        }
    ImageOptions options;
    options.alpha = alpha;
    options.depth = random() % 2 ? ImageDepth::Bits8 : ImageDepth::Bits16;
    // A bare machine with a GPU has not all that OpenImageIO needs, which reads PNG.
    static const bool readsPng = imageModuleProblem().isEmpty();
    if (!readsPng)
        options.depth = ImageDepth::Bits8;
    const Result<QByteArray> bytes =
        encodeImage(readsPng ? ImageFormat::Png : ImageFormat::WebP, image, options, QStringLiteral("test"));
    if (!bytes)
        qFatal("%s", qPrintable(bytes.error()));
    return std::make_shared<const QByteArray>(*bytes);
}

inline Picture randomPicture(std::mt19937_64 &random)
{
    const int width = 1 + int(random() % 60), height = 1 + int(random() % 40);
    return embeddedPicture(randomImage(random, width, height), width, height);
}

/// A place for a picture, turned, skewed and scaled, somewhere near an area.
inline Affine randomPlace(std::mt19937_64 &random, const Picture &picture, double width, double height)
{
    std::uniform_real_distribution<double> u(0, 1);
    const double size = 0.2 * std::pow(10, u(random)) * width / picture.width;
    const Affine turn = Affine::rotation({}, 6.3 * u(random));
    const Affine shape{size, size * (u(random) - 0.5), 0, size * (0.5 + u(random)) * (random() % 4 ? 1 : -1), {}};
    return Affine::translation({width * u(random), height * u(random)}) * turn * shape;
}

/// Gives a stroke a picture, at random.
inline void paintWith(Stroke &stroke, Picture picture, std::mt19937_64 &random, double width, double height)
{
    const Affine place = randomPlace(random, picture, width, height);
    const auto at = [&](double x, double y) { return toOffset(place({x, y}), stroke.origin); };
    picture.corner = at(0, 0), picture.right = at(picture.width, 0), picture.down = at(0, picture.height);
    stroke.picture = std::move(picture);
}

/// The painting with pictures as the paint of some of its strokes, and some pictures that stand alone, in any group.
inline PaintingPtr pictured(const PaintingPtr &p, std::mt19937_64 &random)
{
    auto q = std::make_shared<Painting>(*p);
    const double width = p->canvas.width, height = p->canvas.height;
    for (std::size_t i = 0; i < q->strokes.size(); ++i) {
        Stroke s = *p->strokes[i];
        const std::uint64_t kind = random() % 6;
        if (kind > 1)
            continue;
        const Picture picture = randomPicture(random);
        if (kind == 0) {
            paintWith(s, picture, random, width, height);
        } else {
            Stroke alone = pictureStroke(picture, randomPlace(random, picture, width, height), 0);
            alone.id = s.id, alone.group = s.group, alone.mix = s.mix;
            s = alone;
        }
        q->strokes[i] = std::make_shared<const Stroke>(std::move(s));
    }
    return q;
}

/// One random edit of a picture: another place, another image, none, or one where there was none.
inline PaintingPtr repictured(const PaintingPtr &p, std::mt19937_64 &random)
{
    const std::size_t j = random() % p->strokes.size();
    Stroke s = *p->strokes[j];
    const double width = p->canvas.width, height = p->canvas.height;
    if (!s.picture) {
        paintWith(s, randomPicture(random), random, width, height);
        return withStroke(p, j, s);
    }
    switch (random() % 5) {
    case 0:
        paintWith(s, *s.picture, random, width, height);
        break;
    case 1:
        s.picture = {};
        break;
    case 2: {
        Picture lost = *s.picture;
        lost.image = {};
        s.picture = lost;
        break;
    }
    case 3:
        s.origin.x += double(random() % 3);
        break;
    default:
        paintWith(s, randomPicture(random), random, width, height);
    }
    return withStroke(p, j, s);
}

} // namespace suffuse::test

// A picture as the paint of a stroke.
#pragma once

#include "model/geometry/affine.h"

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <memory>

namespace suffuse {

/// An image as the encoded bytes of its file (PNG, JPEG, TIFF, WebP or EXR). The renderer decodes it.
using EncodedImage = std::shared_ptr<const QByteArray>;

/// An image that a stroke is painted with in place of its colour: where the stroke is, the picture shows
/// (docs/solver.md, "Pictures"). It is in the painting, or the painting names a file that has it.
struct Picture {
    /// The image's bytes. Those of a linked file are read when the painting is opened, and are not stored with it.
    /// Null: they are missing, and nothing is seen where the stroke is.
    EncodedImage image;
    QString link;            ///< the path of the file that has the image; empty: it is in the painting
    QString sha256;          ///< of the bytes, 64 hexadecimal digits: by it images are told from each other
    std::uint32_t width = 1; ///< pixels, as it is seen upright
    std::uint32_t height = 1;
    Offset corner; ///< where its top left corner lies, as an offset from the stroke's origin, units
    Offset right{1, 0};
    Offset down{0, 1}; ///< where the corners to the right of that one and below it lie

    bool isLinked() const { return !link.isEmpty(); }
    std::uint64_t pixels() const { return std::uint64_t(width) * height; }

    /// At most so many pixels.
    static constexpr std::uint64_t mostPixels = std::uint64_t(1) << 26;
    static constexpr int mostSide = 16'384;
    static constexpr int mostLink = 4'096; ///< UTF-16 units
};
/// Images are compared by their SHA-256, so two pictures are equal whether their bytes are there or not.
bool operator==(const Picture &a, const Picture &b);

/// The map from pixels of its image, (0, 0) at its top left corner, to offsets from the stroke's origin.
Affine mapOf(const Picture &picture);
/// The picture with its three corners mapped, as offsets from the origin.
Picture mapped(Picture picture, const Affine &map);

/// The SHA-256 of an image's bytes as a picture has it.
QString sha256Of(const QByteArray &bytes);

/// A picture, or none. Most strokes have none, and copies of a stroke share theirs; two are equal if their values are.
class SharedPicture {
public:
    SharedPicture() = default;
    SharedPicture(Picture picture) : m_picture(std::make_shared<const Picture>(std::move(picture))) {}

    explicit operator bool() const { return bool(m_picture); }
    const Picture &operator*() const { return *m_picture; }
    const Picture *operator->() const { return m_picture.get(); }

    friend bool operator==(const SharedPicture &a, const SharedPicture &b)
    {
        return a.m_picture == b.m_picture || (a.m_picture && b.m_picture && *a.m_picture == *b.m_picture);
    }

private:
    std::shared_ptr<const Picture> m_picture;
};

} // namespace suffuse

#pragma once

#include "render/image_io/image_io.h"

namespace suffuse {

/// How a picture lies in its file, in the numbers of Exif: 1 is upright; 2 to 4 are mirrored or turned by 180°; 5 to 8
/// have rows as columns.
class Orientation {
public:
    Orientation() = default;
    explicit Orientation(int exif) : m_exif(exif >= 1 && exif <= 8 ? exif : 1) {}

    int exif() const { return m_exif; }
    /// Whether the rows of the picture are columns of the file, so that width and height are exchanged.
    bool swapsSides() const { return m_exif >= 5; }
    /// Where row y of a file of width × height pixels lies in the upright picture.
    ImageRun run(int y, int width, int height) const;

private:
    int m_exif = 1;
};

/// What a JPEG, TIFF, PNG or WebP file says, wherever it has its Exif data; upright if it says nothing that can be
/// understood. It never reads beyond the bytes, whatever they are.
Orientation orientationOf(const QByteArray &bytes, ImageFormat format);

} // namespace suffuse

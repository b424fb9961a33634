// TIFF files of channels that are packed already.
#pragma once

#include <QByteArray>

#include <cstdint>
#include <vector>

namespace suffuse {

/// The rows of a channel in PackBits, and how many bytes each of them has.
struct PackedRows {
    QByteArray bytes;
    std::vector<std::uint32_t> sizes;
};

/// An image whose channels lie one after another, each as rows in PackBits. So do those of Photoshop's layers, which
/// need no encoder to become images of their own.
struct PlanarImage {
    int width = 0, height = 0;        ///< pixels
    int bits = 8;                     ///< of a channel: 8 or 16, the latter with the highest byte first
    QByteArray profile;               ///< the ICC profile of its colours; empty: none
    std::vector<PackedRows> channels; ///< grey, or red, green and blue; then, if there is one more, straight alpha
};

/// The image as a TIFF file (6.0).
QByteArray planarTiff(const PlanarImage &image);

} // namespace suffuse

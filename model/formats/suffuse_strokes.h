// Chunks of a .suffuse file that hold strokes, and the one that holds the rest.
#pragma once

#include "model/formats/suffuse_columns.h"
#include "model/painting.h"

#include <span>

namespace suffuse {

/// What keeps a file within the bounds that a reader sets (docs/file-format.md, "Bounds").
struct Density {
    bool segments = false; ///< their lowest plane is stored raw
    bool rewets = false;
    std::uint64_t blocks = blockBudget; ///< bytes of blocks that may still be compressed
};

QByteArray writeStrokes(std::span<const StrokePtr> strokes, Density &density);

/// What may still be declared; reading takes from it.
struct Allowance {
    std::uint64_t segments = 0;
    std::uint64_t rewets = 0;
    std::uint64_t blocks = blockBudget;
};
/// Appends the strokes of a chunk; empty, or what is wrong with it.
QString readStrokes(QByteArrayView payload, Allowance &allowance, StrokeList &strokes);

/// Canvas, groups, swatches and underlay as CBOR; images are appended to `images` and named by their place in it.
QByteArray writeDocument(const Painting &painting, std::vector<EncodedImage> &images);
/// Empty, or what is wrong.
QString readDocument(QByteArrayView payload, const std::vector<EncodedImage> &images, Painting &painting);

} // namespace suffuse

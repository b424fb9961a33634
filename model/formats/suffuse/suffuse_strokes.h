// Chunks of a .suffuse file that hold strokes, and the one that holds the rest.
#pragma once

#include "model/formats/suffuse/suffuse_columns.h"
#include "model/painting/painting.h"

#include <atomic>
#include <span>

namespace suffuse {

/// What keeps a file within the bounds that a reader sets (docs/file-format.md, "Bounds").
struct Density {
    bool segments = false; ///< their lowest plane is stored raw
    bool rewets = false;
    std::uint64_t blocks = blockBudget; ///< bytes of blocks that may still be compressed
};

/// The strokes of one chunk each.
std::vector<std::span<const StrokePtr>> inChunks(std::span<const StrokePtr> strokes);
QByteArray writeStrokes(std::span<const StrokePtr> strokes, Density &density);

/// What may still be declared in a file; reading takes from it. Any thread.
class Allowance {
public:
    Allowance(std::uint64_t elements, std::uint64_t blocks) : m_segments(elements), m_rewets(elements), m_blocks(blocks)
    {}

    bool takeSegments(std::uint64_t n) { return take(m_segments, n); }
    bool takeRewets(std::uint64_t n) { return take(m_rewets, n); }
    bool takeBlock(std::uint64_t bytes) { return take(m_blocks, bytes); }

private:
    static bool take(std::atomic<std::uint64_t> &left, std::uint64_t n)
    {
        for (std::uint64_t now = left; now >= n;)
            if (left.compare_exchange_weak(now, now - n))
                return true;
        return false;
    }

    std::atomic<std::uint64_t> m_segments, m_rewets, m_blocks;
};
/// Appends the strokes of a chunk; empty, or what is wrong with it.
QString readStrokes(QByteArrayView payload, Allowance &allowance, std::vector<StrokePtr> &strokes);

/// Canvas, groups, swatches and underlay as CBOR; images that `images` lacks are appended to it,
/// and all are named by their place in it.
QByteArray writeProperties(const Painting &painting, std::vector<EncodedImage> &images);
/// Empty, or what is wrong.
QString readProperties(QByteArrayView payload, const std::vector<EncodedImage> &images, Painting &painting);

} // namespace suffuse

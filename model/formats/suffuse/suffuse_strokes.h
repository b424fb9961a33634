// The chunks of a .suffuse file that contain strokes, and the one that contains the rest.
#pragma once

#include "model/formats/suffuse/suffuse_columns.h"
#include "model/painting/painting.h"

#include <atomic>
#include <span>

namespace suffuse {

/// What keeps a file within the bounds that a reader sets (docs/file-format.md, "Bounds").
struct Density {
    bool segments = false; ///< whether the lowest plane of segments is stored raw
    bool rewets = false;
    std::uint64_t blocks = blockBudget; ///< bytes of blocks that may still be compressed
};

/// Divides strokes into chunks.
std::vector<std::span<const StrokePtr>> inChunks(std::span<const StrokePtr> strokes);
QByteArray writeStrokes(std::span<const StrokePtr> strokes, Density &density);

/// How much a file may still declare. Reading takes from it, on any thread.
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
/// Appends the strokes of a chunk. Returns an empty text, or what is wrong with the chunk.
QString readStrokes(QByteArrayView payload, Allowance &allowance, std::vector<StrokePtr> &strokes);

/// Writes canvas, groups, swatches and underlay as CBOR. Images that are not in `images` are appended to it, and all
/// are named by their places in it.
QByteArray writeProperties(const Painting &painting, std::vector<EncodedImage> &images);
/// Reads them. Returns an empty text, or what is wrong.
QString readProperties(QByteArrayView payload, const std::vector<EncodedImage> &images, Painting &painting);

} // namespace suffuse

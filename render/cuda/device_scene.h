// The scene in a device's memory, kept up to date with what changes.
#pragma once

#include "render/cuda/device_memory.h"
#include "render/cuda/run_pool.h"
#include "render/scene/live_scene.h"
#include "render/threads/parallel.h"

namespace suffuse::cuda {

class DeviceScene {
public:
    explicit DeviceScene(Device &device);

    /// Brings the device up to date with the scene's strokes; `change` tells how they differ from the last call's, in a
    /// picture of width × height pixels. Uploads the records whose bytes differ. After a fault, call `forget`.
    Fault update(const std::vector<SceneStrokePtr> &strokes, const SceneChange &change, int width, int height,
                 Threads threads);
    /// The next update writes everything anew.
    void forget();

    void fill(Frame &frame) const;
    /// Where the chunks of the i-th stroke begin; their end for i ≥ number of strokes.
    std::uint32_t firstChunk(std::size_t i) const;
    std::uint32_t chunkCount() const { return std::uint32_t(m_chunks.host().size()); }
    /// Whether no stroke near a tile, counted row by row, needs the general kernel.
    bool isPlain(std::size_t tile) const { return m_general[tile] == 0; }

private:
    struct Entry {
        SceneStrokePtr stroke;
        std::uint32_t slot = 0; ///< of its StrokeRecord
        Run nodes, values, deep, small;
        std::uint32_t firstChunk = 0, chunkRoom = 0; ///< chunks that it does not need are empty
    };
    /// A stroke whose records were made anew.
    struct Prepared {
        std::size_t index = 0;
        StrokeRecord record;
        std::vector<ChunkRecord> chunks;
        IndexRange nodes, values, deep, small;
    };

    /// Takes over a list of strokes in which some came, went or moved; returns the first that did.
    std::size_t align(const std::vector<SceneStrokePtr> &strokes, std::vector<Prepared> &changed);
    void reset(int width, int height);
    void drop(Entry &entry);
    void placeRecords(const std::vector<Prepared> &changed);
    void prepare(Prepared &p, Threads threads);
    /// Writes the stroke's node records and makes its chunks.
    void setNodes(Prepared &p, Threads threads);
    /// Puts chunks in document order: in place before stroke `from`, moved together from there on.
    void placeChunks(std::vector<Prepared> &changed, std::size_t from);
    void moveChunks(std::vector<Prepared> &changed, std::size_t from);
    void writeChunks(std::size_t at, const std::vector<ChunkRecord> &chunks, std::uint32_t room);
    /// Counts the tiles that need the general kernel because of a stroke.
    void countGeneral(const Entry &entry, int by);
    Fault upload();

    Mirror<NodeRecord> m_nodes;
    Mirror<float> m_values;
    Mirror<DeepRecord> m_deep;
    Mirror<SmallRecord> m_small;
    Mirror<ChunkRecord> m_chunks;
    Mirror<StrokeRecord> m_strokes;
    RunPool m_nodeRuns, m_valueRuns, m_deepRuns, m_smallRuns;
    std::vector<std::uint32_t> m_freeSlots;
    std::vector<Entry> m_entries; ///< in document order
    bool m_valid = false;
    int m_width = 0, m_height = 0, m_columns = 0;
    std::vector<std::int32_t> m_general; ///< chunks of strokes that are not plain, by tile
};

} // namespace suffuse::cuda

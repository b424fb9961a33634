// This keeps the scene in a device's memory, and follows what changes.
#pragma once

#include "render/cuda/device/device_memory.h"
#include "render/cuda/device_pictures.h"
#include "render/cuda/run_pool.h"
#include "render/scene/live_scene.h"
#include "render/threads/parallel.h"

namespace suffuse::cuda {

class DeviceScene {
public:
    explicit DeviceScene(Device &device);

    /// Brings the device up to date with the scene's strokes in a picture of width × height pixels; `change` says how
    /// they differ from those of the last call. Only records whose bytes differ are uploaded. After a fault, `forget`
    /// must be called.
    Fault update(const std::vector<SceneStrokePtr> &strokes, const SceneChange &change, int width, int height,
                 Threads threads);
    /// Makes the next update write everything anew.
    void forget();

    /// Frees strokes that are no longer needed. There may be hundreds, so it is called while the device works.
    void freeDropped(Threads threads);

    void fill(Frame &frame) const;
    /// Returns where the chunks of the i-th stroke begin. For i ≥ number of strokes it is the end of all chunks.
    std::uint32_t firstChunk(std::size_t i) const;
    /// Returns the index of the i-th stroke's record, and how many records there are.
    std::uint32_t slotOf(std::size_t i) const { return m_entries[i].slot; }
    std::size_t slotCount() const { return m_strokes.host().size(); }
    std::uint32_t chunkCount() const { return std::uint32_t(m_chunks.host().size()); }
    /// Tells whether no stroke near a tile (counted row by row) needs the general kernel.
    bool isPlain(std::size_t tile) const { return m_general[tile] == 0; }

private:
    struct Entry {
        SceneStrokePtr stroke;
        std::uint32_t slot = 0;                        ///< index of its StrokeRecord
        Run nodes, values, deep, small, fill, picture; ///< `nodes` begins with the records of the fill
        std::uint32_t firstChunk = 0, chunkRoom = 0;   ///< Chunks of the room that are not needed are empty.
    };
    /// Holds a stroke whose records were made anew.
    struct Prepared {
        std::size_t index = 0;
        StrokeRecord record;
        std::vector<ChunkRecord> chunks;
        IndexRange nodes, values, deep, small, fill, picture;
        std::vector<NodeRecord> fillRecords;
        std::vector<DeepRecord> deepFill;
    };

    /// Tells whether some of these strokes are known.
    bool knowsAny(const std::vector<SceneStrokePtr> &strokes) const;
    /// Takes over a list of strokes, some of which were added, removed or moved. Returns the index of the first one.
    std::size_t align(const std::vector<SceneStrokePtr> &strokes, std::vector<Prepared> &changed);
    void reset(int width, int height);
    void drop(Entry &entry);
    /// Makes the records of the strokes' fills.
    void prepareFills(std::vector<Prepared> &changed, Threads threads);
    void placeRecords(const std::vector<Prepared> &changed);
    void prepare(Prepared &p, Threads threads);
    /// Writes the node records of a stroke, and makes its chunks.
    void setNodes(Prepared &p, Threads threads);
    /// Puts chunks in document order: in place before stroke `from`, and moved together from there on.
    void placeChunks(std::vector<Prepared> &changed, std::size_t from);
    void moveChunks(std::vector<Prepared> &changed, std::size_t from);
    void writeChunks(std::size_t at, const std::vector<ChunkRecord> &chunks, std::uint32_t room);
    /// Adds `by` to the counts of tiles near a stroke, if it needs the general kernel.
    void countGeneral(const Entry &entry, int by);
    Fault upload();

    Mirror<NodeRecord> m_nodes;
    Mirror<float> m_values;
    Mirror<DeepRecord> m_deep;
    Mirror<SmallRecord> m_small;
    Mirror<FillValues> m_fills;
    Mirror<PictureView> m_pictureViews;
    Mirror<ChunkRecord> m_chunks;
    Mirror<StrokeRecord> m_strokes;
    RunPool m_nodeRuns, m_valueRuns, m_deepRuns, m_smallRuns, m_fillRuns, m_pictureRuns;
    DevicePictures m_pictures;
    std::vector<std::uint32_t> m_freeSlots;
    std::vector<Entry> m_entries;          ///< in document order
    std::vector<SceneStrokePtr> m_dropped; ///< strokes that may be freed
    bool m_valid = false;
    int m_width = 0, m_height = 0, m_columns = 0;
    std::vector<std::int32_t> m_general; ///< for each tile, how many chunks of strokes that are not plain meet it
};

} // namespace suffuse::cuda

// This has nodes built by a device (docs/cuda.md, "Nodes").
#pragma once

#include "render/cuda/device/device_memory.h"
#include "render/nodes/bulk_nodes.h"

namespace suffuse::cuda {

/// Where the device fails or finds no room, strokes are left to the host.
class DeviceNodes : public BulkNodeBuilder {
public:
    static constexpr std::size_t usuallyWorthwhile = 500;

    /// `worthwhile`: see BulkNodeBuilder.
    explicit DeviceNodes(std::shared_ptr<Device> device, std::size_t worthwhile = usuallyWorthwhile);

    /// Makes room for an ordinary painting, so that the first picture need not wait for it.
    void makeReady();
    std::size_t worthwhile() const override { return m_worthwhile; }
    std::vector<std::shared_ptr<const StrokeNodes>> build(std::span<const StrokePtr> strokes, Microseconds T,
                                                          int octave, const Rect &clip, Threads threads) override;

private:
    /// Holds a stroke, and where its segments and jobs are among those of its batch.
    struct Planned {
        std::size_t index = 0;
        const BulkStroke *stroke = nullptr;
        std::uint32_t segment = 0, job = 0;
    };

    /// Uploads the tables, once.
    Fault prepare();
    Fault reserve(std::size_t segments, std::size_t jobs, std::size_t nodes);
    Fault reserveResults(std::size_t segments, std::size_t plain, std::size_t windows, std::size_t merged);
    /// Uploads a batch, and runs the programs.
    Fault run(std::size_t segments, std::size_t jobs);
    /// Fetches what they made.
    Fault fetch(std::size_t segments);
    /// Plans strokes, as far as the device can build them.
    std::vector<Planned> plan(std::span<const StrokePtr> strokes, Microseconds T, int octave, const Rect &clip,
                              Threads threads);
    /// Builds the nodes of a batch. Planned::index is that in `out`.
    Fault buildBatch(const std::vector<Planned> &batch, Threads threads,
                     std::span<std::shared_ptr<const StrokeNodes>> out);
    void release();

    std::shared_ptr<Device> m_device;
    std::size_t m_worthwhile;
    std::vector<BulkStroke> m_plans; ///< kept for their memory
    bool m_prepared = false;
    DeviceArray<panels::Tables> m_panels;
    DeviceArray<spans::Tables> m_spans;
    DeviceArray<float> m_planes;
    PinnedArray<SegmentRecord> m_segments;
    PinnedArray<NodeJob> m_jobs;
    DeviceArray<SegmentRecord> m_deviceSegments;
    DeviceArray<NodeJob> m_deviceJobs;
    DeviceArray<FineNode> m_fine;
    DeviceArray<double> m_length, m_turning;
    DeviceArray<std::uint16_t> m_pieces;
    DeviceArray<SpanLeaf> m_leaves;
    DeviceArray<std::uint32_t> m_deviceStatus;
    DeviceArray<NodePlace> m_devicePlaces;
    DeviceArray<PlainNode> m_devicePlain;
    DeviceArray<MergedWindow> m_deviceWindows;
    DeviceArray<MergedNode> m_deviceMerged;
    PinnedArray<std::uint32_t> m_status;
    PinnedArray<NodePlace> m_places;
    PinnedArray<PlainNode> m_plain;
    PinnedArray<MergedWindow> m_windows;
    PinnedArray<MergedNode> m_merged;
    UnsetVector<std::uint32_t> m_windowAt;
    NodeWork m_work;
};

} // namespace suffuse::cuda

// A worker evaluates the share of one device in a picture: it uploads what differs, and tiles come back.
#pragma once

#include "render/cuda/device_composition.h"
#include "render/cuda/device_layers.h"
#include "render/cuda/device_scene.h"
#include "render/scene/frame_history.h"
#include "render/scene/paper.h"
#include "render/threads/parallel.h"

#include <array>
#include <atomic>
#include <functional>
#include <span>

namespace suffuse::cuda {

/// Names a tile to evaluate. The tiles of a macro-tile follow each other.
struct TileTask {
    std::uint16_t column = 0, row = 0;
    std::uint32_t index = 0;  ///< counted row by row
    bool drawn = false;       ///< whether it was stored where it was wanted
    bool approximate = false; ///< whether it was drawn with an over map
};

class TileWorker {
public:
    TileWorker(std::shared_ptr<Device> device, bool cull, Threads threads, const ApartLimits &apart = {});

    Device &device() { return *m_device; }
    /// Brings the device up to date with the step that `history` has made.
    Fault prepare(const FrameHistory &history, const FrameHistory::Step &step, const RenderRequest &request,
                  const std::shared_ptr<const PaperTexture> &paper);
    /// Evaluates tiles into `picture` (device memory) or, if that is null, into `target`. `drewAll` and the tasks then
    /// say what became of them. `meanwhile`, if there is any, is called while the device works.
    Fault paint(const FrameHistory &history, bool interactive, std::span<TileTask> tasks, std::uint32_t *picture,
                Target &target, const std::atomic<bool> *cancel, std::function<void()> meanwhile);
    /// Tells whether the last `paint` drew all tasks, none of them with an over map. The tasks themselves say it only
    /// if it did not.
    bool drewAll() const { return m_drewAll; }
    /// Returns the milliseconds that the device took for the last `paint`, by its own clock.
    double deviceMs() const { return m_deviceMs; }

private:
    enum class Output { Picture, Argb, Rgba };
    /// Says what one run of the device evaluates.
    struct Band {
        std::size_t tiles = 0, macros = 0;
        int flags = 0;           ///< the flags of all its tiles together
        bool anyGeneral = false; ///< whether some of them are not plain
    };
    /// Holds finished tiles, with 0xAARRGGBB or four floats for each pixel.
    struct TileBuffer {
        explicit TileBuffer(Device &device) : onDevice(device), onHost(device) {}

        DeviceArray<std::uint32_t> onDevice;
        PinnedArray<std::uint32_t> onHost;
    };

    Fault updatePaper(const Paper &paper, const std::shared_ptr<const PaperTexture> &texture);
    /// Keeps the paper that the device has found as long as view and paper stand.
    Fault keepEta();
    /// Makes room for strokes that are evaluated apart from so many tiles.
    Fault reserveApart(std::size_t tiles, std::size_t listed);
    Fault reserveJobs(std::size_t tiles);
    /// Makes jobs of the first tasks, as many as fit.
    Band plan(const FrameHistory &history, bool interactive, std::span<const TileTask> tasks);
    Fault run(const Band &band);
    /// Asks for the band's tiles and status words. Tiles that do not stay in `picture` arrive in `buffer`.
    Fault start(const Band &band, Output output, std::uint32_t *picture, TileBuffer &buffer);
    void store(const FrameHistory &history, Output output, const TileBuffer &buffer, std::span<TileTask> tasks,
               Target &target, const std::atomic<bool> *cancel);
    /// Notes which layers the band's jobs have filled.
    void keepLayers(const Band &band, std::span<TileTask> tasks);
    /// Makes room after memory ran out for so many tiles. Returns true if it is worth another try, without layers or
    /// with fewer tiles.
    bool makeRoom(std::size_t triedTiles);
    /// Gives up layers and buffers. Returns false if there are none.
    bool releaseSpare();
    void releaseBuffers();

    std::shared_ptr<Device> m_device;
    const Threads m_threads;
    DeviceScene m_scene;
    DeviceLayers m_layers;
    DeviceComposition m_composition;
    DeviceArray<BackdropPixel> m_layerPixels;
    DeviceArray<BoundPixel> m_boundPixels;
    bool m_usesLayers = false; ///< whether m_layers keeps what lies below and above edited strokes
    Frame m_frame;
    std::shared_ptr<const PaperTexture> m_paperTexture; ///< the paper that is on the device
    DeviceArray<float> m_paper;
    PinnedArray<TileJob> m_tileJobs;
    PinnedArray<MacroJob> m_macroJobs;
    PinnedArray<std::uint32_t> m_hostStatus;
    DeviceArray<TileJob> m_deviceTileJobs;
    DeviceArray<MacroJob> m_deviceMacroJobs;
    DeviceArray<std::uint32_t> m_status, m_listCounts;
    DeviceArray<std::uint16_t> m_order;
    DeviceArray<ListEntry> m_lists;
    DeviceArray<ApartEntry> m_apart;
    DeviceArray<ApartJob> m_apartJobs;
    DeviceArray<float> m_apartSamples;
    DeviceArray<std::uint32_t> m_apartDone;
    std::size_t m_apartRoom = 0;   ///< slots for strokes that are evaluated apart
    std::size_t m_apartWanted = 0; ///< slots that the last band would have taken
    bool m_apartWorthIt = true;    ///< whether the last band had enough strokes for it
    ApartLimits m_apartLimits;     ///< as the renderer was asked for them
    bool m_apartRefused = false;   ///< whether there was no memory for them
    DeviceArray<float> m_eta;
    DeviceArray<std::uint32_t> m_etaKnown;
    bool m_etaRefused = false;
    /// What the paper that is kept depends on.
    struct EtaOf {
        std::array<double, 15> numbers{};
        const void *texture = nullptr;
        bool operator==(const EtaOf &) const = default;
    };
    EtaOf m_etaOf;
    std::array<TileBuffer, 2> m_buffers; ///< one band is computed while the other is stored
    std::uint32_t m_listRoom = 128;
    std::size_t m_bandTiles; ///< the greatest number of tiles in one run
    bool m_drewAll = false;
    double m_deviceMs = 0;
};

} // namespace suffuse::cuda

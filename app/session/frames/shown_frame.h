// The picture that is on the screen, and what is told of it.
#pragma once

#include "render/renderer.h"

#include <QString>

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace suffuse {

/// What a finished frame was.
struct FrameInfo {
    RenderStats stats;
    View view;
    Microseconds time = 0;
    quint64 serial = 0;   ///< of the request, from 1
    QString error;        ///< empty, or why there is no new picture
    QString backendText;  ///< what drew it: "CPU · 2 threads · AVX2"
    QString notice;       ///< empty, or why the CPU drew it, or why it did not stay on the device
    int coarseness = 1;   ///< pixels of the view to a side of one that was drawn
    bool floats = false;  ///< it was composed of two pictures (Floating)
    double evaluated = 0; ///< pixels that were drawn

    bool isExact() const { return coarseness == 1 && !floats; }
};

/// The last whole picture, on the device or in memory. `dirty` lists what changed since a presenter last cleared it.
struct ShownFrame {
    View view;
    std::shared_ptr<DeviceFrame> device; ///< null: `picture` has the pixels; else it is empty
    Picture8 picture;
    std::vector<PixelRect> dirty;

    int width() const { return device ? device->width() : picture.width; }
    int height() const { return device ? device->height() : picture.height; }
};

/// Where the frame sources put what they have drawn, and presenters find it.
class FrameBoard {
public:
    /// Calls `use` with the shown frame locked, on any thread: keep it short.
    void with(const std::function<void(ShownFrame &)> &use);

    /// What was put there only stands in for the exact picture. The frame thread alone calls this, and the next.
    void notePatches(const std::vector<PixelRect> &rects);
    /// Where something stands in for the exact picture, each rectangle once; the caller replaces it.
    std::vector<PixelRect> takePatches();

private:
    std::mutex m_mutex;
    ShownFrame m_shown;
    std::vector<PixelRect> m_patches;
};

} // namespace suffuse

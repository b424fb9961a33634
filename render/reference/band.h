// Draws a band of rows of the reference's picture.
#pragma once

#include "render/reference/compositing.h"
#include "render/reference/paper.h"
#include "render/reference/sums.h"

namespace suffuse::reference {

/// What all bands share.
struct Scene {
    View view;
    std::vector<StrokeSource> strokes; ///< the visible strokes, from bottom to top
    std::vector<Item> items;           ///< these as they are mixed, in isolated groups
    PaperField paper;
    Colour background;
    bool transparent = false;
};

/// Draws rows of a scene. Each thread has one, and uses it again for band after band.
class BandPainter {
public:
    explicit BandPainter(const Scene &scene) : m_scene(scene) {}

    /// Draws the rows [first, first + count) as stored colours, 4 floats for each pixel. The result is empty once
    /// `cancel` is set.
    const std::vector<float> &draw(int first, int count, const std::atomic<bool> *cancel);

private:
    using Cancelled = const std::atomic<bool> *;
    /// Mixes items into m_spots. `canvas`: as for put. Returns false once `cancel` is set.
    bool addItems(const std::vector<Item> &items, const Rgb *canvas, Cancelled cancel);
    bool addItem(const std::vector<Item> &items, std::size_t item, const Rgb *canvas, Cancelled cancel);
    /// Multiplies `share` with what an item covers by itself.
    bool bound(const std::vector<Item> &items, std::size_t by, std::vector<double> &share, Cancelled cancel);
    void addStroke(const StrokeSource &stroke);
    void addFillLevels(const FillSource &fill, const SampleBlock &block, bool &any);
    /// Mixes the paint of a stroke into a pixel.
    void mixAt(const StrokeSource &stroke, Point pixel, const Paint &paint);
    Paint paintAt(const StrokeSource &stroke, int i, int j, Point pixel, double step) const;
    bool findLevels(const StrokeSource &stroke, const SampleBlock &block);
    void mixPlain(const StrokeSource &stroke, const SampleBlock &block);
    void mixSupersampled(const StrokeSource &stroke, const SampleBlock &block);
    Paint supersampled(const StrokeSource &stroke, const SampleBlock &samples, int column, int level);
    Spot &spotAt(double x, double y);

    const Scene &m_scene;
    int m_first = 0;
    int m_count = 0;
    std::vector<Spot> m_spots;
    std::vector<std::uint8_t> m_levels; ///< k of each pixel of the present block
    StrokeSums m_sums;
    std::vector<float> m_stored;
};

} // namespace suffuse::reference

#include "render/drawing/drawn_bounds.h"

#include "render/composition/composition.h"

#include <algorithm>

namespace suffuse {

namespace {

/// A path as what is seen through it: white, as opaque as it covers.
DrawnStroke coverageOf(const DrawnStroke &drawn)
{
    DrawnStroke white = drawn;
    white.multiplies = false;
    for (DrawnPaint::Stop &stop : white.paint.stops)
        stop.colour = {1, 1, 1, stop.colour[3]};
    if (drawn.stroke->picture) {
        auto bare = std::make_shared<Stroke>(*drawn.stroke);
        bare->picture = {};
        white.stroke = std::move(bare);
    }
    return white;
}

class Bounder {
public:
    Bounder(PathDrawing &drawing, const std::vector<DrawnStroke> &shown)
        : m_drawing(drawing), m_shown(shown), m_composition(compositionOf(*drawing.painting))
    {}

    void run(std::vector<bool> &masks)
    {
        if (!m_composition.isBounded)
            return;
        for (std::size_t k = 0; k < m_composition.layers.size(); ++k) {
            const Layer &layer = m_composition.layers[k];
            if (layer.isMask) {
                const Layer &parent = m_composition.layers[std::size_t(layer.parent)];
                m_drawing.bounds[parent.group].push_back(boundOf(int(k)));
                std::fill(masks.begin() + std::ptrdiff_t(layer.first), masks.begin() + std::ptrdiff_t(layer.last),
                          true);
            }
            if (layer.clippedTo != Layer::none)
                m_drawing.bounds[layer.group].push_back(baseOf(layer.clippedTo));
        }
    }

private:
    DrawnBound boundOf(int mask)
    {
        DrawnBound bound;
        bound.opacity = double(m_composition.layers[std::size_t(mask)].opacity);
        for (std::size_t i = 0; i < m_shown.size(); ++i)
            if (m_composition.isWithin(m_composition.layerOf(i), mask))
                add(bound, i, mask);
        return bound;
    }

    /// Its strokes, and those of groups in it, as they are by themselves.
    DrawnBound baseOf(int base)
    {
        const ClipBase &what = m_composition.bases[std::size_t(base)];
        const auto isBase = [&](const Layer &l) {
            return what.group != 0 && l.group == what.group && l.run == what.run;
        };
        const auto own = std::ranges::find_if(m_composition.layers, isBase);
        const int layer = own == m_composition.layers.end() ? Layer::none : int(own - m_composition.layers.begin());
        DrawnBound bound;
        if (layer != Layer::none)
            bound.opacity = double(own->opacity);
        for (std::size_t i = 0; i < m_shown.size(); ++i)
            if (layer != Layer::none ? m_composition.isWithin(m_composition.layerOf(i), layer) : isPart(i, base))
                add(bound, i, layer);
        return bound;
    }

    bool isPart(std::size_t stroke, int base) const
    {
        bool isPart = m_composition.shapeOf(stroke) == base;
        for (int k = m_composition.layerOf(stroke); k != Layer::none; k = m_composition.layers[std::size_t(k)].parent)
            isPart = isPart || m_composition.layers[std::size_t(k)].shape == base;
        return isPart;
    }

    /// Adds what a stroke covers, but for what masks `within` that layer cover. The opacities of layers between them
    /// are those of each of their strokes.
    void add(DrawnBound &bound, std::size_t stroke, int within)
    {
        if (m_shown[stroke].bands.empty())
            return;
        DrawnStroke covers = coverageOf(m_shown[stroke]);
        const Layer *layer = nullptr;
        for (int k = m_composition.layerOf(stroke); k != within && k != Layer::none; k = layer->parent) {
            layer = &m_composition.layers[std::size_t(k)];
            if (layer->isMask)
                return;
            if (within == Layer::none && layer->shape == Layer::none)
                break; // It is around what is a part.
            for (contours::Band &band : covers.bands)
                band.opacity *= double(layer->opacity);
        }
        bound.strokes.push_back(std::move(covers));
    }

    PathDrawing &m_drawing;
    const std::vector<DrawnStroke> &m_shown;
    const Composition m_composition;
};

} // namespace

void takeBounds(PathDrawing &drawing, std::vector<DrawnStroke> &shown)
{
    std::vector<bool> masks(shown.size());
    Bounder(drawing, shown).run(masks);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < shown.size(); ++i)
        if (!masks[i])
            std::swap(shown[kept++], shown[i]);
    shown.resize(kept);
}

} // namespace suffuse

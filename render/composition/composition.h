// What a painting's groups make of its strokes: which of them mix among themselves before their picture is put on what
// lies below (docs/solver.md, "Groups that blend").
#pragma once

#include "model/painting/painting.h"

#include <cstdint>
#include <vector>

namespace suffuse {

/// An isolated group as the picture has it: a run of strokes. A group whose strokes do not stand together is several.
struct Layer {
    static constexpr int none = -1; ///< as a layer: the canvas itself

    GroupId group = 0;
    int run = 0; ///< which one it is of the group's runs
    float opacity = 1;
    BlendMode blend = BlendMode::Normal;
    int parent = none;               ///< the layer around it
    int depth = 1;                   ///< how many layers it is, with those around it
    std::size_t first = 0, last = 0; ///< its strokes among the visible ones, those of layers within it included

    /// Whether it changes what lies below also where none of its strokes is.
    bool actsEverywhere() const { return blend == BlendMode::DestinationIn; }
    /// Whether it is put on what lies below in the same way.
    bool isPutAs(const Layer &other) const { return opacity == other.opacity && blend == other.blend; }
    bool operator==(const Layer &) const = default;
};

/// The layers of a painting, and in which of them each visible stroke is. Without an isolated group all is empty.
struct Composition {
    std::vector<Layer> layers;   ///< by their first strokes; a layer comes before those within it
    std::vector<int> of;         ///< the innermost layer of each visible stroke; empty if there are no layers
    std::vector<int> everywhere; ///< the layers that act everywhere, in their order

    bool isFlat() const { return layers.empty(); }
    int layerOf(std::size_t stroke) const { return of.empty() ? Layer::none : of[stroke]; }
    /// Whether `layer` is `around` or lies within it; all do in Layer::none.
    bool isWithin(int layer, int around) const;
    bool operator==(const Composition &) const = default;
};

Composition compositionOf(const Painting &painting);

/// What became of the layers from one composition to the next.
class LayerChanges {
public:
    LayerChanges(const Composition &before, const Composition &now);

    /// Whether a stroke has other layers around it, or they are put in another way; by its places before and now.
    bool concerns(std::size_t before, std::size_t now) const;
    /// Whether more may differ than what strokes reach that came, went, changed, or that this concerns.
    bool isEverywhere() const { return m_everywhere; }

private:
    const Composition &m_before, &m_now;
    /// The layer before of each layer that is put in the same way, as are all around it; otherwise Layer::none.
    std::vector<int> m_same;
    bool m_everywhere = false;
};

/// Where a walk through the layers is.
struct LayerPlace {
    int layer = Layer::none;    ///< the innermost one that has begun and not ended
    std::size_t everywhere = 0; ///< how many of those that act everywhere have begun
};

/// A way through the layers, from the first stroke to the last: which layers begin and end between two strokes.
class LayerWalk {
public:
    /// `composition` outlives the walk.
    explicit LayerWalk(const Composition &composition, LayerPlace from = {}) : m_composition(composition), m_place(from)
    {}

    LayerPlace place() const { return m_place; }
    /// Goes on to a stroke. Calls end(layer) and begin(layer) for each layer that ends or begins before it.
    template <class Begin, class End>
    void toStroke(std::size_t stroke, Begin begin, End end)
    {
        if (m_composition.isFlat())
            return;
        passEverywhere(stroke, begin, end);
        to(m_composition.of[stroke], begin, end);
    }
    /// Goes on to the end of all.
    template <class Begin, class End>
    void toEnd(Begin begin, End end)
    {
        if (m_composition.isFlat())
            return;
        passEverywhere(m_composition.of.size(), begin, end);
        to(Layer::none, begin, end);
    }

private:
    /// Visits the layers that act everywhere and begin with a stroke up to this one.
    template <class Begin, class End>
    void passEverywhere(std::size_t stroke, Begin begin, End end)
    {
        const std::vector<int> &all = m_composition.everywhere;
        for (; m_place.everywhere < all.size(); ++m_place.everywhere) {
            const int layer = all[m_place.everywhere];
            if (m_composition.layers[std::size_t(layer)].first > stroke)
                break;
            to(layer, begin, end);
        }
    }
    template <class Begin, class End>
    void to(int layer, Begin begin, End end)
    {
        while (!m_composition.isWithin(layer, m_place.layer)) {
            const int ended = m_place.layer;
            m_place.layer = m_composition.layers[std::size_t(ended)].parent;
            end(ended);
        }
        if (layer != m_place.layer)
            enter(layer, begin);
    }
    /// Begins the layers between the present one and `layer`, the outer ones first.
    template <class Begin>
    void enter(int layer, Begin begin)
    {
        if (const int parent = m_composition.layers[std::size_t(layer)].parent; parent != m_place.layer)
            enter(parent, begin);
        m_place.layer = layer;
        begin(layer);
    }

    const Composition &m_composition;
    LayerPlace m_place;
};

} // namespace suffuse

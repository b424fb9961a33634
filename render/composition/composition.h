// What a painting's groups make of its strokes: which of them mix among themselves before their picture is put on what
// lies below, and what bounds that picture (docs/solver.md, "Groups that blend").
#pragma once

#include "model/painting/painting.h"

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

namespace suffuse {

/// What a layer is clipped to: a run of a group, or a stroke.
struct ClipBase {
    GroupId group = 0;
    int run = 0;
    StrokeId stroke = 0;
    auto operator<=>(const ClipBase &) const = default;
};

/// An isolated group as the picture has it: a run of strokes. A group whose strokes do not stand together is several.
struct Layer {
    static constexpr int none = -1; ///< as a layer: the canvas itself

    GroupId group = 0; ///< 0: all that is painted, where a mask belongs to no group
    int run = 0;       ///< which one it is of the group's runs
    float opacity = 1;
    BlendMode blend = BlendMode::Normal;
    int parent = none;                       ///< the layer around it
    int depth = 1;                           ///< how many layers it is, with those around it
    std::size_t first = 0, last = 0;         ///< its strokes among the visible ones, those of layers within it included
    int clippedTo = none;                    ///< the base, among Composition::bases, whose coverage multiplies its own
    int shape = none;                        ///< the base of which its coverage is a part
    BlendMode shapeMode = BlendMode::Normal; ///< how it becomes one: Normal if it is that base itself
    bool isMask = false; ///< whether its coverage multiplies that of the layer around it, instead of being put on it
    int masks = 0;       ///< how many masks are directly within it

    /// Whether it changes what lies below also where none of its strokes is.
    bool actsEverywhere() const { return blend == BlendMode::DestinationIn && !isMask; }
    /// Whether it is put on what lies below in the same way, if what it is clipped to is the same.
    bool isPutAs(const Layer &other) const
    {
        return opacity == other.opacity && blend == other.blend && isMask == other.isMask && masks == other.masks;
    }
    bool operator==(const Layer &) const = default;
};

/// The layers of a painting, and in which of them each visible stroke is. Without an isolated group all is empty.
struct Composition {
    std::vector<Layer> layers;   ///< by their first strokes; a layer comes before those within it
    std::vector<int> of;         ///< the innermost layer of each visible stroke; empty if there are no layers
    std::vector<int> everywhere; ///< the layers that act everywhere, in their order
    std::vector<ClipBase> bases; ///< what layers are clipped to
    /// The base of which each visible stroke is a part, apart from the layers around it. Empty if there are no bases.
    std::vector<int> shapes;
    bool isBounded = false; ///< whether a layer is clipped, or is a mask

    bool isFlat() const { return layers.empty(); }
    int layerOf(std::size_t stroke) const { return of.empty() ? Layer::none : of[stroke]; }
    int shapeOf(std::size_t stroke) const { return shapes.empty() ? Layer::none : shapes[stroke]; }
    /// What one of `bases` is; null for Layer::none.
    const ClipBase *baseAt(int base) const { return base == Layer::none ? nullptr : &bases[std::size_t(base)]; }
    /// Whether `layer` is `around` or lies within it; all do in Layer::none.
    bool isWithin(int layer, int around) const;
    /// Whether the coverage of a layer, or of what is in it, multiplies others: it is a mask or a part of what they are
    /// clipped to, or one of the layers around it is.
    bool boundsOthers(int layer) const;
    bool operator==(const Composition &) const = default;
};

Composition compositionOf(const Painting &painting);
/// Whether groups differ in nothing but opacities and modes, which isolate the same ones and act in the same places.
bool differInPuts(const std::vector<Group> &before, const std::vector<Group> &now);
/// Takes over the groups' opacities and modes, in which alone they differ from those that the composition was made of.
/// Nothing is clipped.
void putAnew(Composition &composition, const std::vector<Group> &groups);
/// The layer whose opacity or mode is all that two compositions of the same strokes differ in; Layer::none if they
/// differ in more, or in nothing.
int layerPutAnew(const Composition &before, const Composition &now);
/// Whether all strokes mix one after another, as if there were no groups: none is isolated, and none is a wash.
bool mixesInOrder(const Painting &painting);

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
    /// Goes on to where a layer is about to begin: those around it are open.
    template <class Begin, class End>
    void toLayer(int layer, Begin begin, End end)
    {
        const Layer &next = m_composition.layers[std::size_t(layer)];
        passEverywhere(next.first, begin, end, next.parent);
        to(next.parent, begin, end);
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
    /// Visits the layers that act everywhere and begin with a stroke up to this one. Of those that begin with it, it
    /// visits the ones around the layer `around` alone, unless that is left out.
    template <class Begin, class End>
    void passEverywhere(std::size_t stroke, Begin begin, End end, std::optional<int> around = {})
    {
        const std::vector<int> &all = m_composition.everywhere;
        for (; m_place.everywhere < all.size(); ++m_place.everywhere) {
            const int layer = all[m_place.everywhere];
            const std::size_t first = m_composition.layers[std::size_t(layer)].first;
            if (first > stroke || (first == stroke && around && !m_composition.isWithin(*around, layer)))
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

// W3C Compositing and Blending Level 1, as it is written there, in double precision: what an isolated group makes of
// what lies below it.
#pragma once

#include "model/painting/painting.h"
#include "render/reference/colour.h"

#include <vector>

namespace suffuse::reference {

/// What is drawn, from bottom to top: a stroke, or a group with what is in it.
struct Item {
    static constexpr std::size_t nothing = std::size_t(-1);

    std::size_t stroke = nothing; ///< its place among Drawing::strokes; nothing: a group, or a stroke that is hidden
    bool isGroup = false;
    bool isIsolated = false;    ///< a group whose strokes mix among themselves
    bool isMask = false;        ///< a group that is not seen, but bounds its siblings
    bool clips = false;         ///< whether nothing can be clipped to it, since it is clipped itself
    std::size_t base = nothing; ///< the sibling that it is clipped to
    double opacity = 1;
    BlendMode blend = BlendMode::Normal;
    std::vector<Item> inside; ///< of a group

    /// Whether a visible stroke is in it.
    bool isSeen() const;
};

/// What a painting shows.
struct Drawing {
    /// Strokes that are drawn as one. Most are one alone; a wash has several.
    struct Drawn {
        StrokePtr stroke;
        std::vector<StrokePtr> members;
    };
    std::vector<Drawn> strokes;
    std::vector<Item> items;
};

/// The strokes of a painting that are seen, and the tree of its groups.
Drawing drawingOf(const Painting &painting);

/// Puts what a group shows on what lies below it. Its bounds let a share of it through. `canvas`: RGB of the canvas,
/// where that lies below and lets nothing through; null where the ground is transparent.
void put(const Item &group, double share, const Spot &source, const Rgb *canvas, Spot &below);

} // namespace suffuse::reference

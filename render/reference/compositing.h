// W3C Compositing and Blending Level 1, as it is written there, in double precision: what an isolated group makes of
// what lies below it.
#pragma once

#include "model/painting/painting.h"
#include "render/reference/colour.h"

#include <vector>

namespace suffuse::reference {

/// What is drawn, from bottom to top: a stroke, or an isolated group with what is in it.
struct Item {
    std::size_t stroke = 0; ///< its place among the visible strokes
    bool isGroup = false;
    double opacity = 1;
    BlendMode blend = BlendMode::Normal;
    std::vector<Item> inside; ///< of a group
};

/// The visible strokes of a painting as a tree of isolated groups.
std::vector<Item> itemsOf(const Painting &painting);

/// Puts what a group shows on what lies below it. `canvas`: RGB of the canvas, where that lies below and lets nothing
/// through; null where the ground is transparent.
void put(const Item &group, const Spot &source, const Rgb *canvas, Spot &below);

} // namespace suffuse::reference

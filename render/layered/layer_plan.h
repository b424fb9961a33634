// What a painting is as a stack of raster layers, as other programs have them (docs/layered-files.md).
#pragma once

#include "model/painting/painting.h"

#include <vector>

namespace suffuse {

/// A layer of a layered file, or where a folder begins or ends, from bottom to top.
struct PlannedLayer {
    enum class Kind : std::uint8_t {
        Paint, ///< what strokes make of the picture below them: what that takes is found from the picture with them
        Group, ///< a group's own picture, which other programs put on what lies below as this one does
        BeginFolder,
        EndFolder
    };
    Kind kind = Kind::Paint;
    QString name{};
    bool visible = true;                 ///< of a layer that is not, only `alone` is there
    bool locked = false;                 ///< whether its group is, or all of its strokes are
    float opacity = 1;                   ///< of a Group
    BlendMode blend = BlendMode::Normal; ///< of a Group
    PaintingPtr upTo{};                  ///< the painting up to this layer, with it
    PaintingPtr alone{};                 ///< nothing but the strokes of a Group, or of a hidden layer
};

/// Whether other programs put a layer of a mode on an opaque picture by the same formula. Those of dodging, of soft
/// light and of hues differ from program to program.
bool isPutAlike(BlendMode mode);

/// The layers of a painting: folders for groups that only hold others, a Group for each group that is put as a whole
/// and in a way that others know, and Paint for strokes between them and for all else (washes, what is clipped or
/// masked). The first one is the background without any stroke. Strokes that are hidden by themselves are left out.
std::vector<PlannedLayer> planLayers(const Painting &painting);

} // namespace suffuse

// A group by itself.
#pragma once

#include "model/painting/painting.h"

namespace suffuse {

/// The painting with nothing but what is in a group: its own picture. How the group is put on what lies below, and
/// whether it or a group around it is hidden, locked or solo, is left out; what is in it stays as it is. Without such a
/// group there are no strokes.
Painting groupAlone(const Painting &painting, GroupId group);

} // namespace suffuse

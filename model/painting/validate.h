// The domains of solver quantities: the one border that every reader, tool and field passes.
#pragma once

#include "model/painting/painting.h"

namespace suffuse {

/// Empty if every value is finite and in its domain, else e.g. "diffusion: -3 is not in (0, 1e12]"; starts with the
/// member's path as the text form names it ("diffusion", "bezier[2][0]", "style.xi[1]", "rewet[0][1]").
QString problemOf(const Segment &segment);
QString problemOf(const Style &style);
QString problemOf(const Mix &mix);
QString problemOf(const Colour &colour);
/// Also: at least one segment, and each starts where the one before it ends. Paths start with "segments[k].".
QString problemOf(const Stroke &stroke);
QString problemOf(const Canvas &canvas);
QString problemOf(const Underlay &underlay);
/// Also: ids unique and not 0, groups exist, no group cycle, members of a group together. Paths start with
/// "strokes[j].".
QString problemOf(const Painting &painting);

/// The part of it about the order: groups of strokes exist and their members stand together. Groups must be in no
/// cycle.
QString problemOfMembership(const Painting &painting);

} // namespace suffuse

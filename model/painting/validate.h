// The domains of the solver's quantities, which every reader, tool and field checks here.
#pragma once

#include "model/painting/painting.h"

namespace suffuse {

/// Empty if every value is finite and in its domain. Otherwise it is a text such as "diffusion: -3 is not in (0,
/// 1e12]", which starts with the member's path as the text form names it ("diffusion", "bezier[2][0]", "style.xi[1]",
/// "rewet[0][1]").
QString problemOf(const Segment &segment);
QString problemOf(const Style &style);
QString problemOf(const Mix &mix);
QString problemOf(const Colour &colour);
/// Also checks that there is at least one segment, and that each starts where the one before it ends in a chain. Paths
/// start with "segments[k].".
QString problemOf(const Stroke &stroke);
QString problemOf(const Canvas &canvas);
/// Also checks that it is no longer than texts may be, and valid Unicode. Paths start with "text.".
QString problemOf(const Text &text);
QString problemOf(const Underlay &underlay);
/// Also checks that ids are unique and not 0, that groups exist, that no group is within itself, and that the members
/// of a group stand together. Paths start with "strokes[j].".
QString problemOf(const Painting &painting);

/// Checks only the part about the order: that the groups of strokes exist, and that their members stand together. No
/// group may be within itself.
QString problemOfMembership(const Painting &painting);

} // namespace suffuse

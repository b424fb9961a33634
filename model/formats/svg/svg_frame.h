// What stands around the paths of a drawing: its size, and its groups.
#pragma once

#include "model/formats/svg/svg_drawing.h"

#include <QXmlStreamAttributes>

namespace suffuse {

/// Finds area and scale. Where the document gives itself width and height, what they show of the view box is seen.
void takeSize(SvgDrawing &drawing, const QXmlStreamAttributes &root);

/// Removes groups that have nothing in them, and those with only one thing, which gets the group's name if it has
/// none. Counts the texts that came in as letters alone, and calls them by their words where they have no name.
void dissolveGroups(SvgDrawing &drawing);

} // namespace suffuse

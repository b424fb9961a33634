// What elements of SVG are, by their names and attributes.
#pragma once

#include "model/formats/svg/svg_tree.h"
#include "model/geometry/geometry.h"

namespace suffuse {

/// Whether it draws nothing where it stands.
bool isOnlyDefined(const QString &element);
/// Whether it is a group of what is in it.
bool isGroup(const QString &element);
bool mayHaveMarkers(const QString &element);
/// Whether it asks for no extension, and for no language but English.
bool isForAll(const SvgElement &element);

/// The view box of the document, or its size.
Rect viewportOf(const SvgTree &tree);

} // namespace suffuse

// Groups go with their last stroke, since a group without strokes has no place in the order.
#pragma once

#include "model/document/document.h"

namespace suffuse {

/// Lets the edit take away the groups that lose their last stroke by it, with those in them. Returns them.
std::vector<GroupId> takeEmptied(const Painting &painting, Edit &edit);

/// Whether there is such a group, and no stroke is in it or in those within it. Files of earlier versions have such.
bool isEmptyGroup(const Painting &painting, GroupId group);
/// Takes away an empty group, with those in it.
Edit deleteEmptyGroup(const Document &document, GroupId group);

} // namespace suffuse

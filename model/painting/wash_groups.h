// Which groups lie in a wash.
#pragma once

#include "model/painting/painting.h"

#include <unordered_map>

namespace suffuse {

/// For each group that lies in a wash, or is one, that wash: the outermost one. Masks within it belong to no wash.
std::unordered_map<GroupId, const Group *> washesOf(const Painting &painting);

} // namespace suffuse

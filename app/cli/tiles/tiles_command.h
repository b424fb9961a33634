// The part of `render` that writes pictures in tiles.
#pragma once

#include "app/cli/options.h"

namespace suffuse::cli {

/// --tiles and what belongs to it.
void addTilesOptions(CommandLine &line);
int renderTilesCommand(const CommandLine &line);

} // namespace suffuse::cli

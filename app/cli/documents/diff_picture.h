// The picture of suffuse-cli diff: B, pale and grey, with what differs in colours.
#pragma once

#include "app/cli/options.h"
#include "model/document/difference.h"

namespace suffuse::cli {

void addDiffPictureOptions(CommandLine &line);
/// What can be told before the paintings are read. Errors are usage errors.
Result<void> checkDiffPictureOptions(const CommandLine &line);
/// Writes --output.
Result<void> writeDiffPicture(const CommandLine &line, const PaintingPtr &a, const PaintingPtr &b,
                              const PaintingDifference &difference);

} // namespace suffuse::cli

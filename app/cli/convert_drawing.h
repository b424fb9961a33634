// `suffuse-cli convert IN OUT.svg`.
#pragma once

#include "app/cli/options.h"
#include "model/formats/files.h"

namespace suffuse::cli {

/// Adds --as, --bands and --time.
void addDrawingOptions(CommandLine &line);
/// Draws a painting as SVG into `out`, a file or "-", after saying how far that is from the picture. Returns an
/// ExitCode.
int convertToDrawing(const CommandLine &line, const Painting &painting, const QString &out);

} // namespace suffuse::cli

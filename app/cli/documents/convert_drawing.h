// `suffuse-cli convert IN OUT.svg` and `… OUT.pdf`.
#pragma once

#include "app/cli/options.h"
#include "model/formats/files.h"
#include "render/drawing/path_drawing.h"

namespace suffuse::cli {

/// Adds --as, --bands, --time and --page.
void addDrawingOptions(CommandLine &line);
/// Which of them is of no use for what is written; empty if none.
QString drawingProblem(const CommandLine &line, std::optional<DrawingFormat> format);
/// Draws paintings (one; several as the pages of a PDF) into `out`, a file or "-", after saying how far that is from
/// the picture. Returns an ExitCode.
int convertToDrawing(const CommandLine &line, const std::vector<LoadedDocument> &documents, DrawingFormat format,
                     const QString &out);

} // namespace suffuse::cli

// How a painting is looked at, in its file.
#pragma once

#include "model/formats/files.h"

namespace suffuse {

class CanvasWidget;
class Editor;

/// None where it is as usual: all of the canvas, at the end, painted on top of all,
/// with all groups closed, no symmetry, guides and assistants, and never printed. How it was printed stays as the document has it.
std::optional<WorkspaceState> workspaceOf(const CanvasWidget &canvas, const Editor &editor);
/// What lies outside the canvas's limits is brought within them. Groups that are not there any more are passed over.
void showWorkspace(const WorkspaceState &state, CanvasWidget &canvas, Editor &editor);

} // namespace suffuse

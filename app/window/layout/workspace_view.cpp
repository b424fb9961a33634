#include "app/window/layout/workspace_view.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/editor.h"

namespace suffuse {

std::optional<WorkspaceState> workspaceOf(const CanvasWidget &canvas, const Editor &editor)
{
    if (canvas.isFitted() && !editor.clock().isInPast())
        return {};
    const View &view = canvas.view();
    WorkspaceState state{view.centre, view.scale / canvas.devicePixelRatioF(), view.rotation, view.mirrored, {}};
    if (editor.clock().isInPast())
        state.time = editor.clock().time();
    return state;
}

void showWorkspace(const WorkspaceState &state, CanvasWidget &canvas, Editor &editor)
{
    View view = canvas.view();
    view.centre = state.centre;
    view.scale = state.scale * canvas.devicePixelRatioF();
    view.rotation = state.rotation;
    view.mirrored = state.mirrored;
    canvas.lookThrough(view);
    if (state.time)
        editor.clock().lookAt(*state.time);
}

} // namespace suffuse

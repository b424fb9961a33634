#include "app/window/layout/workspace_view.h"

#include "app/canvas/canvas_widget.h"
#include "app/panels/strokes/strokes_panel.h"
#include "app/session/current_layer.h"
#include "app/session/drawing_aids.h"
#include "app/session/editor.h"

namespace suffuse {

namespace {

StrokesPanel *strokesBeside(const CanvasWidget &canvas)
{
    return canvas.window()->findChild<StrokesPanel *>();
}

} // namespace

std::optional<WorkspaceState> workspaceOf(const CanvasWidget &canvas, const Editor &editor)
{
    WorkspaceState state;
    state.isFitted = canvas.isFitted();
    if (const View &view = canvas.view(); !state.isFitted)
        state = {view.centre, view.scale / canvas.devicePixelRatioF(), view.rotation, view.mirrored, {}};
    if (editor.clock().isInPast())
        state.time = editor.clock().time();
    state.layer = editor.layer().isComing() ? 0 : editor.layer().group();
    state.begun = editor.layer().begun();
    if (const StrokesPanel *strokes = strokesBeside(canvas))
        state.open = strokes->openGroups();
    if (const Symmetry &symmetry = editor.aids().symmetry();
        symmetry != DrawingAids::usualSymmetry(editor.unsettled().painting()->canvas.area()))
        state.symmetry = symmetry;
    state.guides = editor.aids().guides();
    state.assistants = editor.aids().assistants();
    if (const auto &kept = editor.extras().view)
        state.print = kept->print;
    const bool isUsual = state.isFitted && !state.time && state.layer == 0 && state.open.empty() && !state.begun &&
                         !state.symmetry && state.guides.empty() && state.assistants.empty() && !state.print;
    return isUsual ? std::nullopt : std::optional(state);
}

void showWorkspace(const WorkspaceState &state, CanvasWidget &canvas, Editor &editor)
{
    if (!state.isFitted) {
        View view = canvas.view();
        view.centre = state.centre;
        view.scale = state.scale * canvas.devicePixelRatioF();
        view.rotation = state.rotation;
        view.mirrored = state.mirrored;
        canvas.lookThrough(view);
    }
    if (state.time)
        editor.clock().lookAt(*state.time);
    if (state.symmetry)
        editor.aids().setSymmetry(*state.symmetry);
    editor.aids().setGuides(state.guides);
    editor.aids().setAssistants(state.assistants);
    if (state.layer != 0)
        editor.layer().choose(state.layer);
    if (state.begun)
        editor.layer().beginAgain(*state.begun);
    if (StrokesPanel *strokes = strokesBeside(canvas))
        strokes->openOnly(state.open);
}

} // namespace suffuse

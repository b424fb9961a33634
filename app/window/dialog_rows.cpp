#include "app/window/dialog_rows.h"

#include "app/canvas/canvas_widget.h"
#include "app/dialogs/fit/fit_dialog.h"
#include "app/dialogs/recolour_dialog.h"
#include "app/dialogs/reshape_dialog.h"
#include "app/dialogs/vary_dialog.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/session/commands/selection_commands.h"
#include "app/session/commands/session_rows.h"
#include "app/session/open_painting.h"
#include "app/widgets/asking/ask_number.h"
#include "app/widgets/habits/at_next_change.h"
#include "app/widgets/habits/place_beside.h"
#include "model/area/outline.h"
#include "undo/time_edits.h"

#include <QInputDialog>
#include <QLineEdit>
#include <QMainWindow>
#include <QStatusBar>

#include <algorithm>

namespace suffuse {

namespace {

/// What is to be renamed and how it is called.
struct PresentName {
    QString label;
    QString name;  ///< as it was typed; empty: none, or several
    QString title; ///< what people see where it has no name
};

/// Of the group that is selected as a whole, or else of the selected strokes; nothing where none are.
std::optional<PresentName> presentNameOf(const Document &document)
{
    const Painting &painting = *document.painting();
    const std::set<StrokeId> &selected = document.selection().strokes;
    if (const GroupId group = selectedGroup(document))
        for (const Group &g : painting.groups)
            if (g.id == group)
                return PresentName{Commands::tr("Name of the group"), g.name, titleOf(g)};
    if (selected.empty())
        return {};
    const StrokePtr first = painting.find(*selected.begin());
    const bool alike = std::all_of(selected.begin(), selected.end(),
                                   [&](StrokeId id) { return painting.find(id)->name == first->name; });
    return PresentName{Commands::tr("Name of %Ln stroke(s)", nullptr, int(selected.size())),
                       alike ? first->name : QString(), selected.size() == 1 ? titleOf(*first) : QStringLiteral("—")};
}

void renameSelected(const Workplace &place)
{
    const std::optional<PresentName> present = presentNameOf(place.open.editor.document());
    if (!present)
        return;
    QInputDialog dialog(&place.window);
    dialog.setWindowTitle(Commands::tr("Rename"));
    dialog.setLabelText(present->label);
    dialog.setTextValue(present->name);
    if (auto *field = dialog.findChild<QLineEdit *>())
        field->setPlaceholderText(present->title);
    if (dialog.exec() == QDialog::Accepted)
        commands::renameSelected(place.open.editor, dialog.textValue());
}

void rewetSelected(const Workplace &place)
{
    Editor &editor = place.open.editor;
    constexpr double usualSeconds = 1, mostSeconds = 1e6;
    const Microseconds now = editor.clock().time(); // the dialog takes its time
    const Painting &painting = *editor.document().painting();
    const auto &selected = editor.selection().strokes;
    const auto isFill = [&](StrokeId id) {
        const StrokePtr stroke = painting.find(id);
        return stroke && isFillAlone(*stroke);
    };
    if (std::ranges::all_of(selected, isFill)) {
        emit place.commands.said(Commands::tr("A fill cannot be wetted again. It spreads as long as it takes to dry."),
                                 8000);
        return;
    }
    const std::optional<double> seconds =
        askNumber(&place.window, {Commands::tr("Re-wet"), Commands::tr("Seconds that the paint spreads on"),
                                  usualSeconds, 0.001, mostSeconds});
    if (!seconds)
        return;
    Edit edit = rewet(editor.document(), now, toMicroseconds(*seconds));
    if (edit.isEmpty())
        emit place.commands.said(Commands::tr("Nothing that is selected is painted yet at this moment."), 5000);
    editor.push(std::move(edit), Commands::tr("Re-wet"));
}

/// Puts a dialog whose work shows on the canvas at once beside what is selected, or beside the canvas, as far as there
/// is room.
void moveBesideSelected(QDialog &dialog, const Workplace &place)
{
    constexpr int paint = 24; // logical pixels that the paint may reach beyond its curves
    const CanvasWidget &canvas = place.canvas;
    const QRect selected = canvas.selectionOnScreen(), all(canvas.mapToGlobal(QPoint()), canvas.size());
    moveBeside(dialog, selected.isEmpty() ? all : selected.adjusted(-paint, -paint, paint, paint) & all);
}

void varySelected(const Workplace &place)
{
    Editor &editor = place.open.editor;
    if (chosenCount(*editor.document().painting(), editor.selection()) == 0) {
        emit place.commands.said(Commands::tr("What is selected is locked or hidden."), 5000);
        return;
    }
    VaryDialog dialog(editor, &place.window);
    moveBesideSelected(dialog, place);
    dialog.exec();
}

void reshapeSelectedBy(const Workplace &place, Reshaping what)
{
    Editor &editor = place.open.editor;
    if (chosenCount(*editor.document().painting(), editor.selection()) == 0) {
        emit place.commands.said(Commands::tr("What is selected is locked or hidden."), 5000);
        return;
    }
    ReshapeDialog dialog(editor, what, &place.window);
    moveBesideSelected(dialog, place);
    dialog.exec();
}

void refitSelected(const Workplace &place)
{
    place.canvas.settleTool();
    place.open.playback.pause();
    Editor &editor = place.open.editor;
    Result<RefitTask> task = RefitTask::ofSelection(editor);
    if (!task) {
        // After a file's name it goes on in lower case.
        emit place.commands.said(task.error().left(1).toUpper() + task.error().mid(1) + QLatin1Char('.'), 8000);
        return;
    }
    FitDialog dialog(editor, std::move(*task), &place.window);
    if (dialog.exec() == QDialog::Accepted)
        sayUntilChange(*place.window.statusBar(), editor.document(), dialog.said());
}

void recolourArtwork(const Workplace &place)
{
    Editor &editor = place.open.editor;
    RecolourDialog dialog(editor, &place.window);
    if (dialog.recolouring().uses().empty()) {
        emit place.commands.said(Commands::tr("What is selected is locked or hidden."), 5000);
        return;
    }
    dialog.setStepKeys(place.commands[Command::Undo].shortcuts(), place.commands[Command::Redo].shortcuts());
    moveBesideSelected(dialog, place);
    const CanvasAids aids = place.canvas.aids();
    CanvasAids bare = aids;
    bare.showOutlines = false; // Outlines over the paint would hide the colours that are judged.
    place.canvas.setAids(bare);
    dialog.exec();
    place.canvas.setAids(aids);
}

} // namespace

void addDialogRows(const Workplace &place)
{
    place.commands
        .add(Command::RenameStrokes, "rename", Commands::tr("Rena&me…"), "", {QKeySequence(Commands::tr("F2"))})
        .when(anySelected(place.open.editor))
        .runs([place] { renameSelected(place); });
    place.commands
        .add(Command::Rewet, "rewet", Commands::tr("Re-&wet…"), "rewet", {QKeySequence(Commands::tr("Ctrl+Alt+W"))},
             Commands::tr("Let the selected paint spread on for a while from this moment"))
        .when(anySelected(place.open.editor))
        .runs([place] { rewetSelected(place); });
    place.commands
        .add(Command::RecolourArtwork, "recolourArtwork", Commands::tr("Recolour Artwor&k…"), "",
             {QKeySequence(Commands::tr("Ctrl+Alt+C"))},
             Commands::tr("Give each colour of the painting, or of what is selected, another one everywhere"))
        .when(anyStrokes(place.open.editor))
        .runs([place] { recolourArtwork(place); });
    place.commands
        .add(Command::SimplifyStrokes, "simplify", Commands::tr("Simp&lify…"), "simplify",
             {QKeySequence(Commands::tr("Ctrl+L"))}, Commands::tr("Make fewer segments of the selected strokes"))
        .when(anySelected(place.open.editor))
        .runs([place] { reshapeSelectedBy(place, Reshaping::Simplify); });
    place.commands
        .add(Command::RefitStrokes, "refit", Commands::tr("&Fewer Strokes…"), "", {},
             Commands::tr("Make fewer strokes that look like the selected ones"))
        .when(anySelected(place.open.editor))
        .runs([place] { refitSelected(place); });
    place.commands
        .add(Command::VaryStrokes, "vary", Commands::tr("Vary at Rand&om…"), "",
             {QKeySequence(Commands::tr("Ctrl+Alt+Y"))},
             Commands::tr("Let values and colours of the selected strokes stray at random"))
        .when(anySelected(place.open.editor))
        .runs([place] { varySelected(place); });
    place.commands
        .add(Command::OffsetStrokes, "offset", Commands::tr("&Offset and More…"), "offset",
             {QKeySequence(Commands::tr("Ctrl+Alt+O"))},
             Commands::tr("Offset, smooth, straighten, grow or shrink the selected strokes by numbers"))
        .when(anySelected(place.open.editor))
        .runs([place] { reshapeSelectedBy(place, Reshaping::Offset); });
}

} // namespace suffuse

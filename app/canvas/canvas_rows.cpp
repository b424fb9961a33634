#include "app/canvas/canvas_rows.h"

#include "app/canvas/canvas_widget.h"
#include "app/canvas/handles/assistant_rows.h"
#include "app/canvas/handles/guide_rows.h"
#include "app/canvas/handles/symmetry_rows.h"
#include "app/canvas/reading/canvas_reading.h"
#include "app/canvas/reading/pen_speech.h"
#include "app/session/commands/selection_commands.h"
#include "app/session/commands/session_rows.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/ask_number.h"

#include <memory>

namespace suffuse {

namespace {

constexpr double zoomStep = 1.4142135623730951;
constexpr double turnStep = 15; ///< degrees

/// Whether something is in the tool's hand, which belongs to no undo step yet.
bool isBusy(const CanvasWidget &canvas)
{
    return canvas.tool() && canvas.tool()->isBusy();
}

bool hasChosen(const CanvasWidget &canvas)
{
    return canvas.tool() && canvas.tool()->hasChosen();
}

/// Undo gives up what is in hand first, as in Krita. Returns false if nothing was in hand.
bool givesUp(CanvasWidget &canvas)
{
    if (!isBusy(canvas))
        return false;
    if (canvas.keyboardPen().isDown())
        canvas.keyboardPen().giveUp(); // No hand lets go of it.
    else
        canvas.tool()->cancel();
    return true;
}

/// Whether something is selected that neither the canvas nor the dock with the keyboard shows: nobody knows then what
/// would be deleted.
bool isUnseen(const CanvasWidget &canvas)
{
    return canvas.hasFocus() && !canvas.selection().isEmpty() && !canvas.tool()->showsOutlines() &&
           !canvas.isSelectionRevealed();
}

void changeAid(CanvasWidget &canvas, bool CanvasAids::*aid, bool on)
{
    CanvasAids aids = canvas.aids();
    aids.*aid = on;
    canvas.setAids(aids);
    settings::setCanvasAids(aids);
}

void askForGridStep(CanvasWidget &canvas)
{
    const std::optional<double> step =
        askNumber(canvas.window(),
                  {Commands::tr("Grid"), Commands::tr("Step"), canvas.aids().gridStep, 0.001, maxGridStep, 3, true});
    if (!step)
        return;
    CanvasAids aids = canvas.aids();
    aids.gridStep = *step;
    canvas.setAids(aids);
    settings::setCanvasAids(aids);
}

void addEditingRows(Commands &table, CanvasWidget &canvas)
{
    using enum Command;
    Editor &editor = canvas.editor();
    const auto keys = [](QKeySequence::StandardKey key) { return QKeySequence::keyBindings(key); };
    const auto inHand = [&canvas, &editor] { return editor.document().draft() || isBusy(canvas); };
    table.add(Undo, "undo", Commands::tr("&Undo"), "undo", keys(QKeySequence::Undo))
        .when([inHand, &editor] { return inHand() || editor.canUndo(); }, Commands::tr("There is nothing to undo."))
        .named([&editor] {
            const bool strokeInHand = editor.document().draft() != nullptr;
            const QString step = strokeInHand ? QString() : editor.undoText();
            return step.isEmpty() ? Commands::tr("&Undo") : Commands::tr("&Undo: %1").arg(step);
        })
        .runs([&canvas, &editor] {
            if (!(canvas.tool() && canvas.tool()->takeBack()) && !givesUp(canvas))
                editor.undo();
        });
    table
        .add(Redo, "redo", Commands::tr("&Redo"), "redo",
             {QKeySequence(Commands::tr("Ctrl+Shift+Z")), QKeySequence(Commands::tr("Ctrl+Y"))})
        .when([inHand, &editor] { return editor.canRedo() && !inHand(); }, Commands::tr("There is nothing to redo."))
        .named([&editor] {
            const QString step = editor.redoText();
            return step.isEmpty() ? Commands::tr("&Redo") : Commands::tr("&Redo: %1").arg(step);
        })
        .runs([&editor] { editor.redo(); });
    table.add(Delete, "delete", Commands::tr("&Delete"), "delete", {QKeySequence(Qt::Key_Delete)})
        .in(CommandScope::Strokes)
        .when([&canvas, &editor] { return isBusy(canvas) || hasChosen(canvas) || commands::canDelete(editor); },
              Commands::tr("Nothing is selected: click paint with Select first."))
        .runs([&canvas, &editor, &table] {
            if (canvas.tool()->takesText() ? canvas.tool()->deleteSelected()
                                           : givesUp(canvas) || canvas.tool()->deleteSelected())
                return;
            if (isUnseen(canvas)) {
                canvas.revealSelection();
                emit table.said(commands::unseenSelection(editor), 8000);
                return;
            }
            const QString done = commands::deleteSelected(editor);
            // A tool that shows no outlines leaves open what was selected.
            if (!done.isEmpty() && !canvas.tool()->showsOutlines())
                emit table.said(done, 5000);
        })
        .action->setAutoRepeat(false); // A key that is held does not go on with what was left.
}

void addViewRows(Commands &table, CanvasWidget &canvas)
{
    using enum Command;
    // They would move the paint away under a pointer that drags it.
    const auto unlessPressed = [&table, &canvas](auto moveView) {
        return [&table, &canvas, moveView] {
            if (!canvas.isPressed())
                moveView();
            else
                table.update(Command::Mirror); // Its tick stays as it was.
        };
    };
    // On many keyboards "=" is the key of "+" without Shift.
    table
        .add(ZoomIn, "zoomIn", Commands::tr("Zoom &In"), "zoom-in",
             {QKeySequence(Qt::Key_Plus), QKeySequence(Qt::Key_Equal), QKeySequence(QKeySequence::ZoomIn)})
        .runs(unlessPressed([&canvas] { canvas.zoomBy(zoomStep); }));
    table
        .add(ZoomOut, "zoomOut", Commands::tr("Zoom &Out"), "zoom-out",
             {QKeySequence(Qt::Key_Minus), QKeySequence(QKeySequence::ZoomOut)})
        .runs(unlessPressed([&canvas] { canvas.zoomBy(1 / zoomStep); }));
    table.add(Zoom100, "zoom100", Commands::tr("&100 %"), "", {QKeySequence(Commands::tr("Ctrl+1"))})
        .runs(unlessPressed([&canvas] { canvas.setZoom(1); }));
    table.add(Fit, "fit", Commands::tr("&Fit the Canvas"), "fit", {QKeySequence(Qt::Key_0)})
        .runs(unlessPressed([&canvas] { canvas.fit(); }));
    table
        .add(ZoomToSelection, "zoomToSelection", Commands::tr("&Zoom to Selection"), "",
             {QKeySequence(Commands::tr("Ctrl+0"))},
             Commands::tr("Show what is selected as large as possible: strokes, segments or nodes"))
        .when(anySelected(canvas.editor()))
        .runs(unlessPressed([&canvas] { canvas.zoomToSelection(); }));
    table.add(RotateLeft, "rotateLeft", Commands::tr("Turn &Left"), "", {QKeySequence(Commands::tr("Ctrl+4"))})
        .runs(unlessPressed([&canvas] { canvas.rotateBy(-turnStep); }));
    table.add(RotateRight, "rotateRight", Commands::tr("Turn &Right"), "", {QKeySequence(Commands::tr("Ctrl+6"))})
        .runs(unlessPressed([&canvas] { canvas.rotateBy(turnStep); }));
    table.add(ResetRotation, "resetRotation", Commands::tr("&Upright"), "", {QKeySequence(Commands::tr("Ctrl+5"))})
        .runs(unlessPressed([&canvas] { canvas.resetRotation(); }));
    table.add(Mirror, "mirror", Commands::tr("&Mirror"), "", {QKeySequence(Qt::Key_M)})
        .checkedWhen([&canvas] { return canvas.view().mirrored; })
        .runs(unlessPressed([&canvas] { canvas.mirror(); }));
}

void addToolRows(Commands &table, CanvasWidget &canvas)
{
    using enum Command;
    table.add(SmallerSize, "smallerSize", Commands::tr("S&maller Tool Size"), "", {QKeySequence(Qt::Key_BracketLeft)})
        .runs([&canvas] { canvas.tool()->stepSize(-1); });
    table.add(LargerSize, "largerSize", Commands::tr("La&rger Tool Size"), "", {QKeySequence(Qt::Key_BracketRight)})
        .runs([&canvas] { canvas.tool()->stepSize(1); });
    table.add(LessOpacity, "lessOpacity", Commands::tr("&Less Opacity"), "", {QKeySequence(Qt::Key_BraceLeft)})
        .runs([&canvas] { canvas.tool()->stepOpacity(-1); });
    table.add(MoreOpacity, "moreOpacity", Commands::tr("More &Opacity"), "", {QKeySequence(Qt::Key_BraceRight)})
        .runs([&canvas] { canvas.tool()->stepOpacity(1); });
}

void addHeldRows(Commands &table, CanvasWidget &canvas)
{
    using enum Command;
    const auto held = std::make_shared<HeldKeys>();
    table.add(HoldToPan, "holdToPan", Commands::tr("Move the Canvas While Held"), "", {QKeySequence(Qt::Key_Space)})
        .in(CommandScope::Canvas)
        .held([&canvas, held](const QList<QKeySequence> &keys) {
            held->pan = keys;
            canvas.setHeldKeys(*held);
        });
    table.add(HoldToTurn, "holdToTurn", Commands::tr("Turn the Canvas While Held"), "", {QKeySequence(Qt::Key_R)})
        .in(CommandScope::Canvas)
        .held([&canvas, held](const QList<QKeySequence> &keys) {
            held->turn = keys;
            canvas.setHeldKeys(*held);
        });
    table
        .add(HoldToHideOutlines, "holdToHideOutlines", Commands::tr("Hide Outlines and Handles While Held"), "",
             {QKeySequence(Qt::Key_O)})
        .in(CommandScope::Canvas)
        .held([&canvas, held](const QList<QKeySequence> &keys) {
            held->bare = keys;
            canvas.setHeldKeys(*held);
        });
}

void addPenRow(Commands &table, CanvasWidget &canvas)
{
    table
        .add(Command::PaintWithKeys, "paintWithKeys", Commands::tr("Paint with Ke&ys"), "",
             {QKeySequence(Commands::tr("Ctrl+Alt+P"))},
             Commands::tr(
                 "Arrow keys move a crosshair over the canvas, Space presses the tool in use down and lifts it"))
        .checkedWhen([&canvas] { return canvas.keyboardPen().isOn(); })
        .runs([&canvas] {
            canvas.setFocus(Qt::OtherFocusReason);
            canvas.setKeyboardPenOn(!canvas.keyboardPen().isOn());
        });
    QObject::connect(&canvas.keyboardPen(), &KeyboardPen::onChanged, &table,
                     [&table] { table.update(Command::PaintWithKeys); });
    auto *reading = new CanvasReading(canvas, &table);
    auto *speech = new PenSpeech(canvas, *reading, &table);
    QObject::connect(speech, &PenSpeech::said, &table, [&table](const QString &text) { emit table.said(text, 8000); });
    QObject::connect(&table, &Commands::said, reading, [reading](const QString &text) { reading->say(text); });
}

void addAidRows(Commands &table, CanvasWidget &canvas)
{
    using enum Command;
    const CanvasAids aids = canvas.aids();
    table.add(SnapToNodes, "snapToNodes", Commands::tr("Snap to &Nodes"), "", {QKeySequence(Commands::tr("%"))})
        .checkable(aids.snapToNodes)
        .toggles([&canvas](bool on) { changeAid(canvas, &CanvasAids::snapToNodes, on); });
    table.add(SnapToGrid, "snapToGrid", Commands::tr("Snap to &Grid"), "", {})
        .checkable(aids.snapToGrid)
        .toggles([&canvas](bool on) { changeAid(canvas, &CanvasAids::snapToGrid, on); });
    table.add(ShowGrid, "showGrid", Commands::tr("&Show the Grid"), "", {QKeySequence(Commands::tr("#"))})
        .checkable(aids.showGrid)
        .toggles([&canvas](bool on) { changeAid(canvas, &CanvasAids::showGrid, on); });
    table.add(GridStep, "gridStep", Commands::tr("Grid St&ep…"), "", {}).runs([&canvas] { askForGridStep(canvas); });
    table
        .add(ShowOutlines, "showOutlines", Commands::tr("Show Ou&tlines"), "", {QKeySequence(Commands::tr("Shift+O"))},
             Commands::tr("Lines along the selected strokes; the Brush shows none"))
        .checkable(aids.showOutlines)
        .toggles([&canvas](bool on) { changeAid(canvas, &CanvasAids::showOutlines, on); });
    table
        .add(ShowErasures, "showErasures", Commands::tr("Show Erasures"), "", {QKeySequence(Commands::tr("Shift+E"))},
             Commands::tr("Dashed lines along what was erased softly from all strokes; what is not selected is paler"))
        .checkable(aids.showErasures)
        .toggles([&canvas](bool on) { changeAid(canvas, &CanvasAids::showErasures, on); });
    table
        .add(ShowBeyond, "showBeyond", Commands::tr("Show Paint &beyond the Canvas"), "", {},
             Commands::tr("Under a veil, what was painted beside the canvas; it is in no picture that is exported"))
        .checkable(aids.showBeyond)
        .toggles([&canvas](bool on) { changeAid(canvas, &CanvasAids::showBeyond, on); });
    table
        .add(ShowSymmetry, "showSymmetry", Commands::tr("&Show the Axes of the Symmetry"), "", {},
             Commands::tr("Also the square that moves them and the disc that turns them"))
        .checkable(aids.showSymmetry)
        .toggles([&canvas](bool on) { changeAid(canvas, &CanvasAids::showSymmetry, on); });
}

} // namespace

void addCanvasRows(Commands &table, CanvasWidget &canvas)
{
    canvas.setAids(settings::canvasAids());
    addEditingRows(table, canvas);
    addViewRows(table, canvas);
    addToolRows(table, canvas);
    addHeldRows(table, canvas);
    addPenRow(table, canvas);
    addAidRows(table, canvas);
    addSymmetryRows(table, canvas);
    addGuideRows(table, canvas);
    addAssistantRows(table, canvas);
    QObject::connect(&canvas, &CanvasWidget::viewChanged, &table, [&table] { table.update(Command::Mirror); });
    QObject::connect(&canvas, &CanvasWidget::busyChanged, &table, [&table, &canvas] {
        if (!canvas.editor().laterChanges().isWaiting()) // Otherwise the table is updated with the changes that wait.
            table.update();
    });
}

} // namespace suffuse

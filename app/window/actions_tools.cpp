// Tools, what they do to nodes, favourite brushes and keys of tools.
#include "app/window/actions.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/commands/selection_commands.h"
#include "app/session/editor.h"

#include <QActionGroup>

namespace suffuse {

void Actions::addTools()
{
    add(Command::Brush, "brush", tr("&Brush"), "brush", {QKeySequence(Qt::Key_B)}, tr("Paint strokes"));
    add(Command::Select, "select", tr("&Select"), "select", {QKeySequence(Qt::Key_V)}, tr("Select and move strokes"));
    add(Command::Segments, "segments", tr("Se&gments"), "segments", {QKeySequence(Qt::Key_N)},
        tr("Edit segments, nodes and handles of strokes"));
    add(Command::Pan, "pan", tr("&Hand"), "pan", {QKeySequence(Qt::Key_H)}, tr("Move the canvas"));
    auto *group = new QActionGroup(this);
    add(Command::Knife, "knife", tr("&Knife"), "knife", {QKeySequence(Qt::Key_K)}, tr("Cut strokes along a line"));
    add(Command::Eraser, "eraser", tr("&Eraser"), "eraser", {QKeySequence(Qt::Key_E)}, tr("Erase parts of strokes"));
    add(Command::AttributeBrush, "attributeBrush", tr("&Attribute Brush"), "attribute-brush", {QKeySequence(Qt::Key_A)},
        tr("Paint values onto segments"));
    add(Command::Eyedropper, "eyedropper", tr("Eye&dropper"), "eyedropper", {QKeySequence(Qt::Key_I)},
        tr("Pick a colour"));
    for (const Command command : {Command::Brush, Command::Select, Command::Segments, Command::Knife, Command::Eraser,
                                  Command::AttributeBrush, Command::Eyedropper, Command::Pan}) {
        m_actions[command]->setCheckable(true);
        group->addAction(m_actions[command]);
    }
    add(Command::Raise, "raise", tr("&Raise"), "raise", {QKeySequence(Qt::Key_PageUp)})
        .when(anySelected)
        .runs([](const CommandTarget &t) { commands::arrangeSelected(t.editor, Arrange::Raise); });
    add(Command::Lower, "lower", tr("&Lower"), "lower", {QKeySequence(Qt::Key_PageDown)})
        .when(anySelected)
        .runs([](const CommandTarget &t) { commands::arrangeSelected(t.editor, Arrange::Lower); });
    add(Command::Top, "top", tr("Raise to &Top"), "top", {QKeySequence(Qt::Key_Home)})
        .when(anySelected)
        .runs([](const CommandTarget &t) { commands::arrangeSelected(t.editor, Arrange::Top); });
    add(Command::Bottom, "bottom", tr("Lower to &Bottom"), "bottom", {QKeySequence(Qt::Key_End)})
        .when(anySelected)
        .runs([](const CommandTarget &t) { commands::arrangeSelected(t.editor, Arrange::Bottom); });
}

void Actions::addNodeCommands()
{
    add(Command::InsertNodes, "insertNodes", tr("&Insert Nodes"), "node-insert", {QKeySequence(Qt::Key_Insert)},
        tr("Insert a node into each selected segment"));
    add(Command::NodeCorner, "nodeCorner", tr("&Corner"), "node-corner", {QKeySequence(tr("Shift+C"))},
        tr("Make the selected nodes corners"));
    add(Command::NodeSmooth, "nodeSmooth", tr("&Smooth"), "node-smooth", {QKeySequence(tr("Shift+S"))},
        tr("Make the selected nodes smooth"));
    add(Command::NodeSymmetric, "nodeSymmetric", tr("S&ymmetric"), "node-symmetric", {QKeySequence(tr("Shift+Y"))},
        tr("Make the selected nodes symmetric"));
    add(Command::BreakNodes, "breakNodes", tr("&Break Strokes"), "node-break", {QKeySequence(tr("Shift+B"))},
        tr("Break strokes at the selected nodes"));
    add(Command::JoinNodes, "joinNodes", tr("&Join Nodes"), "node-join", {QKeySequence(tr("Shift+J"))},
        tr("Join two selected end nodes"));
    add(Command::DeleteSegments, "deleteSegments", tr("&Delete Segments"), "segment-delete",
        {QKeySequence(tr("Ctrl+Del"))}, tr("Delete the selected segments, so that strokes split"));
    add(Command::BridgeSegments, "bridgeSegments", tr("Brid&ge Segments"), "bridge", {QKeySequence(tr("Alt+Del"))},
        tr("Replace selected segments by one that goes on smoothly"));
    add(Command::ReverseStrokes, "reverseStrokes", tr("&Reverse"), "reverse", {QKeySequence(tr("Shift+R"))},
        tr("Let the selected strokes run from end to start"));
}

void Actions::addFavourites()
{
    for (int i = 0; i < 9; ++i)
        add(Command(int(Command::Favourite1) + i), QStringLiteral("favourite%1").arg(i + 1),
            tr("Favourite Brush %1").arg(i + 1), "", {QKeySequence(Qt::Key_1 + i)});
}

void Actions::addToolKeys()
{
    add(Command::SmallerSize, "smallerSize", tr("S&maller Tool Size"), "", {QKeySequence(Qt::Key_BracketLeft)})
        .runs([](const CommandTarget &t) { t.canvas.tool()->stepSize(-1); });
    add(Command::LargerSize, "largerSize", tr("La&rger Tool Size"), "", {QKeySequence(Qt::Key_BracketRight)})
        .runs([](const CommandTarget &t) { t.canvas.tool()->stepSize(1); });
    add(Command::LessOpacity, "lessOpacity", tr("&Less Opacity"), "", {QKeySequence(Qt::Key_BraceLeft)})
        .runs([](const CommandTarget &t) { t.canvas.tool()->stepOpacity(-1); });
    add(Command::MoreOpacity, "moreOpacity", tr("More &Opacity"), "", {QKeySequence(Qt::Key_BraceRight)})
        .runs([](const CommandTarget &t) { t.canvas.tool()->stepOpacity(1); });
    add(Command::HoldToPan, "holdToPan", tr("Move the Canvas While Held"), "", {QKeySequence(Qt::Key_Space)}).held();
    add(Command::HoldToTurn, "holdToTurn", tr("Turn the Canvas While Held"), "", {QKeySequence(Qt::Key_R)}).held();
    add(Command::HoldToHideOutlines, "holdToHideOutlines", tr("Hide Outlines and Handles While Held"), "",
        {QKeySequence(Qt::Key_O)})
        .held();
}

QList<FixedKeys> fixedKeys()
{
    const auto arrows = [](Qt::KeyboardModifiers modifiers) {
        QList<QKeySequence> keys;
        for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down})
            keys << QKeySequence(QKeyCombination(modifiers, key));
        return keys;
    };
    // Tab is not among them: it goes to the next stroke only where a tool has one, and hides the docks otherwise.
    return {{Actions::tr("Move the Selection"), arrows({})},
            {Actions::tr("Move the Selection Ten Times as Far"), arrows(Qt::ShiftModifier)},
            {Actions::tr("Move the Selection by One Unit"), arrows(Qt::AltModifier)},
            {Actions::tr("Move the Selection by Ten Units"), arrows(Qt::AltModifier | Qt::ShiftModifier)},
            {Actions::tr("Previous Stroke or Node"), {QKeySequence(Qt::SHIFT | Qt::Key_Tab)}},
            {Actions::tr("Give Up, or Deselect"), {QKeySequence(Qt::Key_Escape)}}};
}

} // namespace suffuse

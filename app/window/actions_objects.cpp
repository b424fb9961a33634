// The actions that work on whole strokes, and where people look for them.
#include "app/window/actions.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/commands/selection_commands.h"
#include "app/session/editor.h"
#include "app/session/selection_order.h"
#include "app/session/settings/settings.h"
#include "app/session/commands/underlay_commands.h"

#include <QActionGroup>
#include <QMenu>

namespace suffuse {

using enum Command;

namespace {

SpreadRule spreadRule(const CommandTarget &target)
{
    return target.actions[ScaleSpread].isChecked() ? SpreadRule::Scales : SpreadRule::Stays;
}

std::size_t countSelected(const CommandTarget &target)
{
    return target.editor.document().selection().strokes.size();
}

/// To the canvas one stroke can be aligned, too.
bool canAlign(const CommandTarget &target)
{
    return countSelected(target) > 1 || (anySelected(target) && target.actions[AlignToCanvas].isChecked());
}

bool canDistribute(const CommandTarget &target)
{
    return countSelected(target) > 2;
}

void align(const CommandTarget &target, Align how)
{
    const auto is = [&](Command command) { return target.actions[command].isChecked(); };
    const AlignTo to = is(AlignToCanvas)                     ? AlignTo::Canvas
                       : is(AlignToBiggest)                  ? AlignTo::Biggest
                       : is(AlignToLast) || is(AlignToFirst) ? AlignTo::Anchor
                                                             : AlignTo::Selection;
    const SelectionOrder &order = target.selectionOrder;
    commands::alignSelected(target.editor, how, to, is(AlignToFirst) ? order.first() : order.last());
}

void changeAid(const CommandTarget &target, bool CanvasAids::*aid, bool on)
{
    CanvasAids aids = target.canvas.aids();
    aids.*aid = on;
    target.canvas.setAids(aids);
    settings::setCanvasAids(aids);
}

} // namespace

void Actions::addObjects()
{
    const auto key = [](const QString &keys) { return QList<QKeySequence>{QKeySequence(keys)}; };
    add(InvertSelection, "invertSelection", tr("In&vert Selection"), "",
        {QKeySequence(tr("Ctrl+Shift+I")), QKeySequence(tr("!"))})
        .runs([](const CommandTarget &t) { commands::invertSelection(t.editor); });
    add(SameColour, "sameColour", tr("&Colour"), "", {}, tr("Select all strokes of the same colour"))
        .when(anySelected)
        .runs([](const CommandTarget &t) { commands::selectSameAs(t.editor, Same::Colour); });
    add(SameStyle, "sameStyle", tr("&Style"), "", {}, tr("Select all strokes of the same style"))
        .when(anySelected)
        .runs([](const CommandTarget &t) { commands::selectSameAs(t.editor, Same::Style); });
    add(SameBrush, "sameBrush", tr("&Brush"), "", {}, tr("Select all strokes of the same brush"))
        .when(anySelected)
        .runs([](const CommandTarget &t) { commands::selectSameAs(t.editor, Same::Brush); });
    add(SameName, "sameName", tr("&Name"), "", {}, tr("Select all strokes of the same name"))
        .when(anySelected)
        .runs([](const CommandTarget &t) { commands::selectSameAs(t.editor, Same::Name); });
    add(SelectFound, "selectFound", tr("Select &Found"), "", {},
        tr("Select what the search in the Strokes dock has found"));
    add(Lasso, "lasso", tr("&Lasso"), "lasso", key(tr("L")), tr("Select what is drawn around"));
    add(TouchPath, "touchPath", tr("&Touch"), "touch-path", {}, tr("Select what a path touches"));
    add(GroupStrokes, "group", tr("&Group"), "group-strokes", key(tr("Ctrl+G")))
        .when(anySelected)
        .runs([](const CommandTarget &t) { commands::groupSelected(t.editor); });
    add(UngroupStrokes, "ungroup", tr("&Ungroup"), "ungroup", key(tr("Ctrl+Shift+G")))
        .when(anySelected)
        .runs([](const CommandTarget &t) { commands::ungroupSelected(t.editor); });
    add(LockStrokes, "lock", tr("Loc&k"), "lock", key(tr("Ctrl+2"))).when(anySelected).runs([](const CommandTarget &t) {
        commands::lockSelected(t.editor);
    });
    add(UnlockAll, "unlockAll", tr("U&nlock All"), "unlock", key(tr("Ctrl+Alt+2"))).runs([](const CommandTarget &t) {
        commands::unlockAllStrokes(t.editor);
    });
    add(HideStrokes, "hide", tr("&Hide"), "eye-off", key(tr("Ctrl+3")))
        .when(anySelected)
        .runs([](const CommandTarget &t) { commands::hideSelected(t.editor); });
    add(ShowAll, "showAll", tr("Sho&w All"), "eye", key(tr("Ctrl+Alt+3"))).runs([](const CommandTarget &t) {
        commands::showAllStrokes(t.editor);
    });
    add(RenameStrokes, "rename", tr("Rena&me…"), "", key(tr("F2"))).when(anySelected);
    add(FlipAcross, "flipAcross", tr("Flip Hori&zontally"), "flip-across", key(tr("Shift+H")))
        .when(anySelected)
        .runs([](const CommandTarget &t) { commands::flipSelected(t.editor, Axis::Horizontal, spreadRule(t)); });
    add(FlipDown, "flipDown", tr("Flip &Vertically"), "flip-down", key(tr("Shift+V")))
        .when(anySelected)
        .runs([](const CommandTarget &t) { commands::flipSelected(t.editor, Axis::Vertical, spreadRule(t)); });
    add(QuarterLeft, "quarterLeft", tr("Rotate by 90° L&eft"), "quarter-left", key(tr("Ctrl+[")))
        .when(anySelected)
        .runs([](const CommandTarget &t) { commands::quarterTurnSelected(t.editor, -1, spreadRule(t)); });
    add(QuarterRight, "quarterRight", tr("Rotate by 90° R&ight"), "quarter-right", key(tr("Ctrl+]")))
        .when(anySelected)
        .runs([](const CommandTarget &t) { commands::quarterTurnSelected(t.editor, 1, spreadRule(t)); });
    add(ScaleSpread, "scaleSpread", tr("&Scale Spread with the Shape"), "scale-spread", {},
        tr("Spread and density follow the shape when it is scaled"))
        .toggles([](const CommandTarget &, bool on) { settings::setScalesSpread(on); });
    m_actions[ScaleSpread]->setCheckable(true);
    m_actions[ScaleSpread]->setChecked(settings::scalesSpread());
    auto *bands = new QActionGroup(this);
    bands->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    for (const Command command : {Lasso, TouchPath}) {
        m_actions[command]->setCheckable(true);
        bands->addAction(m_actions[command]);
    }
    addAligning();
    addAids();
}

void Actions::addAligning()
{
    add(AlignLeft, "alignLeft", tr("&Left Edges"), "align-left", {}).when(canAlign).runs([](const CommandTarget &t) {
        align(t, Align::Left);
    });
    add(AlignCentre, "alignCentre", tr("&Centres, Horizontally"), "align-centre", {})
        .when(canAlign)
        .runs([](const CommandTarget &t) { align(t, Align::Centre); });
    add(AlignRight, "alignRight", tr("&Right Edges"), "align-right", {})
        .when(canAlign)
        .runs([](const CommandTarget &t) { align(t, Align::Right); });
    add(AlignTop, "alignTop", tr("&Top Edges"), "align-top", {}).when(canAlign).runs([](const CommandTarget &t) {
        align(t, Align::Top);
    });
    add(AlignMiddle, "alignMiddle", tr("&Middles, Vertically"), "align-middle", {})
        .when(canAlign)
        .runs([](const CommandTarget &t) { align(t, Align::Middle); });
    add(AlignBottom, "alignBottom", tr("&Bottom Edges"), "align-bottom", {})
        .when(canAlign)
        .runs([](const CommandTarget &t) { align(t, Align::Bottom); });
    add(AlignToSelection, "alignToSelection", tr("Relative to the &Selection"), "", {});
    add(AlignToLast, "alignToLast", tr("Relative to the Last Select&ed"), "", {});
    add(AlignToFirst, "alignToFirst", tr("Relative to the &First Selected"), "", {});
    add(AlignToBiggest, "alignToBiggest", tr("Relative to the Bi&ggest"), "", {});
    add(AlignToCanvas, "alignToCanvas", tr("Relative to the C&anvas"), "", {});
    auto *relative = new QActionGroup(this);
    for (const Command command : {AlignToSelection, AlignToLast, AlignToFirst, AlignToBiggest, AlignToCanvas}) {
        m_actions[command]->setCheckable(true);
        relative->addAction(m_actions[command]);
    }
    m_actions[AlignToSelection]->setChecked(true);
    connect(relative, &QActionGroup::triggered, this, &Actions::update); // to the canvas one stroke is aligned, too
    add(DistributeGapsAcross, "distributeGapsAcross", tr("Even Gaps, &Horizontally"), "gaps-across", {})
        .when(canDistribute)
        .runs([](const CommandTarget &t) { commands::distributeSelected(t.editor, Axis::Horizontal, Spacing::Gaps); });
    add(DistributeGapsDown, "distributeGapsDown", tr("Even Gaps, &Vertically"), "gaps-down", {})
        .when(canDistribute)
        .runs([](const CommandTarget &t) { commands::distributeSelected(t.editor, Axis::Vertical, Spacing::Gaps); });
    add(DistributeCentresAcross, "distributeCentresAcross", tr("Even &Centres, Horizontally"), "centres-across", {})
        .when(canDistribute)
        .runs(
            [](const CommandTarget &t) { commands::distributeSelected(t.editor, Axis::Horizontal, Spacing::Centres); });
    add(DistributeCentresDown, "distributeCentresDown", tr("Even C&entres, Vertically"), "centres-down", {})
        .when(canDistribute)
        .runs([](const CommandTarget &t) { commands::distributeSelected(t.editor, Axis::Vertical, Spacing::Centres); });
}

void Actions::addAids()
{
    const CanvasAids aids = settings::canvasAids();
    add(SnapToNodes, "snapToNodes", tr("Snap to &Nodes"), "", {QKeySequence(tr("%"))})
        .toggles([](const CommandTarget &t, bool on) { changeAid(t, &CanvasAids::snapToNodes, on); });
    add(SnapToGrid, "snapToGrid", tr("Snap to &Grid"), "", {}).toggles([](const CommandTarget &t, bool on) {
        changeAid(t, &CanvasAids::snapToGrid, on);
    });
    add(ShowGrid, "showGrid", tr("&Show the Grid"), "", {QKeySequence(tr("#"))})
        .toggles([](const CommandTarget &t, bool on) { changeAid(t, &CanvasAids::showGrid, on); });
    add(GridStep, "gridStep", tr("Grid St&ep…"), "", {});
    add(ShowUnderlay, "showUnderlay", tr("Show the Underl&ay"), "", {QKeySequence(tr("Shift+U"))})
        .when([](const CommandTarget &t) { return bool(t.editor.document().painting()->underlay); })
        .checkedWhen([](const CommandTarget &t) {
            const auto &underlay = t.editor.document().painting()->underlay;
            return underlay && underlay->visible;
        })
        .runs([](const CommandTarget &t) { underlay::show(t.editor, t.actions[ShowUnderlay].isChecked()); });
    m_actions[ShowUnderlay]->setCheckable(true);
    add(ShowOutlines, "showOutlines", tr("Show Ou&tlines"), "", {QKeySequence(tr("Shift+O"))},
        tr("Lines along the selected strokes; the Brush shows none"))
        .toggles([](const CommandTarget &t, bool on) { changeAid(t, &CanvasAids::showOutlines, on); });
    add(ShowBeyond, "showBeyond", tr("Show Paint &beyond the Canvas"), "", {},
        tr("Under a veil, what was painted beside the canvas; it is in no picture that is exported"))
        .toggles([](const CommandTarget &t, bool on) { changeAid(t, &CanvasAids::showBeyond, on); });
    const std::pair<Command, bool> states[] = {{SnapToNodes, aids.snapToNodes},
                                               {SnapToGrid, aids.snapToGrid},
                                               {ShowGrid, aids.showGrid},
                                               {ShowOutlines, aids.showOutlines},
                                               {ShowBeyond, aids.showBeyond}};
    for (const auto &[command, on] : states) {
        m_actions[command]->setCheckable(true);
        m_actions[command]->setChecked(on);
    }
}

void Actions::fillObjectMenu(QMenu &menu)
{
    const auto append = [this](QMenu &to, const QList<Command> &commands) {
        for (const Command command : commands)
            to.addAction(m_actions.at(command));
    };
    append(menu, {Raise, Lower, Top, Bottom});
    menu.addSeparator();
    append(menu, {GroupStrokes, UngroupStrokes});
    menu.addSeparator();
    append(menu, {LockStrokes, UnlockAll, HideStrokes, ShowAll, RenameStrokes});
    menu.addSeparator();
    append(menu, {FlipAcross, FlipDown, QuarterLeft, QuarterRight, ScaleSpread});
    menu.addSeparator();
    QMenu *align = menu.addMenu(tr("&Align"));
    append(*align, {AlignLeft, AlignCentre, AlignRight});
    align->addSeparator();
    append(*align, {AlignTop, AlignMiddle, AlignBottom});
    align->addSeparator();
    append(*align, {AlignToSelection, AlignToLast, AlignToFirst, AlignToBiggest, AlignToCanvas});
    append(*menu.addMenu(tr("&Distribute")),
           {DistributeGapsAcross, DistributeCentresAcross, DistributeGapsDown, DistributeCentresDown});
}

void Actions::addSelecting(QMenu &edit)
{
    QAction *after = m_actions[Command::Settings];
    edit.insertAction(after, m_actions[InvertSelection]);
    auto *same = new QMenu(tr("Select Sa&me"), &edit);
    for (const Command command : {SameColour, SameStyle, SameBrush, SameName})
        same->addAction(m_actions[command]);
    edit.insertMenu(after, same);
}

void Actions::addAids(QMenu &view)
{
    for (const Command command : {SnapToNodes, SnapToGrid, ShowGrid, GridStep, ShowOutlines, ShowBeyond, ShowUnderlay})
        view.addAction(m_actions[command]);
    view.addSeparator();
}

} // namespace suffuse

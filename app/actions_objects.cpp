// The actions that work on whole strokes, and where people look for them.
#include "app/actions.h"

#include "app/settings.h"

#include <QActionGroup>
#include <QMenu>

namespace suffuse {

using enum Command;

void Actions::addObjects()
{
    const auto key = [](const QString &keys) { return QList<QKeySequence>{QKeySequence(keys)}; };
    add(InvertSelection, tr("In&vert Selection"), "", {QKeySequence(tr("Ctrl+Shift+I")), QKeySequence(tr("!"))});
    add(SameColour, tr("&Colour"), "", {}, tr("Select all strokes of the same colour"));
    add(SameStyle, tr("&Style"), "", {}, tr("Select all strokes of the same style"));
    add(SameBrush, tr("&Brush"), "", {}, tr("Select all strokes of the same brush"));
    add(Lasso, tr("&Lasso"), "lasso", key(tr("L")), tr("Select what is drawn around"));
    add(TouchPath, tr("&Touch"), "touch-path", {}, tr("Select what a path touches"));
    add(GroupStrokes, tr("&Group"), "group-strokes", key(tr("Ctrl+G")));
    add(UngroupStrokes, tr("&Ungroup"), "ungroup", key(tr("Ctrl+Shift+G")));
    add(LockStrokes, tr("Loc&k"), "lock", key(tr("Ctrl+2")));
    add(UnlockAll, tr("U&nlock All"), "unlock", key(tr("Ctrl+Alt+2")));
    add(HideStrokes, tr("&Hide"), "eye-off", key(tr("Ctrl+3")));
    add(ShowAll, tr("Sho&w All"), "eye", key(tr("Ctrl+Alt+3")));
    add(RenameStrokes, tr("Rena&me…"), "", key(tr("F2")));
    add(FlipAcross, tr("Flip Hori&zontally"), "flip-across", key(tr("Shift+H")));
    add(FlipDown, tr("Flip &Vertically"), "flip-down", key(tr("Shift+V")));
    add(QuarterLeft, tr("Rotate by 90° L&eft"), "quarter-left", key(tr("Ctrl+[")));
    add(QuarterRight, tr("Rotate by 90° R&ight"), "quarter-right", key(tr("Ctrl+]")));
    add(ScaleSpread, tr("&Scale Spread with the Shape"), "scale-spread", {},
        tr("Spread and density follow the shape when it is scaled"));
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
    add(AlignLeft, tr("&Left Edges"), "align-left", {});
    add(AlignCentre, tr("&Centres, Horizontally"), "align-centre", {});
    add(AlignRight, tr("&Right Edges"), "align-right", {});
    add(AlignTop, tr("&Top Edges"), "align-top", {});
    add(AlignMiddle, tr("&Middles, Vertically"), "align-middle", {});
    add(AlignBottom, tr("&Bottom Edges"), "align-bottom", {});
    add(AlignToSelection, tr("Relative to the &Selection"), "", {});
    add(AlignToLast, tr("Relative to the Last Select&ed"), "", {});
    add(AlignToFirst, tr("Relative to the &First Selected"), "", {});
    add(AlignToBiggest, tr("Relative to the Bi&ggest"), "", {});
    add(AlignToCanvas, tr("Relative to the C&anvas"), "", {});
    auto *relative = new QActionGroup(this);
    for (const Command command : {AlignToSelection, AlignToLast, AlignToFirst, AlignToBiggest, AlignToCanvas}) {
        m_actions[command]->setCheckable(true);
        relative->addAction(m_actions[command]);
    }
    m_actions[AlignToSelection]->setChecked(true);
    add(DistributeGapsAcross, tr("Even Gaps, &Horizontally"), "gaps-across", {});
    add(DistributeGapsDown, tr("Even Gaps, &Vertically"), "gaps-down", {});
    add(DistributeCentresAcross, tr("Even &Centres, Horizontally"), "centres-across", {});
    add(DistributeCentresDown, tr("Even C&entres, Vertically"), "centres-down", {});
}

void Actions::addAids()
{
    const CanvasAids aids = settings::canvasAids();
    add(SnapToNodes, tr("Snap to &Nodes"), "", {QKeySequence(tr("%"))});
    add(SnapToGrid, tr("Snap to &Grid"), "", {});
    add(ShowGrid, tr("&Show the Grid"), "", {QKeySequence(tr("#"))});
    add(GridStep, tr("Grid St&ep…"), "", {});
    add(ShowUnderlay, tr("Show the Underl&ay"), "", {QKeySequence(tr("Shift+U"))});
    m_actions[ShowUnderlay]->setCheckable(true);
    const std::pair<Command, bool> states[] = {
        {SnapToNodes, aids.snapToNodes}, {SnapToGrid, aids.snapToGrid}, {ShowGrid, aids.showGrid}};
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
    for (const Command command : {SameColour, SameStyle, SameBrush})
        same->addAction(m_actions[command]);
    edit.insertMenu(after, same);
}

void Actions::addAids(QMenu &view)
{
    for (const Command command : {SnapToNodes, SnapToGrid, ShowGrid, GridStep, ShowUnderlay})
        view.addAction(m_actions[command]);
    view.addSeparator();
}

} // namespace suffuse

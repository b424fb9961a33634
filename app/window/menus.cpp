#include "app/window/menus.h"

#include "app/session/commands/commands.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>
#include <memory>

namespace suffuse {

using enum Command;

namespace {

/// What stands between two lines.
using Group = QList<Command>;

/// Appends groups of commands with a line between each two.
void append(QWidget &to, const Commands &table, const QList<Group> &groups)
{
    for (const Group &group : groups) {
        if (!to.actions().isEmpty()) {
            auto *line = new QAction(&to);
            line->setSeparator(true);
            to.addAction(line);
        }
        for (const Command command : group)
            to.addAction(&table[command]);
    }
}

QMenu *addMenu(QMenuBar &bar, const QString &title, const Commands &table, const QList<Group> &groups)
{
    QMenu *menu = bar.addMenu(title);
    append(*menu, table, groups);
    return menu;
}

QMenu *addMenu(QMenu &above, const QString &title, const Commands &table, const QList<Group> &groups)
{
    QMenu *menu = above.addMenu(title);
    append(*menu, table, groups);
    return menu;
}

QMenu *addFileMenu(QMenuBar &bar, const Commands &table)
{
    QMenu *file = addMenu(bar, Commands::tr("&File"), table, {{New, Open}});
    QMenu *recent = file->addMenu(Commands::tr("Open &Recent"));
    append(*file, table,
           {{Save, SaveAs, SaveCopy, KeepHistory},
            {Revert, RestoreBackup},
            {ImportStrokes, ImportPicture, ImportUnderlay, PictureToStrokes},
            {Export, ExportAgain, ExportDrawing, ExportTimelapse},
            {Print, PrintPreview},
            {Close, Quit}});
    return recent;
}

void addEditMenu(QMenuBar &bar, const Commands &table)
{
    QMenu *edit = addMenu(bar, Commands::tr("&Edit"), table,
                          {{Undo, Redo},
                           {Cut, Copy, Paste, PasteInPlace},
                           {CopyAppearance, PasteAppearance, PasteAppearanceEvenly, MatchAppearance},
                           {Delete, Duplicate},
                           {EditHere, CanvasMenu},
                           {SelectAll, SelectFound, SearchStrokes, Deselect, InvertSelection}});
    addMenu(*edit, Commands::tr("Select Sa&me"), table, {{SameColour, SameStyle, SameBrush, SameName}});
    append(*edit, table, {{RecolourArtwork, MapToSwatches}, {Settings}});
}

void addViewMenu(QMenuBar &bar, const Commands &table, OpenMenus &open)
{
    QMenu *view = addMenu(bar, Commands::tr("&View"), table,
                          {{ZoomIn, ZoomOut, Zoom100, Fit, ZoomToSelection},
                           {RotateLeft, RotateRight, ResetRotation, Mirror},
                           {SnapToNodes, SnapToGrid, ShowGrid, GridStep, ShowOutlines, ShowErasures, ShowBeyond,
                            ShowUnderlay, UnderlayToLayer},
                           {SoftProof, GamutWarning, ProofProfile}});
    view->addSeparator();
    addMenu(*view, Commands::tr("Symmetry"), table,
            {{PaintInSymmetry},
             {SymmetryAcross, SymmetryDown, SymmetryBoth, SymmetryTurns, SymmetryKaleidoscope},
             {SymmetryArms, SymmetryAngle, SymmetryToMiddle, ShowSymmetry}});
    addMenu(*view, Commands::tr("Rulers and Guides"), table,
            {{ShowRulers, RulersInUnits, RulersInMillimetres, RulersInInches},
             {ShowGuides, SnapToGuides, LockGuides},
             {AddLevelGuide, AddUprightGuide, RemoveGuides}});
    addMenu(*view, Commands::tr("Assistants"), table, {{ShowAssistants, SnapToAssistants}, {RemoveAssistants}});
    open.docks = view->addMenu(Commands::tr("&Docks"));
    open.workspaces = addMenu(*view, Commands::tr("Workspaces"), table,
                              {{WorkspacePaint, WorkspaceRefine, WorkspaceTime}, {SaveWorkspace}});
    for (const Command command : {HideDocks, ResetLayout, NextPanel, PreviousPanel, FullScreen, NewView})
        view->addAction(&table[command]);
}

void addObjectMenu(QMenuBar &bar, const Commands &table)
{
    QMenu *object = addMenu(bar, Commands::tr("&Object"), table,
                            {{Raise, Lower, Top, Bottom},
                             {FillStrokes, RemoveFills, AddGradients, RemoveGradients},
                             {GroupStrokes, UngroupStrokes, TextToStrokes, ReleaseTexts, CombineStrokes, BreakApart, RemoveErasures},
                             {LockStrokes, UnlockAll, HideStrokes, ShowAll, RenameStrokes},
                             {FlipAcross, FlipDown, QuarterLeft, QuarterRight, ScaleSpread}});
    addMenu(*object, Commands::tr("Group as a Whole"), table, {{ClipGroups, MaskGroups, WashGroups, DraftGroups}});
    addMenu(*object, Commands::tr("Areas"), table,
            {{UniteAreas, SubtractAreas, IntersectAreas, ExcludeAreas, DivideAreas},
             {InsetAreas, OutsetAreas},
             {LinesToAreas}});
    addMenu(*object, Commands::tr("Resha&pe"), table,
            {{SimplifyStrokes, RefitStrokes, SmoothStrokes, StraightenStrokes, OffsetStrokes}, {GrowPaint, ShrinkPaint}});
    addMenu(*object, Commands::tr("Appl&y Brush"), table,
            {{ApplyBrush}, {ApplyBrushForm, ApplyBrushColour, ApplyBrushTexture}});
    object->addAction(&table[AlongStrokes]);
    object->addAction(&table[VaryStrokes]);
    object->addSeparator();
    addMenu(*object, Commands::tr("&Align"), table,
            {{AlignLeft, AlignCentre, AlignRight},
             {AlignTop, AlignMiddle, AlignBottom},
             {AlignToSelection, AlignToLast, AlignToFirst, AlignToBiggest, AlignToCanvas}});
    addMenu(*object, Commands::tr("&Distribute"), table,
            {{DistributeGapsAcross, DistributeCentresAcross, DistributeGapsDown, DistributeCentresDown}});
}

void addLayerMenu(QMenuBar &bar, const Commands &table)
{
    addMenu(bar, Commands::tr("&Layer"), table,
            {{NewLayer, NewClippedLayer, DuplicateLayer, MergeLayerDown},
             {RaiseLayer, LowerLayer},
             {LayerAbove, LayerBelow, NoLayer},
             {HideOtherLayers, ThisLayerOnly}});
}

void addTimeMenu(QMenuBar &bar, const Commands &table)
{
    QMenu *time = addMenu(bar, Commands::tr("Ti&me"), table,
                          {{Play, ToStart, PreviousStroke, NextStroke, ToEnd},
                           {LoopPlaying, SkipPauses},
                           {FinalPreview, LetDry, FreezeNow, Rewet, RemoveRewetting}});
    time->addSeparator();
    addMenu(*time, Commands::tr("Drawing Pa&ce"), table, {{PaceEven, PaceEaseIn, PaceEaseOut, PaceEaseInOut}});
}

void addToolsMenu(QMenuBar &bar, const Commands &table)
{
    QMenu *tools = addMenu(bar, Commands::tr("&Tools"), table,
                           {{Brush, Select, Segments, Shapes, OutlinePen, LassoFill, Bucket, Text, Redraw, Push, Knife,
                             Eraser, AttributeBrush, Eyedropper, Assistants, Pan}});
    Group favourites;
    for (int i = int(Favourite1); i <= int(Favourite9); ++i)
        favourites << Command(i);
    addMenu(*tools, Commands::tr("&Favourite Brushes"), table, {favourites});
    append(*tools, table, {{BrushPalette}, {SmallerSize, LargerSize, LessOpacity, MoreOpacity}, {PaintWithKeys}});
}

/// One Esc closes a menu, as elsewhere, and gives the keyboard back to what had it. Qt leaves it to the bar, where
/// letters open menus without a sign that they would.
void leaveBarWithMenus(QMenuBar &bar)
{
    const auto had = std::make_shared<QPointer<QWidget>>();
    const auto leave = [&bar, had] {
        if (QApplication::activePopupWidget() || !bar.hasFocus()) // another menu was opened by an arrow key
            return;
        QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
        QCoreApplication::sendEvent(&bar, &escape);
        if (bar.hasFocus() && *had)
            (*had)->setFocus(Qt::MenuBarFocusReason);
    };
    for (const QAction *action : bar.actions()) {
        QObject::connect(action->menu(), &QMenu::aboutToShow, &bar, [&bar, had] {
            if (QWidget *focus = bar.window()->focusWidget(); focus && focus != &bar)
                *had = focus;
        });
        QObject::connect(action->menu(), &QMenu::aboutToHide, &bar,
                         [&bar, leave] { QTimer::singleShot(0, &bar, leave); });
    }
}

/// Its icons get smaller where the screen is low, before Qt hides the last ones behind an arrow.
class ToolsBar : public QToolBar {
public:
    ToolsBar(const QString &title, QWidget *parent) : QToolBar(title, parent) { setIconSize({largest, largest}); }

protected:
    void resizeEvent(QResizeEvent *event) override
    {
        QToolBar::resizeEvent(event);
        const auto along = [this](const QSize &size) {
            return orientation() == Qt::Vertical ? size.height() : size.width();
        };
        const QList<QAction *> all = actions();
        const auto buttons = int(std::ranges::count_if(all, [](const QAction *a) { return !a->isSeparator(); }));
        const int withoutIcons = along(sizeHint()) - buttons * iconSize().width();
        const int room = isFloating() ? largest : (along(this->size()) - withoutIcons) / std::max(buttons, 1);
        const int icon = std::clamp(room, least, largest);
        setIconSize({icon, icon});
    }

private:
    static constexpr int least = 16, largest = 22; ///< logical pixels
};

} // namespace

OpenMenus fillMenus(QMenuBar &bar, const Commands &table)
{
    OpenMenus open;
    open.recent = addFileMenu(bar, table);
    addEditMenu(bar, table);
    addViewMenu(bar, table, open);
    addObjectMenu(bar, table);
    addLayerMenu(bar, table);
    addTimeMenu(bar, table);
    addMenu(bar, Commands::tr("&Nodes"), table,
            {{InsertNodes, NodeCorner, NodeSmooth, NodeSymmetric, BreakNodes, JoinNodes, DeleteSegments, BridgeSegments,
              ReverseStrokes}});
    addToolsMenu(bar, table);
    open.extensions = addMenu(bar, Commands::tr("E&xtensions"), table, {{RepeatExtension}, {ManageExtensions}});
    addMenu(bar, Commands::tr("&Help"), table, {{Manual, Welcome}, {FindCommand, Shortcuts}, {About}});
    leaveBarWithMenus(bar);
    return open;
}

QToolBar *makeToolBar(const Commands &table, QWidget *parent)
{
    auto *bar = new ToolsBar(Commands::tr("Tools"), parent);
    bar->setObjectName("tools");
    bar->setOrientation(Qt::Vertical);
    append(*bar, table,
           {{Brush, Select, Segments, Shapes, OutlinePen, LassoFill, Bucket, Text, Redraw, Push, Knife, Eraser,
             AttributeBrush, Eyedropper, Assistants, Pan},
            {Undo, Redo},
            {ZoomIn, ZoomOut, Fit}});
    for (auto *button : bar->findChildren<QToolButton *>())
        button->setFocusPolicy(Qt::TabFocus); // the keyboard comes here, too; a click leaves it where it is
    return bar;
}

} // namespace suffuse

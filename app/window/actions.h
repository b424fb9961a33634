// The table of commands: a row each with its name, icon, keys, when it can be used and what it does; and the menus.
#pragma once

#include "app/window/command_row.h"

#include <QAction>
#include <QKeySequence>
#include <QList>

#include <map>
#include <optional>

class QMainWindow;
class QMenu;
class QToolBar;

namespace suffuse {

enum class Command {
    New,
    Open,
    Save,
    SaveAs,
    SaveCopy,
    Revert,
    RestoreBackup,
    KeepHistory,
    ImportStrokes,
    ImportUnderlay,
    Export,
    ExportAgain,
    Close,
    Quit,
    Undo,
    Redo,
    Cut,
    Copy,
    Paste,
    PasteInPlace,
    Delete,
    Duplicate,
    SelectAll,
    SelectFound,
    Deselect,
    Settings,
    Brush,
    Select,
    Segments,
    Knife,
    Eraser,
    AttributeBrush,
    Eyedropper,
    Pan,
    Raise,
    Lower,
    Top,
    Bottom,
    InsertNodes,
    NodeCorner,
    NodeSmooth,
    NodeSymmetric,
    BreakNodes,
    JoinNodes,
    DeleteSegments,
    BridgeSegments,
    ReverseStrokes,
    InvertSelection,
    SameColour,
    SameStyle,
    SameBrush,
    SameName,
    Lasso,
    TouchPath,
    GroupStrokes,
    UngroupStrokes,
    LockStrokes,
    UnlockAll,
    HideStrokes,
    ShowAll,
    RenameStrokes,
    FlipAcross,
    FlipDown,
    QuarterLeft,
    QuarterRight,
    ScaleSpread,
    AlignLeft,
    AlignCentre,
    AlignRight,
    AlignTop,
    AlignMiddle,
    AlignBottom,
    AlignToSelection,
    AlignToLast,
    AlignToFirst,
    AlignToBiggest,
    AlignToCanvas,
    DistributeGapsAcross,
    DistributeGapsDown,
    DistributeCentresAcross,
    DistributeCentresDown,
    SnapToNodes,
    SnapToGrid,
    ShowGrid,
    GridStep,
    ShowUnderlay,
    ShowOutlines,
    ShowBeyond,
    Play,
    ToStart,
    PreviousStroke,
    NextStroke,
    ToEnd,
    LoopPlaying,
    SkipPauses,
    LetDry,
    FreezeNow,
    Rewet,
    RemoveRewetting,
    PaceEven,
    PaceEaseIn,
    PaceEaseOut,
    PaceEaseInOut,
    FinalPreview,
    ExportTimelapse,
    Favourite1,
    Favourite2,
    Favourite3,
    Favourite4,
    Favourite5,
    Favourite6,
    Favourite7,
    Favourite8,
    Favourite9,
    SmallerSize,
    LargerSize,
    LessOpacity,
    MoreOpacity,
    HoldToPan,
    HoldToTurn,
    HoldToHideOutlines,
    ZoomIn,
    ZoomOut,
    Zoom100,
    Fit,
    RotateLeft,
    RotateRight,
    ResetRotation,
    Mirror,
    HideDocks,
    NextPanel,
    PreviousPanel,
    FullScreen,
    FindCommand,
    Shortcuts,
    About,
};

/// A menu entry's text without mnemonic ("&Open", "打开(&O)") and dots.
QString plainTitle(QString title);
/// With the menus that lead to it, as the name alone may stand in several: "Object ▸ Align ▸ Left Edges". For undo
/// without the step's name.
QString titleWithMenus(const QAction &action);

/// Keys that tools, not commands, answer to, and that stay as they are.
struct FixedKeys {
    QString title; ///< what they do, translated
    QList<QKeySequence> keys;
};
/// All of them: no command may have one, or it would not be heard of.
QList<FixedKeys> fixedKeys();

/// Makes all actions of a window and puts them into its menus and tool bar.
class Actions : public QObject {
    Q_OBJECT

public:
    explicit Actions(QMainWindow &window);

    QAction &operator[](Command command) const { return *m_actions.at(command); }
    /// All, in the order of the menus.
    QList<QAction *> all() const;
    /// Those that do something when they are triggered.
    QList<QAction *> runnable() const;

    /// From now on the rows run, and are enabled, by this. Call it once.
    void serve(const CommandTarget &target);
    /// Enables, checks and names all commands by their rows. To be called when something that they look at has changed.
    void update();

    /// Fills the menu bar; the docks' toggles go into `docksMenu()` afterwards.
    void fillMenus();
    QMenu *recentMenu() const { return m_recentMenu; }
    QMenu *docksMenu() const { return m_docksMenu; }
    /// The tools, exclusive of each other.
    QToolBar *makeToolBar();

private:
    /// `id` is its name in the settings: the same in every language, and for ever. The row returned is to be completed.
    CommandRow &add(Command command, const QString &id, const QString &text, const char *icon,
                    const QList<QKeySequence> &keys, const QString &tip = {});
    void addFileAndEdit();
    void addTools();
    void addNodeCommands();
    void addViewAndHelp();
    void addObjects();
    void addAligning();
    void addAids();
    void addTime();
    void addFavourites();
    void addToolKeys();
    void fillTimeMenu(QMenu &menu);
    void fillObjectMenu(QMenu &menu);
    void addSelecting(QMenu &edit);
    void addAids(QMenu &view);
    QMenu *addMenu(const QString &title, const QList<Command> &commands);

    QMainWindow &m_window;
    std::map<Command, QAction *> m_actions;
    std::map<Command, CommandRow> m_rows;
    std::optional<CommandTarget> m_target; ///< none: there is no painting yet
    QMenu *m_recentMenu = nullptr;
    QMenu *m_docksMenu = nullptr;
};

} // namespace suffuse

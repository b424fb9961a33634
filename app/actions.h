// The window's actions: names, icons, shortcuts, menus. What they do is connected by the window.
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QList>

#include <map>

class QMainWindow;
class QMenu;
class QToolBar;

namespace suffuse {

enum class Command {
    New,
    Open,
    Save,
    SaveAs,
    KeepHistory,
    ImportStrokes,
    ImportUnderlay,
    Export,
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
    ZoomIn,
    ZoomOut,
    Zoom100,
    Fit,
    RotateLeft,
    RotateRight,
    ResetRotation,
    Mirror,
    HideDocks,
    FullScreen,
    Shortcuts,
    About,
};

/// A menu entry's text without mnemonic ("&Open", "打开(&O)") and dots.
QString plainTitle(QString title);

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
    /// Actions whose keys mean something else in lists and fields (arrange, Tab) belong to `canvas`.
    Actions(QMainWindow &window, QWidget &canvas);

    QAction &operator[](Command command) const { return *m_actions.at(command); }
    /// All, in the order of the menus.
    QList<QAction *> all() const;

    /// Fills the menu bar; the docks' toggles go into `docksMenu()` afterwards.
    void fillMenus();
    QMenu *recentMenu() const { return m_recentMenu; }
    QMenu *docksMenu() const { return m_docksMenu; }
    /// The tools, exclusive of each other.
    QToolBar *makeToolBar();

private:
    void add(Command command, const QString &text, const char *icon, const QList<QKeySequence> &keys,
             const QString &tip = {});
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
    QWidget &m_canvas;
    std::map<Command, QAction *> m_actions;
    QMenu *m_recentMenu = nullptr;
    QMenu *m_docksMenu = nullptr;
};

} // namespace suffuse

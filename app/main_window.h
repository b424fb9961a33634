// One window, one painting: wires editor, canvas, tools, docks and actions together.
#pragma once

#include "app/actions.h"
#include "app/canvas/render_worker.h"
#include "app/editor.h"

#include <QLabel>
#include <QMainWindow>
#include <QTimer>

namespace suffuse {

class CanvasWidget;
class FileWatch;
class Journal;
class Playback;
class SelectionOrder;
class Tool;
class ToolOptionsBar;
enum class ConflictAnswer;
struct LostDocument;

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget *parent = nullptr, MakeRenderer make = makeRenderer);
    ~MainWindow() override;

    Editor &editor() { return m_editor; }
    CanvasWidget &canvas() { return *m_canvas; }
    Playback &playback() { return *m_playback; }
    QAction &action(Command command); ///< as it is for what is selected now

    /// Opens a file here if this window's painting is untouched, else in a window of its own. Errors are shown.
    /// Returns the window that shows the file, or null.
    MainWindow *openFile(const QString &path);
    /// Adds a file's strokes to this window's painting and selects them. Errors are shown, and so is what was left out.
    void importStrokes(const QString &path);
    Journal &journal() { return *m_journal; }
    /// Saves and waits until it is on disk. False if it failed or was given up.
    bool save();
    /// Writes to the path, shows what went wrong, and waits until it is on disk.
    bool saveTo(const QString &path);
    /// Shows a document of an earlier run in a window as openFile does. Its journal goes when this one's is on disk.
    MainWindow *openRecovered(LostDocument document);

protected:
    void changeEvent(QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    void makeTools();
    void makeDocks();
    void makeStatusBar();
    void connectActions();
    void connectViewActions();
    void connectClipboard();
    /// Empty: where it was.
    void pasteAt(std::optional<Point> centre);
    void connectObjectActions();
    void connectAids();
    void connectUnderlay();
    void importUnderlay(const QString &path);
    void renameSelected();
    void updateObjectActions();
    void connectTimeActions();
    void connectBrushes();
    void nameFavourites();
    /// For the next window and the next start.
    void keepBrush();
    void rewetSelected();
    void updateTimeActions();
    void connectUpdates();
    QDockWidget *addDock(const char *name, const QString &title, QWidget *panel);

    void connectSaving();
    /// Starts to save, where it is to go; the user goes on painting. False if that was given up.
    bool startSaving();
    bool startSavingAs();
    void startSavingTo(const QString &path, bool whatever = false);
    /// False if the last attempt failed.
    bool waitForSaving();
    void showOutcome(const SaveOutcome &outcome);
    void fileChangedOutside(const QByteArray &hash);
    void answerConflict(ConflictAnswer answer, const QByteArray &hash);
    void newWindow();
    void chooseFileToOpen();
    void chooseStrokesToImport();
    void fillRecentMenu();
    void hideDocks(bool hide);
    void changeShortcuts();
    void useTool(Tool *tool);
    void showHint();
    void updateActions();
    void updateTitle();
    void showPosition(double x, double y);
    void updateZoom();
    void showFrame(const FrameInfo &frame);
    void showBackend();
    /// True if the painting may go: saved, discarded or never changed.
    bool maySwitch();
    bool isUntouched();
    /// Another window, a little beside this one.
    MainWindow *openWindow();

    Editor m_editor;
    Playback *m_playback = nullptr;
    CanvasWidget *m_canvas = nullptr;
    Actions *m_actions = nullptr;
    SelectionOrder *m_selectionOrder = nullptr;
    ToolOptionsBar *m_toolOptions = nullptr;
    Tool *m_nextTool = nullptr; ///< chosen while a stroke was in hand
    QAction *m_tipAction = nullptr; ///< of the tool that the pen's tip goes back to
    QList<QDockWidget *> m_docks;
    QList<QDockWidget *> m_hiddenDocks;
    QLabel *m_position = nullptr;
    QLabel *m_zoom = nullptr;
    QLabel *m_backend = nullptr;
    QLabel *m_frameTime = nullptr;
    QLabel *m_hint = nullptr;
    QTimer m_brushChanged; ///< a moment ago, and is not kept yet
    QString m_renderError;
    Journal *m_journal = nullptr;
    FileWatch *m_watch = nullptr;
    bool m_savingWorked = true; ///< the last attempt
    bool m_asking = false;      ///< about a file that another program changed
};

} // namespace suffuse

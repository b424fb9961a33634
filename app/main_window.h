// One window, one painting: wires editor, canvas, tools, docks and actions together.
#pragma once

#include "app/actions.h"
#include "app/canvas/render_worker.h"
#include "app/editor.h"

#include <QLabel>
#include <QMainWindow>

namespace suffuse {

class CanvasWidget;
class Playback;
class SelectionOrder;
class Tool;
class ToolOptionsBar;

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget *parent = nullptr, MakeRenderer make = makeRenderer);
    ~MainWindow() override;

    Editor &editor() { return m_editor; }
    CanvasWidget &canvas() { return *m_canvas; }
    Playback &playback() { return *m_playback; }
    QAction &action(Command command) { return (*m_actions)[command]; }

    /// Opens a file here if this window's painting is untouched, else in a window of its own. Errors are shown.
    /// Returns the window that shows the file, or null.
    MainWindow *openFile(const QString &path);
    /// False if it failed or was given up.
    bool save();
    bool saveAs();
    /// Writes to the path and shows what went wrong.
    bool saveTo(const QString &path);

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
    void renameSelected();
    void updateObjectActions();
    void connectTimeActions();
    void connectBrushes();
    void nameFavourites();
    void rewetSelected();
    void updateTimeActions();
    void connectUpdates();
    QDockWidget *addDock(const char *name, const QString &title, QWidget *panel);

    void newWindow();
    void chooseFileToOpen();
    void fillRecentMenu();
    void hideDocks(bool hide);
    void changeShortcuts();
    void useTool(Tool *tool);
    void showHint();
    void updateActions();
    void updateTitle();
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
    QAction *m_tipAction = nullptr; ///< of the tool that the pen's tip goes back to
    QList<QDockWidget *> m_docks;
    QList<QDockWidget *> m_hiddenDocks;
    QLabel *m_position = nullptr;
    QLabel *m_zoom = nullptr;
    QLabel *m_backend = nullptr;
    QLabel *m_frameTime = nullptr;
    QLabel *m_hint = nullptr;
    QString m_renderError;
};

} // namespace suffuse

// One window, one painting: makes the canvas and the parts that work on it, and knows nothing of what they do.
#pragma once

#include "app/session/commands/commands.h"
#include "app/session/open_painting.h"
#include "render/backends.h"

#include <QMainWindow>

#include <vector>

namespace suffuse {

class CanvasWidget;
class Docks;
class Extending;
class FileOpening;
class FileSaving;
class Importing;
class KeptBrush;
class KeyboardFocus;
class ToolOptionsBar;
class Welcoming;
class Workspaces;
enum class DockSet;
struct LostDocument;
struct PaletteEntry;
struct Workplace;

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    /// A new painting, with the brush that was in hand last.
    explicit MainWindow(QWidget *parent = nullptr, MakeRenderer make = makeRenderer);
    /// A painting that is open already.
    explicit MainWindow(std::unique_ptr<OpenPainting> open, MakeRenderer make = makeRenderer,
                        QWidget *parent = nullptr);
    ~MainWindow() override;

    /// Shows what this window shows in a new one, in its place and as the settings are now. Nothing can be done with
    /// this one from then on but to delete it, so none of its own actions and dialogs may be at work.
    MainWindow *replace();

    Editor &editor() { return m_editor; }
    CanvasWidget &canvas() { return *m_canvas; }
    Playback &playback() { return m_open->playback; }
    Journal &journal() { return m_open->journal; }
    QAction &action(Command command); ///< as it is for what is selected now
    /// What the command palette finds.
    std::vector<PaletteEntry> paletteEntries();

    /// Opens a file here if this window's painting is untouched, else in a window of its own. Errors are shown.
    /// Returns the window that shows the file, or null.
    MainWindow *openFile(const QString &path);
    /// Shows a document of an earlier run in a window as openFile does. Its journal goes when this one's is on disk.
    MainWindow *openRecovered(LostDocument document);
    /// Adds a file's strokes to this window's painting and selects them. Errors are shown, and so is what was left out.
    void importStrokes(const QString &path);
    /// Shows the welcome page, if people want it and nothing was begun yet.
    void greet();
    /// Saves and waits until it is on disk. False if it failed or was given up.
    bool save();
    /// Writes to the path, shows what went wrong, and waits until it is on disk.
    bool saveTo(const QString &path);

protected:
    void changeEvent(QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    /// Where a window stands, and its docks and tool bars in it: as they were when the program ended, or as whoever
    /// makes the window puts them. Qt keeps rows of a layout that did not fit a window yet and goes on with them after
    /// another layout was put in their place, so that a window is given one before it is shown, never two.
    enum class Places { Stored, Given };
    MainWindow(std::unique_ptr<OpenPainting> open, MakeRenderer make, QWidget *parent, Places places);

    /// Takes everything away that shows the painting.
    std::unique_ptr<OpenPainting> release();
    /// Those that add rows; called before the rows are shown.
    void makeParts(const Workplace &place);
    void addRows();
    void showRows();
    void placeToolBars();
    void resetLayout(DockSet set);
    void changeSettings();
    void updateTitle();

    std::unique_ptr<OpenPainting> m_open; ///< null: another window shows it
    Editor &m_editor;
    MakeRenderer m_makeRenderer;
    CanvasWidget *m_canvas = nullptr;
    Commands *m_commands = nullptr; ///< null: the painting is gone
    QObject *m_parts = nullptr;     ///< owns the parts, those below too
    QToolBar *m_tools = nullptr;
    ToolOptionsBar *m_toolOptions = nullptr;
    KeptBrush *m_brush = nullptr;
    FileSaving *m_saving = nullptr;
    FileOpening *m_opening = nullptr;
    Welcoming *m_welcoming = nullptr;
    Importing *m_importing = nullptr;
    Docks *m_docks = nullptr;
    Workspaces *m_workspaces = nullptr;
    Extending *m_extending = nullptr;
    QMenu *m_docksMenu = nullptr;
};

} // namespace suffuse

// One window, one painting: wires editor, canvas, tools, docks and actions together.
#pragma once

#include "app/session/commands/commands.h"
#include "app/session/frames/shown_frame.h"
#include "app/session/open_painting.h"
#include "render/backends.h"

#include <QLabel>
#include <QMainWindow>
#include <QTimer>

namespace suffuse {

class CanvasWidget;
class ExportJob;
class FileWatch;
class KeyboardFocus;
class StrokesPanel;
class Tool;
class ToolOptionsBar;
enum class ConflictAnswer;
struct ExportSettings;
struct LostDocument;
struct PaletteEntry;

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget *parent = nullptr, MakeRenderer make = makeRenderer);
    ~MainWindow() override;

    /// Shows what this window shows in a new one, in its place and as the settings are now. Nothing can be done with
    /// this one from then on but to delete it, so none of its own actions and dialogs may be at work.
    MainWindow *replace();

    Editor &editor() { return m_editor; }
    CanvasWidget &canvas() { return *m_canvas; }
    Playback &playback() { return *m_playback; }
    QAction &action(Command command); ///< as it is for what is selected now

    /// Opens a file here if this window's painting is untouched, else in a window of its own. Errors are shown.
    /// Returns the window that shows the file, or null.
    MainWindow *openFile(const QString &path);
    /// Adds a file's strokes to this window's painting and selects them. Errors are shown, and so is what was left out.
    void importStrokes(const QString &path);
    /// What the command palette finds.
    std::vector<PaletteEntry> paletteEntries();
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
    MainWindow(std::unique_ptr<OpenPainting> open, MakeRenderer make, QWidget *parent = nullptr);
    /// Takes everything away that shows the painting.
    std::unique_ptr<OpenPainting> release();
    void addToolRows();
    void makeDocks();
    void makeStatusBar();
    void addFileRows();
    void addWindowRows();
    void addClipboardRows();
    void addExportRows();
    void exportPicture();
    void exportAgain();
    /// Empty: where it was.
    void pasteAt(std::optional<Point> centre);
    void addObjectRows();
    void importUnderlay(const QString &path);
    void renameSelected();
    void addTimeRows();
    void connectBrushes();
    /// For the next window and the next start.
    void keepBrush();
    void rewetSelected();
    void connectUpdates();
    QDockWidget *addDock(const char *name, const QString &title, QWidget *panel);

    void addSavingRows();
    void connectSaving();
    /// Starts to save, where it is to go; the user goes on painting. False if that was given up.
    bool startSaving();
    bool startSavingAs();
    void startSavingCopy();
    /// A file to save to that is open in no other window; empty: given up.
    QString askForFile(const QString &title, const QString &proposal);
    void watchFile();
    void revert();
    void restoreBackup();
    void restoreFrom(const QString &backup);
    MainWindow *openBackup(const QString &backup);
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
    void changeSettings();
    void useTool(Tool *tool);
    void showHint();
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

    std::unique_ptr<OpenPainting> m_open; ///< null: another window shows it
    Editor &m_editor;
    Playback *m_playback;
    SelectionOrder *m_selectionOrder;
    Journal *m_journal;
    MakeRenderer m_makeRenderer;
    KeyboardFocus *m_keyboard = nullptr;
    CanvasWidget *m_canvas = nullptr;
    Commands *m_commands = nullptr;
    ExportJob *m_exportJob = nullptr;
    std::unique_ptr<ExportSettings> m_lastExport; ///< of this painting; null: none
    StrokesPanel *m_strokes = nullptr;
    ToolOptionsBar *m_toolOptions = nullptr;
    Tool *m_nextTool = nullptr;     ///< chosen while a stroke was in hand
    QAction *m_tipAction = nullptr; ///< of the tool that the pen's tip goes back to
    QList<QDockWidget *> m_docks;
    QByteArray m_layout; ///< while the docks are hidden
    QLabel *m_position = nullptr;
    QLabel *m_zoom = nullptr;
    QLabel *m_backend = nullptr;
    QLabel *m_frameTime = nullptr;
    QMenu *m_recentMenu = nullptr;
    QMenu *m_docksMenu = nullptr;
    QLabel *m_hint = nullptr;
    bool m_canPaste = false;
    QTimer m_brushChanged; ///< a moment ago, and is not kept yet
    QString m_renderError;
    FileWatch *m_watch = nullptr;
    bool m_savingWorked = true; ///< the last attempt
    bool m_asking = false;      ///< about a file that another program changed
};

} // namespace suffuse

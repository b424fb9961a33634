// Opening files: each is loaded first, and shown then.
#pragma once

#include "app/window/workplace.h"

#include <QObject>

#include <functional>
#include <memory>

class QMenu;

namespace suffuse {

class FileRestoring;
class KeptBrush;
struct Canvas;
struct LostDocument;
struct OpenedFile;

/// Opens files for a window: in it, if its painting is untouched, else in a window of its own, which is made when the
/// file has been read and not before.
class FileOpening : public QObject {
    Q_OBJECT

public:
    /// Makes a window that shows a painting, without showing the window, and returns what opens files for it.
    using MakeWindow = std::function<FileOpening *(std::unique_ptr<OpenPainting> open)>;

    FileOpening(const Workplace &place, FileRestoring &restoring, KeptBrush &brush, MakeWindow make, QObject *parent);

    QMainWindow &window() const { return m_place.window; }

    /// Opens a file, a backup of one, or raises the window that shows it already. Errors and damage are shown. Returns
    /// whose window shows the file, or null.
    FileOpening *open(const QString &path);
    /// Shows a document of an earlier run. Its journal goes when this one's is on disk.
    FileOpening *openRecovered(LostDocument document);
    void fillRecentMenu(QMenu &menu);
    /// A new painting, here or in a window of its own. `resolution`: canvas units an inch of paper; 0: it is not said.
    /// Returns whose window shows it.
    FileOpening *begin(const Canvas &canvas, double resolution = 0);
    /// Nothing was painted, opened or saved in this window.
    bool isUntouched() const;

private:
    /// Another painting, given by `fill`, here or in a window of its own.
    FileOpening *show(const std::function<void(OpenPainting &open)> &fill);
    FileOpening *showFile(OpenedFile file);
    /// Opens its painting, and puts the backup in place of what is there: saving saves the painting.
    FileOpening *openBackup(const QString &backup);
    void newPainting();
    void chooseFiles();

    Workplace m_place;
    FileRestoring &m_restoring;
    KeptBrush &m_brush;
    MakeWindow m_make;
};

} // namespace suffuse

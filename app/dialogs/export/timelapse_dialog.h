#pragma once

#include "app/dialogs/export/export_rows.h"
#include "app/dialogs/export/timelapse_job.h"

#include <QDialog>
#include <QElapsedTimer>

class QCheckBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace suffuse {

class Editor;
class HintLabel;

/// Makes a film of the painting being painted: numbered frames, an animated WebP or a video. It does the work itself,
/// with a bar and a way to stop it. The file at the target stays until the film is whole.
class TimelapseDialog : public QDialog {
    Q_OBJECT

public:
    /// `shown` is the part of the canvas that the window shows.
    TimelapseDialog(Editor &editor, const Rect &shown, QWidget *parent = nullptr);

    QLineEdit *path() const { return m_path; }
    AreaRow *area() const { return m_area; }
    QSpinBox *widthBox() const { return m_size->widthBox(); }
    QSpinBox *heightBox() const { return m_size->heightBox(); }
    QDoubleSpinBox *fps() const { return m_fps; }
    QDoubleSpinBox *length() const { return m_length; }
    QDoubleSpinBox *idle() const { return m_idle; }
    QCheckBox *transparent() const { return m_transparent; }
    QCheckBox *loops() const { return m_loops; }
    QPushButton *exportButton() const { return m_export; }
    QLabel *progressText() const { return m_left; }
    HintLabel *hint() const { return m_hint; }
    bool isExporting() const { return m_job.isRunning(); }

    void reject() override;

private:
    void addFields(QGridLayout &grid, const Rect &shown);
    QDoubleSpinBox *addNumber(QGridLayout &grid, int row, const QString &name, const QString &suffix,
                              const QString &tip);
    void browse();
    void changed();
    void areaChanged();
    void startExport();
    void showProgress(int frames);
    void exportFinished(bool written, const QString &error);
    void setBusy(bool busy);
    /// Gives the path of numbered pictures its number if it has none.
    QString target() const;
    FilmOptions film() const;

    Editor &m_editor;
    TimelapseJob m_job;
    QElapsedTimer m_clock;
    QWidget *m_form = nullptr;
    QLineEdit *m_path = nullptr;
    AreaRow *m_area = nullptr;
    SizeRow *m_size = nullptr;
    QDoubleSpinBox *m_fps = nullptr;
    QDoubleSpinBox *m_length = nullptr;
    QDoubleSpinBox *m_idle = nullptr;
    QSpinBox *m_quality = nullptr;
    QCheckBox *m_transparent = nullptr;
    QCheckBox *m_loops = nullptr;
    QProgressBar *m_progress = nullptr;
    QLabel *m_left = nullptr;
    QPushButton *m_export = nullptr;
    QPushButton *m_cancel = nullptr;
    HintLabel *m_hint = nullptr;
};

} // namespace suffuse

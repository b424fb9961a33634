#pragma once

#include "app/dialogs/export/export_rows.h"
#include "app/dialogs/export/exporting_dialog.h"
#include "app/dialogs/export/timelapse_job.h"

#include <QElapsedTimer>

class QDoubleSpinBox;
class QLabel;

namespace suffuse {

class Editor;

/// Makes a film of the painting being painted: numbered frames, an animated WebP or a video.
class TimelapseDialog : public ExportingDialog {
    Q_OBJECT

public:
    /// `shown` is the part of the canvas that the window shows.
    TimelapseDialog(Editor &editor, const Rect &shown, QWidget *parent = nullptr);

    AreaRow *area() const { return m_area; }
    QSpinBox *widthBox() const { return m_size->widthBox(); }
    QSpinBox *heightBox() const { return m_size->heightBox(); }
    QDoubleSpinBox *fps() const { return m_fps; }
    QDoubleSpinBox *length() const { return m_length; }
    QDoubleSpinBox *idle() const { return m_idle; }
    QCheckBox *loops() const { return m_loops; }
    QLabel *progressText() const { return m_left; }
    bool isExporting() const override { return m_job.isRunning(); }

private:
    void addFields(QGridLayout &grid, const Rect &shown);
    QDoubleSpinBox *addNumber(int row, const QString &name, const QString &suffix, const QString &tip);
    void browse() override;
    void pathChanged() override;
    void areaChanged();
    void startExport() override;
    void restore();
    void remember() override;
    void stop() override { m_job.cancel(); }
    /// Says so where the name has no ending of a film or a picture. Returns whether it has one.
    bool checkEnding();
    void showProgress(int frames);
    void setBusy(bool busy) override;
    /// Gives the path of numbered pictures its number if it has none.
    QString target() const;
    FilmOptions film() const;

    Editor &m_editor;
    TimelapseJob m_job;
    QElapsedTimer m_clock;
    AreaRow *m_area = nullptr;
    SizeRow *m_size = nullptr;
    QDoubleSpinBox *m_fps = nullptr;
    QDoubleSpinBox *m_length = nullptr;
    QDoubleSpinBox *m_idle = nullptr;
    QCheckBox *m_loops = nullptr;
    QLabel *m_left = nullptr;
};

} // namespace suffuse

#pragma once

#include "app/dialogs/export/export_job.h"
#include "app/dialogs/export/export_rows.h"
#include "app/dialogs/export/export_settings.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QGridLayout;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace suffuse {

class Editor;
class HintLabel;
class PresetRow;
class PrintRows;

/// Exports the painting as a picture: file, area, size, moment, alpha, depth. It begins with the settings of the
/// painting's last export, else with the format of the last export of any painting. It does the work itself, with a bar
/// and a way to stop it. The file at the target stays until the new picture is whole.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    /// `shown` is the part of the canvas that the window shows.
    ExportDialog(Editor &editor, const Rect &shown, QWidget *parent = nullptr);

    /// The present settings.
    ExportSettings settings() const;
    /// Takes the settings of an earlier export of this painting. A choice that is not possible now (a selection) is
    /// left as it is.
    void restore(const ExportSettings &settings);

    PresetRow *presets() const { return m_presets; }
    PrintRows *print() const { return m_print; }
    QLabel *limits() const { return m_limits; }
    QSpinBox *quality() const { return m_quality; }
    QLineEdit *path() const { return m_path; }
    QComboBox *format() const { return m_format; }
    AreaRow *area() const { return m_area; }
    MomentRow *moment() const { return m_moment; }
    QSpinBox *widthBox() const { return m_size->widthBox(); }
    QSpinBox *heightBox() const { return m_size->heightBox(); }
    QCheckBox *transparent() const { return m_transparent; }
    QComboBox *depth() const { return m_depth; }
    QPushButton *exportButton() const { return m_export; }
    HintLabel *hint() const { return m_hint; }
    bool isExporting() const { return m_job.isRunning(); }

    void reject() override;

private:
    void addFields(QGridLayout &grid, const Rect &shown);
    void addFormat(QGridLayout &grid);
    void addImageFields(QGridLayout &grid);
    void addField(QGridLayout &grid, int row, const QString &name, QWidget *field, const QString &tip);
    void browse();
    void formatChanged();
    void showLimits();
    void takeFormat(const ExportSettings &settings);
    void takeArea(const ExportSettings &settings);
    void takePreset(const ExportSettings &settings);
    void startExport();
    void exportFinished(bool written, const QString &error);
    void setBusy(bool busy);
    ImageOptions imageOptions() const;

    Editor &m_editor;
    ExportJob m_job;
    QWidget *m_form = nullptr;
    PresetRow *m_presets = nullptr;
    QLineEdit *m_path = nullptr;
    QComboBox *m_format = nullptr;
    AreaRow *m_area = nullptr;
    SizeRow *m_size = nullptr;
    QLabel *m_limits = nullptr;
    PrintRows *m_print = nullptr;
    MomentRow *m_moment = nullptr;
    QCheckBox *m_transparent = nullptr;
    QComboBox *m_depth = nullptr;
    QSpinBox *m_quality = nullptr;
    QProgressBar *m_progress = nullptr;
    QPushButton *m_export = nullptr;
    QPushButton *m_cancel = nullptr;
    HintLabel *m_hint = nullptr;
};

} // namespace suffuse

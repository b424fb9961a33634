#pragma once

#include "app/dialogs/export/export_job.h"
#include "app/dialogs/export/export_rows.h"
#include "app/dialogs/export/export_settings.h"
#include "app/dialogs/export/exporting_dialog.h"

class QComboBox;
class QLabel;

namespace suffuse {

class Editor;
class PresetRow;
class PrintRows;
class ProfileBox;

/// Exports the painting as a picture: file, area, size, moment, alpha, depth. It begins with the settings of the
/// painting's last export, else with the format of the last export of any painting.
class ExportDialog : public ExportingDialog {
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
    QComboBox *format() const { return m_format; }
    AreaRow *area() const { return m_area; }
    MomentRow *moment() const { return m_moment; }
    QSpinBox *widthBox() const { return m_size->widthBox(); }
    QSpinBox *heightBox() const { return m_size->heightBox(); }
    QComboBox *depth() const { return m_depth; }
    ProfileBox *colours() const { return m_colours; }
    bool isExporting() const override { return m_job.isRunning(); }

private:
    void addFields(QGridLayout &grid, const Rect &shown);
    void addFormat();
    void browse() override;
    void pathChanged() override;
    void showLimits();
    void takeFormat(const ExportSettings &settings);
    void takeArea(const ExportSettings &settings);
    void takePreset(const ExportSettings &settings);
    void startExport() override;
    /// The path as it is written: with the ending of the chosen format, if it has none of its own.
    QString fullPath() const;
    void stop() override { m_job.cancel(); }
    void remember() override;
    ImageOptions imageOptions() const;

    Editor &m_editor;
    ExportJob m_job;
    PresetRow *m_presets = nullptr;
    QComboBox *m_format = nullptr;
    QString m_ending; ///< the last one that chose a format: a name without any gets it
    AreaRow *m_area = nullptr;
    SizeRow *m_size = nullptr;
    QLabel *m_limits = nullptr;
    PrintRows *m_print = nullptr;
    MomentRow *m_moment = nullptr;
    QComboBox *m_depth = nullptr;
    ProfileBox *m_colours = nullptr;
};

} // namespace suffuse

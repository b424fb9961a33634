#pragma once

#include "app/dialogs/export/export_settings.h"

#include <QWidget>

class QComboBox;
class QGridLayout;
class QPushButton;

namespace suffuse {

/// A row of named export settings. One of them can be chosen, the present ones can be saved under a name, and the
/// chosen one can be removed.
class PresetRow : public QWidget {
    Q_OBJECT

public:
    /// Puts itself and its label into the grid. `present` gives the settings that are to be saved.
    PresetRow(QGridLayout &grid, int row, std::function<ExportSettings()> present, QWidget *parent);

    QComboBox *box() const { return m_box; }
    QPushButton *saveButton() const { return m_save; }
    QPushButton *removeButton() const { return m_remove; }
    /// Saves the present settings. They replace those of that name.
    void saveAs(const QString &name);

    /// Shows the first preset that exports as these settings do, or none.
    void showPresetOf(const ExportSettings &settings);

signals:
    void chosen(const suffuse::ExportSettings &settings);

private:
    void askForName();
    void removeChosen();
    /// Shows the names, and which one is chosen; an empty name: none.
    void fill(const QString &chosen);

    std::function<ExportSettings()> m_present;
    QComboBox *m_box = nullptr;
    QPushButton *m_save = nullptr;
    QPushButton *m_remove = nullptr;
};

} // namespace suffuse

#pragma once

#include "app/dialogs/export_settings.h"

#include <QWidget>

class QComboBox;
class QGridLayout;
class QPushButton;

namespace suffuse {

/// Named export settings: one is chosen, the present ones are saved under a name, the chosen one is removed.
class PresetRow : public QWidget {
    Q_OBJECT

public:
    /// Puts itself and its label into the grid. `present` gives what is to be saved.
    PresetRow(QGridLayout &grid, int row, std::function<ExportSettings()> present, QWidget *parent);

    QComboBox *box() const { return m_box; }
    QPushButton *saveButton() const { return m_save; }
    QPushButton *removeButton() const { return m_remove; }
    /// Takes the place of one of that name.
    void saveAs(const QString &name);

signals:
    void chosen(const suffuse::ExportSettings &settings);

private:
    void askForName();
    void removeChosen();
    /// Shows what there is, and which one is chosen; empty: none.
    void fill(const QString &chosen);

    std::function<ExportSettings()> m_present;
    QComboBox *m_box = nullptr;
    QPushButton *m_save = nullptr;
    QPushButton *m_remove = nullptr;
};

} // namespace suffuse

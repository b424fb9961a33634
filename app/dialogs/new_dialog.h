#pragma once

#include "app/dialogs/sheet_presets.h"

#include <QDialog>

#include <optional>

class QComboBox;
class QHBoxLayout;

namespace suffuse {

class CanvasSection;
class LengthUnits;
class NumberField;

/// Asks for size, background and paper of a new painting. It offers the sheets of the welcome page, and takes sides in
/// pixels, or in millimetres or inches at a resolution.
class NewDialog : public QDialog {
    Q_OBJECT

public:
    explicit NewDialog(QWidget *parent = nullptr);

    /// Returns the chosen sheet, or nothing if the user gave up. The dialog begins with the sheet that was chosen last.
    static std::optional<NewSheet> ask(QWidget *parent);

    const Canvas &canvas() const;
    /// The canvas, with a resolution where its sides are lengths of paper: they are given as such, or those of a usual
    /// sheet of paper.
    NewSheet sheet() const;
    QComboBox *presets() const { return m_presets; }
    QComboBox *units() const { return m_units; }
    NumberField *resolution() const { return m_resolution; }
    CanvasSection *section() const { return m_section; }

private:
    void addPresets(QHBoxLayout &row);
    void addUnits(QHBoxLayout &row);
    void takePreset(int index);
    void takeUnit();
    void takeResolution(double resolution);
    void swapSides();
    void showPreset();
    const SheetPreset *preset() const;

    const std::vector<SheetPreset> m_sheets = sheetPresets();
    QComboBox *m_presets = nullptr;
    QComboBox *m_units = nullptr;
    NumberField *m_resolution = nullptr;
    CanvasSection *m_section = nullptr;
    LengthUnits *m_lengths = nullptr; ///< as large on paper as those of the new sheet
};

} // namespace suffuse

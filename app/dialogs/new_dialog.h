#pragma once

#include "model/painting/painting.h"

#include <QDialog>

#include <optional>

class QComboBox;

namespace suffuse {

class CanvasSection;

/// Size, background and paper of a new painting.
class NewDialog : public QDialog {
    Q_OBJECT

public:
    explicit NewDialog(QWidget *parent = nullptr);

    /// The canvas chosen, or nothing if the person thought better of it. Begins with what was chosen last.
    static std::optional<Canvas> ask(QWidget *parent);

    const Canvas &canvas() const;
    QComboBox *presets() const { return m_presets; }
    CanvasSection *section() const { return m_section; }

private:
    void takePreset(int index);
    void swapSides();
    void showPreset();

    QComboBox *m_presets = nullptr;
    CanvasSection *m_section = nullptr;
};

} // namespace suffuse

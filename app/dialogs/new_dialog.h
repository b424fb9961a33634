#pragma once

#include "model/painting/painting.h"

#include <QDialog>

#include <optional>

class QComboBox;

namespace suffuse {

class CanvasSection;

/// Asks for size, background and paper of a new painting.
class NewDialog : public QDialog {
    Q_OBJECT

public:
    explicit NewDialog(QWidget *parent = nullptr);

    /// Returns the chosen canvas, or nothing if the user gave up. The dialog begins with the canvas that was chosen
    /// last.
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

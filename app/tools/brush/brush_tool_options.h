// The brush's row over the canvas.
#pragma once

#include <QWidget>

#include <functional>

class QComboBox;
class QHBoxLayout;

namespace suffuse {

class BrushCombo;
class Editor;
class NumberField;
struct Brush;

/// Shows and changes the brush in use: preset, size, flow, opacity and smoothing.
class BrushToolOptions : public QWidget {
    Q_OBJECT

public:
    explicit BrushToolOptions(Editor &editor);

private:
    void addPresets(QHBoxLayout &row);
    void addSmoothing(QHBoxLayout &row);
    void refresh();
    void change(const std::function<void(Brush &)> &apply);
    void takeAmount(double value);

    Editor &m_editor;
    BrushCombo *m_presets = nullptr;
    NumberField *m_size = nullptr;
    NumberField *m_flow = nullptr;
    NumberField *m_opacity = nullptr;
    QComboBox *m_smoothing = nullptr;
    NumberField *m_amount = nullptr;
};

} // namespace suffuse

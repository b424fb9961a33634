#pragma once

#include "model/painting/style.h"

#include <QWidget>

#include <vector>

class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace suffuse {

class ColourRows;
class ColourSwatch;
class ColourWheel;
class Editor;
class HintLabel;
class MixingSection;
class SwatchGrid;
class SwatchesSection;

/// Shows the colour that is painted with: a wheel, sliders for RYB and opacity, a field for its hex number, the colours
/// that were used last, the painting's swatches, and a sheet to mix on.
class ColourPanel : public QWidget {
    Q_OBJECT

public:
    explicit ColourPanel(Editor &editor, QWidget *parent = nullptr);

    ColourWheel *wheel() const { return m_wheel; }
    ColourRows *rows() const { return m_rows; }
    QLineEdit *hex() const { return m_hex; }
    QPushButton *applyButton() const { return m_apply; }
    SwatchGrid *history() const { return m_history; }
    SwatchesSection *swatches() const { return m_swatches; }
    MixingSection *mixing() const { return m_mixing; }

    QSize sizeHint() const override;

private:
    static constexpr std::size_t recentCount = 16;

    void addCurrent(QVBoxLayout &column);
    void addRecent(QVBoxLayout &column);
    void addApply(QVBoxLayout &column);
    void refresh();
    void takeHex();
    void applyToSelection();
    void rememberUsed();
    void showRecent();

    Editor &m_editor;
    ColourWheel *m_wheel = nullptr;
    ColourRows *m_rows = nullptr;
    QLineEdit *m_hex = nullptr;
    ColourSwatch *m_current = nullptr;
    ColourSwatch *m_previous = nullptr;
    QPushButton *m_apply = nullptr;
    HintLabel *m_hint = nullptr;
    SwatchGrid *m_history = nullptr;
    SwatchesSection *m_swatches = nullptr;
    MixingSection *m_mixing = nullptr;
    std::vector<Colour> m_recent;
    Colour m_used; ///< the colour that was painted with last
};

} // namespace suffuse

#pragma once

#include "model/style.h"

#include <QWidget>

#include <array>
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

/// The colour that is painted with: wheel, RYB and opacity sliders, hex, the colours used last.
class ColourPanel : public QWidget {
    Q_OBJECT

public:
    explicit ColourPanel(Editor &editor, QWidget *parent = nullptr);

    ColourWheel *wheel() const { return m_wheel; }
    ColourRows *rows() const { return m_rows; }
    QLineEdit *hex() const { return m_hex; }
    QPushButton *applyButton() const { return m_apply; }

    QSize sizeHint() const override;

private:
    static constexpr std::size_t recentCount = 10;

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
    std::array<ColourSwatch *, recentCount> m_swatches{};
    std::vector<Colour> m_recent;
    Colour m_used; ///< painted with last
};

} // namespace suffuse

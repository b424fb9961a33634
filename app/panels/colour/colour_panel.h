#pragma once

#include "app/widgets/habits/entry_field.h"
#include "model/painting/style.h"

#include <QWidget>

#include <vector>

class QAbstractButton;
class QComboBox;
class QVBoxLayout;

namespace suffuse {

class ColourHeader;
class ColourRows;
class ColourSwatch;
class ColourWheel;
class Editor;
class HintLabel;
class MixingSection;
class ScreenColourRows;
class SwatchGrid;
class SwatchesSection;

/// Shows a colour: a wheel, sliders, a field for its hex number, the colours that were used last, the painting's
/// swatches, and a sheet to mix on. The header says whose colour it is, the brush's or that of what is selected
/// (ColourTarget).
class ColourPanel : public QWidget {
    Q_OBJECT

public:
    explicit ColourPanel(Editor &editor, QWidget *parent = nullptr);

    ColourHeader *header() const { return m_header; }
    ColourWheel *wheel() const { return m_wheel; }
    ColourRows *rows() const { return m_rows; }
    EntryField *hex() const { return m_hex; }
    /// The sliders of the screen's colours, in place of those of the paint.
    ScreenColourRows *screenRows() const { return m_screenRows; }
    QComboBox *sliderChoice() const { return m_sliders; }
    QAbstractButton *applyButton() const;
    SwatchGrid *history() const { return m_history; }
    SwatchesSection *swatches() const { return m_swatches; }
    MixingSection *mixing() const { return m_mixing; }

    QSize sizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    static constexpr std::size_t recentCount = 16;

    void addCurrent(QVBoxLayout &column);
    void addRecent(QVBoxLayout &column);
    void addSliders(QVBoxLayout &column);
    void chooseSliders(int index);
    void refresh();
    bool showsNone() const;
    void showHex();
    void takeHex(const QString &text);
    Colour beside() const;
    void rememberUsed();
    void showRecent();

    Editor &m_editor;
    ColourHeader *m_header = nullptr;
    ColourWheel *m_wheel = nullptr;
    ColourRows *m_rows = nullptr;
    ScreenColourRows *m_screenRows = nullptr;
    QComboBox *m_sliders = nullptr;
    EntryField *m_hex = nullptr;
    ColourSwatch *m_current = nullptr;
    ColourSwatch *m_previous = nullptr;
    HintLabel *m_hint = nullptr;
    SwatchGrid *m_history = nullptr;
    SwatchesSection *m_swatches = nullptr;
    MixingSection *m_mixing = nullptr;
    std::vector<Colour> m_recent;
    Colour m_used; ///< the colour that was painted with last
};

} // namespace suffuse

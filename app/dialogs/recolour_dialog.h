#pragma once

#include "app/session/colour/recolouring.h"
#include "app/widgets/habits/entry_field.h"

#include <QDialog>
#include <QKeySequence>
#include <QList>

class QCheckBox;
class QGridLayout;
class QPushButton;
class QTreeWidget;
class QVBoxLayout;

namespace suffuse {

class ColourWheel;
class HintLabel;
class SliderField;
class SwatchGrid;
struct FieldSpec;

/// Shows the colours of the painting, or of what is selected, as a list, and gives each another one everywhere, by the
/// wheel, a hex number or a swatch. All of them can be shifted, and mapped to the painting's swatches. What it does
/// shows at once; Cancel takes it back.
class RecolourDialog : public QDialog {
    Q_OBJECT

public:
    RecolourDialog(Editor &editor, QWidget *parent);

    Recolouring &recolouring() { return m_recolouring; }
    QTreeWidget *list() const { return m_list; }
    ColourWheel *wheel() const { return m_wheel; }
    EntryField *hex() const { return m_hex; }
    SwatchGrid *swatches() const { return m_swatches; }
    QCheckBox *keepsBox() const { return m_keeps; }
    QCheckBox *mapsBox() const { return m_maps; }
    QPushButton *resetButton() const { return m_reset; }
    SliderField *hue() const { return m_hue; }
    SliderField *saturation() const { return m_saturation; }
    SliderField *lightness() const { return m_lightness; }

    /// The keys that go back and on through what was changed here.
    void setStepKeys(const QList<QKeySequence> &back, const QList<QKeySequence> &on);

    void accept() override;
    void reject() override;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void step(bool back);
    QWidget *makeList();
    int widthOfColumns() const;
    void addColour(QVBoxLayout &column, const std::vector<Swatch> &swatches);
    void addShift(QVBoxLayout &column);
    SliderField *addRow(const FieldSpec &spec, QGridLayout &grid, double ColourShift::*member);
    std::vector<std::size_t> chosen() const;
    void give(const Colour &colour);
    void takeHex(const QString &text);
    void showColour();
    void showResults();

    Recolouring m_recolouring;
    QTreeWidget *m_list = nullptr;
    ColourWheel *m_wheel = nullptr;
    EntryField *m_hex = nullptr;
    HintLabel *m_hint = nullptr;
    SwatchGrid *m_swatches = nullptr;
    QCheckBox *m_keeps = nullptr;
    QPushButton *m_reset = nullptr;
    SliderField *m_hue = nullptr;
    SliderField *m_saturation = nullptr;
    SliderField *m_lightness = nullptr;
    QCheckBox *m_maps = nullptr;
};

} // namespace suffuse

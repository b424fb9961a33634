#pragma once

#include "app/panels/brushes/brush_page.h"

class QCheckBox;
class QComboBox;

namespace suffuse {

/// The page for the tip, the ends of strokes, and how the hand is steadied.
class BrushHandPage : public BrushPage {
    Q_OBJECT

public:
    explicit BrushHandPage(QWidget *parent);
    void showBrush(const Brush &brush) override;

private:
    void addHand();

    SliderField *m_strength = nullptr;
    SliderField *m_string = nullptr;
    QComboBox *m_stabiliser = nullptr;
    QCheckBox *m_followsPath = nullptr;
};

} // namespace suffuse

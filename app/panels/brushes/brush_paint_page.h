#pragma once

#include "app/panels/brushes/brush_page.h"

#include <array>

class QComboBox;
class QGridLayout;

namespace suffuse {

/// The page for how paint becomes a picture: the style, the mixing, and the numbers of the paint.
class BrushPaintPage : public BrushPage {
    Q_OBJECT

public:
    explicit BrushPaintPage(QWidget *parent);
    void showBrush(const Brush &brush) override;
    QComboBox *style() const { return m_style; }

private:
    void addValues(QGridLayout &grid);

    std::array<SliderField *, 3> m_xi{};
    SliderField *m_beta = nullptr;
    QComboBox *m_style = nullptr;
    QComboBox *m_mix = nullptr;
};

} // namespace suffuse

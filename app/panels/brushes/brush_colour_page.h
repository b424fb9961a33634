#pragma once

#include "app/panels/brushes/brush_page.h"

class QCheckBox;

namespace suffuse {

class ColourSwatch;

/// The page for the second colour, and for how far the paint strays from its colour.
class BrushColourPage : public BrushPage {
    Q_OBJECT

public:
    explicit BrushColourPage(QWidget *parent);
    void showBrush(const Brush &brush) override;

private:
    QCheckBox *m_jitterAlong = nullptr;
    ColourSwatch *m_second = nullptr;
};

} // namespace suffuse

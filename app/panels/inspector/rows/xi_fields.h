// The sliders of ξ1 … ξ3 of styles that are shown together.
#pragma once

#include "app/widgets/numbers/slider_field.h"
#include "model/painting/style.h"

#include <array>
#include <vector>

namespace suffuse {

class XiFields {
public:
    XiFields() = default;
    /// Adds its rows to a grid of fields.
    XiFields(QGridLayout &grid, int row, QWidget *parent);

    SliderField *operator[](std::size_t index) const { return m_fields[index]; }
    /// Shows those that the styles' kind has, with its names and defaults, in ranges within which each of the styles
    /// stays one. Where the kinds differ it shows none.
    void show(const std::vector<Style> &styles);
    /// Sets what the fields say, once they are shown for these styles.
    void setValues(const std::vector<Style> &styles);

    /// The style with which a kind begins.
    static Style defaultStyle(StyleKind kind);

private:
    void name(StyleKind kind);
    void limit(const std::vector<Style> &styles, StyleKind kind);

    std::array<SliderField *, 3> m_fields{};
};

} // namespace suffuse

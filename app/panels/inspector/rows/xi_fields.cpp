#include "app/panels/inspector/rows/xi_fields.h"

#include "app/panels/inspector/inspected.h"
#include "app/widgets/numbers/quantity.h"
#include "model/painting/fields.h"

#include <algorithm>

namespace suffuse {

namespace {

/// The factor is a little smaller than allowed, since the bound must hold after rounding to float.
const double edgeFactor = greatestLightening() * (1 - 1e-7);

std::optional<StyleKind> commonKind(const std::vector<Style> &styles)
{
    return commonValue(styles, [](const Style &style) { return style.kind; });
}

} // namespace

XiFields::XiFields(QGridLayout &grid, int row, QWidget *parent)
{
    for (int i = 0; i < 3; ++i)
        m_fields[std::size_t(i)] = new SliderField(xiSpec(Style{}.kind, i), grid, row + i, parent);
}

Style XiFields::defaultStyle(StyleKind kind)
{
    switch (kind) {
    case StyleKind::Uniform:
        return {kind, {0.5f, 0.05f, 0}};
    case StyleKind::Feathering:
        return {kind, {1, 1.5f, 0}};
    case StyleKind::Edge:
        return {kind, {0.6f, 0.65f, 0.9f}};
    }
    return {};
}

void XiFields::show(const std::vector<Style> &styles)
{
    const std::optional<StyleKind> kind = commonKind(styles);
    for (int i = 0; i < 3; ++i)
        m_fields[std::size_t(i)]->setVisible(kind && i < xiCount(*kind));
    if (!kind)
        return;
    name(*kind);
    limit(styles, *kind);
}

void XiFields::setValues(const std::vector<Style> &styles)
{
    if (!commonKind(styles))
        return;
    for (std::size_t i = 0; i < m_fields.size(); ++i)
        m_fields[i]->setValue(commonNumber(styles, [i](const Style &style) { return style.xi[i]; }));
}

void XiFields::name(StyleKind kind)
{
    const Style fallback = defaultStyle(kind);
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        const FieldSpec spec = xiSpec(kind, int(i));
        m_fields[i]->rename(spec.name, spec.toolTip);
        m_fields[i]->setDefaultValue(double(fallback.xi[i]));
    }
}

void XiFields::limit(const std::vector<Style> &styles, StyleKind kind)
{
    double lowestXi1 = positive.greatest, highestXi2 = positive.leastFloat();
    for (const Style &style : styles) {
        lowestXi1 = std::min(lowestXi1, double(style.xi[0]));
        highestXi2 = std::max(highestXi2, double(style.xi[1]));
    }
    const auto domain = [kind](int index) { return domainOfXi(kind, index); };
    double xi1From = domain(0).leastFloat(), xi2To = domain(1).greatest;
    if (hasRim(kind)) {
        xi1From = highestXi2 / edgeFactor;
        xi2To = lowestXi1 * edgeFactor;
    }
    m_fields[0]->setRange(xi1From, domain(0).greatest);
    m_fields[1]->setRange(domain(1).leastFloat(), xi2To);
    m_fields[2]->setRange(domain(2).leastFloat(), domain(2).greatest);
    m_fields[0]->setSliderRange(std::max(0.02, xi1From), std::max(hasRim(kind) ? 2.0 : 4.0, 2 * xi1From));
    if (kind == StyleKind::Uniform)
        m_fields[1]->setSliderRange(0.002, 1);
    else
        m_fields[1]->setSliderRange(kind == StyleKind::Feathering ? 0.5 : std::min(0.02, xi2To / 2),
                                    std::min(xi2To, 64.0));
    m_fields[2]->setSliderRange(0.05, 1);
}

} // namespace suffuse

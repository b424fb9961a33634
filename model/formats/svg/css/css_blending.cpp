#include "model/formats/svg/css/css_blending.h"

#include "model/painting/fields.h"

#include <algorithm>

namespace suffuse {

namespace {

constexpr const char *plusInCss = "plus-lighter";

bool hasMarkers(const SvgStyle &style)
{
    return std::ranges::any_of(style.markers, [](const QString &marker) { return !svgReference(marker).isEmpty(); });
}

} // namespace

const char *cssOf(BlendMode mode)
{
    if (mode == BlendMode::Plus)
        return plusInCss;
    return mode < BlendMode::Plus ? WordsOf<BlendMode>::list[std::size_t(mode)].data() : nullptr;
}

std::optional<BlendMode> blendModeFrom(const QString &css)
{
    for (int mode = 0; mode <= int(BlendMode::Plus); ++mode)
        if (css.compare(QLatin1String(cssOf(BlendMode(mode))), Qt::CaseInsensitive) == 0)
            return BlendMode(mode);
    return {};
}

bool blendsAsOne(const SvgElement &element, const SvgStyle &style)
{
    if (style.blend != BlendMode::Normal)
        return true;
    const bool isMany = element.name == QLatin1String("use") || element.name == QLatin1String("switch");
    return style.opacity < 1 && (isMany || hasMarkers(style));
}

void setBlending(SvgGroup &group, const SvgStyle &style)
{
    group.opacity = std::clamp(float(style.opacity), 0.0f, 1.0f);
    group.blend = style.blend;
    group.isIsolated = style.isIsolated;
}

bool blends(const SvgGroup &group)
{
    return group.opacity < 1 || group.blend != BlendMode::Normal || group.isIsolated;
}

} // namespace suffuse

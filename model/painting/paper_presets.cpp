#include "model/painting/paper_presets.h"

#include <QCoreApplication>

namespace suffuse {

std::span<const PaperPreset> paperPresets()
{
    static constexpr PaperPreset presets[] = {
        {QT_TRANSLATE_NOOP("Papers", "Smooth"), PaperGrain::Tooth, 4, 0.3f},
        {QT_TRANSLATE_NOOP("Papers", "Cold press"), PaperGrain::Tooth, 12, 0.6f},
        {QT_TRANSLATE_NOOP("Papers", "Rough"), PaperGrain::Tooth, 24, 0.85f},
        {QT_TRANSLATE_NOOP("Papers", "Rice"), PaperGrain::Fibres, 16, 0.6f},
        {QT_TRANSLATE_NOOP("Papers", "Canvas"), PaperGrain::Weave, 6, 0.75f},
    };
    return presets;
}

Paper paperOf(const PaperPreset &preset, std::uint32_t seed)
{
    Paper paper;
    paper.kind = PaperKind::Procedural;
    paper.grain = preset.grain;
    paper.seed = seed;
    paper.scale = preset.scale;
    paper.strength = preset.strength;
    return paper;
}

int presetOf(const Paper &paper)
{
    const auto presets = paperPresets();
    for (std::size_t i = 0; i < presets.size(); ++i)
        if (paper == paperOf(presets[i], paper.seed))
            return int(i);
    return -1;
}

QString titleOf(const PaperPreset &preset)
{
    return QCoreApplication::translate("Papers", preset.name);
}

} // namespace suffuse

#include "render/cuda/device_pictures.h"

#include <algorithm>

namespace suffuse::cuda {

Fault DevicePictures::keep(const std::vector<SceneStrokePtr> &strokes)
{
    std::vector<PictureLevelsPtr> missing;
    for (Kept &kept : m_kept)
        kept.isUsed = false;
    for (const SceneStrokePtr &stroke : strokes) {
        if (!stroke->picture)
            continue;
        const PictureLevelsPtr &levels = stroke->picture->levels;
        const auto known = std::ranges::find(m_kept, levels, &Kept::levels);
        if (known != m_kept.end())
            known->isUsed = true;
        else if (std::ranges::find(missing, levels) == missing.end())
            missing.push_back(levels);
    }
    m_kept.remove_if([](const Kept &kept) { return !kept.isUsed; });
    for (const PictureLevelsPtr &levels : missing) {
        Kept &kept = m_kept.emplace_back(levels, m_device);
        Fault fault = kept.values.reserve(levels->bytes() / sizeof(std::uint16_t));
        if (!fault)
            fault = m_device.upload(kept.values.data(), levels->level(0).rgba, levels->bytes());
        if (fault) {
            m_kept.pop_back();
            return fault;
        }
    }
    return {};
}

PictureView DevicePictures::viewOf(const ScenePicture &picture) const
{
    const auto kept = std::ranges::find(m_kept, picture.levels, &Kept::levels);
    const std::uint16_t *first = picture.levels->level(0).rgba;
    PictureView view = picture.view;
    for (PictureLevel *level : {&view.finer, &view.coarser})
        level->rgba = kept->values.data() + (level->rgba - first);
    return view;
}

} // namespace suffuse::cuda

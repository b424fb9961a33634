#include "app/session/frames/shown_frame.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace suffuse {

void FrameBoard::with(const std::function<void(ShownFrame &)> &use)
{
    const std::lock_guard lock(m_mutex);
    use(m_shown);
}

void FrameBoard::notePatches(const std::vector<PixelRect> &rects)
{
    m_patches.insert(m_patches.end(), rects.begin(), rects.end());
    std::sort(m_patches.begin(), m_patches.end(),
              [](const PixelRect &a, const PixelRect &b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); });
    m_patches.erase(std::unique(m_patches.begin(), m_patches.end()), m_patches.end()); // whole tiles each time
}

std::vector<PixelRect> FrameBoard::takePatches()
{
    return std::exchange(m_patches, {});
}

} // namespace suffuse

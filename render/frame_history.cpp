#include "render/frame_history.h"

#include <algorithm>

namespace suffuse {

bool FrameHistory::sameFrame(const RenderRequest &request, const Target &target) const
{
    return m_target == target.serial() && m_view == request.view && m_transparent == request.transparent &&
           m_canvas.background == request.painting->canvas.background &&
           m_canvas.paper == request.painting->canvas.paper;
}

void FrameHistory::markDifferences(const SceneChange &change, int threads)
{
    const auto &scene = m_scene.strokes();
    if (!change.reordered) {
        for (const SceneChange::Replaced &r : change.replaced)
            markChanged(*r.before, *scene[r.index], m_view, threads, m_region);
        return;
    }
    std::unordered_map<StrokeId, const SceneStroke *> old, now;
    std::vector<StrokeId> orderBefore, orderAfter;
    for (const auto &s : change.before)
        old[s->stroke->id] = s.get(), orderBefore.push_back(s->stroke->id);
    for (const auto &s : scene) {
        now[s->stroke->id] = s.get(), orderAfter.push_back(s->stroke->id);
        const auto it = old.find(s->stroke->id);
        if (it == old.end())
            m_region.mark(s->bounds);
        else if (it->second != s.get())
            markChanged(*it->second, *s, m_view, threads, m_region);
        old.erase(s->stroke->id);
    }
    for (const auto &[id, stroke] : old)
        m_region.mark(stroke->bounds);
    for (StrokeId id : movedInOrder(orderBefore, orderAfter))
        m_region.mark(now[id]->bounds);
}

std::size_t FrameHistory::firstDifference(const SceneChange &change) const
{
    if (!change.reordered)
        return change.replaced.empty() ? noEdit : change.replaced.front().index;
    // Scene strokes are shared while they stay the same: what both scenes begin with did not change.
    const auto &scene = m_scene.strokes();
    const auto [before, now] = std::mismatch(change.before.begin(), change.before.end(), scene.begin(), scene.end());
    return before == change.before.end() && now == scene.end() ? noEdit : std::size_t(now - scene.begin());
}

void FrameHistory::followEdits(Step &step, bool interactive)
{
    step.keepsUnder = step.keepsOver = true;
    m_oneEdited = false;
    if (const std::size_t first = firstDifference(step.scene); first != noEdit) {
        // Kept a little lower than needed while several strokes change by turns (they dry one after another).
        const std::size_t slack = interactive ? 0 : 4;
        if (m_edited == noEdit || first < m_edited || first > m_edited + slack) {
            step.keepsUnder = false;
            m_edited = first;
        }
        m_oneEdited = first == m_edited && step.scene.replaced.size() == 1;
        step.keepsOver = step.keepsUnder && m_oneEdited;
    }
    if (interactive || !m_anyApproximate)
        return;
    m_anyApproximate = false;
    for (int row = 0; row < m_region.rows(); ++row)
        for (int column = 0; column < m_region.columns(); ++column)
            if (std::uint8_t &approximate = m_approximate[tileIndex(column, row)]; approximate) {
                m_region.mark(m_region.tile(column, row));
                approximate = 0;
            }
}

FrameHistory::Step FrameHistory::advance(const RenderRequest &request, Target &target, int threads)
{
    Step step;
    step.whole = !sameFrame(request, target);
    const bool resized =
        m_target != target.serial() || m_view.width != request.view.width || m_view.height != request.view.height;
    step.scene = m_scene.update(request, threads);
    m_view = request.view;
    m_transparent = request.transparent;
    m_canvas = request.painting->canvas;
    if (resized)
        target.resize(m_view.width, m_view.height);
    if (step.whole) {
        m_region.reset(m_view.width, m_view.height, m_tileSize);
        m_edited = noEdit;
        m_oneEdited = false;
        m_approximate.assign(std::size_t(m_region.columns()) * std::size_t(m_region.rows()), 0);
        m_anyApproximate = false;
        m_target = target.serial();
    } else {
        markDifferences(step.scene, threads);
        followEdits(step, request.interactive);
    }
    return step;
}

void FrameHistory::drawnAll()
{
    if (m_anyApproximate)
        std::transform(m_approximate.begin(), m_approximate.end(), m_region.dirtyRow(0), m_approximate.begin(),
                       [](std::uint8_t approximate, std::uint8_t dirty) { return approximate & (1 - dirty); });
    m_region.cleanAll();
}

} // namespace suffuse

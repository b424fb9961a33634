#include "render/scene/frame_history.h"

#include <algorithm>

namespace suffuse {

namespace {

/// The strokes that must be marked whole because they moved relative to the others: those outside a longest sequence
/// that rises in the places before.
std::vector<std::size_t> movedInOrder(const std::vector<std::size_t> &places)
{
    std::vector<std::size_t> common, old; // the strokes of both orders
    for (std::size_t i = 0; i < places.size(); ++i)
        if (places[i] != SceneChange::nowhere)
            common.push_back(i), old.push_back(places[i]);
    if (std::is_sorted(old.begin(), old.end()))
        return {};
    std::vector<std::size_t> tails, previous(old.size(), SIZE_MAX); // patience sorting takes O(n log n)
    for (std::size_t i = 0; i < old.size(); ++i) {
        const auto at = std::lower_bound(tails.begin(), tails.end(), i,
                                         [&](std::size_t tail, std::size_t k) { return old[tail] < old[k]; });
        if (at != tails.begin())
            previous[i] = *(at - 1);
        if (at == tails.end())
            tails.push_back(i);
        else
            *at = i;
    }
    std::vector<char> kept(old.size(), 0);
    for (std::size_t i = tails.back(); i != SIZE_MAX; i = previous[i])
        kept[i] = 1;
    std::vector<std::size_t> moved;
    for (std::size_t i = 0; i < common.size(); ++i)
        if (!kept[i])
            moved.push_back(common[i]);
    return moved;
}

} // namespace

bool FrameHistory::samePaper(const RenderRequest &request, const Target &target) const
{
    return m_target == target.serial() && m_transparent == request.transparent &&
           m_canvas.background == request.painting->canvas.background &&
           m_canvas.paper == request.painting->canvas.paper;
}

bool FrameHistory::move(const RenderRequest &request, const PictureGrid &grid, Target &target)
{
    const PixelRect &was = m_grid.picture, &is = grid.picture;
    const int dx = was.x - is.x, dy = was.y - is.y;
    if (!m_grid.sameGrid(grid) || m_painting != request.painting || m_time != request.time || m_anyApproximate ||
        was.width != is.width || was.height != is.height || std::abs(dx) >= is.width || std::abs(dy) >= is.height)
        return false;
    return target.move(dx, dy);
}

void FrameHistory::markDifferences(const SceneChange &change, Threads threads)
{
    const auto &scene = m_scene.strokes();
    if (!change.reordered) {
        for (const SceneChange::Replaced &r : change.replaced)
            markChanged(*r.before, *scene[r.index], m_grid, threads, m_region);
        return;
    }
    const LayerChanges layers(change.composed, m_scene.composition());
    if (layers.isEverywhere() || (!m_scene.composition().everywhere.empty() && !movedInOrder(change.places).empty())) {
        m_region.markAll();
        return;
    }
    std::vector<char> stays(change.before.size(), 0);
    for (std::size_t i = 0; i < scene.size(); ++i) {
        const std::size_t place = change.places[i];
        if (place == SceneChange::nowhere) {
            m_region.mark(scene[i]->bounds);
            continue;
        }
        stays[place] = 1;
        if (layers.concerns(place, i))
            m_region.mark(change.before[place]->bounds), m_region.mark(scene[i]->bounds);
        else if (change.before[place] != scene[i])
            markChanged(*change.before[place], *scene[i], m_grid, threads, m_region);
    }
    for (std::size_t i = 0; i < stays.size(); ++i)
        if (!stays[i])
            m_region.mark(change.before[i]->bounds);
    for (const std::size_t i : movedInOrder(change.places))
        m_region.mark(scene[i]->bounds);
}

std::size_t FrameHistory::firstDifference(const SceneChange &change) const
{
    if (!change.reordered)
        return change.replaced.empty() ? noEdit : change.replaced.front().index;
    // Strokes of a scene are shared while they stay the same, so what both scenes begin with has not changed.
    const auto &scene = m_scene.strokes();
    const auto [before, now] = std::mismatch(change.before.begin(), change.before.end(), scene.begin(), scene.end());
    const auto same = std::size_t(now - scene.begin());
    const LayerChanges layers(change.composed, m_scene.composition());
    if (layers.isEverywhere())
        return 0;
    for (std::size_t i = 0; i < same; ++i)
        if (layers.concerns(i, i))
            return i;
    return before == change.before.end() && now == scene.end() ? noEdit : same;
}

void FrameHistory::followEdits(Step &step, bool interactive)
{
    step.keepsUnder = step.keepsOver = true;
    m_edits = Edits::Other;
    if (const std::size_t first = firstDifference(step.scene); first != noEdit) {
        // It is kept a little lower than needed while several strokes change by turns (as when they dry one after
        // another).
        const std::size_t slack = interactive ? 0 : 4;
        // What lies below knows what it covers of the bases alone that there were.
        const Composition &before = step.scene.composed, &now = m_scene.composition();
        const bool sameKind = !step.scene.reordered || (before.isFlat() == now.isFlat() && before.bases == now.bases &&
                                                        before.isBounded == now.isBounded);
        step.keepsUnder = m_edited != noEdit && first >= m_edited && sameKind;
        step.raisesUnder = step.keepsUnder && first > m_edited + slack;
        if (!step.keepsUnder || step.raisesUnder)
            m_edited = first;
        int put =
            step.scene.reordered && step.scene.before == m_scene.strokes() ? layerPutAnew(before, now) : Layer::none;
        if (put != Layer::none && now.layers[std::size_t(put)].first != first) // It acts everywhere.
            put = Layer::none;
        if (first == m_edited && (put != Layer::none || step.scene.replaced.size() == 1))
            m_edits = put != Layer::none ? Edits::OnePut : Edits::OneStroke;
        step.keepsOver =
            step.keepsUnder && !step.raisesUnder && m_edits != Edits::Other && m_edits == m_kept && put == m_layer;
        m_kept = m_edits;
        m_layer = put;
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

FrameHistory::Step FrameHistory::advance(const RenderRequest &request, const PictureGrid &grid, Target &target,
                                         Threads threads, const std::atomic<bool> *stop)
{
    Step step;
    const bool samePicture = m_grid.samePlace(grid) && m_grid.picture == grid.picture;
    step.moved = !samePicture && samePaper(request, target) && move(request, grid, target);
    step.whole = !step.moved && !(samePicture && samePaper(request, target));
    const bool resized = m_target != target.serial() || m_grid.picture.width != grid.picture.width ||
                         m_grid.picture.height != grid.picture.height;
    step.scene = m_scene.update(request, grid, threads, stop);
    m_grid = grid;
    m_painting = request.painting;
    m_time = request.time;
    m_transparent = request.transparent;
    m_canvas = request.painting->canvas;
    if (resized)
        target.resize(grid.picture.width, grid.picture.height);
    if (step.whole || step.moved) {
        if (step.whole)
            m_region.reset(grid.picture, m_tileSize);
        else
            m_region.moveTo(grid.picture);
        m_edited = noEdit;
        m_edits = Edits::Other;
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

#include "app/panels/strokes/thumbnails/group_thumbnails.h"

#include "app/panels/strokes/thumbnails/thumbnail_renderer.h"
#include "model/painting/influence.h"
#include "undo/layers/group_alone.h"

#include <algorithm>
#include <functional>

namespace suffuse {

namespace {

constexpr std::size_t mostGroupsWanted = 64; ///< Older wishes are dropped, since their rows have been scrolled past.
constexpr int idleMs = 250;            ///< since something was asked for

void mixIn(std::size_t &state, std::size_t value)
{
    state ^= value + 0x9e3779b97f4a7c15u + (state << 6) + (state >> 2);
}

/// Mixes in what of a group changes its picture.
void mixGroup(std::size_t &state, const Group &group, bool isWithin)
{
    mixIn(state, std::size_t(group.id));
    if (group.wash) {
        for (const float xi : group.wash->style.xi)
            mixIn(state, std::hash<float>()(xi));
        mixIn(state, std::size_t(group.wash->style.kind) * 8 + std::size_t(group.wash->mix.mode) + 1);
        mixIn(state, std::hash<float>()(group.wash->mix.beta));
    }
    if (!isWithin)
        return mixIn(state, group.isolated);
    mixIn(state, std::hash<float>()(group.opacity));
    mixIn(state, std::size_t(group.blend) * 16 + group.visible * 8 + group.isolated * 4 + group.clips * 2 + group.mask);
}

} // namespace

GroupThumbnails::GroupThumbnails(const StrokesTree &tree, QObject *parent)
    : QObject(parent), m_tree(tree), m_renderer(std::make_shared<ThumbnailRenderer>())
{
    m_thread.setMaxThreadCount(1);
    m_thread.setThreadPriority(QThread::IdlePriority);
    m_idle.setSingleShot(true);
    m_idle.setInterval(idleMs);
    connect(&m_idle, &QTimer::timeout, this, &GroupThumbnails::startNext);
}

GroupThumbnails::~GroupThumbnails()
{
    if (m_cancel)
        *m_cancel = true;
    m_thread.waitForDone();
}

/// Strokes are values that never change, so which ones there are tells what the picture shows.
std::size_t GroupThumbnails::stateOf(const StrokesTree::Node &group) const
{
    std::size_t state = 0;
    const auto add = [&](const StrokesTree::Node &node, bool isWithin, const auto &again) -> void {
        if (node.stroke) {
            mixIn(state, std::hash<const void *>()(node.value.get()));
            mixIn(state, std::size_t(node.stroke));
            return;
        }
        if (const Group *value = m_tree.groupOf(node.group))
            mixGroup(state, *value, isWithin);
        for (const auto &child : node.children)
            again(*child, true, again);
    };
    add(group, false, add);
    return state;
}

QImage GroupThumbnails::of(const StrokesTree::Node &group, double ratio, bool quiet)
{
    if (quiet && m_cancel)
        *m_cancel = true;
    Entry *entry = m_known.object(group.group);
    if (!entry) {
        entry = new Entry;
        m_known.insert(group.group, entry);
    }
    if (m_seenIn != m_tree.painting()) {
        m_seenIn = m_tree.painting();
        ++m_seen;
    }
    if (std::exchange(entry->seen, m_seen) != m_seen) // The walk through what is in it is done once for each change.
        entry->state = stateOf(group);
    const Wish wish{group.group, entry->state, ratio};
    if (entry->shown != wish && !quiet)
        ask(wish);
    return entry->image;
}

void GroupThumbnails::ask(const Wish &wish)
{
    if (m_running == wish && m_cancel && !*m_cancel)
        return;
    if (m_running.group == wish.group && m_running != wish && m_cancel)
        *m_cancel = true; // It shows what was before.
    if (std::ranges::find(m_wanted, wish) != m_wanted.end())
        return;
    std::erase_if(m_wanted, [&](const Wish &other) { return other.group == wish.group; });
    if (m_wanted.size() >= mostGroupsWanted)
        m_wanted.erase(m_wanted.begin());
    m_wanted.push_back(wish);
    m_idle.start();
}

void GroupThumbnails::startNext()
{
    if (m_running.group != 0 || m_wanted.empty())
        return;
    m_running = m_wanted.back();
    m_wanted.pop_back();
    m_cancel = std::make_shared<std::atomic<bool>>(false);
    m_thread.start([this, wish = m_running, painting = m_tree.painting(), cancel = m_cancel, renderer = m_renderer] {
        const auto alone = std::make_shared<const Painting>(groupAlone(*painting, wish.group));
        const Rect box = alone->strokes.empty() ? Rect() : influenceOf(*alone, alone->end());
        const QImage image = box.isEmpty() || *cancel ? QImage() : renderer->draw(alone, box, wish.ratio, cancel.get());
        QMetaObject::invokeMethod(
            this, [this, wish, image] { take(wish, image); }, Qt::QueuedConnection);
    });
}

void GroupThumbnails::take(const Wish &wish, const QImage &image)
{
    const bool isWhole = !*m_cancel;
    m_running = {};
    m_cancel.reset();
    if (Entry *entry = isWhole ? m_known.object(wish.group) : nullptr) {
        entry->shown = wish;
        entry->image = image;
    }
    emit ready(wish.group); // Where it was given up, the row asks again once it is painted.
    if (!m_idle.isActive())
        startNext();
}

} // namespace suffuse

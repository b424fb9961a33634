#include "app/session/current_layer.h"

#include "app/session/painting_clock.h"
#include "app/session/settings/settings.h"
#include "model/painting/text_title.h"
#include "undo/history/order_tree.h"
#include "undo/layers/emptied_groups.h"
#include "undo/layers/group_alone.h"
#include "undo/time_edits.h"

#include <QCoreApplication>

#include <algorithm>

namespace suffuse {

namespace {

const QString onlyKey = QStringLiteral("layers/only");

} // namespace

QString titleOf(const Group &group)
{
    const QString title = group.name.isEmpty() && group.text ? titleOf(*group.text) : group.name;
    return title.isEmpty() ? QCoreApplication::translate("suffuse::StrokesModel", "Group %1").arg(group.id) : title;
}

QString nameOfCopy(const std::vector<Group> &groups, const QString &name)
{
    const QString copy = CurrentLayer::tr("%1 copy").arg(name);
    for (int n = 1;; ++n)
        if (const QString numbered = n == 1 ? copy : CurrentLayer::tr("%1 copy %2").arg(name).arg(n);
            std::ranges::find(groups, numbered, &Group::name) == groups.end())
            return numbered;
}

CurrentLayer::CurrentLayer(Document &document, const PaintingClock &clock)
    : m_document(document), m_clock(clock), m_isOnly(settings::store().value(onlyKey).toBool())
{
    connect(&document, &Document::changed, this, &CurrentLayer::follow);
}

bool CurrentLayer::isComing() const
{
    return m_layer.group != 0 && !m_document.painting()->findGroup(m_layer.group);
}

QString CurrentLayer::title() const
{
    if (m_layer.group == 0)
        return {};
    const Group *group = m_document.painting()->findGroup(m_layer.group);
    return titleOf(group ? *group : *m_layer.coming);
}

void CurrentLayer::setOnly(bool only)
{
    if (std::exchange(m_isOnly, only) == only)
        return;
    settings::store().setValue(onlyKey, only);
    emit changed();
}

PaintingPtr CurrentLayer::reached() const
{
    const PaintingPtr &painting = m_document.painting();
    const GroupId group = reachedGroup();
    if (group == 0)
        return painting;
    if (m_whole != painting || m_reachedGroup != group) {
        m_whole = painting, m_reachedGroup = group;
        const bool isFree =
            !isComing() && groupTakingPaint(*painting, group) == group && !isHiddenBySolo(painting->groups, group);
        m_reached = std::make_shared<const Painting>(groupAlone(*painting, isFree ? group : 0));
    }
    return m_reached;
}

void CurrentLayer::noteOnly()
{
    emit noted(tr("Only what is on %1 is reached. Layer ▸ This Layer Only reaches all again.").arg(title()));
}

void CurrentLayer::set(PaintedLayer layer)
{
    m_layer = std::move(layer);
    tell();
}

void CurrentLayer::tell()
{
    const Painting &painting = *m_document.painting();
    m_around = groupsAround(painting, isComing() ? m_layer.coming->parent : m_layer.group);
    m_title = title();
    m_wasComing = isComing();
    emit changed();
}

void CurrentLayer::choose(GroupId group)
{
    const Painting &painting = *m_document.painting();
    const GroupId layer = painting.findGroup(group) ? layerAround(painting, group) : 0;
    if (layer == m_layer.group)
        return;
    set({layer, {}, 0});
    m_chosen = m_layer;
    emit noted(layer ? tr("Layer: %1").arg(m_title) : tr("No layer: paint goes on top of all"));
}

void CurrentLayer::chooseByStep(GroupId group)
{
    const PaintedLayer *before = m_steps.before(m_done - 1);
    const PaintedLayer was = before ? *before : m_chosen;
    choose(group);
    m_steps.note(m_done - 1, was, m_layer);
}

/// The number in a name that `newName` gives; 0: it is another one.
int CurrentLayer::numberIn(const QString &name) const
{
    const QString pattern = tr("Layer %1");
    const qsizetype at = pattern.indexOf(QLatin1String("%1")), after = pattern.size() - at - 2;
    if (!name.startsWith(pattern.left(at)) || !name.endsWith(pattern.right(after)))
        return 0;
    return name.mid(at, name.size() - at - after).toInt();
}

/// Counts on, also where layers have been renamed or deleted.
QString CurrentLayer::newName() const
{
    int last = m_lastNumber;
    for (const Group &group : m_document.painting()->groups)
        last = std::max(last, numberIn(group.name));
    return tr("Layer %1").arg(last + 1);
}

/// What is selected on a layer that is left could be deleted by mistake.
void CurrentLayer::deselectWithin(GroupId group)
{
    Selection selection = m_document.selection();
    if (group == 0 || selection.isEmpty())
        return;
    WithinGroup within(*m_document.painting(), group);
    for (const StrokePtr &stroke : m_document.painting()->strokes)
        if (within(*stroke) && selection.strokes.erase(stroke->id) > 0)
            std::erase_if(selection.segments, [&](const SegmentRef &ref) { return ref.stroke == stroke->id; });
    m_document.setSelection(std::move(selection));
}

void CurrentLayer::noteNew()
{
    emit noted((m_layer.coming->clips ? tr("New clipped layer: %1. Paint on it, where the layer below has paint.")
                                      : tr("New layer: %1. Paint on it."))
                   .arg(m_title));
}

void CurrentLayer::beginNew(bool clips)
{
    if (isComing() && !m_layer.place) {
        m_layer.coming->clips = clips;
        m_chosen = m_layer;
        return noteNew();
    }
    const Group *below = m_document.painting()->findGroup(m_layer.group);
    PaintedLayer layer;
    layer.group = m_document.takeGroupId();
    Group &coming = layer.coming.emplace();
    coming.id = layer.group;
    coming.name = newName();
    coming.clips = clips;
    deselectWithin(m_layer.group);
    coming.parent = below ? below->parent : isComing() ? m_layer.coming->parent : 0;
    layer.above = m_layer.group;
    layer.place = m_layer.place;
    set(std::move(layer));
    m_chosen = m_layer;
    noteNew();
}

std::optional<BegunLayer> CurrentLayer::begun() const
{
    if (!isComing() || m_layer.place)
        return {};
    const Group &coming = *m_layer.coming;
    return BegunLayer{coming.name, coming.clips, coming.parent, m_layer.above};
}

void CurrentLayer::beginAgain(const BegunLayer &begun)
{
    const auto isThere = [this](GroupId group) { return m_document.painting()->findGroup(group) != nullptr; };
    if (begun.parent != 0 && !isThere(begun.parent))
        return;
    PaintedLayer layer;
    layer.group = m_document.takeGroupId();
    Group &coming = layer.coming.emplace();
    coming.id = layer.group;
    coming.name = begun.name;
    coming.clips = begun.clips;
    coming.parent = begun.parent;
    layer.above = isThere(begun.above) ? begun.above : 0;
    set(std::move(layer));
    m_chosen = m_layer;
    noteNew();
}

/// Whether it is there, or can come.
bool CurrentLayer::canBe(const PaintedLayer &layer) const
{
    const Painting &painting = *m_document.painting();
    return layer.group == 0 || painting.findGroup(layer.group) ||
           (layer.coming && (layer.coming->parent == 0 || painting.findGroup(layer.coming->parent)));
}

void CurrentLayer::follow(const Change &change)
{
    if (change.selection)
        m_selects = change.order || change.canvas || change.texts || !change.strokes.empty();
    if (change.reset) {
        set({});
        m_chosen = m_layer;
        m_lastNumber = 0;
        return;
    }
    if (m_layer.group == 0 || (!change.canvas && !change.texts && !change.order))
        return;
    const Painting &painting = *m_document.painting();
    if (!canBe(m_layer)) {
        const auto left = std::ranges::find_if(m_around, [&](GroupId id) { return painting.findGroup(id); });
        return set({left == m_around.end() ? 0 : layerAround(painting, *left), {}, 0});
    }
    if (painting.findGroup(m_layer.group)) {
        if (layerAround(painting, m_layer.group) != m_layer.group)
            return set({layerAround(painting, m_layer.group), {}, 0});
        if (m_wasComing)
            m_lastNumber = std::max(m_lastNumber, numberIn(title()));
        m_layer = {m_layer.group, {}, 0};
        m_around = groupsAround(painting, m_layer.group);
    }
    if (title() != m_title || isComing() != m_wasComing)
        tell();
}

void CurrentLayer::takeEmptied(Edit &edit)
{
    const Painting &painting = *m_document.painting();
    const std::vector<GroupId> gone = suffuse::takeEmptied(painting, edit);
    if (std::ranges::find(gone, m_layer.group) != gone.end())
        m_layer = emptiedLayer(painting, m_layer.group, gone);
}

void CurrentLayer::stepComes(int number)
{
    m_steps.add(number, m_chosen, m_layer);
    m_chosen = m_layer;
    m_done = number + 1;
    m_selects = false;
}

void CurrentLayer::walkTo(int steps)
{
    const int from = std::exchange(m_done, steps);
    if (from == steps)
        return;
    const PaintedLayer was = m_chosen;
    const bool selects = std::exchange(m_selects, false) && !m_document.selection().isEmpty();
    const std::optional<GroupId> known = selects ? m_steps.known(from, steps) : std::nullopt;
    if (const std::optional<PaintedLayer> layer = m_steps.walked(was, from, steps); layer && canBe(*layer))
        set(*layer);
    else if (known && *known != m_layer.group && canBe({*known, {}, 0}))
        set({*known, {}, 0});
    else if (m_layer.group != was.group && from > steps) // It went by what was undone, and comes back with it.
        m_steps.note(from - 1, m_layer, was);
    m_chosen = m_layer;
}

void CurrentLayer::forgetSteps(int steps)
{
    m_steps.clear();
    m_done = steps;
    m_chosen = m_layer;
}

/// When the first of what an edit brings was begun, in the past; else nothing.
std::optional<Microseconds> CurrentLayer::bornIn(const Edit &edit) const
{
    std::optional<Microseconds> born;
    if (m_clock.isInPast())
        for (const auto &[id, stroke] : edit.strokes)
            if (stroke)
                born = born ? std::min(*born, stroke->born()) : stroke->born();
    return born;
}

Edit CurrentLayer::put(Edit edit, LayerEnd end) const
{
    const std::optional<Microseconds> born = bornIn(edit);
    return endingSolo(m_document, addedToLayer(m_document, std::move(edit), m_layer, end, born));
}

bool CurrentLayer::isTop() const
{
    return m_layer.group == 0 && !isHiddenBySolo(m_document.painting()->groups, 0);
}

/// Says of an edit that it ends solo, if it does.
Edit CurrentLayer::shown(Edit edit)
{
    if (edit.groups && std::ranges::any_of(m_document.painting()->groups, &Group::solo) &&
        std::ranges::none_of(*edit.groups, &Group::solo))
        emit noted(tr("All is shown again, since this would be hidden"));
    return edit;
}

Edit CurrentLayer::takePasted(Edit edit)
{
    const std::optional<Microseconds> born = bornIn(edit);
    return shown(endingSolo(m_document, pastedToLayer(m_document, std::move(edit), m_layer, born)));
}

/// The layer or the innermost group around it that is hidden or locked; null: none.
const Group *CurrentLayer::closed() const
{
    const Painting &painting = *m_document.painting();
    for (const GroupId id : groupsAround(painting, isComing() ? m_layer.coming->parent : m_layer.group))
        if (const Group *group = painting.findGroup(id); group && (!group->visible || group->locked))
            return group;
    return nullptr;
}

bool CurrentLayer::takesPaint()
{
    const Group *group = closed();
    if (group)
        emit noted((group->locked ? tr("%1 is locked: nothing is painted there")
                                  : tr("%1 is hidden: nothing is painted there"))
                       .arg(titleOf(*group)));
    return !group;
}

Edit CurrentLayer::take(Edit edit, LayerEnd end)
{
    if (isTop() || edit.isEmpty())
        return edit;
    if (!addedOnTop(*m_document.painting(), edit).empty() && !takesPaint())
        return {};
    return shown(put(std::move(edit), end));
}

bool CurrentLayer::findDraftPlace() const
{
    const StrokePtr &draft = m_document.draft();
    const PaintingPtr &painting = m_document.painting();
    if (m_place.painting == painting && m_place.draft == draft->id && m_place.layer == m_layer.group &&
        m_place.isInPast == m_clock.isInPast())
        return true;
    Edit edit = put(addStrokes(m_document, {draft}, false), LayerEnd::Top);
    if (m_clock.isInPast())
        edit = placedInTime(m_document, std::move(edit));
    const auto it = edit.strokes.find(draft->id);
    if (it == edit.strokes.end() || !edit.order)
        return false;
    const auto at = std::ranges::find(*edit.order, draft->id);
    m_place = {painting,
               draft->id,
               m_layer.group,
               m_clock.isInPast(),
               std::size_t(at - edit.order->begin()),
               it->second->group,
               std::move(edit.groups)};
    return true;
}

PaintingPtr CurrentLayer::withDraft() const
{
    if (!findDraftPlace())
        return m_document.snapshot();
    auto painting = std::make_shared<Painting>(*m_document.painting());
    if (m_place.groups)
        painting->groups = *m_place.groups;
    std::size_t index = m_place.index;
    const auto putIn = [&](StrokePtr stroke) {
        if (stroke->group != m_place.group) {
            auto member = std::make_shared<Stroke>(*stroke);
            member->group = m_place.group;
            stroke = std::move(member);
        }
        painting->strokes.insert(std::as_const(painting->strokes).begin() + std::ptrdiff_t(index++), std::move(stroke));
    };
    putIn(m_document.draft());
    for (const StrokePtr &stroke : m_document.draftCompany())
        putIn(stroke);
    return painting;
}

} // namespace suffuse

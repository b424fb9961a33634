#include "model/painting/editable.h"
#include "model/painting/influence.h"
#include "undo/edits.h"
#include "undo/history/order_tree.h"

namespace suffuse {

namespace {

/// Computes how far the visible strokes of each sibling reach.
void fillInfluence(std::vector<Sibling> &siblings, const std::unordered_map<StrokeId, Rect> &influences)
{
    for (Sibling &s : siblings) {
        fillInfluence(s.members, influences);
        if (const auto it = influences.find(s.stroke); it != influences.end())
            s.influence = it->second;
        for (const Sibling &m : s.members)
            s.influence = s.influence.united(m.influence);
    }
}

/// Raises each selected sibling, the topmost first, above the next one whose influence it meets, unless that one is
/// selected, too.
void raise(std::vector<Sibling> &siblings)
{
    for (std::size_t i = siblings.size(); i-- > 0;) {
        if (!siblings[i].selected)
            continue;
        for (std::size_t j = i + 1; j < siblings.size(); ++j) {
            if (!siblings[j].influence.intersects(siblings[i].influence))
                continue;
            if (!siblings[j].selected)
                std::rotate(siblings.begin() + std::ptrdiff_t(i), siblings.begin() + std::ptrdiff_t(i) + 1,
                            siblings.begin() + std::ptrdiff_t(j) + 1);
            break;
        }
    }
}

void arrange(std::vector<Sibling> &siblings, Arrange how)
{
    const auto isSelected = [](const Sibling &s) { return s.selected; };
    switch (how) {
    case Arrange::Raise:
        raise(siblings);
        break;
    case Arrange::Lower:
        std::reverse(siblings.begin(), siblings.end());
        raise(siblings);
        std::reverse(siblings.begin(), siblings.end());
        break;
    case Arrange::Top:
        std::stable_partition(siblings.begin(), siblings.end(), std::not_fn(isSelected));
        break;
    case Arrange::Bottom:
        std::stable_partition(siblings.begin(), siblings.end(), isSelected);
        break;
    }
    for (Sibling &s : siblings)
        if (s.group != 0 && !s.selected)
            arrange(s.members, how);
}

bool isOrderOf(const std::vector<StrokeId> &order, const Painting &painting)
{
    return std::equal(order.begin(), order.end(), painting.strokes.begin(), painting.strokes.end(),
                      [](StrokeId id, const StrokePtr &s) { return s->id == id; });
}

/// The groups in no other group all of whose members are moved.
std::set<GroupId> wholeGroups(const Painting &painting, const std::set<StrokeId> &moved)
{
    std::set<GroupId> whole, broken;
    for (const StrokePtr &s : painting.strokes)
        if (s->group != 0)
            (moved.contains(s->id) ? whole : broken).insert(outermostGroup(painting, s->group));
    for (GroupId id : broken)
        whole.erase(id);
    return whole;
}

} // namespace

Edit arrangeSelection(const Document &document, Arrange how)
{
    Edit edit;
    if (document.selection().strokes.empty())
        return edit;
    const Painting &painting = *document.painting();
    std::vector<Sibling> tree = orderTree(painting, document.selection().strokes);
    std::unordered_map<StrokeId, Rect> influences;
    const Microseconds end = painting.end();
    const Visibility isVisible(painting.groups);
    for (const StrokePtr &s : painting.strokes)
        if (isVisible(*s))
            influences.emplace(s->id, influenceOf(*s, end));
    fillInfluence(tree, influences);
    arrange(tree, how);
    std::vector<StrokeId> order = orderOf(tree);
    if (!isOrderOf(order, *document.painting()))
        edit.order = std::move(order);
    return edit;
}

Edit reorder(const Document &document, const std::set<StrokeId> &strokes, StrokeId before)
{
    const Painting &painting = *document.painting();
    std::set<StrokeId> moved;
    const Locks isLocked(painting.groups);
    for (const StrokePtr &s : painting.strokes)
        if (strokes.contains(s->id) && !isLocked(*s))
            moved.insert(s->id);
    auto place = painting.strokes.end();
    GroupId group = 0;
    if (before != 0) {
        place = std::find_if(painting.strokes.begin(), painting.strokes.end(),
                             [before](const StrokePtr &s) { return s->id == before; });
        if (place == painting.strokes.end())
            return {};
        group = (*place)->group;
        // What is dropped on one of the moved strokes goes below the next one that stays.
        while (place != painting.strokes.end() && moved.contains((*place)->id))
            ++place;
    }
    if (moved.empty())
        return {};
    const std::set<GroupId> whole = group == 0 ? wholeGroups(painting, moved) : std::set<GroupId>();

    Edit edit;
    std::vector<StrokeId> below, among, above;
    for (auto it = painting.strokes.begin(); it != painting.strokes.end(); ++it) {
        const Stroke &s = **it;
        if (!moved.contains(s.id)) {
            (it < place ? below : above).push_back(s.id);
            continue;
        }
        among.push_back(s.id);
        if (s.group == group || whole.contains(outermostGroup(painting, s.group)))
            continue;
        auto regrouped = std::make_shared<Stroke>(s);
        regrouped->group = group;
        edit.strokes.emplace(s.id, std::move(regrouped));
    }
    below.insert(below.end(), among.begin(), among.end());
    below.insert(below.end(), above.begin(), above.end());
    if (!isOrderOf(below, painting))
        edit.order = std::move(below);
    return edit;
}

} // namespace suffuse

#include "model/influence.h"
#include "undo/edits.h"

#include <unordered_map>

namespace suffuse {

namespace {

/// The order as a tree: a group with its members, or one stroke. Siblings stand from bottom to top.
struct Sibling {
    GroupId group = 0; ///< 0: a stroke
    StrokeId stroke = 0;
    std::vector<Sibling> members;
    bool selected = false; ///< the stroke, or all members
    Rect influence;        ///< of what is visible
};

class Tree {
public:
    Tree(const Painting &painting, const std::set<StrokeId> &selected)
    {
        for (const Group &g : painting.groups)
            m_parents.emplace(g.id, g.parent);
        const Microseconds end = painting.end();
        for (const StrokePtr &s : painting.strokes) {
            Sibling leaf;
            leaf.stroke = s->id;
            leaf.selected = selected.contains(s->id) && !painting.isLocked(*s);
            if (painting.isVisible(*s))
                leaf.influence = influenceOf(*s, end);
            siblingsOf(s->group).push_back(std::move(leaf));
        }
        summarise(m_roots);
    }

    std::vector<Sibling> &roots() { return m_roots; }

    static void appendOrder(const std::vector<Sibling> &siblings, std::vector<StrokeId> &order)
    {
        for (const Sibling &s : siblings) {
            if (s.group == 0)
                order.push_back(s.stroke);
            appendOrder(s.members, order);
        }
    }

private:
    /// The members of a group that is on top of its siblings, which it is made if it is not there yet.
    std::vector<Sibling> &siblingsOf(GroupId id)
    {
        if (id == 0 || !m_parents.contains(id))
            return m_roots;
        std::vector<Sibling> &around = siblingsOf(m_parents[id]);
        if (around.empty() || around.back().group != id) {
            around.emplace_back();
            around.back().group = id;
        }
        return around.back().members;
    }

    static void summarise(std::vector<Sibling> &siblings)
    {
        for (Sibling &s : siblings) {
            if (s.group == 0)
                continue;
            summarise(s.members);
            s.selected = std::all_of(s.members.begin(), s.members.end(), [](const Sibling &m) { return m.selected; });
            for (const Sibling &m : s.members)
                s.influence = s.influence.united(m.influence);
        }
    }

    std::unordered_map<GroupId, GroupId> m_parents;
    std::vector<Sibling> m_roots;
};

/// Each selected sibling, the topmost first, goes above the next one whose influence it meets, unless that is selected.
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

/// The group that holds this one and lies in no other.
GroupId rootOf(const Painting &painting, GroupId id)
{
    for (std::size_t steps = 0; steps < painting.groups.size(); ++steps) {
        const auto it =
            std::find_if(painting.groups.begin(), painting.groups.end(), [id](const Group &g) { return g.id == id; });
        if (it == painting.groups.end() || it->parent == 0)
            return id;
        id = it->parent;
    }
    return id;
}

/// Root groups of which every member is among the moved.
std::set<GroupId> wholeGroups(const Painting &painting, const std::set<StrokeId> &moved)
{
    std::set<GroupId> whole, broken;
    for (const StrokePtr &s : painting.strokes)
        if (s->group != 0)
            (moved.contains(s->id) ? whole : broken).insert(rootOf(painting, s->group));
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
    Tree tree(*document.painting(), document.selection().strokes);
    arrange(tree.roots(), how);
    std::vector<StrokeId> order;
    order.reserve(document.painting()->strokes.size());
    Tree::appendOrder(tree.roots(), order);
    if (!isOrderOf(order, *document.painting()))
        edit.order = std::move(order);
    return edit;
}

Edit reorder(const Document &document, const std::set<StrokeId> &strokes, StrokeId before)
{
    const Painting &painting = *document.painting();
    std::set<StrokeId> moved;
    for (const StrokePtr &s : painting.strokes)
        if (strokes.contains(s->id) && !painting.isLocked(*s))
            moved.insert(s->id);
    auto place = painting.strokes.end();
    GroupId group = 0;
    if (before != 0) {
        place = std::find_if(painting.strokes.begin(), painting.strokes.end(),
                             [before](const StrokePtr &s) { return s->id == before; });
        if (place == painting.strokes.end())
            return {};
        group = (*place)->group;
        // Dropped on one of themselves: below the next that stays.
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
        if (s.group == group || whole.contains(rootOf(painting, s.group)))
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

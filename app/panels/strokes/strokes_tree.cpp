#include "app/panels/strokes/strokes_tree.h"

#include <algorithm>
#include <unordered_set>

namespace suffuse {

namespace {

/// Whether two lists of groups make trees of the same shape. Switches and names may differ.
bool sameTree(const std::vector<Group> &a, const std::vector<Group> &b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Group &x, const Group &y) { return x.id == y.id && x.parent == y.parent; });
}

/// Those of the named strokes that are in the painting.
std::unordered_map<StrokeId, StrokePtr> changedStrokes(const Painting &painting, const std::set<StrokeId> &ids)
{
    std::unordered_map<StrokeId, StrokePtr> changed;
    if (!ids.empty())
        for (const StrokePtr &stroke : painting.strokes)
            if (ids.contains(stroke->id))
                changed.emplace(stroke->id, stroke);
    return changed;
}

} // namespace

StrokesTree::Layout StrokesTree::layoutOf(const Painting &painting)
{
    std::unordered_map<GroupId, GroupId> parentOf;
    for (const Group &group : painting.groups)
        parentOf.emplace(group.id, group.parent);
    Layout layout;
    std::unordered_set<GroupId> placed;
    // A group stands where its topmost member stands.
    const auto place = [&](GroupId group) {
        while (group && parentOf.contains(group) && placed.insert(group).second) {
            layout[parentOf[group]].push_back({0, group});
            group = parentOf[group];
        }
    };
    for (auto it = painting.strokes.rbegin(); it != painting.strokes.rend(); ++it) {
        const GroupId group = parentOf.contains((*it)->group) ? (*it)->group : 0;
        place(group);
        layout[group].push_back({(*it)->id, 0});
    }
    for (const Group &group : painting.groups)
        place(group.id);
    return layout;
}

void StrokesTree::renumber(Node &node)
{
    for (std::size_t i = 0; i < node.children.size(); ++i)
        node.children[i]->row = int(i);
}

void StrokesTree::buildBelow(Node &node, const Layout &layout)
{
    const auto it = layout.find(node.group);
    if (it == layout.end())
        return;
    for (const Entry &entry : it->second) {
        auto child = std::make_unique<Node>();
        child->stroke = entry.stroke;
        child->group = entry.group;
        child->parent = &node;
        child->row = int(node.children.size());
        if (entry.stroke) {
            m_nodes[entry.stroke] = child.get();
            child->segments = int(m_values.at(entry.stroke)->segments.size());
        } else {
            buildBelow(*child, layout);
        }
        node.children.push_back(std::move(child));
    }
}

void StrokesTree::build(const PaintingPtr &painting)
{
    m_painting = painting;
    m_groups = painting->groups;
    m_values.clear();
    m_values.reserve(painting->strokes.size());
    for (const StrokePtr &stroke : painting->strokes)
        m_values.emplace(stroke->id, stroke);
    m_nodes.clear();
    m_nodes.reserve(m_values.size());
    m_root = std::make_unique<Node>();
    buildBelow(*m_root, layoutOf(*painting));
}

const StrokesTree::Node *StrokesTree::nodeOf(StrokeId id) const
{
    const auto it = m_nodes.find(id);
    return it == m_nodes.end() ? nullptr : it->second;
}

StrokePtr StrokesTree::strokeOf(StrokeId id) const
{
    const auto it = m_values.find(id);
    return it == m_values.end() ? nullptr : it->second;
}

const Group *StrokesTree::groupOf(GroupId id) const
{
    const auto it = std::find_if(m_groups.begin(), m_groups.end(), [id](const Group &g) { return g.id == id; });
    return it == m_groups.end() ? nullptr : &*it;
}

bool StrokesTree::isWithin(GroupId group, const std::set<GroupId> &groups) const
{
    for (const Group *at = groupOf(group); at; at = groupOf(at->parent))
        if (groups.contains(at->id))
            return true;
    return false;
}

std::set<StrokeId> StrokesTree::strokesBelow(const Node &node)
{
    std::set<StrokeId> result;
    std::vector<const Node *> open{&node};
    while (!open.empty()) {
        const Node *next = open.back();
        open.pop_back();
        if (next->stroke)
            result.insert(next->stroke);
        for (const auto &child : next->children)
            open.push_back(child.get());
    }
    return result;
}

StrokeId StrokesTree::lowestStrokeOf(const Node &node)
{
    if (node.stroke)
        return node.stroke;
    for (auto it = node.children.rbegin(); it != node.children.rend(); ++it)
        if (const StrokeId id = lowestStrokeOf(**it))
            return id;
    return 0;
}

std::optional<StrokesTree::Changed> StrokesTree::follow(const PaintingPtr &painting, const Change &change,
                                                        Listener &listener)
{
    if (!sameTree(painting->groups, m_groups))
        return {};
    const std::set<StrokeId> ids(change.strokes.begin(), change.strokes.end());
    const Values changed = changedStrokes(*painting, ids);
    const bool regrouped = std::any_of(changed.begin(), changed.end(), [&](const auto &entry) {
        const auto before = m_values.find(entry.first);
        return before != m_values.end() && entry.second->group != before->second->group;
    });
    if (regrouped)
        return {};
    for (const auto &[id, stroke] : changed)
        // Only what is new is taken; rows that stay show their old values until their changes are announced.
        m_values.emplace(id, stroke);
    if (change.order)
        followOrder(*painting, listener);
    m_painting = painting;
    for (const auto &[id, stroke] : changed)
        if (const auto it = m_nodes.find(id); it != m_nodes.end())
            followSegments(*it->second, *stroke, listener);
    Changed result = takeValues(ids, changed);
    result.groups = m_groups != painting->groups;
    result.switches |= change.order;
    m_groups = painting->groups;
    return result;
}

StrokesTree::Changed StrokesTree::takeValues(const std::set<StrokeId> &ids, const Values &changed)
{
    Changed result;
    for (const StrokeId id : ids) {
        const auto now = changed.find(id);
        if (now == changed.end()) {
            m_values.erase(id);
            continue;
        }
        StrokePtr &value = m_values[id];
        if (const auto it = m_nodes.find(id); it != m_nodes.end()) {
            result.strokes.push_back(it->second);
            if (value->segments != now->second->segments)
                result.withSegments.push_back(it->second);
            result.switches |= value->visible != now->second->visible || value->locked != now->second->locked;
        }
        value = now->second;
    }
    return result;
}

void StrokesTree::followSegments(Node &node, const Stroke &stroke, Listener &listener)
{
    const int wanted = int(stroke.segments.size());
    if (wanted > node.segments) {
        listener.rowsCome(node, node.segments, wanted - 1);
        node.segments = wanted;
        listener.rowsCame();
    } else if (wanted < node.segments) {
        listener.rowsGo(node, wanted, node.segments - 1);
        node.segments = wanted;
        listener.rowsWent();
    }
}

void StrokesTree::followOrder(const Painting &painting, Listener &listener)
{
    const Layout layout = layoutOf(painting);
    std::vector<Node *> open{m_root.get()};
    while (!open.empty()) {
        Node *node = open.back();
        open.pop_back();
        const auto it = layout.find(node->group);
        const Entries wanted = it == layout.end() ? Entries() : it->second;
        removeMissing(*node, wanted, listener);
        insertNew(*node, wanted, listener);
        sortLike(*node, wanted, listener);
        for (const auto &child : node->children)
            if (child->group)
                open.push_back(child.get());
    }
}

void StrokesTree::removeMissing(Node &node, const Entries &wanted, Listener &listener)
{
    std::unordered_set<StrokeId> stay;
    for (const Entry &entry : wanted)
        stay.insert(entry.stroke);
    const auto gone = [&](int row) {
        const Node &child = *node.children[std::size_t(row)];
        return child.stroke && !stay.contains(child.stroke);
    };
    for (int last = int(node.children.size()) - 1; last >= 0; --last) {
        if (!gone(last))
            continue;
        int first = last;
        while (first > 0 && gone(first - 1))
            --first;
        listener.rowsGo(node, first, last);
        for (int row = first; row <= last; ++row)
            m_nodes.erase(node.children[std::size_t(row)]->stroke);
        node.children.erase(node.children.begin() + first, node.children.begin() + last + 1);
        renumber(node);
        listener.rowsWent();
        last = first;
    }
}

void StrokesTree::insertNew(Node &node, const Entries &wanted, Listener &listener)
{
    const auto isNew = [&](const Entry &entry) { return entry.stroke && !m_nodes.contains(entry.stroke); };
    // A new row goes behind the one that it follows in the new order. Sorting moves what is left.
    int at = 0;
    for (std::size_t i = 0; i < wanted.size();) {
        if (!isNew(wanted[i])) {
            const Entry &entry = wanted[i++];
            const auto it = entry.stroke ? m_nodes.find(entry.stroke) : m_nodes.end();
            at = it != m_nodes.end() ? it->second->row + 1 : std::min(at + 1, int(node.children.size()));
            continue;
        }
        std::size_t end = i;
        while (end < wanted.size() && isNew(wanted[end]))
            ++end;
        listener.rowsCome(node, at, at + int(end - i) - 1);
        std::vector<std::unique_ptr<Node>> added;
        for (; i < end; ++i) {
            auto child = std::make_unique<Node>();
            child->stroke = wanted[i].stroke;
            child->parent = &node;
            child->segments = int(m_values.at(child->stroke)->segments.size());
            m_nodes[child->stroke] = child.get();
            added.push_back(std::move(child));
        }
        node.children.insert(node.children.begin() + at, std::make_move_iterator(added.begin()),
                             std::make_move_iterator(added.end()));
        renumber(node);
        listener.rowsCame();
        at += int(added.size());
    }
}

void StrokesTree::sortLike(Node &node, const Entries &wanted, Listener &listener)
{
    const bool matches =
        std::equal(wanted.begin(), wanted.end(), node.children.begin(), node.children.end(),
                   [](const Entry &e, const auto &c) { return e.stroke == c->stroke && e.group == c->group; });
    if (matches)
        return;
    std::unordered_map<StrokeId, int> strokeRows;
    std::unordered_map<GroupId, int> groupRows;
    for (std::size_t i = 0; i < wanted.size(); ++i)
        (wanted[i].stroke ? strokeRows[wanted[i].stroke] : groupRows[wanted[i].group]) = int(i);
    const auto rowOf = [&](const Node &n) { return n.stroke ? strokeRows[n.stroke] : groupRows[n.group]; };

    listener.rowsMove(node);
    std::sort(node.children.begin(), node.children.end(),
              [&](const auto &a, const auto &b) { return rowOf(*a) < rowOf(*b); });
    renumber(node);
    listener.rowsMoved(node);
}

} // namespace suffuse

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

bool isCalledLike(const Group &a, const Group &b)
{
    return a.name == b.name && a.text == b.text;
}

template <typename Map>
auto *foundIn(const Map &map, typename Map::key_type key)
{
    const auto it = map.find(key);
    return it == map.end() ? nullptr : it->second;
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
            layout[parentOf[group]].push_back({nullptr, group});
            group = parentOf[group];
        }
    };
    Entries *run = nullptr; // Most often neighbours are of one group, which is looked up once.
    GroupId last = 0;
    for (auto it = painting.strokes.rbegin(); it != painting.strokes.rend(); ++it) {
        if (const GroupId own = (*it)->group; !run || own != last) {
            last = own;
            const GroupId group = parentOf.contains(own) ? own : 0;
            place(group);
            run = &layout[group];
        }
        run->push_back({&*it, 0});
    }
    for (const Group &group : painting.groups)
        place(group.id);
    return layout;
}

void StrokesTree::renumber(Node &node, std::size_t from)
{
    for (std::size_t i = from; i < node.children.size(); ++i)
        node.children[i]->row = int(i);
}

bool StrokesTree::matches(const Node &node, const Entries &wanted)
{
    return std::equal(wanted.begin(), wanted.end(), node.children.begin(), node.children.end(),
                      [](const Entry &entry, const auto &child) { return entry.is(*child); });
}

void StrokesTree::takeGroups(const Painting &painting)
{
    m_groups = painting.groups;
    m_places.clear();
    for (std::size_t i = 0; i < m_groups.size(); ++i)
        m_places.emplace(m_groups[i].id, i);
}

std::unique_ptr<StrokesTree::Node> StrokesTree::made(const Entry &entry, Node &parent, const Layout &layout)
{
    auto node = std::make_unique<Node>();
    node->parent = &parent;
    node->group = entry.group;
    if (entry.stroke) {
        node->value = *entry.stroke;
        node->stroke = node->value->id;
        node->segments = int(node->value->segments.size());
        m_nodes[node->stroke] = node.get();
    } else {
        m_groupNodes[node->group] = node.get();
        buildBelow(*node, layout);
    }
    return node;
}

void StrokesTree::buildBelow(Node &node, const Layout &layout)
{
    const auto it = layout.find(node.group);
    if (it == layout.end())
        return;
    node.children.reserve(it->second.size());
    for (const Entry &entry : it->second)
        node.children.push_back(made(entry, node, layout));
    renumber(node, 0);
}

void StrokesTree::forget(const Node &node)
{
    if (node.stroke)
        m_nodes.erase(node.stroke);
    else
        m_groupNodes.erase(node.group);
    for (const auto &child : node.children)
        forget(*child);
}

void StrokesTree::build(const PaintingPtr &painting)
{
    m_painting = painting;
    takeGroups(*painting);
    m_nodes.clear();
    m_nodes.reserve(painting->strokes.size());
    m_groupNodes.clear();
    m_root = std::make_unique<Node>();
    buildBelow(*m_root, layoutOf(*painting));
}

const StrokesTree::Node *StrokesTree::nodeOf(StrokeId id) const
{
    return foundIn(m_nodes, id);
}

const StrokesTree::Node *StrokesTree::nodeOfGroup(GroupId id) const
{
    return foundIn(m_groupNodes, id);
}

const StrokesTree::Node *StrokesTree::nodeOf(const Entry &entry) const
{
    return entry.stroke ? nodeOf((*entry.stroke)->id) : nodeOfGroup(entry.group);
}

StrokePtr StrokesTree::strokeOf(StrokeId id) const
{
    const Node *node = nodeOf(id);
    return node ? node->value : nullptr;
}

const Group *StrokesTree::groupOf(GroupId id) const
{
    const auto it = m_places.find(id);
    return it == m_places.end() ? nullptr : &m_groups[it->second];
}

bool StrokesTree::isWithin(GroupId group, const std::set<GroupId> &groups) const
{
    for (const Group *at = groups.empty() ? nullptr : groupOf(group); at; at = groupOf(at->parent))
        if (groups.contains(at->id))
            return true;
    return false;
}

std::set<StrokeId> StrokesTree::strokesBelow(const Node &node)
{
    std::vector<StrokeId> found;
    std::vector<const Node *> open{&node};
    while (!open.empty()) {
        const Node *next = open.back();
        open.pop_back();
        if (next->stroke)
            found.push_back(next->stroke);
        for (const auto &child : next->children)
            open.push_back(child.get());
    }
    std::ranges::sort(found); // A set is made of sorted numbers in a pass.
    return {found.begin(), found.end()};
}

StrokesTree::Changed StrokesTree::follow(const PaintingPtr &painting, const Change &change, Listener &listener)
{
    const std::unordered_set<StrokeId> ids(change.strokes.begin(), change.strokes.end());
    const bool groupsChanged = m_groups != painting->groups;
    const bool groupsRenamed = groupsChanged && !std::ranges::equal(m_groups, painting->groups, isCalledLike);
    bool ordered = change.order || (groupsChanged && !sameTree(painting->groups, m_groups));
    if (!ids.empty() && !ordered)
        ordered = std::ranges::any_of(painting->strokes, [&](const StrokePtr &stroke) {
            const Node *node = ids.contains(stroke->id) ? nodeOf(stroke->id) : nullptr;
            return node && node->value->group != stroke->group;
        });
    if (groupsChanged)
        takeGroups(*painting);
    const bool cameOrWent = ordered && followOrder(*painting, listener);
    m_painting = painting;
    Changed result = followValues(*painting, change.strokes, listener);
    result.groups = groupsChanged;
    result.names |= groupsRenamed;
    result.switches |= cameOrWent;
    return result;
}

/// Rows that stay show their old values until their changes are announced.
StrokesTree::Changed StrokesTree::followValues(const Painting &painting, const std::vector<StrokeId> &ids,
                                               Listener &listener)
{
    Changed result;
    std::unordered_set<StrokeId> left(ids.begin(), ids.end());
    for (auto it = painting.strokes.begin(); it != painting.strokes.end() && !left.empty(); ++it) {
        const StrokePtr &now = *it;
        const auto node = left.erase(now->id) > 0 ? m_nodes.find(now->id) : m_nodes.end();
        if (node == m_nodes.end() || node->second->value == now)
            continue;
        StrokePtr &value = node->second->value;
        followSegments(*node->second, *now, listener);
        result.strokes.push_back(node->second);
        if (value->segments != now->segments)
            result.withSegments.push_back(node->second);
        result.names |= value->name != now->name;
        result.switches |= value->visible != now->visible || value->locked != now->locked;
        value = now;
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

bool StrokesTree::followOrder(const Painting &painting, Listener &listener)
{
    const Layout layout = layoutOf(painting);
    const Entries none;
    const auto wantedBelow = [&](const Node &node) -> const Entries & {
        const auto it = layout.find(node.group);
        return it == layout.end() ? none : it->second;
    };
    // What comes into another group has gone everywhere before it comes.
    std::vector<Node *> open{m_root.get()}, differing;
    bool any = false;
    while (!open.empty()) {
        Node *node = open.back();
        open.pop_back();
        if (const Entries &wanted = wantedBelow(*node); !matches(*node, wanted)) {
            differing.push_back(node);
            any |= removeMissing(*node, wanted, listener);
        }
        for (const auto &child : node->children)
            if (child->group)
                open.push_back(child.get());
    }
    for (Node *node : differing) {
        const Entries &wanted = wantedBelow(*node);
        any |= insertNew(*node, wanted, layout, listener);
        sortLike(*node, wanted, listener);
    }
    return any;
}

bool StrokesTree::removeMissing(Node &node, const Entries &wanted, Listener &listener)
{
    std::unordered_set<const Node *> stay;
    stay.reserve(wanted.size());
    for (const Entry &entry : wanted)
        if (const Node *there = nodeOf(entry); there && there->parent == &node)
            stay.insert(there);
    if (stay.size() == node.children.size())
        return false;
    const auto gone = [&](int row) { return !stay.contains(node.children[std::size_t(row)].get()); };
    for (int last = int(node.children.size()) - 1; last >= 0; --last) {
        if (!gone(last))
            continue;
        int first = last;
        while (first > 0 && gone(first - 1))
            --first;
        listener.rowsGo(node, first, last);
        for (int row = first; row <= last; ++row)
            forget(*node.children[std::size_t(row)]);
        node.children.erase(node.children.begin() + first, node.children.begin() + last + 1);
        renumber(node, std::size_t(first));
        listener.rowsWent();
        last = first;
    }
    return true;
}

bool StrokesTree::insertNew(Node &node, const Entries &wanted, const Layout &layout, Listener &listener)
{
    if (wanted.size() == node.children.size())
        return false; // What has gone has gone by now, so none is new.
    // A new row goes behind the one that it follows in the new order. Sorting moves what is left.
    int at = 0;
    for (std::size_t i = 0; i < wanted.size();) {
        if (const Node *there = nodeOf(wanted[i])) {
            at = there->row + 1;
            ++i;
            continue;
        }
        std::size_t end = i;
        while (end < wanted.size() && !nodeOf(wanted[end]))
            ++end;
        listener.rowsCome(node, at, at + int(end - i) - 1);
        std::vector<std::unique_ptr<Node>> added;
        for (; i < end; ++i)
            added.push_back(made(wanted[i], node, layout));
        node.children.insert(node.children.begin() + at, std::make_move_iterator(added.begin()),
                             std::make_move_iterator(added.end()));
        renumber(node, std::size_t(at));
        listener.rowsCame();
        at += int(added.size());
    }
    return true;
}

void StrokesTree::sortLike(Node &node, const Entries &wanted, Listener &listener)
{
    auto &children = node.children;
    const auto is = [](const Entry &entry, const auto &child) { return entry.is(*child); };
    const auto first = std::mismatch(wanted.begin(), wanted.end(), children.begin(), is);
    if (first.first == wanted.end())
        return;
    const auto last = std::mismatch(wanted.rbegin(), wanted.rend(), children.rbegin(), is);
    // The rows between the first and the last that differ; most often some of them together go past the others.
    const auto begin = first.second, end = last.second.base();
    const auto middle = std::find_if(begin, end, [&](const auto &child) { return first.first->is(*child); });
    const bool isMove =
        std::equal(middle, end, first.first, [&](const auto &child, const Entry &e) { return e.is(*child); }) &&
        std::equal(begin, middle, first.first + (end - middle),
                   [&](const auto &child, const Entry &e) { return e.is(*child); });
    const auto rowOf = [&](const auto &it) { return int(it - children.begin()); };
    if (isMove) {
        const bool isUp = end - middle <= middle - begin; // The fewer rows are those that move.
        listener.rowsMove(node, isUp ? rowOf(middle) : rowOf(begin), (isUp ? rowOf(end) : rowOf(middle)) - 1,
                          isUp ? rowOf(begin) : rowOf(end));
        const std::size_t from = std::size_t(rowOf(begin));
        std::rotate(begin, middle, end);
        renumber(node, from);
        listener.rowsMoved();
        return;
    }
    std::unordered_map<StrokeId, std::size_t> strokes;
    std::unordered_map<GroupId, std::size_t> groups;
    for (std::size_t i = 0; i < wanted.size(); ++i)
        (wanted[i].stroke ? strokes[(*wanted[i].stroke)->id] : groups[wanted[i].group]) = i;
    std::vector<std::unique_ptr<Node>> sorted(children.size());
    listener.rowsSort(node);
    for (auto &child : children)
        sorted[child->stroke ? strokes.at(child->stroke) : groups.at(child->group)] = std::move(child);
    children = std::move(sorted);
    renumber(node, 0);
    listener.rowsSorted(node);
}

} // namespace suffuse

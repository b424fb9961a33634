#include "undo/layers/group_edits.h"

#include "model/painting/editable.h"
#include "model/painting/validate.h"
#include "undo/history/order_tree.h"

#include <algorithm>

namespace suffuse {

namespace {

bool holdsSelected(const Sibling &sibling)
{
    return sibling.selected || std::any_of(sibling.members.begin(), sibling.members.end(), holdsSelected);
}

/// Moves the selected siblings out of the tree, wherever they lie. Groups that have no members left are removed.
void takeSelected(std::vector<Sibling> &siblings, std::vector<Sibling> &taken)
{
    std::vector<Sibling> rest;
    for (Sibling &s : siblings) {
        if (s.selected) {
            taken.push_back(std::move(s));
            continue;
        }
        takeSelected(s.members, taken);
        rest.push_back(std::move(s));
    }
    siblings = std::move(rest);
}

/// Groups what is selected, in the innermost group that contains all of it. Returns the id of that group, which is 0 at
/// the top level.
GroupId groupWithin(std::vector<Sibling> &siblings, GroupId around, Sibling &made)
{
    const auto holding = std::count_if(siblings.begin(), siblings.end(), holdsSelected);
    const auto top = std::find_if(siblings.rbegin(), siblings.rend(), holdsSelected);
    if (holding == 1 && !top->selected)
        return groupWithin(top->members, top->group, made);
    std::vector<Sibling> result;
    const auto last = std::size_t(siblings.rend() - top) - 1;
    for (std::size_t i = 0; i < siblings.size(); ++i) {
        if (siblings[i].selected) {
            made.members.push_back(std::move(siblings[i]));
        } else {
            takeSelected(siblings[i].members, made.members);
            result.push_back(std::move(siblings[i]));
        }
        if (i == last)
            result.push_back(made);
    }
    siblings = std::move(result);
    return around;
}

/// Whether its numbers are in their domains.
bool isValid(const Group &group)
{
    const bool hasWash =
        !group.wash || (problemOf(group.wash->style).isEmpty() && problemOf(group.wash->mix).isEmpty());
    return group.opacity >= 0 && group.opacity <= 1 && hasWash;
}

StrokePtr inGroup(const Stroke &stroke, GroupId group)
{
    auto result = std::make_shared<Stroke>(stroke);
    result->group = group;
    return result;
}

Edit dissolve(const Painting &painting, const std::set<GroupId> &gone)
{
    Edit edit;
    if (gone.empty())
        return edit;
    const auto staying = [&](GroupId id) {
        while (gone.contains(id))
            id = painting.findGroup(id)->parent;
        return id;
    };
    edit.groups.emplace();
    for (Group g : painting.groups) {
        if (gone.contains(g.id))
            continue;
        g.parent = staying(g.parent);
        edit.groups->push_back(std::move(g));
    }
    for (const StrokePtr &s : painting.strokes)
        if (gone.contains(s->group))
            edit.strokes.emplace(s->id, inGroup(*s, staying(s->group)));
    return edit;
}

Edit changeGroups(const Painting &painting, const std::function<void(Group &)> &change)
{
    std::vector<Group> groups = painting.groups;
    for (Group &g : groups)
        change(g);
    Edit edit;
    if (groups != painting.groups)
        edit.groups = std::move(groups);
    return edit;
}

Edit changeGroup(const Document &document, GroupId group, const std::function<void(Group &)> &change)
{
    return changeGroups(*document.painting(), [&](Group &g) {
        if (g.id == group)
            change(g);
    });
}

/// Changes all strokes and groups that need it, selected or not.
template <typename Strokes, typename Groups>
Edit changeEverything(const Document &document, Strokes needsChange, const std::function<void(Stroke &)> &change,
                      Groups changeGroup)
{
    std::set<StrokeId> ids;
    for (const StrokePtr &s : document.painting()->strokes)
        if (needsChange(*s))
            ids.insert(s->id);
    Edit edit = changeStrokes(document, ids, change);
    edit.groups = changeGroups(*document.painting(), changeGroup).groups;
    return edit;
}

/// Changes the outermost groups that are selected as a whole, and the other selected strokes.
Edit closeSelection(const Document &document, Edit (*changeStrokes)(const Document &, const std::set<StrokeId> &, bool),
                    const std::function<void(Group &)> &change, bool value)
{
    std::set<StrokeId> strokes;
    std::set<GroupId> groups;
    // What is hidden or locked in a group already does not keep it from being selected as a whole.
    const Painting &painting = *document.painting();
    Painting open = painting;
    open.strokes.clear();
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (isEditable(*stroke))
            open.strokes.push_back(stroke);
    const std::vector<Sibling> tree = orderTree(open, document.selection().strokes);
    for (const Sibling *unit : selectedUnits(tree))
        if (unit->group != 0)
            groups.insert(unit->group);
        else
            strokes.insert(unit->stroke);
    Edit edit = changeStrokes(document, strokes, value);
    edit.groups = changeGroups(*document.painting(), [&](Group &g) {
                      if (groups.contains(g.id))
                          change(g);
                  }).groups;
    if (!edit.isEmpty())
        edit.selection = Selection();
    return edit;
}

/// Of what is painted: of a fill alone the outline has a colour that nobody sees, and what takes paint away has none.
std::array<double, 3> meanColour(const Stroke &stroke)
{
    std::array<double, 3> sum{};
    double count = 0;
    const auto add = [&](const Colour &colour) {
        sum[0] += colour.red;
        sum[1] += colour.yellow;
        sum[2] += colour.blue;
        ++count;
    };
    for (const Segment &s : stroke.segments)
        if (!s.takesPaint() && s.density > 0)
            add(s.colour);
    if (count == 0 && stroke.fill) {
        add(stroke.fill->colour);
        if (stroke.fill->gradient)
            add(stroke.fill->gradient->colour);
    }
    for (std::size_t k = 0; count == 0 && k < stroke.segments.size(); ++k)
        add(stroke.segments[k].colour);
    for (double &channel : sum)
        channel /= std::max(1.0, count);
    return sum;
}

bool isSame(const Stroke &a, const Stroke &b, Same what)
{
    switch (what) {
    case Same::Colour: {
        const auto x = meanColour(a), y = meanColour(b);
        return std::equal(x.begin(), x.end(), y.begin(),
                          [](double u, double v) { return std::abs(u - v) <= 1.0 / 128; });
    }
    case Same::Style:
        return a.style == b.style && a.mix == b.mix;
    case Same::Brush:
        return a.brush == b.brush;
    case Same::Name:
        return !a.name.isEmpty() && a.name == b.name;
    }
    return false;
}

} // namespace

Edit groupSelection(Document &document, const QString &name)
{
    const Painting &painting = *document.painting();
    std::vector<Sibling> tree = orderTree(painting, document.selection().strokes);
    if (!std::any_of(tree.begin(), tree.end(), holdsSelected))
        return {};
    Sibling made;
    made.group = document.takeGroupId();
    const GroupId id = made.group;
    const GroupId around = groupWithin(tree, 0, made);
    Edit edit;
    edit.groups = painting.groups;
    edit.groups->push_back({id, name, around, true, false});
    for (const Sibling &member : made.members) {
        if (member.group == 0)
            edit.strokes.emplace(member.stroke, inGroup(*painting.find(member.stroke), id));
        for (Group &g : *edit.groups)
            if (g.id == member.group)
                g.parent = id;
    }
    edit.order = orderOf(tree);
    return edit;
}

Edit ungroupSelection(const Document &document)
{
    const Painting &painting = *document.painting();
    const std::vector<Sibling> tree = orderTree(painting, document.selection().strokes);
    std::set<GroupId> gone;
    const Locks isLocked(painting.groups);
    for (const Sibling *unit : selectedUnits(tree)) {
        const GroupId group = unit->group != 0 ? unit->group : painting.find(unit->stroke)->group;
        if (group != 0 && !isLocked(group))
            gone.insert(group);
    }
    return dissolve(painting, gone);
}

bool canUngroup(const Document &document)
{
    const Painting &painting = *document.painting();
    const std::set<StrokeId> &selected = document.selection().strokes;
    const Locks isLocked(painting.groups);
    return !selected.empty() && std::ranges::any_of(painting.strokes, [&](const StrokePtr &s) {
        return s->group != 0 && selected.contains(s->id) && !isLocked(*s);
    });
}

GroupId selectedGroup(const Document &document)
{
    const std::vector<GroupId> groups = selectedGroups(document);
    return groups.size() == 1 ? groups.front() : 0;
}

std::vector<GroupId> selectedGroups(const Document &document)
{
    const Selection &selection = document.selection();
    if (!selection.segments.empty() || selection.strokes.empty() || document.painting()->groups.empty())
        return {};
    const std::vector<Sibling> tree = orderTree(*document.painting(), selection.strokes);
    std::vector<GroupId> groups;
    for (const Sibling *unit : selectedUnits(tree)) {
        if (unit->group == 0)
            return {};
        groups.push_back(unit->group);
    }
    return groups;
}

Edit ungroup(const Document &document, GroupId group)
{
    const Painting &painting = *document.painting();
    if (!painting.findGroup(group) || Locks(painting.groups)(group))
        return {};
    return dissolve(painting, {group});
}

Edit setLocked(const Document &document, const std::set<StrokeId> &strokes, bool locked)
{
    return changeStrokes(document, strokes, [locked](Stroke &s) { s.locked = locked; });
}

Edit setVisible(const Document &document, const std::set<StrokeId> &strokes, bool visible)
{
    return changeStrokes(document, strokes, [visible](Stroke &s) { s.visible = visible; });
}

Edit lockSelection(const Document &document)
{
    return closeSelection(
        document, setLocked, [](Group &g) { g.locked = true; }, true);
}

Edit hideSelection(const Document &document)
{
    return closeSelection(
        document, setVisible, [](Group &g) { g.visible = false; }, false);
}

Edit setGroupLocked(const Document &document, GroupId group, bool locked)
{
    return changeGroup(document, group, [locked](Group &g) { g.locked = locked; });
}

Edit setGroupVisible(const Document &document, GroupId group, bool visible)
{
    return changeGroup(document, group, [visible](Group &g) { g.visible = visible; });
}

Edit unlockAll(const Document &document)
{
    return changeEverything(
        document, [](const Stroke &s) { return s.locked; }, [](Stroke &s) { s.locked = false; },
        [](Group &g) { g.locked = false; });
}

Edit showAll(const Document &document)
{
    return changeEverything(
        document, [](const Stroke &s) { return !s.visible; }, [](Stroke &s) { s.visible = true; },
        [](Group &g) { g.visible = true, g.solo = false; });
}

Edit renameStroke(const Document &document, StrokeId stroke, const QString &name)
{
    return changeStrokes(document, {stroke}, [&name](Stroke &s) { s.name = name; });
}

Edit renameGroup(const Document &document, GroupId group, const QString &name)
{
    return changeGroup(document, group, [&name](Group &g) { g.name = name; });
}

Edit changeBlending(const Document &document, const Painting &before, const std::vector<GroupId> &groups,
                    const std::function<void(Group &now, const Group &then)> &change)
{
    const Painting &painting = *document.painting();
    const Locks isLocked(painting.groups);
    return changeGroups(painting, [&](Group &group) {
        if (std::ranges::find(groups, group.id) == groups.end() || isLocked(group.id))
            return;
        const Group *then = before.findGroup(group.id);
        Group changed = group;
        change(changed, then ? *then : group);
        if (isValid(changed))
            group = std::move(changed);
    });
}

Edit setGroupOpacity(const Document &document, const std::vector<GroupId> &groups, float opacity)
{
    return changeBlending(document, *document.painting(), groups,
                          [opacity](Group &now, const Group &) { now.opacity = opacity; });
}

Edit setGroupBlend(const Document &document, const std::vector<GroupId> &groups, BlendMode blend)
{
    return changeBlending(document, *document.painting(), groups,
                          [blend](Group &now, const Group &) { now.blend = blend; });
}

Edit setGroupIsolated(const Document &document, const std::vector<GroupId> &groups, bool isolated)
{
    return changeBlending(document, *document.painting(), groups,
                          [isolated](Group &now, const Group &) { now.isolated = isolated; });
}

Selection selectSame(const Document &document, Same what)
{
    const Painting &painting = *document.painting();
    Selection result;
    result.strokes = document.selection().strokes;
    std::vector<const Stroke *> examples;
    for (const StrokePtr &s : painting.strokes) {
        const auto isKnown = [&](const Stroke *e) { return isSame(*e, *s, what); };
        if (result.strokes.contains(s->id) && std::none_of(examples.begin(), examples.end(), isKnown))
            examples.push_back(s.get());
    }
    const Editable isEditable(painting.groups);
    for (const StrokePtr &s : painting.strokes)
        if (isEditable(*s) &&
            std::any_of(examples.begin(), examples.end(), [&](const Stroke *e) { return isSame(*e, *s, what); }))
            result.strokes.insert(s->id);
    return result;
}

} // namespace suffuse

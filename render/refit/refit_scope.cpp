#include "render/refit/refit_scope.h"

#include "model/paint/half_width.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::refit {

namespace {

constexpr double roomShare = 0.1; ///< of the greater side, around what is seen of the chosen strokes
constexpr double roomSpreads = 2; ///< or so many of the greatest spread

/// The groups around a stroke, from the innermost one outwards.
std::vector<const Group *> groupsAround(const Painting &painting, const Stroke &stroke)
{
    std::vector<const Group *> out;
    for (const Group *g = painting.findGroup(stroke.group); g; g = painting.findGroup(g->parent))
        out.push_back(g);
    return out;
}

/// The innermost isolated group around all of them; 0 if there is none.
GroupId scopeOf(const Painting &painting, const std::vector<StrokePtr> &strokes)
{
    for (const Group *group : groupsAround(painting, *strokes.front()))
        if (group->isIsolated() && std::all_of(strokes.begin(), strokes.end(), [&](const StrokePtr &stroke) {
                const std::vector<const Group *> around = groupsAround(painting, *stroke);
                return std::find(around.begin(), around.end(), group) != around.end();
            }))
            return group->id;
    return 0;
}

QString nameOf(const Group &group)
{
    return group.name.isEmpty() ? QString::number(group.id) : group.name;
}

} // namespace

Result<RefitScope> RefitScope::of(PaintingPtr painting, const std::unordered_set<StrokeId> &ids)
{
    RefitScope scope;
    scope.m_painting = std::move(painting);
    const Painting &all = *scope.m_painting;
    const Visibility isVisible(all.groups);
    std::vector<StrokePtr> taken;
    for (const StrokePtr &stroke : all.strokes)
        if (ids.contains(stroke->id) && isVisible(*stroke) && !all.isLocked(*stroke)) {
            taken.push_back(stroke);
            scope.m_taken.insert(stroke->id);
        }
    if (taken.empty())
        return Error{
            QCoreApplication::translate("refit", "none of the strokes is visible and unlocked; choose others")};
    scope.m_count = taken.size();
    scope.m_top = taken.back()->id;
    scope.m_group = scopeOf(all, taken);
    if (const QString problem = scope.findHome(); !problem.isEmpty())
        return Error{problem};
    bool begun = false;
    for (const StrokePtr &stroke : all.strokes) {
        const std::vector<const Group *> around = groupsAround(all, *stroke);
        const bool isWithin = scope.m_group == 0 || std::any_of(around.begin(), around.end(),
                                                                [&](const Group *g) { return g->id == scope.m_group; });
        if (!isWithin || !isVisible(*stroke))
            continue;
        begun = begun || scope.isTaken(stroke->id);
        if (stroke->id == scope.m_top)
            scope.m_highest = scope.m_strokes.size();
        Stroke copy = *stroke;
        copy.group = copy.group == scope.m_group ? 0 : copy.group;
        scope.m_strokes.push_back(copy.group == stroke->group ? stroke
                                                              : std::make_shared<const Stroke>(std::move(copy)));
    }
    for (std::size_t i = 0, found = 0; i < scope.m_highest; ++i) {
        found += scope.isTaken(scope.m_strokes[i]->id) ? 1 : 0;
        scope.m_between += found > 0 && !scope.isTaken(scope.m_strokes[i]->id) ? 1 : 0;
    }
    for (Group group : all.groups) {
        // What is hidden has been left out.
        group.visible = true, group.solo = false;
        group.parent = group.parent == scope.m_group ? 0 : group.parent;
        if (group.id != scope.m_group)
            scope.m_groups.push_back(std::move(group));
    }
    scope.measure();
    if (scope.m_area.isEmpty())
        return Error{
            QCoreApplication::translate("refit", "the strokes lie beside the sheet, where nothing is seen of them")};
    return scope;
}

/// Finds the group that new strokes come into. Returns what is in the way.
QString RefitScope::findHome()
{
    const Painting &all = *m_painting;
    std::vector<const Group *> parts; // that mix in their own way within the scope, and have chosen strokes
    for (const StrokePtr &stroke : all.strokes) {
        if (!isTaken(stroke->id))
            continue;
        for (const Group *group : groupsAround(all, *stroke)) {
            if (group->id == m_group)
                break;
            if ((group->isIsolated() || group->wash) && std::find(parts.begin(), parts.end(), group) == parts.end())
                parts.push_back(group);
        }
    }
    const Visibility isVisible(all.groups);
    for (const StrokePtr &stroke : all.strokes)
        for (const Group *group : groupsAround(all, *stroke))
            if (!isTaken(stroke->id) && isVisible(*stroke) &&
                std::find(parts.begin(), parts.end(), group) != parts.end())
                return QCoreApplication::translate("refit",
                                                   "the strokes of group “%1” mix in their own way; choose all "
                                                   "of them that are visible, or none of them")
                    .arg(nameOf(*group));
    const Group *scope = all.findGroup(m_group);
    if (scope && scope->wash)
        return QCoreApplication::translate("refit", "group “%1” is a wash, whose strokes are one; make it a group like "
                                                    "others first")
            .arg(nameOf(*scope));
    m_home = all.find(m_top)->group;
    for (const Group *group : groupsAround(all, *all.find(m_top))) {
        if (group->id == m_group)
            break;
        if (group->isIsolated() || group->wash)
            m_home = m_plain = group->id;
    }
    return {};
}

void RefitScope::measure()
{
    Rect seen;
    double greatest = 0;
    m_finest = std::numeric_limits<double>::infinity();
    m_firstBirth = std::numeric_limits<Microseconds>::max(), m_lastBirth = std::numeric_limits<Microseconds>::min();
    const auto takeBirth = [this](Microseconds born) {
        m_firstBirth = std::min(m_firstBirth, born), m_lastBirth = std::max(m_lastBirth, born);
    };
    const Microseconds end = m_painting->end();
    for (const StrokePtr &stroke : m_strokes) {
        if (!isTaken(stroke->id))
            continue;
        seen = seen.united(seenBox(*stroke));
        for (const Segment &segment : stroke->segments) {
            takeBirth(segment.born);
            if (const double spread = segment.spread(end); spread > 0 && segment.density > 0)
                m_finest = std::min(m_finest, spread), greatest = std::max(greatest, spread);
        }
        if (stroke->fill)
            takeBirth(stroke->fill->born), greatest = std::max(greatest, stroke->fill->spread(end));
    }
    if (!(m_finest < std::numeric_limits<double>::infinity()))
        m_finest = 0;
    const double room = std::max(roomShare * std::max(seen.width(), seen.height()), roomSpreads * greatest);
    const Rect sheet = m_painting->canvas.area();
    m_area = {std::max(seen.left - room, sheet.left), std::max(seen.top - room, sheet.top),
              std::min(seen.right + room, sheet.right), std::min(seen.bottom + room, sheet.bottom)};
    if (!(m_area.width() > 0) || !(m_area.height() > 0))
        m_area = {};
}

bool RefitScope::showsCoverage() const
{
    return m_group != 0 || m_painting->canvas.background.opacity < 1;
}

Colour RefitScope::sheet(bool onBlack) const
{
    const Colour &own = m_painting->canvas.background;
    const float opacity = m_group != 0 ? 0 : own.opacity, rest = onBlack ? 1 - opacity : 0; // White is 0, black 1.
    return {opacity * own.red + rest, opacity * own.yellow + rest, opacity * own.blue + rest, 1};
}

Painting RefitScope::part(Part part, const Colour &sheet) const
{
    Painting out;
    out.canvas = m_painting->canvas;
    out.canvas.background = sheet;
    out.groups = m_groups;
    for (std::size_t i = 0; i < m_strokes.size(); ++i) {
        const bool isAbove = i > m_highest, isChosen = isTaken(m_strokes[i]->id);
        if (part == Above ? isAbove : !isAbove && (part == Chosen || !isChosen))
            out.strokes.push_back(m_strokes[i]);
    }
    return out;
}

Painting RefitScope::with(const StrokeList &strokes) const
{
    Painting out = *m_painting;
    Microseconds last = 0;
    for (const StrokePtr &stroke : strokes)
        for (const Segment &segment : stroke->segments)
            last = std::max(last, segment.born);
    const double pace = last > 0 ? double(m_lastBirth - m_firstBirth) / double(last) : 0;
    out.strokes.clear();
    StrokeId id = m_painting->nextStrokeId();
    std::unordered_set<GroupId> left, lost; // that stay, and that had chosen strokes
    // The home stays, also where no stroke comes into it: whoever is shown alone must not show the others by going.
    for (const Group *g = m_painting->findGroup(m_home); g; g = m_painting->findGroup(g->parent))
        left.insert(g->id);
    const auto put = [&](StrokePtr stroke) {
        for (const Group *group : groupsAround(*m_painting, *stroke))
            left.insert(group->id);
        out.strokes.push_back(std::move(stroke));
    };
    std::unordered_set<GroupId> changed;
    for (const StrokePtr &stroke : m_painting->strokes) {
        if (!isTaken(stroke->id))
            put(stroke);
        else
            changed.insert(stroke->group);
        for (const Group *group :
             isTaken(stroke->id) ? groupsAround(*m_painting, *stroke) : std::vector<const Group *>())
            lost.insert(group->id);
        if (stroke->id != m_top)
            continue;
        for (const StrokePtr &added : strokes) {
            Stroke copy = *added;
            copy.id = id++;
            copy.group = m_home;
            for (Segment &segment : copy.segments)
                segment.born = m_firstBirth + Microseconds(std::llround(pace * double(segment.born)));
            put(std::make_shared<const Stroke>(std::move(copy)));
        }
    }
    changed.insert(m_home);
    std::erase_if(out.groups, [&](const Group &group) { return lost.contains(group.id) && !left.contains(group.id); });
    for (Group &group : out.groups)
        if (changed.contains(group.id))
            group.text = {}; // Its strokes are no letters any more.
    for (Group &group : out.groups)
        if (group.id == m_plain) {
            group.opacity = 1, group.blend = BlendMode::Normal, group.wash = {};
            group.isolated = group.clips = group.mask = false;
        }
    return out;
}

} // namespace suffuse::refit

// Which strokes are a text, and how it follows its letters, whatever has moved, turned or scaled them.
#include "undo/history/order_tree.h"
#include "undo/text_edits.h"

#include <unordered_map>

namespace suffuse {

namespace {

using Pairs = std::vector<std::pair<const Stroke *, const Stroke *>>;

bool hasSameShape(const Stroke &a, const Stroke &b)
{
    return std::ranges::equal(a.segments, b.segments,
                              [](const Segment &x, const Segment &y) { return x.bezier == y.bezier; });
}

/// How far all strokes have been moved, if nothing else was done with their outlines.
std::optional<Point> commonMove(const Pairs &pairs)
{
    const Point by = pairs.front().second->origin - pairs.front().first->origin;
    for (const auto &[then, now] : pairs) {
        const Point off = now->origin - then->origin - by;
        const double rounding = 1e-12 * (length(then->origin) + length(now->origin)) + 1e-9;
        if (length(off) > rounding || !hasSameShape(*then, *now))
            return {};
    }
    return by;
}

/// Fits a map to pairs of points, by least squares around their means.
class MapFit {
public:
    MapFit(Point from, Point to) : m_from(from), m_to(to) {}

    void add(Point from, Point to)
    {
        const Point p = from - m_from, q = to - m_to;
        ++m_count;
        m_p = m_p + p;
        m_q = m_q + q;
        m_xx += p.x * p.x, m_xy += p.x * p.y, m_yy += p.y * p.y;
        m_xu += p.x * q.x, m_yu += p.y * q.x, m_xv += p.x * q.y, m_yv += p.y * q.y;
    }
    std::optional<Affine> result() const
    {
        if (m_count < 3)
            return {};
        const double n = m_count;
        const double xx = m_xx - m_p.x * m_p.x / n, xy = m_xy - m_p.x * m_p.y / n, yy = m_yy - m_p.y * m_p.y / n;
        const double xu = m_xu - m_p.x * m_q.x / n, yu = m_yu - m_p.y * m_q.x / n;
        const double xv = m_xv - m_p.x * m_q.y / n, yv = m_yv - m_p.y * m_q.y / n;
        const double determinant = xx * yy - xy * xy;
        if (!(determinant > 1e-12 * xx * yy))
            return {};
        Affine map{(xu * yy - yu * xy) / determinant,
                   (yu * xx - xu * xy) / determinant,
                   (xv * yy - yv * xy) / determinant,
                   (yv * xx - xv * xy) / determinant,
                   {}};
        map.offset = m_to + (1 / n) * m_q - map.turned(m_from + (1 / n) * m_p);
        return map;
    }

private:
    Point m_from, m_to;
    double m_count = 0;
    Point m_p, m_q;
    double m_xx = 0, m_xy = 0, m_yy = 0, m_xu = 0, m_yu = 0, m_xv = 0, m_yv = 0;
};

/// The map that takes all strokes to where they are, if one does, within what float32 can tell.
std::optional<Affine> commonMap(const Pairs &pairs)
{
    if (const std::optional<Point> by = commonMove(pairs))
        return Affine::translation(*by);
    MapFit fit(pairs.front().first->origin, pairs.front().second->origin);
    const auto forEachPoint = [&pairs](const auto &visit) {
        for (const auto &[then, now] : pairs) {
            if (then->segments.size() != now->segments.size())
                return false;
            for (std::size_t k = 0; k < then->segments.size(); ++k)
                for (std::size_t i = 0; i < 4; ++i)
                    if (!visit(then->origin + then->segments[k].bezier[i], now->origin + now->segments[k].bezier[i]))
                        return false;
        }
        return true;
    };
    Rect reach;
    const bool fits = forEachPoint([&](Point from, Point to) {
        reach.include(to - pairs.front().second->origin);
        fit.add(from, to);
        return true;
    });
    std::optional<Affine> map = fits ? fit.result() : std::nullopt;
    if (!map)
        return {};
    const double most = 3e-6 * (std::hypot(reach.width(), reach.height()) + 1e-9);
    if (!forEachPoint([&](Point from, Point to) { return length((*map)(from)-to) <= most; }))
        return {};
    return map;
}

} // namespace

SharedText textOf(const Painting &painting, GroupId group)
{
    const Group *found = group ? painting.findGroup(group) : nullptr;
    return found ? found->text : SharedText();
}

bool isTextLocked(const Painting &painting, GroupId group)
{
    Stroke member;
    member.group = group;
    return painting.isLocked(member) || std::ranges::any_of(painting.strokes, [group](const StrokePtr &stroke) {
               return stroke->locked && stroke->group == group;
           });
}

GroupId textAround(const Painting &painting, const Stroke &stroke)
{
    for (const GroupId id : groupsAround(painting, stroke.group))
        if (textOf(painting, id))
            return id;
    return 0;
}

std::set<StrokeId> strokesWithin(const Painting &painting, GroupId group)
{
    std::set<StrokeId> ids;
    WithinGroup within(painting, group);
    for (const StrokePtr &stroke : painting.strokes)
        if (within(*stroke))
            ids.insert(ids.end(), stroke->id);
    return ids;
}

GroupId selectedText(const Document &document)
{
    const Painting &painting = *document.painting();
    const std::set<StrokeId> &selected = document.selection().strokes;
    if (selected.empty() || std::ranges::none_of(painting.groups, [](const Group &g) { return bool(g.text); }))
        return 0;
    GroupId text = 0;
    for (const StrokePtr &stroke : painting.strokes)
        if (selected.contains(stroke->id)) {
            const GroupId around = stroke->group ? textAround(painting, *stroke) : 0;
            if (around == 0 || (text != 0 && around != text))
                return 0;
            text = around;
        }
    return text;
}

std::map<GroupId, Text> wholeTexts(const Painting &painting, const std::function<bool(StrokeId)> &isAmong)
{
    std::map<GroupId, Text> texts;
    for (const Group &group : painting.groups)
        if (group.text)
            texts.emplace(group.id, *group.text);
    std::set<GroupId> seen;
    for (const StrokePtr &stroke : painting.strokes) {
        if (texts.empty() || stroke->group == 0)
            continue;
        const GroupId text = textAround(painting, *stroke);
        seen.insert(text);
        if (text != 0 && !isAmong(stroke->id))
            texts.erase(text);
    }
    std::erase_if(texts, [&seen](const auto &entry) { return !seen.contains(entry.first); });
    return texts;
}

std::optional<std::vector<Group>> withTextsMapped(const Painting &painting, const std::map<GroupId, Text> &before,
                                                  const Affine &map)
{
    if (before.empty())
        return {};
    std::vector<Group> groups = painting.groups;
    for (Group &group : groups)
        if (const auto at = before.find(group.id); at != before.end() && group.text) {
            Text text = *group.text;
            text.place = map * at->second.place;
            group.text = std::move(text);
        }
    return groups != painting.groups ? std::optional(std::move(groups)) : std::nullopt;
}

void followTexts(const Painting &before, Edit &edit)
{
    if (edit.strokes.empty() || edit.groups ||
        std::ranges::none_of(before.groups, [](const Group &g) { return bool(g.text); }))
        return;
    std::unordered_map<GroupId, Pairs> pairs;
    std::unordered_map<GroupId, bool> isWhole;
    for (const StrokePtr &stroke : before.strokes) {
        if (stroke->group == 0)
            continue;
        const auto [whole, isNew] = isWhole.try_emplace(stroke->group, true);
        if (!whole->second)
            continue;
        const auto changed = edit.strokes.find(stroke->id);
        if (changed == edit.strokes.end() || !changed->second)
            whole->second = false;
        else
            pairs[stroke->group].emplace_back(stroke.get(), changed->second.get());
    }
    for (std::size_t k = 0; k < before.groups.size(); ++k) {
        const Group &group = before.groups[k];
        const auto found = group.text ? pairs.find(group.id) : pairs.end();
        if (found == pairs.end() || !isWhole[group.id])
            continue;
        const std::optional<Affine> map = commonMap(found->second);
        if (!map || map->isIdentity())
            continue;
        if (!edit.groups)
            edit.groups = before.groups;
        Text text = *group.text;
        text.place = *map * text.place;
        (*edit.groups)[k].text = std::move(text);
    }
}

} // namespace suffuse

#include "render/composition/washes.h"

#include "model/painting/wash_groups.h"

#include <algorithm>

namespace suffuse {

namespace {

Stroke united(const std::vector<StrokePtr> &members, GroupId group, const Wash &wash)
{
    Stroke all = *members.front();
    all.group = group;
    all.style = wash.style, all.mix = wash.mix;
    all.picture = {}; // The paint of all is mixed, and none of it is a picture.
    std::size_t segments = 0;
    for (const StrokePtr &member : members)
        segments += member->segments.size();
    all.segments.reserve(segments);
    for (std::size_t i = 1; i < members.size(); ++i) {
        const Stroke &member = *members[i];
        const bool moves = !(member.origin == all.origin);
        for (std::size_t k = 0; k < member.segments.size(); ++k) {
            Segment &segment = all.segments.emplace_back(member.segments[k]);
            segment.start = member.beginsChain(k);
            if (moves)
                for (Offset &p : segment.bezier)
                    p = toOffset(member.origin + p, all.origin);
        }
    }
    return all;
}

StrokePtr restyled(const Stroke &stroke, GroupId group, const Wash &wash)
{
    auto own = std::make_shared<Stroke>(stroke);
    own->group = group;
    own->style = wash.style, own->mix = wash.mix;
    return own;
}

} // namespace

const StrokePtr &Washes::unite(std::unordered_map<StrokeId, United> &now, std::vector<StrokePtr> members, GroupId group,
                               const Wash &wash)
{
    const StrokeId first = members.front()->id;
    const auto known = m_united.find(first);
    if (known != m_united.end() && known->second.wash == wash && known->second.members == members &&
        known->second.stroke->group == group)
        return now.emplace(first, std::move(known->second)).first->second.stroke;
    const bool isFilled = bool(members.front()->fill);
    StrokePtr stroke =
        isFilled ? restyled(*members.front(), group, wash) : std::make_shared<Stroke>(united(members, group, wash));
    return now.emplace(first, United{wash, std::move(members), std::move(stroke)}).first->second.stroke;
}

PaintingPtr Washes::drawn(const PaintingPtr &painting)
{
    const auto isWash = [](const Group &group) { return group.wash.has_value(); };
    if (std::ranges::none_of(painting->groups, isWash)) {
        m_united.clear();
        return painting;
    }
    const std::unordered_map<GroupId, const Group *> washes = washesOf(*painting);
    const Visibility isVisible(painting->groups);
    const auto washOf = [&](const Stroke &stroke) -> const Group * {
        const auto wash = washes.find(stroke.group);
        return wash == washes.end() || !isVisible(stroke) ? nullptr : wash->second;
    };
    std::unordered_map<GroupId, std::vector<StrokePtr>> members;
    for (const StrokePtr &stroke : painting->strokes)
        if (const Group *wash = washOf(*stroke); wash && !stroke->fill)
            members[wash->id].push_back(stroke);
    std::unordered_map<StrokeId, United> now;
    auto drawn = std::make_shared<Painting>(*painting);
    drawn->strokes.clear();
    for (const StrokePtr &stroke : painting->strokes) {
        const Group *wash = washOf(*stroke);
        if (!wash)
            drawn->strokes.push_back(stroke);
        else if (stroke->fill)
            drawn->strokes.push_back(unite(now, {stroke}, wash->id, *wash->wash));
        else if (std::vector<StrokePtr> &all = members[wash->id]; !all.empty() && all.front() == stroke)
            drawn->strokes.push_back(unite(now, std::move(all), wash->id, *wash->wash));
    }
    m_united = std::move(now);
    return drawn;
}

} // namespace suffuse

// Paintings whose strokes are in groups that blend.
#pragma once

#include "tests/render/paintings.h"

namespace suffuse::test {

/// The modes whose result changes with their arguments no faster than twice as much; the slope of the others has no
/// bound, so that neighbours in rounding are far apart where they are steep.
inline constexpr BlendMode calmModes[] = {
    BlendMode::Normal,         BlendMode::Multiply,   BlendMode::Screen,       BlendMode::Overlay,   BlendMode::Darken,
    BlendMode::Lighten,        BlendMode::HardLight,  BlendMode::Difference,   BlendMode::Exclusion, BlendMode::Plus,
    BlendMode::DestinationOut, BlendMode::SourceAtop, BlendMode::DestinationIn};

/// Gives a group another opacity, mode or isolation, at random.
inline void blendRandomly(Group &group, std::mt19937_64 &random)
{
    std::uniform_real_distribution<double> u(0, 1);
    group.opacity = random() % 3 ? float(u(random)) : 1;
    // What keeps only what lies below is rare: it leaves little to look at.
    group.blend = random() % 3 ? calmModes[random() % 12] : random() % 8 ? BlendMode::Normal : BlendMode::DestinationIn;
    group.isolated = random() % 2;
    group.clips = random() % 5 == 0;
    group.mask = random() % 8 == 0;
    group.wash.reset();
    if (random() % 6 == 0)
        group.wash =
            Wash{styleOf(StyleKind(random() % 3)), random() % 2 ? Mix() : Mix{MixMode::Beta, float(random() % 5) / 4}};
}

/// Divides the strokes [from, to) into runs, of which some are groups within `parent`.
inline void groupRandomly(Painting &painting, std::size_t from, std::size_t to, GroupId parent, int depth,
                          std::mt19937_64 &random)
{
    while (from < to) {
        const std::size_t end = from + 1 + random() % (to - from);
        if (random() % 3 && depth < 5) {
            Group group;
            group.id = painting.groups.size() + 1;
            group.parent = parent;
            if (random() % 4)
                blendRandomly(group, random);
            painting.groups.push_back(group);
            groupRandomly(painting, from, end, group.id, depth + 1, random);
        } else if (parent) {
            for (std::size_t i = from; i < end; ++i) {
                Stroke stroke = *painting.strokes[i];
                stroke.group = parent;
                painting.strokes[i] = std::make_shared<const Stroke>(stroke);
            }
        }
        from = end;
    }
}

/// A painting in a random tree of groups, most of which blend.
inline PaintingPtr grouped(const PaintingPtr &p, std::mt19937_64 &random)
{
    auto q = std::make_shared<Painting>(*p);
    groupRandomly(*q, 0, q->strokes.size(), 0, 0, random);
    return q;
}

/// One random edit of groups: how one blends, whether it shows, or what is in it.
inline PaintingPtr regrouped(const PaintingPtr &p, std::mt19937_64 &random)
{
    auto q = std::make_shared<Painting>(*p);
    if (q->groups.empty())
        return grouped(p, random);
    Group &group = q->groups[random() % q->groups.size()];
    switch (random() % 8) {
    case 0:
        group.opacity = float(random() % 5) / 4;
        break;
    case 1:
        blendRandomly(group, random);
        break;
    case 2:
        group.visible = !group.visible;
        break;
    case 3: { // one stroke goes to where its neighbour is, or out of all groups
        const std::size_t i = random() % q->strokes.size();
        Stroke stroke = *p->strokes[i];
        stroke.group = i > 0 && random() % 2 ? p->strokes[i - 1]->group : 0;
        q->strokes[i] = std::make_shared<const Stroke>(stroke);
        break;
    }
    case 4:
        group.clips = !group.clips;
        break;
    case 5:
        group.mask = !group.mask;
        break;
    case 6:
        group.solo = random() % 4 == 0;
        break;
    default:
        group.isolated = !group.isolated;
    }
    return q;
}

} // namespace suffuse::test

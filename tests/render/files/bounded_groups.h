// Paintings of groups that are seen through others.
#pragma once

#include "tests/render/paintings.h"

#include <utility>
#include <vector>

namespace suffuse::test {

/// Masks in groups and of all, groups that are clipped to strokes and groups, and both at once; 300 × 200 units. In
/// each of them strokes that lie over each other have one colour, so that programs without RYB can show it.
inline std::vector<std::pair<const char *, PaintingPtr>> boundedGroups()
{
    const Style soft = styleOf(StyleKind::Uniform);
    const auto one = [&](StrokeId id, Shape shape, Point centre, double size, double spread, GroupId group) {
        Stroke s = stroke(id, shape, centre, size, spread, soft, {}, {0.1f, 0.7f, 0.9f, 0.8f});
        s.group = group;
        return s;
    };
    const Stroke wide = one(1, Shape::Straight, {150, 100}, 180, 40, 0),
                 across = one(2, Shape::Curved, {150, 100}, 90, 12, 2),
                 beside = one(3, Shape::Straight, {170, 110}, 120, 20, 2);
    const auto in = [](Stroke stroke, GroupId group) {
        stroke.group = group;
        return stroke;
    };
    const auto made = [](std::vector<Stroke> strokes, std::vector<Group> groups) {
        auto p = std::make_shared<Painting>(*painting(std::move(strokes), 300, 200));
        p->groups = std::move(groups);
        return PaintingPtr(p);
    };
    Group plain, mask, clipped;
    plain.id = 1, plain.name = "base";
    mask.id = 2, mask.name = "mask", mask.mask = true, mask.opacity = 0.75f;
    clipped.id = 3, clipped.name = "clipped", clipped.clips = true;
    Group within = mask, ofClipped = mask, half = plain;
    within.parent = 1, ofClipped.parent = 3, half.opacity = 0.5f;
    return {{"mask in a group", made({in(wide, 1), across, beside}, {plain, within})},
            {"mask of all", made({wide, across}, {mask})},
            {"clipped to a stroke", made({across, in(wide, 3)}, {mask, clipped})},
            {"clipped to the stroke below", made({in(across, 0), in(wide, 3)}, {clipped})},
            {"clipped to a group", made({in(across, 1), in(beside, 1), in(wide, 3)}, {plain, clipped})},
            {"clipped to a group of half opacity", made({in(across, 1), in(beside, 1), in(wide, 3)}, {half, clipped})},
            {"clipped and masked", made({in(across, 0), in(wide, 3), beside}, {clipped, ofClipped})}};
}

} // namespace suffuse::test

// A painting with texts and locks, for tests of layered files.
#pragma once

#include "tests/render/paintings.h"

namespace suffuse::test {

/// A folder that is locked, with a text in it, and a text that is locked itself and has no name.
inline PaintingPtr lockedTexts()
{
    auto p = std::make_shared<Painting>();
    p->canvas = {64, 48, {}, {}};
    Text text;
    text.string = QStringLiteral("Two  lines\nof a text"), text.family = QStringLiteral("a font");
    for (const GroupId id : {1, 2, 3}) {
        Group group;
        group.id = id, group.parent = id == 2 ? 1 : 0, group.locked = id != 2;
        if (id != 1)
            group.text = text;
        if (id == 2)
            group.name = QStringLiteral("greeting");
        p->groups.push_back(group);
    }
    for (const GroupId in : {2, 3, 0}) {
        Stroke s = stroke(StrokeId(p->strokes.size() + 1), Shape::Straight, {20.0 + 6 * double(in), 20}, 10, 3,
                          styleOf(StyleKind::Uniform));
        s.group = in;
        p->strokes.push_back(std::make_shared<const Stroke>(std::move(s)));
    }
    return p;
}

/// Names from bottom to top, as layered files have them; an exclamation mark where a group is locked.
inline QStringList namesAndLocks(const std::vector<Group> &groups)
{
    QStringList out;
    for (const Group &group : groups)
        out << group.name + (group.locked ? QStringLiteral("!") : QString());
    out.sort();
    return out;
}

inline const QStringList lockedTextsInFiles{"Background", "Group 1!", "Strokes", "Two lines of a text!", "greeting"};

} // namespace suffuse::test

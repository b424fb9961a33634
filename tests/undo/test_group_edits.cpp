// Aligning, distributing, grouping, locking, and selecting by likeness.
#include "model/paint/half_width.h"
#include "model/painting/validate.h"
#include "tests/undo/random_edits.h"
#include "undo/history/edit_command.h"
#include "undo/layers/group_edits.h"
#include "undo/transform_edits.h"

#include <QTest>

using namespace suffuse;

namespace {

using Order = std::vector<StrokeId>;

/// To a billionth: boxes of paint are sums of numbers that are no binary fractions.
double rounded(double x)
{
    return std::round(x * 1e9) / 1e9;
}

void lock(Document &d, StrokeId id)
{
    Edit edit = setLocked(d, {id}, true);
    d.exchange(edit);
}

} // namespace

class TestGroupEdits : public QObject {
    Q_OBJECT

private slots:
    void copiesOfSegments()
    {
        Document d;
        d.reset(makePainting(3));
        Selection some{{1, 2}, {{1, 0}}};
        d.setSelection(some);
        const PaintingPtr before = d.painting();
        const Point by{5, 0};
        Edit edit = duplicateSelection(d, by);
        d.exchange(edit);
        QCOMPARE(d.painting()->strokes.size(), std::size_t(5));
        const Stroke &part = *d.painting()->strokes[2], &whole = *d.painting()->strokes[3]; // above the topmost
        QCOMPARE(part.segments.size(), std::size_t(1));
        QCOMPARE(part.segments[0], strokeOf(d, 1).segments[0]);
        QCOMPARE(part.origin, strokeOf(d, 1).origin + by);
        QCOMPARE(whole.segments, strokeOf(d, 2).segments);
        QCOMPARE(d.selection().strokes, (std::set<StrokeId>{part.id, whole.id}));
        QVERIFY(d.selection().segments.empty());
        d.exchange(edit);
        QVERIFY(*d.painting() == *before);
        QCOMPARE(d.selection(), some);
    }

    void alignMovesBoxes()
    {
        Document d;
        d.reset(makePainting(3)); // from 60 i to 60 i + 40
        select(d, {1, 2, 3});
        Edit denser = changeSegments(d, targetSegments(d), [](Segment &segment) { segment.density = 90; });
        d.exchange(denser);
        const auto lefts = [&d] {
            std::vector<double> x;
            for (const StrokePtr &s : d.painting()->strokes)
                x.push_back(rounded(curveBox(*s).left));
            return x;
        };
        const auto after = [&](Edit edit) {
            d.exchange(edit);
            const std::vector<double> x = lefts();
            d.exchange(edit);
            return x;
        };
        using X = std::vector<double>;
        QCOMPARE(selectionBox(*d.painting(), d.selection()), Rect::of(60, 0, 160, 0));
        QCOMPARE(after(align(d, Align::Left)), (X{60, 60, 60}));
        QCOMPARE(after(align(d, Align::Right)), (X{180, 180, 180}));
        QCOMPARE(after(align(d, Align::Centre)), (X{120, 120, 120}));
        QCOMPARE(after(align(d, Align::Left, AlignTo::Anchor, 2)), (X{120, 120, 120}));
        QCOMPARE(after(align(d, Align::Left, AlignTo::Anchor)), (X{180, 180, 180})); // the topmost
        QCOMPARE(after(align(d, Align::Left, AlignTo::Biggest)), (X{60, 60, 60}));   // all the same: the lowest
        const double beyond = curveBox(strokeOf(d, 1)).left - seenBox(strokeOf(d, 1)).left;
        QVERIFY(beyond > 0);
        const double right = rounded(984 - beyond); // the paint touches the edge, not the curve
        QCOMPARE(after(align(d, Align::Right, AlignTo::Canvas)), (X{right, right, right}));
        QVERIFY(align(d, Align::Top).isEmpty());
        Edit middle = align(d, Align::Middle, AlignTo::Canvas);
        d.exchange(middle);
        QCOMPARE(curveBox(strokeOf(d, 2)).top, 384.0);
        d.exchange(middle);
        // A group that is selected as a whole moves as one.
        select(d, {2, 3});
        Edit grouped = groupSelection(d, QStringLiteral("g"));
        d.exchange(grouped);
        select(d, {1, 2, 3});
        QCOMPARE(after(align(d, Align::Left)), (X{60, 60, 120}));
        lock(d, 2);
        QCOMPARE(after(align(d, Align::Left)), (X{60, 120, 60}));
    }

    void distributeMakesGapsAndCentresEven()
    {
        auto p = std::make_shared<Painting>();
        p->strokes.push_back(makeStroke(1, 200, 0, 1)); // the outermost ones need not come first
        p->strokes.push_back(makeStroke(2, 0, 0, 2));
        p->strokes.push_back(makeStroke(3, 30, 50, 4));
        p->strokes.push_back(makeStroke(4, 40, 7, 1));
        Document d;
        d.reset(p);
        select(d, {1, 2, 3, 4});
        Edit gaps = distribute(d, Axis::Horizontal, Spacing::Gaps); // 210 − 80 in three
        d.exchange(gaps);
        const double gap = 130.0 / 3;
        QCOMPARE(curveBox(strokeOf(d, 1)).left, 200.0);
        QCOMPARE(curveBox(strokeOf(d, 2)).left, 0.0);
        // By centres: 2 (10), 4 (45), 3 (50), 1 (205).
        QVERIFY(std::abs(curveBox(strokeOf(d, 4)).left - (20 + gap)) < 1e-9);
        QVERIFY(std::abs(curveBox(strokeOf(d, 3)).left - (30 + 2 * gap)) < 1e-9);
        d.exchange(gaps);
        Edit centres = distribute(d, Axis::Horizontal, Spacing::Centres);
        d.exchange(centres);
        QVERIFY(std::abs(curveBox(strokeOf(d, 4)).centre().x - 75) < 1e-9);
        QVERIFY(std::abs(curveBox(strokeOf(d, 3)).centre().x - 140) < 1e-9);
        d.exchange(centres);
        select(d, {1, 2});
        QVERIFY(distribute(d, Axis::Vertical, Spacing::Gaps).isEmpty());
    }

    void duplicatesOfGroupsAreGroups()
    {
        // 1, [a: 2, [b: 3, 4 (hidden)], 5], 6
        Document d;
        auto p = std::make_shared<Painting>(*makePainting(6));
        p->groups = {{1, QStringLiteral("a"), 0, true, false}, {2, QStringLiteral("b"), 1, true, false}};
        for (const auto &[place, group] : std::map<std::size_t, GroupId>{{1, 1}, {2, 2}, {3, 2}, {4, 1}}) {
            auto member = std::make_shared<Stroke>(*std::as_const(p->strokes)[place]);
            member->group = group;
            member->visible = place != 3;
            p->strokes[place] = member;
        }
        d.reset(p);
        const auto duplicated = [&](std::set<StrokeId> strokes) {
            d.reset(p);
            d.setSelection({std::move(strokes), {}});
            Edit edit = duplicateSelection(d, {0, 0});
            d.exchange(edit);
            return edit;
        };
        duplicated({2, 3, 5}); // as a click selects it
        QCOMPARE(orderOf(d), (Order{1, 2, 3, 4, 5, 7, 8, 9, 6}));
        QCOMPARE(d.selection(), (Selection{{7, 8, 9}, {}}));
        QCOMPARE(d.painting()->groups, (std::vector<Group>{p->groups[0],
                                                           p->groups[1],
                                                           {3, QStringLiteral("a"), 0, true, false},
                                                           {4, QStringLiteral("b"), 3, true, false}}));
        QCOMPARE(strokeOf(d, 7).group, GroupId(3));
        QCOMPARE(strokeOf(d, 8).group, GroupId(4));
        QCOMPARE(strokeOf(d, 9).group, GroupId(3));
        QCOMPARE(strokeOf(d, 5).group, GroupId(1));
        QVERIFY(problemOf(*d.painting()).isEmpty());

        Edit inner = duplicated({3}); // all of the inner group that shows: it is copied within the outer one
        QCOMPARE(orderOf(d), (Order{1, 2, 3, 4, 7, 5, 6}));
        QCOMPARE(d.painting()->groups.back(), (Group{3, QStringLiteral("b"), 1, true, false}));
        QVERIFY(problemOf(*d.painting()).isEmpty());
        d.exchange(inner);
        QVERIFY(*d.painting() == *p);

        duplicated({5}); // a part of a group stays in it
        QCOMPARE(orderOf(d), (Order{1, 2, 3, 4, 5, 7, 6}));
        QCOMPARE(strokeOf(d, 7).group, GroupId(1));
        QCOMPARE(d.painting()->groups, p->groups);

        duplicated({2, 3, 5, 6}); // with a stroke above it: all of them above that
        QCOMPARE(orderOf(d), (Order{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
        QCOMPARE(strokeOf(d, 10).group, GroupId(0));
        QCOMPARE(strokeOf(d, 7).group, GroupId(3));
    }

    void groupsStandTogetherAndNest()
    {
        Document d;
        d.reset(makePainting(6));
        const auto push = [&d](Edit edit) {
            d.exchange(edit);
            QCOMPARE(problemOf(*d.painting()), QString());
        };
        select(d, {1, 4});
        push(groupSelection(d, QStringLiteral("a")));
        QCOMPARE(orderOf(d), (Order{2, 3, 1, 4, 5, 6}));
        const GroupId a = strokeOf(d, 1).group;
        QVERIFY(a != 0 && strokeOf(d, 4).group == a);
        QCOMPARE(d.painting()->groups, (std::vector<Group>{{a, QStringLiteral("a"), 0, true, false}}));
        // With a stroke outside: the group goes into the new one as it is.
        select(d, {1, 4, 6});
        push(groupSelection(d, QStringLiteral("b")));
        QCOMPARE(orderOf(d), (Order{2, 3, 5, 1, 4, 6}));
        const GroupId b = strokeOf(d, 6).group;
        QCOMPARE(strokeOf(d, 1).group, a);
        QCOMPARE(d.painting()->groups[0].parent, b);
        // A part of a group leaves it; the new group stands above what it came from.
        select(d, {2, 4});
        push(groupSelection(d, QStringLiteral("c")));
        QCOMPARE(orderOf(d), (Order{3, 5, 1, 6, 2, 4}));
        QCOMPARE(strokeOf(d, 1).group, a);
        // Within a group.
        select(d, {6});
        push(groupSelection(d, QStringLiteral("d")));
        QCOMPARE(d.painting()->groups.back().parent, b);
        // The outermost that is selected as a whole dissolves.
        select(d, {1, 6});
        push(ungroupSelection(d));
        QCOMPARE(d.painting()->groups.size(), std::size_t(3));
        QCOMPARE(strokeOf(d, 1).group, a);
        QCOMPARE(d.painting()->groups[0].parent, GroupId(0));
        select(d, {2}); // a part of c
        push(ungroupSelection(d));
        QCOMPARE(strokeOf(d, 4).group, GroupId(0));
        push(ungroup(d, a));
        QCOMPARE(strokeOf(d, 1).group, GroupId(0));
        QVERIFY(ungroup(d, a).isEmpty());
        select(d, {});
        QVERIFY(groupSelection(d, QString()).isEmpty());
    }

    void groupsBlend()
    {
        Document d;
        d.reset(makePainting(6));
        const auto group = [&d](std::set<StrokeId> strokes) {
            select(d, std::move(strokes));
            Edit edit = groupSelection(d, {});
            d.exchange(edit);
            return d.painting()->groups.back().id;
        };
        const GroupId a = group({1, 2}), b = group({3, 4});
        const auto of = [&d](GroupId id) { return *std::ranges::find(d.painting()->groups, id, &Group::id); };
        const PaintingPtr before = d.painting();
        using Values = std::tuple<float, BlendMode, bool>;
        const auto values = [&of](GroupId id) { return Values{of(id).opacity, of(id).blend, of(id).isolated}; };
        const auto isDoneAndUndone = [&](Edit edit, const Values &ofA, const Values &ofB) {
            if (edit.isEmpty() || !edit.strokes.empty() || edit.reorders() || edit.selection)
                return false; // nothing but the groups is touched
            d.exchange(edit);
            const bool done = values(a) == ofA && values(b) == ofB;
            d.exchange(edit);
            return done && *d.painting() == *before;
        };
        const Values usual{1, BlendMode::Normal, false};
        QVERIFY(isDoneAndUndone(setGroupOpacity(d, {a}, 0.25f), {0.25f, BlendMode::Normal, false}, usual));
        QVERIFY(isDoneAndUndone(setGroupBlend(d, {b}, BlendMode::Hue), usual, {1, BlendMode::Hue, false}));
        const Values isolated{1, BlendMode::Normal, true};
        QVERIFY(isDoneAndUndone(setGroupIsolated(d, {a, b}, true), isolated, isolated));
        // What changes nothing is no edit, and neither is what no painting can have.
        QVERIFY(setGroupOpacity(d, {a, b}, 1).isEmpty());
        QVERIFY(setGroupBlend(d, {a}, BlendMode::Normal).isEmpty());
        QVERIFY(setGroupIsolated(d, {a}, false).isEmpty());
        QVERIFY(setGroupOpacity(d, {99}, 0.5f).isEmpty());
        QVERIFY(setGroupOpacity(d, {}, 0.5f).isEmpty());
        QVERIFY(setGroupOpacity(d, {a}, -0.5f).isEmpty());
        QVERIFY(setGroupOpacity(d, {a}, std::numeric_limits<float>::quiet_NaN()).isEmpty());

        // A drag counts each group from where it began.
        Edit first = setGroupOpacity(d, {a}, 0.5f);
        d.exchange(first);
        Edit more = changeBlending(d, *before, {a, b},
                                   [](Group &now, const Group &then) { now.opacity = then.opacity - 0.25f; });
        d.exchange(more);
        QCOMPARE(of(a).opacity, 0.75f);
        QCOMPARE(of(b).opacity, 0.75f);
        d.exchange(more);
        QCOMPARE(of(a).opacity, 0.5f);
        QCOMPARE(of(b).opacity, 1.0f);

        // Neither a locked group nor one within a locked one changes.
        const GroupId around = group({1, 2, 5});
        QCOMPARE(of(a).parent, around);
        Edit lockIt = setGroupLocked(d, around, true);
        d.exchange(lockIt);
        QVERIFY(setGroupBlend(d, {around}, BlendMode::Multiply).isEmpty());
        QVERIFY(setGroupBlend(d, {a}, BlendMode::Multiply).isEmpty());
        Edit some = setGroupBlend(d, {a, b}, BlendMode::Multiply);
        d.exchange(some);
        QCOMPARE(of(a).blend, BlendMode::Normal);
        QCOMPARE(of(b).blend, BlendMode::Multiply);
    }

    void groupsSelectedAsAWhole()
    {
        Document d;
        d.reset(makePainting(6));
        using Ids = std::vector<GroupId>;
        select(d, {1, 2});
        QCOMPARE(selectedGroups(d), Ids());
        for (const std::set<StrokeId> &strokes : {std::set<StrokeId>{1, 2}, {4, 5}}) {
            select(d, strokes);
            Edit edit = groupSelection(d, {});
            d.exchange(edit);
        }
        const GroupId a = strokeOf(d, 1).group, b = strokeOf(d, 4).group;
        const auto of = [&d](std::set<StrokeId> strokes) {
            select(d, std::move(strokes));
            return selectedGroups(d);
        };
        QCOMPARE(of({1, 2}), Ids{a});
        QCOMPARE(selectedGroup(d), a);
        QCOMPARE(of({1, 2, 4, 5}), (Ids{a, b}));
        QCOMPARE(selectedGroup(d), GroupId(0));
        QCOMPARE(of({1}), Ids());
        QCOMPARE(of({1, 2, 3}), Ids());
        QCOMPARE(of({1, 2, 4}), Ids());
        QCOMPARE(of({}), Ids());
        d.setSelection({{1, 2}, {{1, 0}}});
        QCOMPARE(selectedGroups(d), Ids());
    }

    /// What comes into a group that was hidden or locked as a whole is hidden or locked, too.
    void aWholeGroupIsHiddenAndLockedItself()
    {
        Document d;
        d.reset(makePainting(5));
        select(d, {1, 2});
        Edit grouping = groupSelection(d, {});
        d.exchange(grouping);
        const GroupId group = strokeOf(d, 1).group;
        select(d, {1, 2, 3});
        Edit hiding = hideSelection(d);
        d.exchange(hiding);
        QVERIFY(!d.painting()->findGroup(group)->visible && !strokeOf(d, 3).visible);
        QVERIFY(strokeOf(d, 1).visible && strokeOf(d, 2).visible && strokeOf(d, 4).visible);
        QVERIFY(d.selection().isEmpty());
        d.exchange(hiding);
        QVERIFY(d.painting()->findGroup(group)->visible && strokeOf(d, 3).visible);
        QCOMPARE(d.selection().strokes, (std::set<StrokeId>{1, 2, 3}));
        select(d, {1}); // a part of the group
        Edit locking = lockSelection(d);
        d.exchange(locking);
        QVERIFY(strokeOf(d, 1).locked && !d.painting()->findGroup(group)->locked);
        select(d, {1, 2});
        Edit lockingAll = lockSelection(d);
        d.exchange(lockingAll);
        QVERIFY(d.painting()->findGroup(group)->locked && !strokeOf(d, 2).locked);
        select(d, {});
        QVERIFY(hideSelection(d).isEmpty());
    }

    void locksNamesAndLikeness()
    {
        Document d;
        d.reset(makePainting(4));
        const auto push = [&d](Edit edit) { d.exchange(edit); };
        push(setLocked(d, {1, 2}, true));
        push(setVisible(d, {2, 3}, false));
        QVERIFY(setLocked(d, {1, 2}, true).isEmpty());
        QVERIFY(strokeOf(d, 1).locked && !strokeOf(d, 2).visible);
        push(renameStroke(d, 1, QStringLiteral("sky"))); // though it is locked
        QCOMPARE(strokeOf(d, 1).name, QStringLiteral("sky"));
        push(showAll(d));
        push(unlockAll(d));
        QVERIFY(!strokeOf(d, 1).locked && strokeOf(d, 2).visible && strokeOf(d, 3).visible);
        QVERIFY(unlockAll(d).isEmpty() && showAll(d).isEmpty());
        select(d, {1, 2});
        push(groupSelection(d, QStringLiteral("g")));
        const GroupId g = strokeOf(d, 1).group;
        push(renameGroup(d, g, QStringLiteral("hills")));
        push(setGroupLocked(d, g, true));
        push(setGroupVisible(d, g, false));
        QCOMPARE(d.painting()->groups, (std::vector<Group>{{g, QStringLiteral("hills"), 0, false, true}}));
        QVERIFY(ungroup(d, g).isEmpty()); // locked
        push(unlockAll(d));
        push(showAll(d));
        QVERIFY(d.painting()->groups[0].visible && !d.painting()->groups[0].locked);
        push(changeBlending(d, *d.painting(), {g}, [](Group &now, const Group &) { now.solo = true; }));
        QVERIFY(!d.painting()->isVisible(strokeOf(d, 3)));
        push(showAll(d));
        QVERIFY(d.painting()->isVisible(strokeOf(d, 3)));

        push(changeStrokes(d, {1, 3}, [](Stroke &s) {
            s.brush = QStringLiteral("pencil");
            s.segments[0].colour.red = 0.9f;
        }));
        push(changeStrokes(d, {2, 3}, [](Stroke &s) { s.style = {StyleKind::Feathering, {1, 2, 0}}; }));
        select(d, {3});
        QCOMPARE(selectSame(d, Same::Brush).strokes, (std::set<StrokeId>{1, 3}));
        QCOMPARE(selectSame(d, Same::Colour).strokes, (std::set<StrokeId>{1, 3}));
        QCOMPARE(selectSame(d, Same::Style).strokes, (std::set<StrokeId>{2, 3}));
        push(setVisible(d, {1}, false));
        QCOMPARE(selectSame(d, Same::Brush).strokes, (std::set<StrokeId>{3}));
        select(d, {});
        QVERIFY(selectSame(d, Same::Style).isEmpty());
        // Of fills alone it is the fill's colour that is seen.
        push(showAll(d));
        for (const StrokeId id : {1, 2, 3})
            push(changeStrokes(d, {id}, [id](Stroke &s) {
                for (Segment &segment : s.segments)
                    segment.density = 0;
                Fill fill;
                fill.colour = id == 2 ? Colour{1, 0, 0, 1} : Colour{0, 1, 0, 1};
                s.fill = fill;
            }));
        select(d, {1});
        QCOMPARE(selectSame(d, Same::Colour).strokes, (std::set<StrokeId>{1, 3}));
    }
};

QTEST_APPLESS_MAIN(TestGroupEdits)
#include "test_group_edits.moc"

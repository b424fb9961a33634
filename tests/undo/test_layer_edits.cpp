// Groups as layers: where what is painted comes, copies, merging, moving, and the only one that shows.
#include "model/painting/validate.h"
#include "tests/undo/random_edits.h"
#include "undo/layers/group_edits.h"
#include "undo/layers/layer_edits.h"
#include "undo/layers/merge_layers.h"

using namespace suffuse;

namespace {

using Order = std::vector<StrokeId>;

Group makeGroup(GroupId id, GroupId parent = 0)
{
    Group group;
    group.id = id;
    group.parent = parent;
    return group;
}

/// From bottom to top: 1, group 1 {2, 3, group 2 {4, 5}}, group 3 {6}, 7.
PaintingPtr layered()
{
    auto painting = std::make_shared<Painting>();
    const GroupId groups[] = {0, 1, 1, 2, 2, 3, 0};
    for (int i = 1; i <= 7; ++i) {
        const StrokePtr plain = makeStroke(StrokeId(i), 60.0 * i, 0, 2, groups[i - 1]);
        Stroke stroke = *plain;
        for (Segment &segment : stroke.segments)
            segment.born = 1000 * i;
        painting->strokes.push_back(std::make_shared<const Stroke>(std::move(stroke)));
    }
    painting->groups = {makeGroup(1), makeGroup(2, 1), makeGroup(3)};
    return painting;
}

void change(Document &document, GroupId id, const std::function<void(Group &)> &change)
{
    Edit edit;
    edit.groups = document.painting()->groups;
    change(*std::ranges::find(*edit.groups, id, &Group::id));
    document.exchange(edit);
}

Edit added(Document &document, const PaintedLayer &layer, LayerEnd end = LayerEnd::Top,
           std::optional<Microseconds> born = {})
{
    const StrokePtr stroke = makeStroke(8, 0, 0);
    return addedToLayer(document, addStrokes(document, {stroke}, false), layer, end, born);
}

/// Does an edit, checks that the painting is valid then, and that the way back leads back.
void exchangeAndCheck(Document &document, Edit &edit)
{
    const PaintingPtr before = document.painting();
    document.exchange(edit);
    QCOMPARE(problemOf(*document.painting()), QString());
    const PaintingPtr after = document.painting();
    document.exchange(edit);
    QVERIFY(*document.painting() == *before);
    document.exchange(edit);
    QVERIFY(*document.painting() == *after);
}

} // namespace

class TestLayerEdits : public QObject {
    Q_OBJECT

private slots:
    void paintComesOnTopOfItsLayer_data()
    {
        QTest::addColumn<int>("group");
        QTest::addColumn<bool>("bottom");
        QTest::addColumn<std::vector<StrokeId>>("order");
        QTest::newRow("group with a group") << 1 << false << Order{1, 2, 3, 4, 5, 8, 6, 7};
        QTest::newRow("its bottom") << 1 << true << Order{1, 8, 2, 3, 4, 5, 6, 7};
        QTest::newRow("group within") << 2 << false << Order{1, 2, 3, 4, 5, 8, 6, 7};
        QTest::newRow("last group") << 3 << false << Order{1, 2, 3, 4, 5, 6, 8, 7};
    }
    void paintComesOnTopOfItsLayer()
    {
        QFETCH(const int, group);
        QFETCH(const bool, bottom);
        Document d;
        d.reset(layered());
        Edit edit = added(d, {GroupId(group), {}, 0}, bottom ? LayerEnd::Bottom : LayerEnd::Top);
        exchangeAndCheck(d, edit);
        QTEST(orderOf(d), "order");
        QCOMPARE(strokeOf(d, 8).group, GroupId(group));
    }

    void withoutALayerItComesOnTopOfAll()
    {
        Document d;
        d.reset(layered());
        Edit edit = added(d, {});
        d.exchange(edit);
        QCOMPARE(orderOf(d), (Order{1, 2, 3, 4, 5, 6, 7, 8}));
        QCOMPARE(strokeOf(d, 8).group, GroupId(0));
    }

    /// In the past it comes above what was begun by then, but into no group within the layer.
    void paintOfThePastHasItsPlaceInTheLayer()
    {
        Document d;
        d.reset(layered());
        for (const auto &[born, index] : {std::pair(500, 1), {2500, 2}, {4500, 3}, {9000, 5}}) {
            Edit edit = added(d, {1, {}, 0}, LayerEnd::Top, born);
            exchangeAndCheck(d, edit);
            QCOMPARE(d.painting()->indexOf(8), index);
            QCOMPARE(strokeOf(d, 8).group, GroupId(1));
            d.exchange(edit);
        }
    }

    void whatIsHiddenOrLockedTakesNoPaint()
    {
        Document d;
        d.reset(layered());
        change(d, 2, [](Group &group) { group.locked = true; });
        QCOMPARE(groupTakingPaint(*d.painting(), 2), GroupId(1));
        Edit above = added(d, {2, {}, 0});
        exchangeAndCheck(d, above);
        QCOMPARE(orderOf(d), (Order{1, 2, 3, 4, 5, 8, 6, 7}));
        QCOMPARE(strokeOf(d, 8).group, GroupId(1));
        d.exchange(above);
        change(d, 1, [](Group &group) { group.visible = false; });
        Edit outside = added(d, {2, {}, 0});
        exchangeAndCheck(d, outside);
        QCOMPARE(orderOf(d), (Order{1, 2, 3, 4, 5, 8, 6, 7}));
        QCOMPARE(strokeOf(d, 8).group, GroupId(0));
    }

    void aNewLayerComesWithItsFirstStroke()
    {
        Document d;
        d.reset(layered());
        PaintedLayer layer{d.takeGroupId(), makeGroup(0, 0), 1};
        Edit edit = added(d, layer);
        exchangeAndCheck(d, edit);
        QCOMPARE(orderOf(d), (Order{1, 2, 3, 4, 5, 8, 6, 7})); // above group 1
        QCOMPARE(strokeOf(d, 8).group, layer.group);
        QCOMPARE(d.painting()->findGroup(layer.group)->parent, GroupId(0));
        d.exchange(edit);
        layer.above = 0;
        layer.coming->parent = 1;
        Edit within = added(d, layer);
        exchangeAndCheck(d, within);
        QCOMPARE(d.painting()->findGroup(layer.group)->parent, GroupId(1));
        QCOMPARE(d.painting()->indexOf(8), 5);
    }

    /// As a text is added: a group with its strokes.
    void aNewGroupComesIntoTheLayerAsAWhole()
    {
        Document d;
        d.reset(layered());
        const GroupId text = d.takeGroupId();
        Edit edit = addStrokes(d, {makeStroke(8, 0, 0), makeStroke(9, 0, 0)}, false);
        for (auto &[id, stroke] : edit.strokes)
            stroke = makeStroke(id, 0, 0, 2, text);
        edit.groups = d.painting()->groups;
        edit.groups->push_back(makeGroup(text));
        Edit placed = addedToLayer(d, edit, {2, {}, 0}, LayerEnd::Top);
        exchangeAndCheck(d, placed);
        QCOMPARE(orderOf(d), (Order{1, 2, 3, 4, 5, 8, 9, 6, 7}));
        QCOMPARE(d.painting()->findGroup(text)->parent, GroupId(2));
    }

    void layersAreListedAsTheyStand()
    {
        Document d;
        d.reset(layered());
        QCOMPARE(layersOf(*d.painting()), (std::vector<GroupId>{3, 1, 2}));
        change(d, 1, [](Group &group) { group.text = Text(); });
        QCOMPARE(layersOf(*d.painting()), (std::vector<GroupId>{3}));
        QCOMPARE(layerAround(*d.painting(), 2), GroupId(0)); // within a text
        QCOMPARE(layerAround(*d.painting(), 3), GroupId(3));
    }

    void aCopyStandsAboveItsOriginal()
    {
        Document d;
        d.reset(layered());
        change(d, 2, [](Group &group) { group.opacity = 0.5f, group.locked = true; });
        GroupId copy = 0;
        Edit edit = duplicateGroup(d, 1, "copy", copy);
        exchangeAndCheck(d, edit);
        QCOMPARE(d.painting()->strokes.size(), std::size_t(11));
        QCOMPARE(d.painting()->groups.size(), std::size_t(5));
        for (std::size_t i = 0; i < 4; ++i) {
            const Stroke &original = *d.painting()->strokes[1 + i], &made = *d.painting()->strokes[5 + i];
            QCOMPARE(made.segments, original.segments);
            QVERIFY(made.id != original.id && made.group != original.group);
        }
        const Group &within = *d.painting()->findGroup(d.painting()->strokes[8]->group);
        QCOMPARE(within.parent, copy);
        QCOMPARE(within.opacity, 0.5f);
        QVERIFY(within.locked);
    }

    void mergingKeepsTheOrder()
    {
        Document d;
        d.reset(layered());
        change(d, 2, [](Group &group) { group.opacity = 0.25f; });
        MergedDown merged = mergeDown(d, 3);
        QCOMPARE(merged.why, NotMerged::Merged);
        QCOMPARE(merged.below, GroupId(1));
        exchangeAndCheck(d, merged.edit);
        QCOMPARE(orderOf(d), (Order{1, 2, 3, 4, 5, 6, 7}));
        QCOMPARE(strokeOf(d, 6).group, GroupId(1));
        QVERIFY(!d.painting()->findGroup(3) && !merged.keepsGroup);
        QCOMPARE(d.painting()->findGroup(2)->opacity, 0.25f);
    }

    void whatCannotBeMergedSaysWhy()
    {
        Document d;
        d.reset(layered());
        QCOMPARE(mergeDown(d, 1).why, NotMerged::NoGroupBelow); // but a stroke
        QCOMPARE(mergeDown(d, 2).why, NotMerged::NoGroupBelow);
        QCOMPARE(mergeDown(d, 9).why, NotMerged::NothingBelow);
        change(d, 1, [](Group &group) { group.locked = true; });
        QCOMPARE(mergeDown(d, 3).why, NotMerged::Locked);
        change(d, 1, [](Group &group) { group.locked = false, group.visible = false; });
        QCOMPARE(mergeDown(d, 3).why, NotMerged::Hidden);
        change(d, 1, [](Group &group) { group.visible = true, group.text = Text(); });
        QCOMPARE(mergeDown(d, 3).why, NotMerged::NoGroupBelow);
    }

    void layersMovePastWhatIsNextToThem()
    {
        Document d;
        d.reset(layered());
        Edit up = moveGroup(d, 1, true);
        exchangeAndCheck(d, up);
        QCOMPARE(orderOf(d), (Order{1, 6, 2, 3, 4, 5, 7}));
        Edit down = moveGroup(d, 2, false);
        exchangeAndCheck(d, down);
        QCOMPARE(orderOf(d), (Order{1, 6, 2, 4, 5, 3, 7}));
        QVERIFY(moveGroup(d, 9, true).isEmpty());
        change(d, 3, [](Group &group) { group.locked = true; });
        QVERIFY(moveGroup(d, 3, true).isEmpty());
    }

    void onlyOneIsShownOrAllAgain()
    {
        Document d;
        d.reset(layered());
        change(d, 3, [](Group &group) { group.solo = true; });
        Edit first = toggleSolo(d, 1);
        exchangeAndCheck(d, first);
        QVERIFY(d.painting()->findGroup(1)->solo && !d.painting()->findGroup(3)->solo);
        QVERIFY(d.painting()->isVisible(strokeOf(d, 4)) && !d.painting()->isVisible(strokeOf(d, 6)));
        Edit second = toggleSolo(d, 1);
        exchangeAndCheck(d, second);
        QVERIFY(d.painting()->isVisible(strokeOf(d, 6)) && d.painting()->isVisible(strokeOf(d, 7)));
        QVERIFY(toggleSolo(d, 9).isEmpty());
    }
};

QTEST_GUILESS_MAIN(TestLayerEdits)
#include "test_layer_edits.moc"

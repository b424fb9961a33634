// Orders as differences: exact both ways, and no larger than what moved.
#include "model/document/document.h"

#include <QRandomGenerator>
#include <QTest>

#include <algorithm>
#include <set>

using namespace suffuse;

using Order = std::vector<StrokeId>;

namespace {

Order upTo(StrokeId n)
{
    Order order(n);
    for (StrokeId i = 0; i < n; ++i)
        order[i] = i + 1;
    return order;
}

/// `after` from `before` by way of the difference; what `after` lacks goes.
Order byDifference(const Order &before, const Order &after)
{
    const std::set<StrokeId> stay(after.begin(), after.end());
    return reordered(before, orderDifference(before, after), [&](StrokeId id) { return !stay.contains(id); });
}

StrokePtr stroke(StrokeId id)
{
    auto s = std::make_shared<Stroke>();
    s->id = id;
    s->segments.resize(1);
    return s;
}

} // namespace

class TestOrderDifference : public QObject {
    Q_OBJECT

private slots:
    void holdsWhatMoved()
    {
        const Order order = upTo(1000);
        QVERIFY(orderDifference(order, order).empty());

        Order added = order;
        added.insert(added.begin() + 400, 2000);
        QCOMPARE(orderDifference(order, added), (OrderDifference{{400, 2000}}));
        QVERIFY(orderDifference(added, order).empty()); // what goes is not named

        Order raised = order; // the lowest comes to the top
        std::rotate(raised.begin(), raised.begin() + 1, raised.end());
        QCOMPARE(orderDifference(order, raised), (OrderDifference{{999, 1}}));
        QCOMPARE(orderDifference(raised, order), (OrderDifference{{0, 1}}));

        const Order turned(order.rbegin(), order.rend());
        QCOMPARE(orderDifference(order, turned).size(), std::size_t(999));
    }

    void anyOrderComesBack()
    {
        QRandomGenerator random(7);
        for (int round = 0; round < 2000; ++round) {
            const auto n = StrokeId(random.bounded(1, 40));
            Order before = upTo(n), after = upTo(n + StrokeId(random.bounded(8)));
            const int moves = random.bounded(6);
            for (int i = 0; i < moves; ++i)
                std::swap(after[std::size_t(random.bounded(int(after.size())))],
                          after[std::size_t(random.bounded(int(after.size())))]);
            const int gone = random.bounded(int(after.size()));
            for (int i = 0; i < gone; ++i)
                after.erase(after.begin() + random.bounded(int(after.size())));
            if (random.bounded(3) == 0)
                std::shuffle(before.begin(), before.end(), random);
            QCOMPARE(byDifference(before, after), after);
            QCOMPARE(byDifference(after, before), before);
        }
    }

    /// An undo step that adds a stroke to many, or moves one, holds one place, whichever way it was last exchanged.
    void editsHoldPlacesOnly()
    {
        auto painting = std::make_shared<Painting>();
        for (StrokeId id = 1; id <= 300; ++id)
            painting->strokes.push_back(stroke(id));
        Document d;
        d.reset(painting);
        Edit edit;
        edit.strokes = {{7, nullptr}, {400, stroke(400)}};
        edit.order = upTo(300);
        std::erase(*edit.order, StrokeId(7));
        edit.order->insert(edit.order->begin() + 100, 400);
        std::rotate(edit.order->begin() + 1, edit.order->begin() + 2, edit.order->end()); // 2 on top
        const Order wanted = *edit.order;
        for (int i = 0; i < 3; ++i) {
            d.exchange(edit);
            QVERIFY(!edit.order);
            QCOMPARE(*edit.places, (OrderDifference{{1, 2}, {6, 7}}));
            QCOMPARE(orderOf(*d.painting()), wanted);
            d.exchange(edit);
            QCOMPARE(*edit.places, (OrderDifference{{99, 400}, {299, 2}}));
            QVERIFY(*d.painting() == *painting);
        }
    }

    /// What lies below the first place that differs goes on sharing its memory with the snapshot before.
    void lowerStrokesStayShared()
    {
        auto painting = std::make_shared<Painting>();
        for (StrokeId id = 1; id <= 640; ++id)
            painting->strokes.push_back(stroke(id));
        Document d;
        d.reset(painting);
        Edit edit;
        edit.strokes = {{700, stroke(700)}};
        edit.order = upTo(640);
        edit.order->push_back(700);
        d.exchange(edit);
        const PaintingPtr after = d.painting();
        for (std::size_t i = 0; i < 640; ++i)
            QCOMPARE(&std::as_const(after->strokes)[i], &std::as_const(painting->strokes)[i]);
    }
};

QTEST_GUILESS_MAIN(TestOrderDifference)
#include "test_order_difference.moc"

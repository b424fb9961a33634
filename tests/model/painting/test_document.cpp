// Document, painting and influence.
#include "model/document/document.h"
#include "model/painting/influence.h"

#include <QSignalSpy>
#include <QTest>

using namespace suffuse;

namespace {

std::shared_ptr<Stroke> makeStroke(StrokeId id, double x = 0, int segments = 2)
{
    auto s = std::make_shared<Stroke>();
    s->id = id;
    s->origin = {x, 10};
    for (int k = 0; k < segments; ++k) {
        Segment g;
        for (int i = 0; i < 4; ++i)
            g.bezier[std::size_t(i)] = {float(10 * k) + float(i) * 10 / 3, 0};
        if (k > 0)
            g.bezier[0] = s->segments.back().bezier[3];
        g.born = k * 1000;
        s->segments.push_back(g);
    }
    return s;
}

PaintingPtr makePainting(int strokes)
{
    auto p = std::make_shared<Painting>();
    for (int i = 1; i <= strokes; ++i)
        p->strokes.push_back(makeStroke(StrokeId(i), 100.0 * i));
    return p;
}

} // namespace

class TestDocument : public QObject {
    Q_OBJECT

private slots:
    void exchangeIsItsOwnInverse()
    {
        Document d;
        d.reset(makePainting(4));
        const PaintingPtr before = d.painting();
        auto moved = std::make_shared<Stroke>(*before->strokes[1]);
        moved->origin.x += 5;
        Edit edit;
        edit.strokes = {{2, moved}, {3, nullptr}, {9, makeStroke(9)}};
        edit.order = std::vector<StrokeId>{4, 9, 2, 1};
        Canvas canvas = before->canvas;
        canvas.width = 77;
        edit.canvas = canvas;
        edit.groups = std::vector<Group>{{5, QStringLiteral("g"), 0, true, false}};
        edit.swatches = std::vector<Swatch>{{QStringLiteral("ochre"), {0.2f, 0.8f, 0.1f, 1}}};
        edit.underlay = std::make_shared<const Underlay>();

        d.exchange(edit);
        QCOMPARE(orderOf(*d.painting()), (std::vector<StrokeId>{4, 9, 2, 1}));
        QCOMPARE(d.painting()->strokes[2], StrokePtr(moved));
        QCOMPARE(d.painting()->strokes[3], before->strokes[0]); // shared, not copied
        QCOMPARE(d.painting()->canvas.width, 77.0);
        QCOMPARE(d.painting()->swatches.size(), std::size_t(1));
        QVERIFY(hashOf(*d.painting()) != hashOf(*before));
        const PaintingPtr after = d.painting();

        d.exchange(edit);
        QVERIFY(*d.painting() == *before);
        QCOMPARE(hashOf(*d.painting()), hashOf(*before));
        d.exchange(edit);
        QVERIFY(*d.painting() == *after);
    }

    void oneSignalAnEdit()
    {
        Document d;
        d.reset(makePainting(3));
        QSignalSpy spy(&d, &Document::changed);
        Edit edit;
        edit.strokes = {{1, makeStroke(1, 50)}, {2, makeStroke(2, 60)}};
        Canvas canvas;
        canvas.height = 5;
        edit.canvas = canvas;
        d.exchange(edit);
        QCOMPARE(spy.count(), 1);
        const auto change = spy.takeFirst().first().value<Change>();
        QCOMPARE(change.strokes, (std::vector<StrokeId>{1, 2}));
        QVERIFY(change.canvas && !change.order && !change.selection && !change.reset);
        Edit nothing;
        d.exchange(nothing);
        QCOMPARE(spy.count(), 0);
    }

    /// What is typed is told apart from other changes of groups, which more of the program has to follow.
    void anotherTextIsToldAsThat()
    {
        Document d;
        d.reset(makePainting(2));
        std::vector<Change> told;
        connect(&d, &Document::changed, this, [&told](const Change &change) { told.push_back(change); });
        const auto exchange = [&d](std::vector<Group> groups) {
            Edit edit;
            edit.groups = std::move(groups);
            d.exchange(edit);
        };
        Text text;
        text.string = QStringLiteral("a");
        const Group plain{1, QStringLiteral("plain")};
        Group of{2, QStringLiteral("text")};
        exchange({plain, of});
        QVERIFY(told.back().canvas && !told.back().texts);
        of.text = text;
        exchange({plain, of}); // it becomes a text
        QVERIFY(told.back().canvas && !told.back().texts);
        text.string = QStringLiteral("ab");
        of.text = text;
        exchange({plain, of});
        QVERIFY(!told.back().canvas && told.back().texts);
        QCOMPARE(d.painting()->groups.back().text->string, text.string);
        text.string = QStringLiteral("abc");
        of.text = text;
        of.visible = false;
        exchange({plain, of});
        QVERIFY(told.back().canvas && !told.back().texts);
        exchange({of, plain});
        QVERIFY(told.back().canvas && !told.back().texts);
        of.text = {};
        exchange({of, plain});
        QVERIFY(told.back().canvas && !told.back().texts);
        Edit edit;
        edit.canvas = d.painting()->canvas;
        d.exchange(edit);
        QVERIFY(told.back().canvas && !told.back().texts);
    }

    /// Strokes come, go, change and move in the middle of many; what lies below and above stays as it is.
    void theMiddleOfTheOrderIsExchanged()
    {
        Document d;
        d.reset(makePainting(300));
        const PaintingPtr before = d.painting();
        std::vector<StrokeId> order = orderOf(*before);
        order.insert(order.begin() + 100, {901, 902});
        std::swap(order[120], order[140]);
        order.erase(order.begin() + 130);
        const auto moved = makeStroke(order[125], 7), above = makeStroke(order[200], 8);
        Edit edit;
        edit.strokes = {{901, makeStroke(901)}, {902, makeStroke(902)}, {order[125], moved}, {order[200], above}};
        for (const StrokePtr &stroke : before->strokes)
            if (std::ranges::find(order, stroke->id) == order.end())
                edit.strokes.emplace(stroke->id, nullptr);
        edit.order = order;
        d.exchange(edit);
        QCOMPARE(orderOf(*d.painting()), order);
        QCOMPARE(d.painting()->strokes[125], StrokePtr(moved));
        QCOMPARE(d.painting()->strokes[200], StrokePtr(above));
        for (const StrokePtr &stroke : d.painting()->strokes)
            if (const StrokePtr was = before->find(stroke->id); was && stroke != moved && stroke != above)
                QCOMPARE(stroke, was);
        d.exchange(edit);
        QVERIFY(std::ranges::equal(d.painting()->strokes, before->strokes));
        d.exchange(edit);
        QCOMPARE(orderOf(*d.painting()), order);
    }

    void selectionStaysValid()
    {
        Document d;
        d.reset(makePainting(3));
        d.setSelection({{1, 2, 42}, {{3, 0}, {3, 7}, {2, -1}}});
        QCOMPARE(d.selection(), (Selection{{1, 2, 3}, {{3, 0}}}));
        const Selection before = d.selection();
        Edit edit;
        edit.strokes = {{2, nullptr}};
        edit.order = std::vector<StrokeId>{1, 3};
        d.exchange(edit);
        QCOMPARE(d.selection(), (Selection{{1, 3}, {{3, 0}}}));
        d.exchange(edit);
        QCOMPARE(d.selection(), before);

        Edit shorter;
        shorter.strokes = {{3, makeStroke(3, 0, 1)}};
        d.setSelection({{}, {{3, 1}}});
        d.exchange(shorter);
        QVERIFY(d.selection().segments.empty());
        d.exchange(shorter);
        QCOMPARE(d.selection(), (Selection{{3}, {{3, 1}}}));
    }

    void idsNeverRepeat()
    {
        Document d;
        d.reset(makePainting(3));
        QCOMPARE(d.takeStrokeId(), StrokeId(4));
        Edit edit;
        edit.strokes = {{20, makeStroke(20)}};
        edit.order = std::vector<StrokeId>{1, 2, 3, 20};
        d.exchange(edit);
        d.exchange(edit); // gone, but undo may bring it back
        QCOMPARE(d.takeStrokeId(), StrokeId(21));
        QCOMPARE(d.takeGroupId(), GroupId(1));
        QCOMPARE(d.takeGroupId(), GroupId(2));
    }

    void draftIsOnTopAndNotCommitted()
    {
        Document d;
        d.reset(makePainting(2));
        QCOMPARE(d.snapshot(), d.painting());
        QSignalSpy spy(&d, &Document::changed);
        const StrokePtr draft = makeStroke(7);
        d.setDraft(draft);
        d.setDraft(draft);
        QCOMPARE(spy.count(), 1);
        QCOMPARE(d.snapshot()->strokes.back(), draft);
        QCOMPARE(d.painting()->strokes.size(), std::size_t(2));
        d.setDraft(nullptr);
        QCOMPARE(d.snapshot(), d.painting());
    }

    void hashSeesEveryField()
    {
        const PaintingPtr base = makePainting(2);
        QSet<QByteArray> hashes{hashOf(*base)};
        int variants = 1;
        const auto vary = [&](const std::function<void(Painting &, Stroke &, Segment &)> &change) {
            Painting p = *base;
            auto s = std::make_shared<Stroke>(*p.strokes[1]);
            change(p, *s, s->segments[0]);
            p.strokes[1] = s;
            hashes.insert(hashOf(p));
            ++variants;
            QVERIFY(!(p == *base));
        };
        vary([](Painting &, Stroke &, Segment &g) { g.bezier[2].y = 1; });
        vary([](Painting &, Stroke &, Segment &g) { g.diffusion = std::nextafter(g.diffusion, 99.f); });
        vary([](Painting &, Stroke &, Segment &g) { g.density = 1; });
        vary([](Painting &, Stroke &, Segment &g) { g.granulation = 0; });
        vary([](Painting &, Stroke &, Segment &g) { g.maxAge = 2; });
        vary([](Painting &, Stroke &, Segment &g) { g.born = 1; });
        vary([](Painting &, Stroke &, Segment &g) { g.born = Microseconds(1) << 40; });
        vary([](Painting &, Stroke &, Segment &g) { g.colour.opacity = 0.5f; });
        vary([](Painting &, Stroke &, Segment &g) { g.style = Style(); });
        vary([](Painting &, Stroke &, Segment &g) { g.anisotropyRatio = 2; });
        vary([](Painting &, Stroke &, Segment &g) { g.anisotropyAngle = 1; });
        vary([](Painting &, Stroke &, Segment &g) { g.node = NodeKind::Corner; });
        vary([](Painting &, Stroke &, Segment &g) { g.rewet = {{5, 6}}; });
        vary([](Painting &, Stroke &s, Segment &) { s.name = QStringLiteral("n"); });
        vary([](Painting &, Stroke &s, Segment &) { s.brush = QStringLiteral("n"); });
        vary([](Painting &, Stroke &s, Segment &) { s.group = 1; });
        vary([](Painting &, Stroke &s, Segment &) { s.visible = false; });
        vary([](Painting &, Stroke &s, Segment &) { s.locked = true; });
        vary([](Painting &, Stroke &s, Segment &) { s.style.xi[0] = 1; });
        vary([](Painting &, Stroke &s, Segment &) { s.mix = {MixMode::Beta, 0}; });
        vary([](Painting &, Stroke &s, Segment &) { s.mix.beta = 1; });
        vary([](Painting &, Stroke &s, Segment &) { s.origin.y = 1e-300; });
        vary([](Painting &, Stroke &s, Segment &) { s.segments.pop_back(); });
        vary([](Painting &p, Stroke &, Segment &) { p.strokes[0] = std::make_shared<Stroke>(); });
        vary([](Painting &p, Stroke &, Segment &) { p.canvas.width = 1; });
        vary([](Painting &p, Stroke &, Segment &) { p.canvas.background.red = 1; });
        vary([](Painting &p, Stroke &, Segment &) { p.canvas.paper.kind = PaperKind::Procedural; });
        vary([](Painting &p, Stroke &, Segment &) { p.canvas.paper.seed = 2; });
        vary([](Painting &p, Stroke &, Segment &) { p.canvas.paper.grain = PaperGrain::Weave; });
        vary([](Painting &p, Stroke &, Segment &) { p.canvas.paper.image = std::make_shared<QByteArray>("x"); });
        vary([](Painting &p, Stroke &, Segment &) { p.groups.push_back({1, {}, 0, true, false}); });
        vary([](Painting &p, Stroke &, Segment &) { p.swatches.push_back({}); });
        vary([](Painting &p, Stroke &, Segment &) { p.underlay = std::make_shared<Underlay>(); });
        QCOMPARE(hashes.size(), variants);
        QCOMPARE(hashOf(*base).size(), 32);
    }

    void equalPaintingsHashEqually()
    {
        Painting a = *makePainting(1), b = *makePainting(1);
        QVERIFY(a == b);
        auto s = std::make_shared<Stroke>(*a.strokes[0]);
        s->segments[0].bezier[0].y = -0.0f; // equals 0
        a.strokes[0] = s;
        a.canvas.paper.image = std::make_shared<QByteArray>("abc");
        b.canvas.paper.image = std::make_shared<QByteArray>("abc");
        QVERIFY(a == b);
        QCOMPARE(hashOf(a), hashOf(b));
    }

    void visibilityGoesThroughGroups()
    {
        Painting p = *makePainting(1);
        p.groups = {{1, {}, 2, true, false}, {2, {}, 0, false, true}, {3, {}, 3, true, false}};
        Stroke s = *p.strokes[0];
        QVERIFY(p.isVisible(s) && !p.isLocked(s));
        s.group = 1;
        QVERIFY(!p.isVisible(s) && p.isLocked(s));
        s.group = 3; // a cycle, as a damaged file may have: ends
        QVERIFY(p.isVisible(s) && !p.isLocked(s));
    }

    void endIsWhenAllHasDried()
    {
        Painting p;
        QCOMPARE(p.end(), Microseconds(0));
        auto s = makeStroke(1);
        s->segments[1].born = 2'000'000;
        s->segments[0].rewet = {{5'000'000, 500'000}};
        p.strokes = {s};
        QCOMPARE(p.end(), Microseconds(5'500'000));
    }

    void influenceFollowsTheSpread()
    {
        auto s = makeStroke(1, 100, 1);
        Segment &g = s->segments[0];
        g.diffusion = 25, g.maxAge = 1, g.born = 1'000'000;
        QVERIFY(influenceOf(*s, g, 1'000'000).isEmpty());
        const Rect dried = influenceOf(*s, g, 9'000'000); // s = 10
        QCOMPARE(dried.left, 100.0 - 40);
        QCOMPARE(dried.right, 110.0 + 40);
        QCOMPARE(dried.top, 10.0 - 40);
        const Rect young = influenceOf(*s, g, 1'250'000); // s = 5
        QCOMPARE(young.left, 100.0 - 20);
        g.anisotropyRatio = 4;
        QCOMPARE(influenceOf(*s, g, 9'000'000).left, 100.0 - 80);
        Painting p;
        QVERIFY(influenceOf(p, 0).isEmpty());
        s->visible = false;
        p.strokes = {s};
        QVERIFY(influenceOf(p, 9'000'000).isEmpty());
    }
};

QTEST_GUILESS_MAIN(TestDocument)
#include "test_document.moc"

// What differs between two paintings.
#include "model/document/difference.h"

#include <QTest>

using namespace suffuse;

namespace {

using Ids = std::vector<StrokeId>;
using Places = std::vector<std::size_t>;

Painting somePainting(int strokes = 6)
{
    Painting p;
    for (StrokeId id = 1; id <= StrokeId(strokes); ++id) {
        auto stroke = std::make_shared<Stroke>();
        stroke->id = id;
        stroke->segments.resize(5);
        for (std::size_t k = 0; k < 5; ++k)
            stroke->segments[k].density = float(10 * id + k);
        p.strokes.push_back(stroke);
    }
    return p;
}

std::shared_ptr<Stroke> copyOf(const Painting &p, std::size_t index)
{
    return std::make_shared<Stroke>(*p.strokes[index]);
}

} // namespace

class TestDifference : public QObject {
    Q_OBJECT

private slots:
    void equalPaintings()
    {
        const Painting a = somePainting();
        QVERIFY(differenceOf(a, a).isEmpty());
        Painting b; // other pointers, the same values
        for (std::size_t k = 0; k < a.strokes.size(); ++k)
            b.strokes.push_back(copyOf(a, k));
        QVERIFY(differenceOf(a, b).isEmpty());
        QVERIFY(valuesThatDiffer(a, b).empty());
    }

    void strokesComeGoChangeAndMove()
    {
        const Painting a = somePainting();
        Painting b = a;
        auto changed = copyOf(a, 1);
        changed->name = QStringLiteral("x");
        b.strokes[1] = changed;
        PaintingDifference d = differenceOf(a, b);
        QCOMPARE(d.changed, Ids{2});
        QVERIFY(d.added.empty() && d.removed.empty() && d.moved.empty());
        auto added = copyOf(a, 0);
        added->id = 20;
        b.strokes = {changed, a.strokes[3], added, a.strokes[4], a.strokes[0], a.strokes[5]};
        d = differenceOf(a, b);
        QCOMPARE(d.changed, Ids{2});
        QCOMPARE(d.added, Ids{20});
        QCOMPARE(d.removed, Ids{3});
        QCOMPARE(d.moved, Ids{1});
        const PaintingDifference back = differenceOf(b, a);
        QCOMPARE(back.added, Ids{3});
        QCOMPARE(back.removed, Ids{20});
        QCOMPARE(back.changed, Ids{2});
    }

    /// Strokes in other places of an equally long list are no changes.
    void replacedStrokes()
    {
        const Painting a = somePainting();
        Painting b = a;
        auto other = copyOf(a, 2);
        other->id = 30;
        b.strokes[2] = other;
        const PaintingDifference d = differenceOf(a, b);
        QCOMPARE(d.added, Ids{30});
        QCOMPARE(d.removed, Ids{3});
        QVERIFY(d.changed.empty() && d.moved.empty());
    }

    void theRest()
    {
        const Painting a = somePainting();
        Painting b = a;
        b.canvas.height = 5;
        b.canvas.paper.kind = PaperKind::Procedural;
        b.groups = {{4, QStringLiteral("g"), 0, true, false}};
        b.swatches = {{QStringLiteral("s"), {}}};
        auto underlay = std::make_shared<Underlay>();
        underlay->image = std::make_shared<const QByteArray>("abc");
        b.underlay = underlay;
        const PaintingDifference d = differenceOf(a, b);
        QVERIFY(d.canvas && d.groups && d.swatches && d.underlay && !d.isEmpty());
        const auto values = valuesThatDiffer(a, b);
        const auto has = [&](const ValueDifference &v) {
            return std::find(values.begin(), values.end(), v) != values.end();
        };
        QVERIFY(has({"canvas.height", "768", "5"}));
        QVERIFY(has({"canvas.paper.kind", "\"none\"", "\"procedural\""}));
        QVERIFY(has({"groups[4].name", "", "\"g\""}));
        QVERIFY(has({"groups", "[]", "[4]"}));
        QVERIFY(has({"swatches[0].colour", "", "[0,0,0,1]"}));
        QVERIFY(has({"underlay.opacity", "", "0.5"}));
        QVERIFY(std::any_of(values.begin(), values.end(), [](const ValueDifference &v) {
            return v.path == QLatin1String("underlay.image") &&
                   v.after.startsWith(QLatin1String("\"3 bytes, SHA-256 ba7816bf"));
        }));
    }

    void segmentsOfAStroke()
    {
        const Painting p = somePainting(1);
        const Stroke &a = *p.strokes[0];
        Stroke b = a;
        QVERIFY(differenceOf(a, b).values.empty());
        b.segments[2].born = 16'000;
        b.segments[2].style = Style{StyleKind::Edge, {0.5f, 0.25f, 1}};
        b.origin = {0.1, -2};
        StrokeDifference d = differenceOf(a, b);
        QCOMPARE(d.changed, Places{2});
        QVERIFY(d.added.empty() && d.removed.empty());
        QCOMPARE(d.values, (std::vector<ValueDifference>{
                               {"origin", "[0,0]", "[0.1,-2]"},
                               {"segments[2].born", "0", "0.016"},
                               {"segments[2].style", "null", "{\"kind\": \"edge\", \"xi\": [0.5, 0.25, 1]}"}}));
        b = a; // two come after the second
        b.segments.insert(b.segments.begin() + 2, 2, Segment());
        d = differenceOf(a, b);
        QCOMPARE(d.added, (Places{2, 3}));
        QVERIFY(d.changed.empty() && d.removed.empty());
        d = differenceOf(b, a);
        QCOMPARE(d.removed, (Places{2, 3}));
        QVERIFY(d.changed.empty() && d.added.empty());
        b = a; // split: one becomes two others
        b.segments[1].density = 1;
        b.segments.insert(b.segments.begin() + 2, Segment());
        d = differenceOf(a, b);
        QCOMPARE(d.changed, Places{1});
        QCOMPARE(d.added, Places{2});
    }
};

QTEST_APPLESS_MAIN(TestDifference)
#include "test_difference.moc"

// What the inspector looks at, and what it keeps of it.
#include "app/panels/inspector/figures/figure_warnings.h"
#include "tests/app/selecting.h"
#include "undo/edits.h"

#include <QTest>

#include <random>

using namespace suffuse;

namespace {

StrokePtr randomStroke(StrokeId id, std::mt19937 &random)
{
    const auto between = [&](double low, double high) {
        return float(std::uniform_real_distribution<double>(low, high)(random));
    };
    Stroke stroke = *line(id, {0, 0}, {between(10, 90), 30}, 1 + int(random() % 4));
    stroke.style.xi[0] = random() % 3 == 0 ? 0.4f : 0.2f;
    for (Segment &segment : stroke.segments) {
        segment.diffusion = between(1, 500);
        segment.density = random() % 9 == 0 ? 0 : between(0.1, 30);
        segment.maxAge = between(0.1, 4);
        segment.colour.opacity = random() % 7 == 0 ? 0 : between(0.1, 1);
        segment.anisotropyRatio = random() % 11 == 0 ? 2 : 1;
        segment.lift = random() % 5 == 0;
    }
    return std::make_shared<const Stroke>(std::move(stroke));
}

/// A few strokes as a whole, and a few segments of others.
Selection randomSelection(const Painting &painting, std::mt19937 &random)
{
    Selection selection;
    for (const StrokePtr &stroke : painting.strokes) {
        if (random() % 4 == 0)
            continue;
        selection.strokes.insert(stroke->id);
        for (int k = 0; k < int(stroke->segments.size()) && random() % 3 == 0; ++k)
            selection.segments.insert({stroke->id, k});
    }
    return selection;
}

/// One by one.
FiguresSummary summed(const Inspected &inspected)
{
    FiguresSummary sum;
    for (const InspectedSegment &segment : inspected.segments)
        sum.add(segment);
    return sum;
}

bool same(const Extent &a, const Extent &b)
{
    return a.least == b.least && a.most == b.most && a.count == b.count;
}

bool same(const FiguresSummary &a, const FiguresSummary &b)
{
    return a.segments == b.segments && a.transparent == b.transparent && a.withoutPaint == b.withoutPaint &&
           same(a.spread, b.spread) && same(a.along, b.along) && same(a.peak, b.peak) &&
           same(a.halfWidth, b.halfWidth) && same(a.driesOut, b.driesOut) && same(a.fading, b.fading) &&
           same(a.shrinking, b.shrinking) && a.uneven == b.uneven && a.styles == b.styles && a.erasing == b.erasing &&
           a.withoutEffect == b.withoutEffect && same(a.reach, b.reach) && same(a.taken, b.taken);
}

} // namespace

class TestInspected : public QObject {
    Q_OBJECT

private slots:
    void allTargetsAreInspected()
    {
        std::mt19937 random(3);
        for (int round = 0; round < 50; ++round) {
            Painting painting;
            for (int i = 0; i < 12; ++i)
                painting.strokes.push_back(randomStroke(StrokeId(i + 1), random));
            std::shuffle(painting.strokes.begin(), painting.strokes.end(), random);
            Document document;
            document.reset(std::make_shared<const Painting>(painting));
            document.setSelection(randomSelection(painting, random));
            const Inspected inspected = inspect(document);
            QVERIFY(inspected.refs == targetSegments(document));
            QCOMPARE(inspected.segments.size(), inspected.refs.size());
            for (std::size_t i = 0; i < inspected.refs.size(); ++i) {
                const auto [stroke, segment] = inspected.refs[i];
                QVERIFY(inspected.segments[i].stroke == document.painting()->find(stroke).get());
                QVERIFY(inspected.segments[i].segment == &inspected.segments[i].stroke->segments[std::size_t(segment)]);
            }
            std::vector<const Stroke *> strokes;
            for (const StrokePtr &stroke : document.painting()->strokes)
                if (document.selection().strokes.contains(stroke->id))
                    strokes.push_back(stroke.get());
            QVERIFY(inspected.strokes == strokes);
        }
    }

    void whatIsKeptOfStrokesHolds()
    {
        std::mt19937 random(4);
        Painting painting;
        for (int i = 0; i < 20; ++i)
            painting.strokes.push_back(randomStroke(StrokeId(i + 1), random));
        Document document;
        FiguresKeeper keeper;
        StrokeId next = 100;
        for (int step = 0; step < 400; ++step) {
            const std::size_t place = random() % painting.strokes.size();
            const auto at = std::as_const(painting.strokes).begin() + std::ptrdiff_t(place);
            if (step % 7 == 0)
                painting.strokes.insert(at, randomStroke(next++, random));
            else if (step % 7 == 3 && painting.strokes.size() > 5)
                painting.strokes.erase(at);
            else
                painting.strokes[place] = randomStroke((*at)->id, random);
            const Selection before = document.selection();
            document.reset(std::make_shared<const Painting>(painting));
            document.setSelection(step % 5 == 0 ? randomSelection(painting, random) : before);
            const Inspected inspected = inspect(document);
            const FiguresSummary kept = keeper.summaryOf(inspected), expected = summed(inspected);
            QVERIFY(same(kept, expected));
            if (expected.segments + expected.erasing > 0)
                QCOMPARE(figureWarnings(kept), figureWarnings(expected));
        }
    }

    /// What takes paint away is no paint: it is in no figure of paint, and no warning of paint is about it.
    void erasuresHaveFiguresOfTheirOwn()
    {
        Stroke stroke = *line(1, {0, 0}, {100, 0}, 3);
        stroke.segments[2].lift = true;
        stroke.segments[2].density = 0;
        stroke.segments[2].diffusion = 400;
        stroke.segments[2].colour.opacity = 0;
        FiguresSummary paint, mixed, erasure;
        for (const std::size_t k : {0, 1})
            paint.add({&stroke, &stroke.segments[k]});
        for (const Segment &segment : stroke.segments)
            mixed.add({&stroke, &segment});
        erasure.add({&stroke, &stroke.segments[2]});
        QVERIFY(same(mixed.spread, paint.spread) && same(mixed.halfWidth, paint.halfWidth));
        QCOMPARE(mixed.segments, std::size_t(2));
        QCOMPARE(figureWarnings(mixed), figureWarnings(paint));
        QVERIFY(!mixed.isErasure() && erasure.isErasure());
        QCOMPARE(figureWarnings(erasure), QStringList{"Strength 0: nothing is taken away."});
        stroke.segments[2].density = 5;
        FiguresSummary strong;
        strong.add({&stroke, &stroke.segments[2]});
        QVERIFY(figureWarnings(strong).isEmpty());
        QVERIFY(strong.taken.most > 0 && strong.reach.most > paint.spread.most);
    }
};

QTEST_GUILESS_MAIN(TestInspected)
#include "test_inspected.moc"

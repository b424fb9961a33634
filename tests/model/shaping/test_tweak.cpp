// Pushing, combing, pinching and roughening strokes, and drawing over a part of one.
#include "model/painting/validate.h"
#include "model/shaping/curves/split.h"
#include "model/shaping/nodes/redraw.h"
#include "model/shaping/nodes/reshape.h"
#include "model/shaping/nodes/tweak.h"

#include <QTest>

using namespace suffuse;

namespace {

/// A straight stroke of `count` segments from (0, 0) to (400, 0), each of another density.
Stroke line(int count)
{
    Stroke stroke;
    stroke.id = 1;
    const double each = 400.0 / count;
    for (int k = 0; k < count; ++k) {
        Segment s;
        s.bezier = toOffsets({{Point{k * each, 0}, Point{(k + 1.0 / 3) * each, 0}, Point{(k + 2.0 / 3) * each, 0},
                               Point{(k + 1) * each, 0}}});
        if (k > 0)
            s.bezier[0] = stroke.segments.back().bezier[3];
        s.born = k * 1000;
        s.density = float(5 + k);
        stroke.segments.push_back(s);
    }
    return stroke;
}

/// The segment of `stroke` whose middle is nearest to x.
const Segment &segmentAt(const Stroke &stroke, double x)
{
    return *std::min_element(stroke.segments.begin(), stroke.segments.end(), [&](const Segment &a, const Segment &b) {
        return std::abs(stroke.cubicOf(a).at(0.5).x - x) < std::abs(stroke.cubicOf(b).at(0.5).x - x);
    });
}

} // namespace

class TestTweak : public QObject {
    Q_OBJECT

private slots:
    void aPushMovesWhatLiesUnderTheCircle()
    {
        const Stroke before = line(40);
        std::vector<int> sources;
        const std::optional<Stroke> after = tweaked(before, {TweakKind::Push, {200, 0}, 60, {0, 10}, 1, 0}, &sources);
        QVERIFY(after);
        QCOMPARE(problemOf(*after), QString());
        QCOMPARE(sources.size(), after->segments.size());
        double most = 0;
        for (std::size_t k = 0; k < after->segments.size(); ++k) {
            const Segment &s = after->segments[k], &from = before.segments[std::size_t(sources[k])];
            QCOMPARE(s.density, from.density);
            QCOMPARE(s.born, from.born);
            for (double p = 0; p <= 1; p += 0.25) {
                const Point at = after->cubicOf(s).at(p);
                most = std::max(most, at.y);
                if (std::abs(at.x - 200) > 75) // beyond the circle and the segment at its edge
                    QCOMPARE(at.y, 0.0);
            }
        }
        QVERIFY2(std::abs(most - 10) < 0.2, qPrintable(QString::number(most)));
        QVERIFY(cornersOf(*after).empty()); // it stays smooth
    }

    void whatIsFarAwayIsLeftAlone()
    {
        for (const TweakKind kind : {TweakKind::Push, TweakKind::Comb, TweakKind::Pinch, TweakKind::Roughen})
            QVERIFY(!tweaked(line(40), {kind, {200, 500}, 60, {0, 10}, 0.5, 1}));
    }

    void longSegmentsAreSplitToFollow()
    {
        std::vector<int> sources;
        const std::optional<Stroke> after = tweaked(line(1), {TweakKind::Push, {200, 0}, 30, {0, 8}, 1, 0}, &sources);
        QVERIFY(after);
        QVERIFY(after->segments.size() > 4);
        QVERIFY(std::all_of(sources.begin(), sources.end(), [](int k) { return k == 0; }));
        QVERIFY(std::abs(after->cubicOf(segmentAt(*after, 20)).at(0.5).y) < 0.5);
    }

    void aPinchPullsTogetherAndApart()
    {
        Stroke aside = line(40);
        for (Segment &s : aside.segments)
            for (Offset &o : s.bezier)
                o.y += 20;
        const auto height = [&](double share) {
            const std::optional<Stroke> after = tweaked(aside, {TweakKind::Pinch, {200, 0}, 60, {}, share, 0});
            return after->cubicOf(segmentAt(*after, 200)).at(0.5).y;
        };
        QVERIFY(height(0.2) < 18);
        QVERIFY(height(-0.2) > 22);
    }

    void roughnessIsOfItsSeed()
    {
        const Stroke before = line(60);
        const auto rough = [&](unsigned seed) {
            return *tweaked(before, {TweakKind::Roughen, {200, 0}, 80, {}, 0.2, seed});
        };
        QVERIFY(rough(1) == rough(1));
        QVERIFY(!(rough(1) == rough(2)));
        QVERIFY(!(rough(1) == before));
    }

    /// The plane moves with all that lies in it, holes among it; but combing turns the hair and not the holes in it.
    void whatWasErasedGoesWithThePlane()
    {
        Stroke before = line(40);
        Segment across = before.segments[0];
        across.lift = true;
        across.bezier = toOffsets({{Point{200, -20}, Point{200, -10}, Point{200, 10}, Point{200, 20}}});
        appendChain(before, {across});
        const auto liftsOf = [](const Stroke &stroke) {
            std::vector<Segment> lifts = stroke.segments;
            std::erase_if(lifts, [](const Segment &s) { return !s.lift; });
            return lifts;
        };
        for (const TweakKind kind : {TweakKind::Push, TweakKind::Comb, TweakKind::Pinch, TweakKind::Roughen}) {
            const std::optional<Stroke> after = tweaked(before, {kind, {195, 3}, 60, {0, 10}, 0.3, 1});
            QVERIFY(after && after->segments[20].bezier != before.segments[20].bezier);
            QCOMPARE(liftsOf(*after) == liftsOf(before), kind == TweakKind::Comb);
        }
        // Where there is nothing else, it is what is combed.
        Stroke alone = before;
        alone.segments = {across};
        QVERIFY(tweaked(alone, {TweakKind::Comb, {195, 3}, 60, {10, 10}, 0.3, 1}));
    }

    void aLineTakesThePlaceOfThePartBetween()
    {
        const Stroke before = line(40);
        Stroke bow;
        bow.id = 2;
        Segment s;
        s.bezier = toOffsets({{Point{100, 1}, Point{150, 80}, Point{250, 80}, Point{300, 1}}});
        s.density = 99;
        bow.segments = {s};
        const std::optional<RedrawnPart> part = partToRedraw(before, pointsAlong(bow), 6);
        QVERIFY(part);
        QVERIFY(part->joinsStart && part->joinsEnd && !part->reversed);
        for (const RedrawValues values : {RedrawValues::Kept, RedrawValues::Line}) {
            std::vector<int> sources;
            const std::optional<Stroke> after = redrawn(before, *part, bow, 6, values, &sources);
            QVERIFY(after);
            QCOMPARE(problemOf(*after), QString());
            QCOMPARE(sources.size(), after->segments.size());
            const Segment &top = segmentAt(*after, 200);
            QVERIFY(after->cubicOf(top).at(0.5).y > 50);
            QCOMPARE(top.density == 99, values == RedrawValues::Line);
            QVERIFY(after->segments.front() == before.segments.front());
            QVERIFY(after->segments.back() == before.segments.back());
        }
        // A line that is at no stroke redraws nothing.
        std::vector<Point> far;
        for (const Point p : pointsAlong(bow))
            far.push_back({p.x, p.y + 300});
        QVERIFY(!partToRedraw(before, far, 6));
    }
};

QTEST_APPLESS_MAIN(TestTweak)
#include "test_tweak.moc"

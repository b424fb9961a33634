// Retiming, freezing, re-wetting, and strokes that are painted in the past.
#include "model/painting/validate.h"
#include "tests/undo/random_edits.h"
#include "tests/undo/steps.h"
#include "undo/node_edits.h"
#include "undo/time_edits.h"

#include <QTest>
#include <QUndoStack>

using namespace suffuse;

namespace {

constexpr Microseconds second = 1'000'000;

/// Stroke i of n (from 1) begins at second i; its four segments are a tenth of a second apart.
PaintingPtr timedPainting(int n)
{
    auto painting = std::make_shared<Painting>(*makePainting(n));
    for (int i = 0; i < n; ++i) {
        auto stroke = std::make_shared<Stroke>(*painting->strokes[std::size_t(i)]);
        for (int k = 0; k < 4; ++k)
            stroke->segments[std::size_t(k)].born = (i + 1) * second + k * second / 10;
        painting->strokes[std::size_t(i)] = std::move(stroke);
    }
    return painting;
}

std::vector<Microseconds> births(const Stroke &stroke)
{
    std::vector<Microseconds> times;
    for (const Segment &s : stroke.segments)
        times.push_back(s.born);
    return times;
}

using Times = std::vector<Microseconds>;

/// A stroke that was erased softly long after it was painted.
PaintingPtr erasedLater()
{
    auto painting = std::make_shared<Painting>(*timedPainting(1));
    auto stroke = std::make_shared<Stroke>(*painting->strokes[0]);
    for (int k = 0; k < 3; ++k) {
        Segment lift = stroke->segments[std::size_t(k)];
        lift.start = k == 0;
        lift.lift = true;
        lift.born = 20 * second + k * second / 10;
        stroke->segments.push_back(lift);
    }
    painting->strokes[0] = stroke;
    return painting;
}

/// A document with a stack.
struct Desk {
    Document document;
    QUndoStack stack;

    explicit Desk(PaintingPtr painting) { document.reset(std::move(painting)); }
    const Stroke &stroke(StrokeId id) { return strokeOf(document, id); }
    void push(Edit edit, StepRun *run = nullptr)
    {
        if (!edit.isEmpty())
            pushStep(stack, document, std::move(edit), QStringLiteral("edit"), run);
        QCOMPARE(problemOf(*document.painting()), QString());
    }
};

} // namespace

class TestTimeEdits : public QObject {
    Q_OBJECT

private slots:
    void shiftsStrokesAndRuns()
    {
        Desk d(timedPainting(3));
        const QByteArray first = hashOf(*d.document.painting());
        const PaintingPtr before = d.document.painting();
        select(d.document, {1, 2}, {{2, 1}, {2, 2}});
        d.push(retime(*before, d.document.selection(), second / 2));
        QCOMPARE(births(d.stroke(1)), (Times{1'500'000, 1'600'000, 1'700'000, 1'800'000}));
        QCOMPARE(births(d.stroke(2)), (Times{2'000'000, 2'600'000, 2'700'000, 2'300'000}));
        QCOMPARE(d.document.painting()->find(3), before->find(3));
        Segment same = d.stroke(1).segments[2];
        same.born = before->find(1)->segments[2].born;
        QCOMPARE(same, before->find(1)->segments[2]); // nothing but its time
        checkUndoAllAndRedo(d.stack, d.document, first);
    }

    void eachBeginsWhereTheMapSays()
    {
        Desk d(timedPainting(3));
        const QByteArray first = hashOf(*d.document.painting());
        select(d.document, {2});
        d.push(rewet(d.document, 5 * second, second));
        select(d.document, {1, 2, 3}, {{3, 2}, {3, 3}});
        const auto doubled = [](Microseconds begin) { return std::optional(2 * begin); };
        d.push(beginAt(*d.document.painting(), d.document.selection(), doubled));
        QCOMPARE(births(d.stroke(1)), (Times{2'000'000, 2'100'000, 2'200'000, 2'300'000}));
        QCOMPARE(births(d.stroke(2)), (Times{4'000'000, 4'100'000, 4'200'000, 4'300'000}));
        QCOMPARE(births(d.stroke(3)), (Times{3'000'000, 3'100'000, 6'400'000, 6'500'000}));
        QCOMPARE(d.stroke(2).segments[0].rewet.front().time, 7 * second);
        const auto some = [](Microseconds begin) { return begin > 3 * second ? std::optional(begin) : std::nullopt; };
        QVERIFY(beginAt(*d.document.painting(), d.document.selection(), some).isEmpty());
        checkUndoAllAndRedo(d.stack, d.document, first);
    }

    void nothingBeginsBeforeZero()
    {
        Desk d(timedPainting(2));
        select(d.document, {1, 2});
        d.push(retime(*d.document.painting(), d.document.selection(), -10 * second));
        QCOMPARE(births(d.stroke(1)).front(), Microseconds(0));
        QCOMPARE(births(d.stroke(2)).front(), second); // both by the same
        // What began before zero may stay there, but goes no further.
        Desk early(std::make_shared<const Painting>([] {
            Painting painting = *timedPainting(1);
            auto stroke = std::make_shared<Stroke>(*painting.strokes[0]);
            for (Segment &s : stroke->segments)
                s.born -= 2 * second;
            painting.strokes[0] = stroke;
            return painting;
        }()));
        select(early.document, {1});
        d.push(retime(*early.document.painting(), early.document.selection(), -second));
        QCOMPARE(births(early.stroke(1)).front(), -second);
    }

    void stretchesAndCarriesRewetting()
    {
        auto painting = std::make_shared<Painting>(*timedPainting(1));
        auto stroke = std::make_shared<Stroke>(*painting->strokes[0]);
        stroke->segments[1].rewet = {{5 * second, second}, {7 * second, second / 2}};
        painting->strokes[0] = stroke;
        Desk d(painting);
        select(d.document, {1});
        const TimeSpan drawn = drawnSpan(*painting, d.document.selection());
        QCOMPARE(drawn, (TimeSpan{second, 1'300'000}));
        d.push(stretch(*painting, d.document.selection(), {second, 1'900'000}));
        QCOMPARE(births(d.stroke(1)), (Times{1'000'000, 1'300'000, 1'600'000, 1'900'000}));
        QCOMPARE(d.stroke(1).segments[1].rewet, (std::vector<Rewet>{{13 * second, second}, {19 * second, second / 2}}));
        d.push(stretch(*painting, d.document.selection(), {1'150'000, 1'300'000}));
        QCOMPARE(births(d.stroke(1)), (Times{1'150'000, 1'200'000, 1'250'000, 1'300'000}));
    }

    void whatWasThereAtOnceIsDrawn()
    {
        Desk d(makePainting(1)); // all born at 0
        select(d.document, {1});
        d.push(stretch(*d.document.painting(), d.document.selection(), {0, 3 * second}));
        QCOMPARE(births(d.stroke(1)), (Times{0, second, 2 * second, 3 * second}));
    }

    void aDragIsOneStepAndNoneIfItComesBack()
    {
        Desk d(timedPainting(3));
        const PaintingPtr before = d.document.painting();
        select(d.document, {2});
        const Selection selection = d.document.selection();
        StepRun run;
        for (const Microseconds by : {100'000, 500'000, -300'000, 250'000})
            d.push(retime(*before, selection, by), &run);
        QCOMPARE(d.stack.count(), 1);
        QCOMPARE(d.stroke(2).born(), 2'250'000);
        d.stack.undo();
        QVERIFY(*d.document.painting() == *before);
        d.stack.redo();
        run.reset();
        const PaintingPtr now = d.document.painting();
        for (const Microseconds by : {100'000, -100'000, 0})
            d.push(retime(*now, selection, by), &run);
        QCOMPARE(d.stack.count(), 1);
        QVERIFY(*d.document.painting() == *now);
    }

    void lockedStrokesKeepTheirTime()
    {
        auto painting = std::make_shared<Painting>(*timedPainting(2));
        auto locked = std::make_shared<Stroke>(*painting->strokes[0]);
        locked->locked = true;
        painting->strokes[0] = locked;
        Desk d(painting);
        select(d.document, {1, 2});
        QCOMPARE(drawnSpan(*painting, d.document.selection()).begin, 2 * second);
        d.push(retime(*painting, d.document.selection(), second));
        d.push(setPace(d.document, Pace::EaseIn));
        d.push(freeze(d.document, 1'200'000));
        d.push(rewet(d.document, 9 * second, second));
        QCOMPARE(d.document.painting()->find(1), StrokePtr(locked));
        QCOMPARE(d.stroke(2).born(), 3 * second);
        select(d.document, {1});
        QVERIFY(drawnSpan(*painting, d.document.selection()).end < drawnSpan(*painting, d.document.selection()).begin);
        QVERIFY(retime(*painting, d.document.selection(), second).isEmpty());
    }

    void pacesFollowTheCurve()
    {
        Desk d(timedPainting(1));
        select(d.document, {1});
        const auto paced = [&](Pace pace) {
            d.push(setPace(d.document, pace));
            Times times = births(d.stroke(1));
            for (Microseconds &t : times)
                t -= second;
            return times;
        };
        QCOMPARE(paced(Pace::EaseIn), (Times{0, 173'205, 244'949, 300'000}));
        QCOMPARE(paced(Pace::EaseOut), (Times{0, 55'051, 126'795, 300'000}));
        const Times both = paced(Pace::EaseInOut);
        QCOMPARE(both[1] + both[2], Microseconds(300'000)); // the same from both ends
        QVERIFY(both[1] > 100'000);
        QCOMPARE(paced(Pace::Even), (Times{0, 100'000, 200'000, 300'000}));
        QVERIFY(setPace(d.document, Pace::Even).isEmpty());
        select(d.document, {1}, {{1, 1}, {1, 2}, {1, 3}});
        d.push(setPace(d.document, Pace::EaseIn));
        QCOMPARE(births(d.stroke(1)), (Times{1'000'000, 1'100'000, 1'241'421, 1'300'000}));
    }

    void easingKeepsTheEndsAndTheOrder()
    {
        auto painting = std::make_shared<Painting>(*timedPainting(2));
        auto wetted = std::make_shared<Stroke>(*painting->strokes[0]);
        wetted->segments[2].rewet = {{5 * second, second}};
        painting->strokes[0] = wetted;
        const PaintingPtr before = painting;
        Desk d(before);
        const QByteArray first = hashOf(*before);
        select(d.document, {1});
        d.push(ease(*before, d.document.selection(), {2, 1}));
        // Slope 2 at the start: u(2(1 − u)² + u(3 − 2u) − u(1 − u)) at u = 1/3 and 2/3.
        const Times slow = births(d.stroke(1));
        QCOMPARE(slow, (Times{second, 1'144'444, 1'222'222, 1'300'000}));
        QCOMPARE(d.stroke(1).segments[2].rewet[0].time - 5 * second, slow[2] - 1'200'000); // it goes along
        QCOMPARE(d.document.painting()->find(2), before->find(2));
        checkUndoAllAndRedo(d.stack, d.document, first);
        while (d.stack.canUndo())
            d.stack.undo();
        // The other end, mirrored; farther than the pen can be slowed, it never goes back.
        d.push(ease(*before, d.document.selection(), {1, 2}));
        const Times late = births(d.stroke(1));
        QVERIFY(std::abs((late[3] - late[2]) - (slow[1] - slow[0])) <= 1);
        d.push(ease(*before, d.document.selection(), {100, 100}));
        QVERIFY(std::ranges::is_sorted(births(d.stroke(1))));
        d.push(ease(*before, d.document.selection(), {0, -3}));
        QVERIFY(std::ranges::is_sorted(births(d.stroke(1))));
        d.push(ease(*before, d.document.selection(), {})); // as it was, pointers too
        QCOMPARE(hashOf(*d.document.painting()), first);
        QVERIFY(d.document.painting()->find(1) == wetted);
    }

    void freezingKeepsTheAges()
    {
        Desk d(timedPainting(3));
        const Microseconds now = 2'150'000;
        const PaintingPtr before = d.document.painting();
        d.push(freeze(d.document, now));
        for (StrokeId id = 1; id <= 3; ++id)
            for (std::size_t k = 0; k < 4; ++k) {
                const Segment &was = before->find(id)->segments[k], &is = d.stroke(id).segments[k];
                const bool wet = was.born <= now && was.driesAt() > now;
                if (!wet) {
                    QCOMPARE(is, was); // dry, or not painted yet
                    continue;
                }
                QVERIFY(std::abs(is.age(now) - was.age(now)) < 1e-6);
                QCOMPARE(is.age(now + 10 * second), double(is.maxAge));
                QVERIFY(is.driesAt() <= now + 1);
            }
        QCOMPARE(d.stack.count(), 1);
        QVERIFY(freeze(d.document, now + 1).isEmpty() || d.document.painting()->find(2)->driesAt() > now + 1);
        d.stack.undo();
        QVERIFY(*d.document.painting() == *before);
    }

    void rewettingIsAddedCutAndRemoved()
    {
        Desk d(timedPainting(1));
        select(d.document, {1});
        d.push(rewet(d.document, 5 * second, 2 * second));
        d.push(rewet(d.document, 3 * second, second));
        d.push(rewet(d.document, 1'100'000, second)); // the last two are not there yet
        const std::vector<Rewet> later{{3 * second, second}, {5 * second, 2 * second}};
        QCOMPARE(d.stroke(1).segments[3].rewet, later);
        QCOMPARE(d.stroke(1).segments[0].rewet.size(), std::size_t(3));
        QCOMPARE(d.stroke(1).segments[3].age(4 * second), 2.0);
        QCOMPARE(d.stroke(1).driesAt(), 7 * second);
        const double before = d.stroke(1).segments[3].age(5'500'000);
        d.push(freeze(d.document, 5'500'000));
        QCOMPARE(d.stroke(1).segments[3].rewet, (std::vector<Rewet>{{3 * second, second}, {5 * second, second / 2}}));
        QCOMPARE(d.stroke(1).segments[3].age(9 * second), before);
        select(d.document, {1}, {{1, 3}});
        d.push(removeRewetting(d.document));
        QVERIFY(d.stroke(1).segments[3].rewet.empty());
        QVERIFY(!d.stroke(1).segments[2].rewet.empty());
        QVERIFY(removeRewetting(d.document).isEmpty());
        QVERIFY(rewet(d.document, 5 * second, 0).isEmpty());
    }

    /// An erasure does not spread again with its stroke, unless it is selected itself.
    void erasuresAreNotWettedAgain()
    {
        auto painting = std::make_shared<Painting>(*timedPainting(1));
        auto stroke = std::make_shared<Stroke>(*painting->strokes[0]);
        Segment lift = stroke->segments.front();
        lift.start = lift.lift = true;
        stroke->segments.push_back(lift);
        painting->strokes[0] = stroke;
        Desk d(painting);
        select(d.document, {1});
        d.push(rewet(d.document, 5 * second, second));
        QCOMPARE(d.stroke(1).segments[0].rewet.size(), std::size_t(1));
        QVERIFY(d.stroke(1).segments.back().rewet.empty());
        select(d.document, {1}, {{1, int(stroke->segments.size()) - 1}});
        d.push(rewet(d.document, 7 * second, second));
        QCOMPARE(d.stroke(1).segments.back().rewet.size(), std::size_t(1));
    }

    /// What is drawn is the paint.
    void anErasureIsNoPartOfTheDrawing()
    {
        const PaintingPtr before = erasedLater();
        Desk d(before);
        const QByteArray first = hashOf(*before);
        select(d.document, {1});
        const Selection selection = d.document.selection();
        const Times erased{20'000'000, 20'100'000, 20'200'000};
        const auto checkDrawn = [&](const Times &paint, const Times &erasure) {
            Times all = paint;
            all.insert(all.end(), erasure.begin(), erasure.end());
            QCOMPARE(births(d.stroke(1)), all);
        };
        QCOMPARE(drawnSpan(*before, selection), (TimeSpan{second, 1'300'000}));
        d.push(stretch(*before, selection, {second, 4 * second}));
        checkDrawn({1'000'000, 2'000'000, 3'000'000, 4'000'000}, erased);
        d.push(setPace(d.document, Pace::EaseIn));
        checkDrawn({1'000'000, 2'732'051, 3'449'490, 4'000'000}, erased);
        d.push(setPace(d.document, Pace::Even));
        checkDrawn({1'000'000, 2'000'000, 3'000'000, 4'000'000}, erased);
        d.push(ease(*d.document.painting(), selection, {2, 1}));
        checkDrawn({1'000'000, 2'444'444, 3'222'222, 4'000'000}, erased);
        // Nothing is erased before the stroke is begun, and what went along comes back with it.
        d.push(stretch(*before, selection, {30 * second, 33 * second}));
        checkDrawn({30'000'000, 31'000'000, 32'000'000, 33'000'000}, {30'000'000, 30'000'000, 30'000'000});
        d.push(stretch(*before, selection, drawnSpan(*before, selection)));
        QCOMPARE(hashOf(*d.document.painting()), first);
        // The whole of it moves as one.
        d.push(retime(*before, selection, second));
        checkDrawn({2'000'000, 2'100'000, 2'200'000, 2'300'000}, {21'000'000, 21'100'000, 21'200'000});
        d.push(beginAt(*before, selection, [](Microseconds begin) { return begin + second / 2; }));
        checkDrawn({1'500'000, 1'600'000, 1'700'000, 1'800'000}, {20'500'000, 20'600'000, 20'700'000});
        checkUndoAllAndRedo(d.stack, d.document, first);
    }

    /// An erasure that is selected by itself has a time that can be changed.
    void aSelectedErasureIsRetimed()
    {
        const PaintingPtr before = erasedLater();
        Desk d(before);
        select(d.document, {1}, {{1, 4}, {1, 5}, {1, 6}});
        const Selection selection = d.document.selection();
        QCOMPARE(drawnSpan(*before, selection), (TimeSpan{20 * second, 20'200'000}));
        d.push(stretch(*before, selection, {20 * second, 22 * second}));
        QCOMPARE(births(d.stroke(1)),
                 (Times{1'000'000, 1'100'000, 1'200'000, 1'300'000, 20'000'000, 21'000'000, 22'000'000}));
    }

    /// Paint before and behind an erasure in the list of segments is one run: the pen did not rest between.
    void anErasureDoesNotEndARun()
    {
        auto painting = std::make_shared<Painting>(*erasedLater());
        auto stroke = std::make_shared<Stroke>(*painting->strokes[0]);
        stroke->segments[2].start = true;
        std::rotate(stroke->segments.begin() + 2, stroke->segments.begin() + 4, stroke->segments.end());
        painting->strokes[0] = stroke;
        Desk d(painting);
        select(d.document, {1});
        d.push(stretch(*painting, d.document.selection(), {second, second}));
        d.push(stretch(*d.document.painting(), d.document.selection(), {second, 4 * second}));
        QCOMPARE(births(d.stroke(1)),
                 (Times{1'000'000, 2'000'000, 20'000'000, 20'100'000, 20'200'000, 3'000'000, 4'000'000}));
    }

    void oneRewettingOfManyIsRemoved()
    {
        Desk d(timedPainting(2));
        const QByteArray first = hashOf(*d.document.painting());
        select(d.document, {1, 2});
        d.push(rewet(d.document, 4 * second, second));
        d.push(rewet(d.document, 6 * second, second / 2));
        d.push(rewet(d.document, 6 * second, second));
        select(d.document, {1}, {{1, 2}});
        d.push(removeRewetting(d.document, {6 * second, second / 2}));
        QCOMPARE(d.stroke(1).segments[1].rewet.size(), std::size_t(3));
        QCOMPARE(d.stroke(1).segments[2].rewet, (std::vector<Rewet>{{4 * second, second}, {6 * second, second}}));
        QVERIFY(removeRewetting(d.document, {5 * second, second}).isEmpty());
        checkUndoAllAndRedo(d.stack, d.document, first);
    }

    /// Parts of a stroke that is cut stay beside each other, also where the stroke was raised over later ones.
    void whatIsCutInThePastKeepsItsPlace()
    {
        Desk d(timedPainting(3));
        select(d.document, {1});
        d.push(arrangeSelection(d.document, Arrange::Top));
        Edit cut = splitAt(d.document, {{1, {{2, 0}}}});
        QCOMPARE(cut.strokes.size(), std::size_t(2));
        d.push(placedInTime(d.document, std::move(cut)));
        const StrokeList &strokes = d.document.painting()->strokes;
        QCOMPARE(strokes.size(), std::size_t(4));
        QCOMPARE(strokes[0]->id, StrokeId(2));
        QCOMPARE(strokes[1]->id, StrokeId(3));
        QCOMPARE(strokes[2]->id, StrokeId(1));
        QCOMPARE(strokes[3]->born(), strokes[2]->segments.back().born + second / 10);
    }

    void aStrokeOfThePastTakesItsPlace()
    {
        Desk d(timedPainting(4));
        auto painted = std::make_shared<Stroke>(*makeStroke(d.document.takeStrokeId(), 0, 0));
        for (Segment &s : painted->segments)
            s.born = 2'500'000;
        d.push(placedInTime(d.document, addStrokes(d.document, {painted}, false)));
        QCOMPARE(orderOf(d.document), (std::vector<StrokeId>{1, 2, painted->id, 3, 4}));
        d.stack.undo();
        QCOMPARE(orderOf(d.document), (std::vector<StrokeId>{1, 2, 3, 4}));
        QCOMPARE(placeInTime(*d.document.painting(), 0).index, std::size_t(0));
        QCOMPARE(placeInTime(*d.document.painting(), 9 * second).index, std::size_t(4));
        // An old stroke that was raised does not lift it over those that come later.
        select(d.document, {1});
        d.push(arrangeSelection(d.document, Arrange::Top));
        d.push(placedInTime(d.document, addStrokes(d.document, {painted}, false)));
        QCOMPARE(orderOf(d.document), (std::vector<StrokeId>{2, painted->id, 3, 4, 1}));
        // An edit that adds nothing stays what it is.
        select(d.document, {2});
        const Edit raise = arrangeSelection(d.document, Arrange::Raise);
        QCOMPARE(placedInTime(d.document, raise).order, raise.order);
    }

    void aTextOfThePastTakesItsPlace()
    {
        for (const bool within : {false, true}) {
            auto painting = std::make_shared<Painting>(*timedPainting(4));
            if (within) {
                painting->groups = {{1, {}, 0, true, false}};
                for (const std::size_t i : {1u, 2u}) {
                    auto member = std::make_shared<Stroke>(*painting->strokes[i]);
                    member->group = 1;
                    painting->strokes[i] = member;
                }
            }
            Desk d(painting);
            const QByteArray first = hashOf(*d.document.painting());
            std::vector<StrokeId> letters;
            Edit edit;
            edit.groups = painting->groups;
            edit.groups->push_back({7, {}, 0, true, false});
            edit.order = orderOf(d.document);
            for (int i = 0; i < 3; ++i) {
                auto letter = std::make_shared<Stroke>(*makeStroke(d.document.takeStrokeId(), 0, 0));
                letter->group = 7;
                for (Segment &s : letter->segments)
                    s.born = 2'500'000 + (i == 0 ? second : 0);
                edit.order->push_back(letter->id);
                letters.push_back(letter->id);
                edit.strokes.emplace(letter->id, std::move(letter));
            }
            d.push(placedInTime(d.document, std::move(edit)));
            QCOMPARE(orderOf(d.document), (std::vector<StrokeId>{1, 2, letters[0], letters[1], letters[2], 3, 4}));
            QCOMPARE(d.document.painting()->groups.back().parent, GroupId(within ? 1 : 0));
            QCOMPARE(d.stroke(letters[1]).group, GroupId(7));
            d.stack.undo();
            QCOMPARE(hashOf(*d.document.painting()), first);
        }
    }

    void groupsStayTogether()
    {
        for (const bool locked : {false, true}) {
            auto painting = std::make_shared<Painting>(*timedPainting(4));
            painting->groups = {{1, {}, 0, true, false}, {2, {}, 1, true, locked}};
            for (const std::size_t i : {1u, 2u}) {
                auto member = std::make_shared<Stroke>(*painting->strokes[i]);
                member->group = 2;
                painting->strokes[i] = member;
            }
            Desk d(painting);
            auto painted = std::make_shared<Stroke>(*makeStroke(d.document.takeStrokeId(), 0, 0));
            for (Segment &s : painted->segments)
                s.born = 2'500'000;
            d.push(placedInTime(d.document, addStrokes(d.document, {painted}, false)));
            const std::vector<StrokeId> within{1, 2, painted->id, 3, 4}, below{1, painted->id, 2, 3, 4};
            QCOMPARE(orderOf(d.document), locked ? below : within);
            QCOMPARE(d.stroke(painted->id).group, GroupId(locked ? 1 : 2));
        }
    }

    void randomRetimingComesBack()
    {
        std::mt19937 random(7);
        const auto below = [&random](int n) { return int(random() % unsigned(n)); };
        Desk d(timedPainting(5));
        const QByteArray first = hashOf(*d.document.painting());
        for (int i = 0; i < 400; ++i) {
            std::set<StrokeId> strokes;
            std::set<SegmentRef> segments;
            for (int k = below(3); k >= 0; --k) {
                const auto id = StrokeId(1 + below(5));
                strokes.insert(id);
                if (below(2))
                    segments.insert({id, below(4)});
            }
            select(d.document, strokes, segments);
            const Selection selection = d.document.selection();
            const PaintingPtr now = d.document.painting();
            const Microseconds T = below(8'000'000);
            switch (below(6)) {
            case 0:
                d.push(retime(*now, selection, below(4'000'000) - 2'000'000));
                break;
            case 1:
                d.push(stretch(*now, selection, {T, T + below(3'000'000)}));
                break;
            case 2:
                d.push(setPace(d.document, Pace(below(4))));
                break;
            case 3:
                d.push(rewet(d.document, T, below(2'000'000)));
                break;
            case 4:
                d.push(removeRewetting(d.document));
                break;
            default:
                d.push(freeze(d.document, T));
            }
            QVERIFY(d.document.painting()->strokes.front()->born() >= 0);
            if (below(6) == 0)
                d.stack.undo();
        }
        QVERIFY(d.stack.index() > 100);
        checkUndoAllAndRedo(d.stack, d.document, first);
    }
};

QTEST_GUILESS_MAIN(TestTimeEdits)
#include "test_time_edits.moc"

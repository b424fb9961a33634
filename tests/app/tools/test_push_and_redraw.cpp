// Push, Comb, Pinch, Roughen and Redraw as a hand uses them in the window.
#include "app/session/settings/settings.h"
#include "app/tools/shaping/push_tool.h"
#include "app/tools/shaping/redraw_tool.h"
#include "model/shaping/curves/split.h"
#include "tests/app/trunk.h"

#include <QTemporaryDir>

using namespace suffuse;

namespace {

/// The trunk, selected, with Push in hand.
struct PushSession : TrunkSession {
    PushSession(TweakKind kind, double radius)
    {
        use(Command::Push);
        tool().setKind(kind);
        tool().setRadius(radius);
        tool().setStrength(1);
    }
    PushTool &tool() { return *qobject_cast<PushTool *>(canvas().tool()); }
    const Stroke &shape() { return stroke(trunk); }
    void lift(Point to) { QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, at(to)); }
};

struct RedrawSession : TrunkSession {
    RedrawSession() { use(Command::Redraw); }
    RedrawTool &tool() { return *qobject_cast<RedrawTool *>(canvas().tool()); }
    const Stroke &shape() { return stroke(trunk); }
    /// Draws along points in many reports.
    void draw(const std::vector<Point> &line, bool lift = true)
    {
        QTest::mousePress(&canvas(), Qt::LeftButton, {}, at(line.front()));
        for (std::size_t i = 1; i < line.size(); ++i)
            for (int k = 1; k <= 12; ++k) {
                advance(8000);
                move(line[i - 1] + (k / 12.0) * (line[i] - line[i - 1]));
            }
        if (lift)
            QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, at(line.back()));
    }
};

Point middleOf(const Stroke &stroke)
{
    const std::size_t k = stroke.segments.size() / 2;
    return stroke.cubicOf(stroke.segments[k]).at(0.5);
}

double distanceTo(const Stroke &stroke, Point point)
{
    double distance = 0;
    nearestPlace(stroke, point, &distance);
    return distance;
}

/// The mean angle between some segments and a direction, or its opposite, in degrees.
double meanAngle(const Stroke &stroke, int first, int last, Point direction)
{
    double sum = 0;
    for (int k = first; k <= last; ++k) {
        const Point d = stroke.cubicOf(stroke.segments[std::size_t(k)]).derivative(0.5);
        sum += std::atan2(std::abs(cross(d, direction)), std::abs(dot(d, direction)));
    }
    return sum / (last - first + 1) * 180 / std::numbers::pi;
}

/// The greatest turn at a node, radians.
double sharpestNode(const Stroke &stroke)
{
    double most = 0;
    for (std::size_t k = 1; k < stroke.segments.size(); ++k) {
        const Point a = endDirection(offsetsOf(stroke.segments[k - 1])),
                    b = startDirection(offsetsOf(stroke.segments[k]));
        most = std::max(most, std::abs(std::atan2(cross(a, b), dot(a, b))));
    }
    return most;
}

} // namespace

class TestPushAndRedraw : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }
    void cleanup() { settings::store().remove("tools"); }

    void pushTakesTheStrokeAlong()
    {
        PushSession s(TweakKind::Push, 60);
        const Stroke before = s.shape();
        const int steps = s.steps();
        const Point from = middleOf(before) - Point{20, 0}, to = from + Point{60, 0};
        s.drag(from, to);
        QCOMPARE(s.steps(), steps + 1);
        QCOMPARE(s.editor().undoText(), QString("Push strokes"));
        const Point pushed = middleOf(before) + Point{40, 0};
        QVERIFY2(distanceTo(s.shape(), pushed) < 25, qPrintable(QString::number(distanceTo(s.shape(), pushed))));
        QVERIFY(distanceTo(s.shape(), middleOf(before)) > 15);
        QVERIFY(cornersOf(s.shape()).empty());
        // What is far away is the same, and so are values everywhere.
        QVERIFY(s.shape().segments.front() == before.segments.front());
        QVERIFY(s.shape().segments.back() == before.segments.back());
        for (const Segment &segment : s.shape().segments)
            QVERIFY(std::any_of(before.segments.begin(), before.segments.end(), [&](Segment other) {
                other.bezier = segment.bezier;
                other.node = segment.node;
                other.start = segment.start;
                return other == segment;
            }));
        s.use(Command::Undo);
        QVERIFY(s.shape() == before);
        s.use(Command::Redo);
        QVERIFY(!(s.shape() == before));
    }

    void combTurnsStrokesIntoTheDrag()
    {
        PushSession s(TweakKind::Comb, 60);
        s.tool().setStrength(0.3);
        const Stroke before = s.shape();
        const int middle = int(before.segments.size()) / 2;
        const Point along = before.cubicOf(before.segments[std::size_t(middle)]).derivative(0.5);
        const Point way = unit(along + 0.8 * Point{-along.y, along.x}); // forty degrees aside
        const Point at = middleOf(before);
        const int steps = s.steps();
        s.drag(at - 12 * way, at + 12 * way);
        QCOMPARE(s.steps(), steps + 1);
        QCOMPARE(s.editor().undoText(), QString("Comb strokes"));
        QCOMPARE(s.shape().segments.size(), before.segments.size());
        const double was = meanAngle(before, middle - 8, middle + 8, way);
        const double is = meanAngle(s.shape(), middle - 8, middle + 8, way);
        QVERIFY2(is < was - 10, qPrintable(QString("%1 %2").arg(was).arg(is)));
        QVERIFY(s.shape().segments.front() == before.segments.front());
        QVERIFY(s.shape().segments.back() == before.segments.back());
        QVERIFY(sharpestNode(s.shape()) < 0.2);
    }

    void combTurnsAFreeEnd()
    {
        PushSession s(TweakKind::Comb, 70);
        s.tool().setStrength(0.5);
        const Stroke before = s.shape();
        const int n = int(before.segments.size());
        const Point tip = nodePosition(before, n);
        const double was = meanAngle(before, n - 30, n - 1, {1, 0});
        s.drag(tip + Point{-15, 25}, tip + Point{35, 25});
        const double is = meanAngle(s.shape(), n - 30, n - 1, {1, 0});
        QVERIFY2(is < was - 20, qPrintable(QString("%1 %2").arg(was).arg(is)));
        QVERIFY(nodePosition(s.shape(), n).x > tip.x + 10); // It goes where the hand goes.
        s.use(Command::Undo);
        s.drag(tip + Point{15, 25}, tip + Point{-35, 25});
        QVERIFY(nodePosition(s.shape(), n).x < tip.x - 10);
        QVERIFY(s.shape().segments.front() == before.segments.front());
    }

    void pinchAndRoughenGoOnWhileThePointerStays()
    {
        for (const TweakKind kind : {TweakKind::Pinch, TweakKind::Roughen}) {
            PushSession s(kind, 50);
            const Stroke before = s.shape();
            const Point at = middleOf(before) + Point{20, 0};
            QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at(at));
            const Stroke once = s.shape();
            QVERIFY(!(once == before));
            QTRY_VERIFY(!(s.shape() == once));
            s.lift(at);
            const Stroke after = s.shape();
            QTest::qWait(120);
            QVERIFY(s.shape() == after); // no more of it
            if (kind == TweakKind::Pinch)
                QVERIFY(distanceTo(after, at) < distanceTo(before, at) - 1);
            s.use(Command::Undo);
            QVERIFY(s.shape() == before);
        }
    }

    void shiftPinchesApart()
    {
        PushSession s(TweakKind::Pinch, 50);
        const Stroke before = s.shape();
        const Point at = middleOf(before) + Point{15, 0};
        s.drag(at, at + Point{0, 12}, Qt::ShiftModifier);
        QVERIFY(distanceTo(s.shape(), at) > distanceTo(before, at) + 1);
    }

    void roughenLeavesNoTraceOfItsSteps()
    {
        PushSession s(TweakKind::Roughen, 60);
        const Stroke before = s.shape();
        const Point at = middleOf(before);
        s.drag(at - Point{0, 60}, at + Point{0, 60});
        QVERIFY(!(s.shape() == before));
        QVERIFY(sharpestNode(s.shape()) < 1); // rough, and no hairpins
        QCOMPARE(s.editor().undoText(), QString("Roughen strokes"));
    }

    void escapeGivesAPushUp()
    {
        for (const TweakKind kind : {TweakKind::Push, TweakKind::Comb, TweakKind::Pinch, TweakKind::Roughen}) {
            PushSession s(kind, 60);
            const Stroke before = s.shape();
            const int steps = s.steps();
            const Point at = middleOf(before);
            s.drag(at - Point{30, 20}, at + Point{30, 0}, {}, false);
            QVERIFY(!(s.shape() == before));
            QTest::keyClick(&s.canvas(), Qt::Key_Escape);
            s.lift(at);
            QVERIFY(s.shape() == before);
            QCOMPARE(s.steps(), steps);
        }
    }

    void lettersAreLeftAloneUnlessSelected()
    {
        for (const TweakKind kind : {TweakKind::Push, TweakKind::Comb, TweakKind::Pinch, TweakKind::Roughen}) {
            PushSession s(kind, 80);
            // The wave is the one letter of a text.
            Painting painting = s.painting();
            Group title;
            title.id = 1;
            title.text = SharedText(Text{});
            painting.groups.push_back(title);
            StrokePtr &letter =
                *std::ranges::find_if(painting.strokes, [&](const StrokePtr &p) { return p->id == s.id; });
            Stroke member = *letter;
            member.group = 1;
            letter = std::make_shared<const Stroke>(member);
            s.editor().document().reset(std::make_shared<const Painting>(painting));
            s.editor().document().setSelection({});
            const Stroke wave = s.stroke();
            s.drag({600, 300}, {640, 330});
            QVERIFY(s.stroke() == wave);
            QVERIFY2(s.tool().hint().startsWith("Letters"), qPrintable(s.tool().hint()));
            s.editor().document().setSelection({{s.id}, {}});
            s.drag({600, 300}, {640, 330});
            QVERIFY(!(s.stroke() == wave));
            QVERIFY(!s.tool().hint().startsWith("Letters"));
        }
    }

    void pushKeepsToWhatMayBeChanged()
    {
        PushSession s(TweakKind::Push, 80);
        const Stroke wave = s.stroke();
        s.drag({300, 300}, {340, 330}); // the trunk is selected, and the wave is not
        QVERIFY(s.stroke() == wave);
        s.editor().document().setSelection({});
        s.drag({300, 300}, {340, 330});
        QVERIFY(!(s.stroke() == wave));
        s.editor().push(changeStrokes(s.editor().document(), {s.id, s.trunk}, [](Stroke &t) { t.locked = true; }),
                        "lock");
        const auto locked = s.editor().document().painting();
        s.drag({300, 300}, {340, 330});
        QVERIFY(s.painting() == *locked);
        // Where a stroke is not painted yet there is nothing to push.
        s.use(Command::Undo);
        s.editor().clock().setTime(-1);
        const auto past = s.editor().document().painting();
        s.drag({300, 300}, {340, 330});
        QVERIFY(s.painting() == *past);
    }

    void redrawMakesThePartFollow()
    {
        RedrawSession s;
        const Stroke before = s.shape();
        const int steps = s.steps(), n = int(before.segments.size());
        const Point a = nodePosition(before, n / 4), b = nodePosition(before, 3 * n / 4);
        const Point aside = 0.5 * (a + b) + Point{120, 0};
        s.draw({a, a + 0.5 * (aside - a) + Point{20, 10}, aside, b + 0.5 * (aside - b) + Point{20, -10}, b});
        QCOMPARE(s.steps(), steps + 1);
        QCOMPARE(s.editor().undoText(), QString("Redraw"));
        const Stroke after = s.shape();
        QVERIFY2(distanceTo(after, aside) < 6, qPrintable(QString::number(distanceTo(after, aside))));
        QVERIFY(distanceTo(after, nodePosition(before, n / 2)) > 40);
        QVERIFY(after.segments.front() == before.segments.front());
        QVERIFY(after.segments.back() == before.segments.back());
        QCOMPARE(after.id, before.id);
        QCOMPARE(chainsOf(after).size(), std::size_t(1));
        QVERIFY2(sharpestNode(after) < 0.35, qPrintable(QString::number(sharpestNode(after)))); // no break at the ends
        // The times that were there, by the way along it.
        for (std::size_t k = 1; k < after.segments.size(); ++k)
            QVERIFY(after.segments[k].born >= after.segments[k - 1].born);
        QCOMPARE(after.born(), before.born());
        s.use(Command::Undo);
        QVERIFY(s.shape() == before);
    }

    void redrawToAnEndReplacesTheTop()
    {
        RedrawSession s;
        const Stroke before = s.shape();
        const int n = int(before.segments.size());
        const Point from = nodePosition(before, 2 * n / 3), up = from + Point{15, -60}, top{420, 60};
        s.draw({from, up, top});
        const Stroke after = s.shape();
        QVERIFY(length(nodePosition(after, int(after.segments.size())) - top) < 3);
        QVERIFY(after.segments.front() == before.segments.front());
        QVERIFY(distanceTo(after, nodePosition(before, n)) > 20);
        QCOMPARE(after.segments.back().density, before.segments.back().density); // the tapered end
    }

    void redrawTakesTheValuesOfTheBrush()
    {
        RedrawSession s;
        Brush brush = s.editor().brush();
        brush.colour = {0, 1, 0, 1};
        s.editor().setBrush(brush);
        const Stroke before = s.shape();
        const int n = int(before.segments.size());
        const Point a = nodePosition(before, n / 4), b = nodePosition(before, n / 2);
        const auto coloured = [&] {
            return std::count_if(s.shape().segments.begin(), s.shape().segments.end(),
                                 [](const Segment &k) { return k.colour.yellow == 1 && k.colour.red == 0; });
        };
        s.draw({a, 0.5 * (a + b) + Point{60, 0}, b});
        QCOMPARE(coloured(), 0);
        s.use(Command::Undo);
        s.tool().setValues(RedrawValues::Line);
        s.draw({a, 0.5 * (a + b) + Point{60, 0}, b});
        QVERIFY(coloured() > 3);
        QVERIFY(s.shape().segments.front() == before.segments.front());
    }

    void redrawGivesUpAndSaysWhy()
    {
        RedrawSession s;
        const auto before = s.editor().document().painting();
        const int steps = s.steps(), n = int(s.shape().segments.size());
        const Point a = nodePosition(s.shape(), n / 4), b = nodePosition(s.shape(), n / 2);
        s.draw({a, a + Point{60, -40}, b}, false);
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at(b));
        QVERIFY(s.painting() == *before);
        const QString usual = s.tool().hint();
        s.draw({{600, 500}, {700, 550}, {650, 600}});
        QVERIFY(s.painting() == *before);
        QVERIFY(s.tool().hint() != usual);
        s.draw({{200, 300}, {300, 250}, {400, 300}}); // at the wave, which is not selected
        QVERIFY(s.painting() == *before);
        QCOMPARE(s.steps(), steps);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestPushAndRedraw)
#include "test_push_and_redraw.moc"

// The bucket fills what paint bounds.
#include "app/tools/shapes/bucket_tool.h"
#include "app/tools/shapes/shape_paint.h"
#include "model/area/area_sets.h"
#include "model/area/outline.h"
#include "model/brush/brush_width.h"
#include "model/painting/validate.h"
#include "model/shaping/curves/chains.h"
#include "model/shaping/nodes/reshape.h"
#include "tests/app/session.h"
#include "undo/edits.h"

#include <QComboBox>
#include <QSignalSpy>
#include <QTemporaryDir>

using namespace suffuse;

namespace {

struct Filling : Session {
    Filling()
    {
        use(Command::Zoom100);
        use(Command::Bucket);
        tool().setWish({}, false);
    }

    BucketTool &tool() { return *qobject_cast<BucketTool *>(canvas().tool()); }
    /// A line of paint along the shape between two points, dry, but for so much of its end.
    void paint(Point a, Point b, double open = 0)
    {
        std::vector<Cubic> curves = outlineOf({}, a, b);
        if (open > 0) {
            const Cubic last = curves.back();
            curves.back() = last.split(1 - open / length(last.p[3] - last.p[0]))[0];
        }
        const StrokePtr line = paintedAlong(curves, editor().brush(), editor().document().takeStrokeId(),
                                            editor().clock().time(), ShapePaint::Outline);
        editor().push(addStrokes(editor().document(), {line}, false), "line");
        editor().clock().setTime(painting().end());
    }
    const Stroke &filled()
    {
        for (const StrokePtr &stroke : painting().strokes)
            if (stroke->fill)
                return *stroke;
        return *painting().strokes.back();
    }
    int steps() { return editor().undoStack().count(); }
    bool isBusy() { return canvas().tool()->isBusy(); }
    /// A click, and the work on it.
    void fillAt(Point where)
    {
        click(where);
        QVERIFY(isBusy());
        QTRY_VERIFY_WITH_TIMEOUT(!isBusy(), waitMs);
    }
    /// Two rooms with a wall between them.
    void paintRooms()
    {
        paint({200, 200}, {400, 400});
        paint({400, 200}, {600, 400});
    }
};

double extentOf(const Stroke &stroke)
{
    return sizeOf(areaOf(closedOutline(stroke), stroke.fill->rule));
}

double leftOf(const Stroke &stroke)
{
    double left = nodePosition(stroke, 0).x;
    for (int node = 1; node < nodeCount(stroke); ++node)
        left = std::min(left, nodePosition(stroke, node).x);
    return left;
}

} // namespace

class TestBucket : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void aClickFillsWhatIsBounded()
    {
        Filling s;
        s.paint({300, 200}, {600, 400});
        s.tool().setWish({0.1, 0, 0}, false);
        s.fillAt({450, 300});
        QCOMPARE(s.steps(), 2);
        QCOMPARE(s.editor().undoText(), QString("Bucket fill"));
        const Stroke &fill = s.filled();
        QVERIFY(isFillAlone(fill));
        QCOMPARE(problemOf(fill), QString());
        QCOMPARE(fill.fill->colour, s.editor().brush().colour);
        QCOMPARE(s.painting().strokes.back()->id, fill.id); // on top
        QCOMPARE(s.selection().strokes, std::set<StrokeId>{fill.id});
        // Within the line, of which the inner half is as wide as it is seen or more.
        const double half = halfWidthOf(s.editor().brush()), extent = extentOf(fill);
        QVERIFY2(extent < (300 - 2 * half + 4) * (200 - 2 * half + 4) && extent > 0.75 * 300 * 200,
                 qPrintable(QString::number(extent)));
        QVERIFY2(fill.segments.size() < 24, qPrintable(QString::number(fill.segments.size())));
        s.use(Command::Undo);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        // Farther, under the line, and below it.
        s.tool().setWish({0.1, 0, 5}, true);
        s.fillAt({450, 300});
        QCOMPARE(s.painting().strokes.front()->id, s.filled().id);
        QVERIFY(std::abs(extentOf(s.filled()) - extent - 5 * 900) < 1200);
    }

    /// Of paint that is filled anew no rim is left, also where the view has few pixels for it.
    void itReachesUnderItsBoundsInAnyView()
    {
        for (const double zoom : {0.3, 0.65, 1.0, 2.0}) {
            Filling s;
            s.editor().setBrush(*std::ranges::find(builtinBrushes(), "brush-pen", &Brush::name)); // has crisp edges
            s.canvas().setZoom(zoom);
            const StrokePtr below =
                paintedAlong(outlineOf({.kind = ShapeKind::Ellipse}, {350, 250}, {600, 450}), s.editor().brush(),
                             s.editor().document().takeStrokeId(), s.editor().clock().time(), ShapePaint::Fill);
            s.editor().push(addStrokes(s.editor().document(), {below}, false), "ellipse");
            s.editor().clock().setTime(s.painting().end());
            s.editor().setColour({0.1f, 0.9f, 0.6f, 1});
            s.fillAt({475, 350});
            QCOMPARE(s.painting().strokes.size(), std::size_t(2));
            const double was = extentOf(*below), is = extentOf(*s.painting().strokes.back());
            constexpr double around = 710; // units; a rim of a pixel would be as wide as half a unit or more
            QVERIFY2(is > was - 0.25 * around && is < was + 4 * around,
                     qPrintable(QString("%1: %2 of %3").arg(zoom).arg(is).arg(was)));
        }
    }

    void holesStayOpen()
    {
        Filling s;
        s.paint({200, 150}, {700, 500});
        s.paint({400, 250}, {500, 350});
        s.fillAt({300, 300});
        const Stroke &fill = s.filled();
        QCOMPARE(chainsOf(fill).size(), std::size_t(2));
        QVERIFY(extentOf(fill) < 500 * 350 - 100 * 100);
    }

    void gapsAreClosed()
    {
        Filling s;
        s.paint({300, 200}, {600, 400}, 30);
        s.fillAt({450, 300});
        const double all = extentOf(s.filled());
        QVERIFY(all > 100'000); // it runs out
        s.use(Command::Undo);
        s.tool().setWish({0.1, 40, 0}, false);
        s.fillAt({450, 300});
        QVERIFY2(extentOf(s.filled()) < 65'000, qPrintable(QString::number(extentOf(s.filled()))));
    }

    void whatIsNowhereIsSaid()
    {
        Filling s;
        s.canvas().panBy({-400, 0});
        const Rect sheet = s.painting().canvas.area();
        s.fillAt({sheet.right + 50, 300});
        QCOMPARE(s.steps(), 0);
        QVERIFY(s.tool().hint().contains("canvas"));
        s.fillAt({sheet.right - 50, 300}); // an empty sheet is filled as a whole
        QCOMPARE(s.steps(), 1);
        QVERIFY(std::abs(extentOf(s.filled()) - sheet.width() * sheet.height()) <
                0.01 * sheet.width() * sheet.height());
        QVERIFY(!s.tool().hint().contains("lies on"));
    }

    /// The window goes on while a region is looked for, and says so.
    void itIsWorkedOnAside()
    {
        Filling s;
        s.paintRooms();
        QSignalSpy busy(&s.canvas(), &CanvasWidget::busyChanged);
        const QString hint = s.tool().hint();
        s.click({300, 300});
        QVERIFY(s.isBusy());
        QCOMPARE(s.steps(), 2); // It is not done before the event loop comes round.
        QVERIFY(s.tool().hint() != hint && s.tool().hint().contains("Esc"));
        QCOMPARE(s.canvas().cursor().shape(), Qt::BusyCursor);
        busy.clear();
        QTRY_VERIFY_WITH_TIMEOUT(!s.isBusy(), waitMs);
        QCOMPARE(busy.count(), 1);
        QCOMPARE(s.canvas().cursor().shape(), Qt::CrossCursor);
        QCOMPARE(s.tool().hint(), hint);
        QCOMPARE(s.steps(), 3);
    }

    /// What is given up is never heard of again, and leaves the painting as it was.
    void itIsGivenUp()
    {
        Filling s;
        s.paintRooms();
        const PaintingPtr before = s.editor().document().painting();
        const QString hint = s.tool().hint();
        const std::function<void()> ways[] = {
            [&] { QTest::keyClick(&s.canvas(), Qt::Key_Escape); },
            [&] { s.use(Command::Undo); },
            [&] { s.use(Command::Delete); },
            [&] {
                s.use(Command::Brush);
                s.use(Command::Bucket);
            },
        };
        for (const auto &giveUp : ways) {
            s.click({300, 300});
            QVERIFY(s.isBusy());
            giveUp();
            QVERIFY(!s.isBusy());
            QCOMPARE(s.tool().hint(), hint);
            QCOMPARE(s.canvas().cursor().shape(), Qt::CrossCursor);
            QCOMPARE(s.editor().document().painting(), before);
        }
        s.fillAt({500, 300}); // It waits for the threads before it, whose fills would be there by now.
        QCOMPARE(s.steps(), 3);
        QCOMPARE(s.painting().strokes.size(), std::size_t(3));
        QVERIFY(leftOf(s.filled()) > 390);
    }

    /// What was found in another picture bounds nothing any more.
    void whatIsFoundInAnotherPaintingIsDropped()
    {
        Filling s;
        s.paintRooms();
        s.click({300, 300});
        s.paint({250, 250}, {350, 350});
        QTRY_VERIFY_WITH_TIMEOUT(!s.isBusy(), waitMs);
        QCOMPARE(s.steps(), 3);
        QVERIFY2(s.tool().hint().contains("changed"), qPrintable(s.tool().hint()));
        s.fillAt({300, 300});
        QCOMPARE(s.steps(), 4);
        QVERIFY(!s.tool().hint().contains("changed"));
    }

    /// Each with the brush of its own click, in the picture with the fills before it. Undo takes back the last click.
    void clicksThatComeMeanwhileWait()
    {
        Filling s;
        s.paintRooms();
        const std::array colours{Colour{0.1f, 0.9f, 0.6f, 1}, Colour{0.9f, 0.1f, 0.2f, 1}};
        for (const bool takesBack : {false, true}) {
            const int before = s.steps();
            s.editor().setColour(colours[0]);
            s.click({300, 300});
            s.editor().setColour(colours[1]);
            s.click({300, 310}); // fills what the first one has filled
            s.click({500, 300});
            s.editor().setColour(colours[0]);
            if (takesBack) {
                s.use(Command::Undo);
                s.use(Command::Undo);
                QVERIFY(s.isBusy());
            }
            QTRY_VERIFY_WITH_TIMEOUT(!s.isBusy(), waitMs);
            QCOMPARE(s.steps() - before, takesBack ? 1 : 3);
            const auto &strokes = s.painting().strokes;
            if (!takesBack) {
                QCOMPARE(strokes[2]->fill->colour, colours[0]);
                QCOMPARE(strokes[3]->fill->colour, colours[1]);
                QCOMPARE(strokes[4]->fill->colour, colours[1]);
                QVERIFY(std::abs(extentOf(*strokes[3]) - extentOf(*strokes[2])) < 0.1 * extentOf(*strokes[2]));
                QVERIFY(leftOf(*strokes[4]) > 390);
            }
        }
        s.click({300, 300});
        s.click({500, 300});
        QTest::keyClick(&s.canvas(), Qt::Key_Escape); // gives up all of them
        QVERIFY(!s.isBusy());
        QCOMPARE(s.steps(), 6);
    }

    /// A double click is one fill, not two that lie on each other.
    void aDoubleClickFillsOnce()
    {
        Filling s;
        s.paintRooms();
        s.click({300, 300});
        QTest::mouseDClick(&s.canvas(), Qt::LeftButton, {}, s.at({300, 300}));
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({300, 300}));
        QTRY_VERIFY_WITH_TIMEOUT(!s.isBusy(), waitMs);
        QCOMPARE(s.steps(), 3);
    }

    /// The window may go at any time.
    void theWindowMayGoMeanwhile()
    {
        for (int i = 0; i < 3; ++i) {
            Filling s;
            s.click({300, 300});
            if (i == 1)
                s.click({310, 300});
            QVERIFY(s.isBusy());
        }
    }

    void theRowIsRemembered()
    {
        Filling s;
        s.tool().setWish({0.25, 7, -3}, true);
        Session next;
        next.use(Command::Bucket);
        const auto &tool = *qobject_cast<BucketTool *>(next.canvas().tool());
        QCOMPARE(tool.wish().tolerance, 0.25);
        QCOMPARE(tool.wish().gap, 7.0);
        QCOMPARE(tool.wish().grow, -3.0);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestBucket)
#include "test_bucket.moc"

// Drags that float: pictures in place of edits while the hand moves, and what the document has when it rests.
#include "app/session/settings/settings.h"
#include "tests/app/selecting.h"
#include "tests/app/slow_renderer.h"
#include "tests/app/worker_frames.h"
#include "undo/edits.h"
#include "undo/layers/group_edits.h"

#include <QSettings>
#include <QTemporaryDir>

#include <random>

using namespace suffuse;

namespace {

/// Says that it was slow, so that nothing that is dragged is believed to be quick.
Result<std::unique_ptr<Renderer>> makeSlowRenderer(const RendererOptions &options)
{
    return makeSlow(options, [](const RenderRequest &, RenderStats &stats) { stats.totalMs += 2000; });
}

/// Says that it took hardly any time, as on a machine that has nothing else to do.
Result<std::unique_ptr<Renderer>> makeQuickRenderer(const RendererOptions &options)
{
    return makeSlow(options, [](const RenderRequest &, RenderStats &stats) { stats.totalMs = 0.01; });
}

StrokeList threeLines()
{
    return {line(1, {300, 250}, {480, 330}), line(2, {320, 420}, {500, 400}), line(3, {560, 200}, {620, 500})};
}

/// Three lines, the first two selected; its drags float.
struct Floats : Selecting {
    int composed = 0, exact = 0, coarse = 0;
    bool isLastExact = false; ///< of the frames on the screen
    int rested = 0;           ///< the hand, for long enough: then the document has what floated

    explicit Floats(MakeRenderer make = makeSlowRenderer) : Selecting(threeLines(), std::move(make))
    {
        QObject::connect(&canvas(), &CanvasWidget::framePresented, &window, [this](const FrameInfo &frame) {
            (frame.floats ? composed : exact) += frame.error.isEmpty() && (frame.floats || frame.isExact());
            coarse += frame.coarseness > 1;
            isLastExact = frame.error.isEmpty() && !frame.floats && frame.isExact();
        });
        QObject::connect(&editor(), &Editor::dragEnded, &window, [this] { ++rested; });
        select({1, 2});
        dry();
    }
    void report(Point from, Point by) { send(QEvent::MouseMove, logical(canvas().view().toPixels(from + by)), none); }
    void press(Point from) { send(QEvent::MouseButtonPress, logical(canvas().view().toPixels(from)), none); }
    void release(Point at) { send(QEvent::MouseButtonRelease, logical(canvas().view().toPixels(at)), none); }
    /// Presses on the first stroke and moves until it floats by so much.
    bool floatBy(Point by)
    {
        press(grip);
        for (int i = 1; i <= 4; ++i)
            report(grip, (i / 4.0) * by);
        const int before = composed;
        return QTest::qWaitFor([&] { return composed > before; }, waitMs);
    }
    /// What the document has without what floats, which asking for the document would put into it.
    QByteArray unsettled() { return hashOf(*editor().unsettled().painting()); }
    double unsettledX() { return editor().unsettled().painting()->find(1)->origin.x; }
    RenderRequest shownRequest()
    {
        return {editor().document().painting(), editor().clock().time(), canvas().view(), false, false};
    }
    /// The exact picture of what the document has is on the screen.
    bool restsExactly()
    {
        if (!QTest::qWaitFor([&] { return canvas().isUpToDate() && !editor().isDragging(); }, waitMs))
            return false;
        const QImage shown = canvas().picture();
        const Pixels<std::uint32_t> wanted = pixelsOf(shownRequest());
        return std::equal(wanted.begin(), wanted.end(), reinterpret_cast<const std::uint32_t *>(shown.constBits()));
    }

    static constexpr Point grip{390, 290};
};

} // namespace

class TestFloating : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
        QVERIFY(m_folder.isValid());
    }

    void init() { settings::store().clear(); }

    void aDragFloatsAndItsEndIsExact_data()
    {
        QTest::addColumn<TransformHandle>("handle");
        QTest::addColumn<double>("rotation");
        QTest::addColumn<bool>("mirrored");
        QTest::newRow("move") << TransformHandle{Kind::Centre, 0, 0} << 0.0 << false;
        QTest::newRow("move, turned and mirrored") << TransformHandle{Kind::Centre, 0, 0} << 30.0 << true;
        QTest::newRow("scale") << TransformHandle{Kind::Scale, 1, 1} << 0.0 << false;
        QTest::newRow("scale across, turned and mirrored") << TransformHandle{Kind::Scale, 1, 0} << 30.0 << true;
        QTest::newRow("rotate") << TransformHandle{Kind::Rotate, 1, 1} << 0.0 << false;
        QTest::newRow("skew, mirrored") << TransformHandle{Kind::Skew, 0, 1} << 0.0 << true;
    }

    void aDragFloatsAndItsEndIsExact()
    {
        QFETCH(TransformHandle, handle);
        QFETCH(double, rotation);
        QFETCH(bool, mirrored);
        QByteArray ends[2];
        for (const bool floats : {true, false}) {
            Floats s(floats ? makeSlowRenderer : makeQuickRenderer);
            s.canvas().rotateBy(rotation);
            if (mirrored)
                s.canvas().mirror();
            if (handle.kind == Kind::Rotate || handle.kind == Kind::Skew) {
                s.click(Floats::grip);
                QCOMPARE(s.tool().handles().mode(), TransformHandles::Mode::Turn);
            }
            s.dry();
            const QByteArray before = hashOf(s.painting());
            const Point from = handle.kind == Kind::Centre
                                   ? Floats::grip
                                   : s.canvas().view().toCanvas(s.tool().handles().place(handle, s.canvas().view(), 1));
            s.press(from);
            QCOMPARE(s.canvas().isLifted(), floats);
            for (int i = 1; i <= 6; ++i)
                s.report(from, i * Point{11, 7});
            QVERIFY((s.unsettled() == before) == floats || s.rested > 0);
            if (floats) {
                const int composed = s.composed;
                s.report(from, {60, 40});
                QTRY_VERIFY_WITH_TIMEOUT(s.composed > composed, waitMs);
                QVERIFY(s.steps() == 0 || s.rested > 0);
            }
            s.report(from, {60, 40});
            s.release(from + Point{60, 40});
            QVERIFY(!s.canvas().isLifted());
            QCOMPARE(s.steps(), 1);
            ends[floats] = hashOf(s.painting());
            QVERIFY(ends[floats] != before);
            QVERIFY(s.restsExactly());
            s.select({3});
            s.use(Command::Undo);
            QCOMPARE(hashOf(s.painting()), before);
            QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
            QVERIFY(s.restsExactly());
        }
        QCOMPARE(ends[0], ends[1]);
    }

    void whatFloatsLooksLikeWhatWillBe()
    {
        Floats s;
        const QByteArray before = hashOf(s.painting());
        QVERIFY(s.floatBy({40, 24}));
        const QImage shown = s.canvas().picture();
        QVERIFY(s.unsettled() == before || s.rested > 0);
        s.release(Floats::grip + Point{40, 24});
        const double mean = meanDifference(argbOf(shown), pixelsOf(s.shownRequest()));
        QVERIFY2(mean < 0.2, qPrintable(QString::number(mean)));
    }

    /// A picture of some strokes over a picture of the others is not what a painting is where a group is put on the
    /// rest as a whole: whether the group is dragged, or what lies below or above it.
    void nothingFloatsWhereAGroupBlends_data()
    {
        QTest::addColumn<bool>("dragsTheGroup");
        QTest::addColumn<bool>("isVisible");
        QTest::addColumn<int>("what");
        QTest::newRow("opacity, dragged") << true << true << 0;
        QTest::newRow("opacity, beside it") << false << true << 0;
        QTest::newRow("mode, dragged") << true << true << 1;
        QTest::newRow("mode, beside it") << false << true << 1;
        QTest::newRow("isolated, dragged") << true << true << 2;
        QTest::newRow("a plain group, dragged") << true << true << 3;
        QTest::newRow("hidden, beside it") << false << false << 1;
    }

    void nothingFloatsWhereAGroupBlends()
    {
        QFETCH(bool, dragsTheGroup);
        QFETCH(bool, isVisible);
        QFETCH(int, what);
        Floats s;
        s.select(dragsTheGroup ? std::set<StrokeId>{1, 2} : std::set<StrokeId>{3});
        s.editor().push(groupSelection(s.editor().document(), {}), "group");
        const GroupId group = s.painting().groups.back().id;
        const Document &document = s.editor().document();
        if (what == 0)
            s.editor().push(setGroupOpacity(document, {group}, 0.5f), "opacity");
        else if (what == 1)
            s.editor().push(setGroupBlend(document, {group}, BlendMode::Multiply), "mode");
        else if (what == 2)
            s.editor().push(setGroupIsolated(document, {group}, true), "isolated");
        if (!isVisible)
            s.editor().push(setGroupVisible(document, group, false), "hide");
        const bool floats = what == 3 || !isVisible;
        s.select({1, 2});
        s.dry();
        const int steps = s.steps(), composed = s.composed;
        const QByteArray before = hashOf(s.painting());
        s.press(Floats::grip);
        QCOMPARE(s.canvas().isLifted(), floats);
        for (int i = 1; i <= 4; ++i) {
            s.report(Floats::grip, i * Point{10, 6});
            QTest::qWait(20);
        }
        QVERIFY(floats || near(s.unsettledX(), 340, 2)); // The document has what is shown.
        s.release(Floats::grip + Point{40, 24});
        QVERIFY(s.restsExactly());
        QVERIFY(floats || s.composed == composed);
        QCOMPARE(s.steps(), steps + 1);
        QVERIFY(near(s.stroke(1).origin.x, 340, 2) && near(s.stroke(1).origin.y, 274, 2));
        s.use(Command::Undo);
        QCOMPARE(hashOf(s.painting()), before);
        QVERIFY(s.restsExactly());
    }

    /// Where all is lifted, what is shown moves: nothing has to be drawn, and nothing is coarse.
    void allFloatsAtOnce_data()
    {
        QTest::addColumn<double>("zoom");
        QTest::newRow("within the view") << 1.0;
        QTest::newRow("beyond the view") << 4.0;
    }

    void allFloatsAtOnce()
    {
        QFETCH(double, zoom);
        Floats s;
        s.select({1, 2, 3});
        s.canvas().setZoom(zoom);
        s.canvas().lookThrough([&] {
            View view = s.canvas().view();
            view.centre = {430, 330};
            return view;
        }());
        s.dry();
        const QByteArray before = hashOf(s.painting());
        QVERIFY(s.floatBy({20, 12}));
        QCOMPARE(s.coarse, 0);
        const QImage shown = s.canvas().picture();
        QVERIFY(s.unsettled() == before || s.rested > 0);
        s.release(Floats::grip + Point{20, 12});
        QVERIFY(hashOf(s.painting()) != before);
        if (zoom == 1) { // else what comes in from beside the view is missing at first
            const double mean = meanDifference(argbOf(shown), pixelsOf(s.shownRequest()));
            QVERIFY2(mean < 0.2, qPrintable(QString::number(mean)));
        }
        QVERIFY(s.restsExactly());
        s.use(Command::Undo);
        QCOMPARE(hashOf(s.painting()), before);
        QVERIFY(s.restsExactly());
    }

    void aHandThatRestsGetsTheExactPicture()
    {
        Floats s;
        QVERIFY(s.floatBy({40, 24}));
        QVERIFY(s.restsExactly());
        QTRY_VERIFY_WITH_TIMEOUT(s.isLastExact, waitMs); // The frame is there before the window has heard of it.
        QVERIFY(near(s.stroke(1).origin.x, 340, 2));
        QVERIFY(s.canvas().isLifted());
        const int composed = s.composed, rested = s.rested;
        s.report(Floats::grip, {80, 24}); // and on
        QTRY_VERIFY_WITH_TIMEOUT(s.composed > composed, waitMs);
        QVERIFY(near(s.unsettledX(), 340, 2) || s.rested > rested);
        s.report(Floats::grip, {0, 0}); // and back
        s.release(Floats::grip);
        QCOMPARE(s.stroke(1).origin, (Point{300, 250}));
        QCOMPARE(s.steps(), 0);
        QVERIFY(s.restsExactly());
    }

    void whatIsGivenUpLeavesNothing_data()
    {
        QTest::addColumn<bool>("rests");
        QTest::addColumn<bool>("undo");
        QTest::newRow("Esc") << false << false;
        QTest::newRow("Esc after a rest") << true << false;
        QTest::newRow("undo") << false << true;
        QTest::newRow("undo after a rest") << true << true;
    }

    void whatIsGivenUpLeavesNothing()
    {
        QFETCH(bool, rests);
        QFETCH(bool, undo);
        Floats s;
        const QByteArray before = hashOf(s.painting());
        QVERIFY(s.floatBy({40, 24}));
        if (rests)
            QVERIFY(s.restsExactly());
        if (undo)
            s.use(Command::Undo);
        else
            QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QVERIFY(!s.canvas().isLifted());
        s.report(Floats::grip, {90, 24});
        s.release(Floats::grip);
        QCOMPARE(hashOf(s.painting()), before);
        QCOMPARE(s.steps(), 0);
        QVERIFY(s.restsExactly());
    }

    void readersViewsAndMomentsFindTheDocumentUpToDate()
    {
        const auto floats = [](auto act) {
            Floats s;
            QVERIFY(s.floatBy({30, 24}));
            s.report(Floats::grip, {40, 24}); // no event in between: nobody has asked for the document since
            QVERIFY(s.unsettledX() != 340);
            act(s);
            QVERIFY(near(s.unsettledX(), 340, 2));
            QVERIFY(near(s.stroke(1).origin.x, 340, 2));
            QVERIFY(s.restsExactly());
            const double x = s.stroke(1).origin.x;
            const int composed = s.composed;
            s.report(Floats::grip, {80, 24});
            s.report(Floats::grip, {81, 24});
            QTRY_VERIFY_WITH_TIMEOUT(s.composed > composed || s.stroke(1).origin.x > x, waitMs); // it goes on
            s.release(Floats::grip + Point{81, 24});
            QCOMPARE(s.steps(), 1);
            QVERIFY(s.stroke(1).origin.x > x + 30);
            QVERIFY(s.restsExactly());
        };
        floats([](Floats &s) { (void)s.editor().document(); }); // whoever asks for it
        floats([](Floats &s) { s.canvas().zoomBy(1.25); });
        floats([](Floats &s) { s.canvas().panBy({-31, 12}); });
        floats([](Floats &s) { s.editor().clock().setTime(s.editor().clock().time() + 1'000'000); });
    }

    /// At every report, with no event in between.
    void whoeverReadsFindsWhatIsShown()
    {
        Floats s;
        QVERIFY(s.floatBy({40, 24}));
        for (int i = 1; i <= 8; ++i) {
            s.report(Floats::grip, {40.0 + 5 * i, 24});
            QVERIFY(s.unsettledX() != 340.0 + 5 * i);
            QVERIFY(near(s.stroke(1).origin.x, 340 + 5 * i, 1));
            QCOMPARE(s.editor().shown()->find(1)->origin.x, s.stroke(1).origin.x);
            QVERIFY(s.canvas().isLifted()); // and it goes on
        }
        s.release(Floats::grip + Point{80, 24});
        QCOMPARE(s.steps(), 1);
        QVERIFY(s.restsExactly());
    }

    void whatElseIsDoneIsLeftAlone()
    {
        Floats s;
        QVERIFY(s.floatBy({40, 24}));
        s.editor().push(changeStrokes(s.editor().document(), {2}, [](Stroke &stroke) { stroke.name = "other"; }),
                        "name");
        QVERIFY(!s.canvas().isLifted());
        QVERIFY(near(s.stroke(1).origin.x, 340, 2));
        const Point there = s.stroke(2).origin; // as it was when something else was done to it
        QVERIFY(near(there.x, 360, 2));
        s.report(Floats::grip, {60, 24});
        s.release(Floats::grip + Point{60, 24});
        QVERIFY(near(s.stroke(1).origin.x, 360, 2));
        QCOMPARE(s.stroke(2).origin, there);
        QCOMPARE(s.stroke(2).name, QString("other"));
        QVERIFY(s.restsExactly());
    }

    void anotherDocumentTakesTheDragAway()
    {
        Floats s;
        QVERIFY(s.floatBy({40, 24}));
        auto other = std::make_shared<Painting>();
        other->strokes = {line(1, {100, 100}, {150, 150})};
        const QByteArray others = hashOf(*other);
        s.editor().undoStack().clear();
        s.editor().document().reset(other);
        s.report(Floats::grip, {60, 24});
        s.release(Floats::grip);
        s.editor().clock().setTime(s.painting().end());
        QCOMPARE(hashOf(s.painting()), others);
        QCOMPARE(s.steps(), 0);
        QVERIFY(s.restsExactly());
    }

    void aClickLiftsNothingForLong()
    {
        Floats s;
        const QByteArray before = hashOf(s.painting());
        s.press(Floats::grip);
        QVERIFY(s.canvas().isLifted());
        QTest::qWait(50);
        s.release(Floats::grip);
        QVERIFY(!s.canvas().isLifted());
        QCOMPARE(hashOf(s.painting()), before);
        QVERIFY(s.restsExactly());
        QCOMPARE(s.composed, 0);
    }

    void whatCannotFloatDoesNot()
    {
        Floats s;
        s.select({1});
        s.press(Floats::grip); // one stroke is quick
        QVERIFY(!s.canvas().isLifted());
        s.release(Floats::grip);
        s.select({1, 2});
        const Point handle =
            s.canvas().view().toCanvas(s.tool().handles().place({Kind::Scale, 1, 1}, s.canvas().view(), 1));
        s.use(Command::ScaleSpread); // stays: a picture that is scaled would show another spread
        s.press(handle);
        for (int i = 1; i <= 4; ++i)
            s.report(handle, i * Point{10, 10});
        QVERIFY(s.box(1).width() > 190);
        s.release(handle + Point{40, 40});
        QVERIFY(s.restsExactly());
        QCOMPARE(s.composed, 0);
        QCOMPARE(s.steps(), 1);
    }

    /// What lay beside the view is there when it comes in, once the hand has rested.
    void theViewsEdgeIsNoEdge()
    {
        Floats s;
        s.use(Command::Zoom100);
        s.canvas().setZoom(3);
        s.canvas().lookThrough([&] {
            View view = s.canvas().view();
            view.centre = {480, 300};
            return view;
        }());
        s.dry();
        const Point from{470, 325.5};
        s.press(from);
        QVERIFY(s.canvas().isLifted());
        for (int i = 1; i <= 5; ++i)
            s.report(from, i * Point{14, 0});
        QVERIFY(s.restsExactly());
        QVERIFY(s.canvas().isLifted()); // anew
        const double x = s.stroke(1).origin.x;
        QVERIFY(x > 360);
        const int composed = s.composed, rested = s.rested;
        s.report(from, {90, 0});
        QTRY_VERIFY_WITH_TIMEOUT(s.composed > composed, waitMs);
        const QImage shown = s.canvas().picture();
        QVERIFY(s.unsettledX() == x || s.rested > rested);
        s.release(from + Point{90, 0});
        QVERIFY(s.stroke(1).origin.x > x);
        const double mean = meanDifference(argbOf(shown), pixelsOf(s.shownRequest()));
        QVERIFY2(mean < 0.5, qPrintable(QString::number(mean)));
    }

    /// Drags with whatever else in between: undoing all gives the first painting back, and each rest is exact.
    void anythingInBetween()
    {
        Floats s;
        const QByteArray first = hashOf(s.painting());
        std::mt19937 random(unsigned(7 + qEnvironmentVariableIntValue("SUFFUSE_MONKEY_SEED")));
        const auto below = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
        Point at;
        const auto report = [&](QEvent::Type type) { s.send(type, s.logical(s.canvas().view().toPixels(at)), none); };
        for (int i = 0; i < 600; ++i) {
            const int deed = below(40);
            if (deed < 5) {
                const StrokePtr stroke = s.painting().strokes.at(std::size_t(below(int(s.painting().strokes.size()))));
                at = stroke->cubicOf(stroke->segments[1]).at(0.5);
                if (below(4) > 0)
                    s.use(Command::SelectAll);
                report(QEvent::MouseButtonPress);
            } else if (deed < 9) {
                report(QEvent::MouseButtonRelease);
            } else if (deed < 26) {
                at = at + Point{double(below(41) - 20), double(below(41) - 20)};
                report(QEvent::MouseMove);
                QTest::qWait(2);
            } else if (deed < 30) {
                QTest::qWait(below(60));
            } else if (deed == 30) {
                QTest::qWait(200);
            } else if (deed < 33) {
                s.select(deed == 31 ? std::set<StrokeId>{1, 2} : std::set<StrokeId>{1, 2, 3});
            } else if (deed == 33) {
                s.use(below(2) ? Command::Undo : Command::Redo);
            } else if (deed == 34) {
                below(2) ? s.editor().undoStack().undo() : s.editor().undoStack().redo();
            } else if (deed == 35) {
                QTest::keyClick(&s.canvas(), below(2) ? Qt::Key_Escape : Qt::Key_Left);
            } else if (deed == 36) {
                below(2) ? s.canvas().fit() : s.canvas().panBy({double(below(60) - 30), 9});
            } else if (deed == 37) {
                s.use(below(2) ? Command::Duplicate : Command::FlipAcross);
            } else if (deed == 38) {
                s.editor().push(changeStrokes(s.editor().document(), s.selected(),
                                              [](Stroke &stroke) { stroke.style.xi[0] = 0.9f - stroke.style.xi[0]; }),
                                "other");
            } else if (i % 3 == 0) {
                QVERIFY(s.restsExactly());
            }
        }
        QVERIFY(s.composed > 0);
        s.canvas().tool()->cancel();
        QVERIFY(s.restsExactly());
        while (s.editor().undoStack().canRedo()) // the last deed may have been an undo
            s.editor().undoStack().redo();
        const QByteArray last = hashOf(s.painting());
        while (s.editor().undoStack().canUndo())
            s.editor().undoStack().undo();
        QCOMPARE(hashOf(s.painting()), first);
        QVERIFY(s.restsExactly());
        while (s.editor().undoStack().canRedo())
            s.editor().undoStack().redo();
        QCOMPARE(hashOf(s.painting()), last);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestFloating)
#include "test_floating.moc"

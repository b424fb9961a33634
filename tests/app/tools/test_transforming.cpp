// Moving, scaling, turning, aligning and snapping: handles, numbers and commands.
#include "app/session/settings/settings.h"
#include "app/widgets/numbers/number_field.h"
#include "tests/app/selecting.h"

#include <QSettings>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QToolButton>

#include <numbers>

using namespace suffuse;

class TestTransforming : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
        QVERIFY(m_folder.isValid());
    }

    void init() { settings::store().clear(); }

    void handlesScale_data()
    {
        QTest::addColumn<double>("rotation");
        QTest::addColumn<bool>("mirrored");
        QTest::newRow("upright") << 0.0 << false;
        QTest::newRow("turned and mirrored") << 40.0 << true;
    }

    void handlesScale()
    {
        QFETCH(double, rotation);
        QFETCH(bool, mirrored);
        Selecting s({line(1, {300, 300}, {500, 400})});
        s.canvas().rotateBy(rotation);
        if (mirrored)
            s.canvas().mirror();
        s.select({1});
        const float diffusion = s.stroke(1).segments[0].diffusion;
        const float density = s.stroke(1).segments[0].density;
        s.dragHandle({Kind::Scale, 1, 1}, {200, 100});
        QVERIFY(near(s.box(1).left, 300) && near(s.box(1).top, 300));
        QVERIFY(near(s.box(1).right, 700) && near(s.box(1).bottom, 500));
        QCOMPARE(s.steps(), 1);
        QCOMPARE(s.editor().undoStack().undoText(), QString("Scale"));
        QVERIFY(near(s.stroke(1).segments[0].diffusion, 4 * diffusion));
        QVERIFY(near(s.stroke(1).segments[0].density, 2 * density));
        s.use(Command::Undo);
        QCOMPARE(s.box(1), Rect::of(300, 300, 200, 100));
        QCOMPARE(s.selected(), std::set<StrokeId>{1});

        s.use(Command::ScaleSpread); // stays
        s.dragHandle({Kind::Scale, 0, 1}, {57, 100});
        QVERIFY(near(s.box(1).width(), 200) && near(s.box(1).height(), 200));
        QCOMPARE(s.stroke(1).segments[0].diffusion, diffusion);
        s.use(Command::Undo);
        s.dragHandle({Kind::Scale, 1, 0}, {100, 31}, shift);
        QVERIFY(near(s.box(1).left, 200) && near(s.box(1).right, 600) && near(s.box(1).height(), 100));
        s.use(Command::Undo);
        s.dragHandle({Kind::Scale, 1, 0}, {100, 31}, ctrl);
        QVERIFY(near(s.box(1).width(), 300) && near(s.box(1).height(), 150));
    }

    /// What cannot be painted any more is not done by halves, and not in silence.
    void aRefusedDragSaysWhy()
    {
        for (const bool spreads : {true, false}) {
            StrokePtr dense = line(1, {300, 300}, {500, 400});
            Stroke changed = *dense;
            for (Segment &segment : changed.segments)
                segment.density = 8e11f;
            Selecting s({std::make_shared<const Stroke>(changed), line(2, {320, 320}, {480, 380})});
            s.canvas().fit();
            const PaintingPtr before = s.editor().document().painting();
            s.select({1, 2});
            if (!spreads)
                s.use(Command::ScaleSpread);
            s.dragHandle({Kind::Scale, 1, 1}, {200, 100});
            QCOMPARE(*s.editor().document().painting() == *before, spreads);
            QCOMPARE(s.steps(), spreads ? 0 : 1);
            QCOMPARE(s.window.statusBar()->currentMessage().contains("too small, too large or too far away"), spreads);
        }
    }

    /// Through the opposite side and on: mirrored, across that side alone, also in proportion.
    void handlesMirror()
    {
        Selecting s({line(1, {300, 300}, {500, 400})});
        s.canvas().fit();
        s.select({1});
        const auto ends = [&] {
            const Stroke &stroke = s.stroke(1);
            return std::pair(stroke.cubicOf(stroke.segments.front()).p[0], stroke.cubicOf(stroke.segments.back()).p[3]);
        };
        const auto liesAt = [&](Point from, Point to) {
            const auto [a, b] = ends();
            return length(a - from) < 1e-3 && length(b - to) < 1e-3;
        };
        QString said;
        QObject::connect(&s.tool(), &Tool::hintChanged, [&] {
            if (s.tool().hint().startsWith("Scale to"))
                said = s.tool().hint();
        });
        s.dragHandle({Kind::Scale, 1, 0}, {-300, 0});
        QVERIFY(liesAt({300, 300}, {200, 400}));
        QCOMPARE(said, QString("Scale to -50.0 % × 100.0 %"));
        s.use(Command::Undo);
        s.dragHandle({Kind::Scale, 1, 0}, {-300, 0}, ctrl); // half as high about the middle, and not upside down
        QVERIFY(liesAt({300, 325}, {200, 375}));
        QCOMPARE(said, QString("Scale to -50.0 % × 50.0 %"));
        s.use(Command::Undo);
        s.dragHandle({Kind::Scale, 0, -1}, {0, 300}, ctrl);
        QVERIFY(liesAt({200, 600}, {600, 400}));
        s.use(Command::Undo);
        s.dragHandle({Kind::Scale, 1, 1}, {-600, 100}, ctrl); // a corner past one side only
        QVERIFY(liesAt({300, 300}, {-100, 500}));
        QCOMPARE(said, QString("Scale to -200.0 % × 200.0 %"));
        s.use(Command::Undo);
        s.dragHandle({Kind::Scale, 1, 1}, {-600, -300}, ctrl); // past both
        QVERIFY(liesAt({300, 300}, {-100, 100}));
        s.use(Command::Undo);
        s.dragHandle({Kind::Scale, 1, 1}, {200, 100}, ctrl);
        QVERIFY(liesAt({300, 300}, {700, 500}));
        s.use(Command::Undo);
        s.dragHandle({Kind::Scale, -1, 0}, {300, 0}, shift); // about the centre
        QVERIFY(liesAt({600, 300}, {200, 400}));
    }

    void handlesTurnAndSkew()
    {
        Selecting s({line(1, {300, 300}, {500, 400})});
        s.click({400, 350});
        s.click({400, 350});
        s.dragHandle({Kind::Rotate, 1, -1}, {-3, 211}, ctrl);
        QCOMPARE(s.editor().undoStack().undoText(), QString("Rotate"));
        const Point d =
            s.stroke(1).cubicOf(s.stroke(1).segments.back()).p[3] - s.stroke(1).cubicOf(s.stroke(1).segments[0]).p[0];
        const double turned = (std::atan2(d.y, d.x) - std::atan2(100.0, 200.0)) * 180 / std::numbers::pi;
        QVERIFY2(near(std::remainder(turned, 15), 0, 1e-3) && turned > 30, qPrintable(QString::number(turned)));
        QVERIFY(near(s.box(1).centre().x, 400) && near(s.box(1).centre().y, 350));
        s.use(Command::Undo);

        s.dragHandle({Kind::Skew, 0, -1}, {50, 0}, shift); // the lower side stays
        QVERIFY(near(s.box(1).left, 350) && near(s.box(1).right, 500));
        QVERIFY(near(s.box(1).height(), 100));
        s.use(Command::Undo);

        s.dragHandle({Kind::Centre, 0, 0}, {100, 50}); // onto the end of the stroke
        QCOMPARE(s.steps(), 1);                        // the undone skewing: moving the centre is no edit
        QVERIFY(near(s.tool().handles().centre().x, 500));
        s.dragHandle({Kind::Rotate, -1, -1}, {-60, 80});
        const Point end = s.stroke(1).cubicOf(s.stroke(1).segments.back()).p[3];
        QVERIFY(near(end.x, 500, 0.02) && near(end.y, 400, 0.02));
        QVERIFY(near(s.tool().handles().centre().x, 500, 0.02)); // it stays where it was
        QCOMPARE(s.steps(), 1);
    }

    void aDragThatIsGivenUpLeavesNothing()
    {
        Selecting s({line(1, {300, 300}, {500, 400}), line(2, {300, 500}, {500, 500})});
        s.select({1});
        const QByteArray before = hashOf(s.painting());
        const View view = s.canvas().view();
        const Point handle = view.toCanvas(s.tool().handles().place({Kind::Scale, 1, 1}, view, 1));
        s.pressAndMove({handle, handle + Point{80, 20}}, none);
        QVERIFY(hashOf(s.painting()) != before);
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QCOMPARE(hashOf(s.painting()), before);
        s.send(QEvent::MouseButtonRelease, s.logical(view.toPixels(handle)), none);
        QCOMPARE(s.steps(), 0);
        s.pressAndMove({handle, handle + Point{80, 20}}, none);
        s.use(Command::Undo);
        QCOMPARE(hashOf(s.painting()), before);
        s.send(QEvent::MouseButtonRelease, s.logical(view.toPixels(handle)), none);
        s.drag({handle, handle + Point{80, 20}, handle});
        QCOMPARE(s.steps(), 0); // back at its start
        QCOMPARE(hashOf(s.painting()), before);

        s.pressAndMove({handle, handle + Point{80, 20}}, none); // another painting under the drag
        auto other = std::make_shared<Painting>();
        other->strokes = {line(1, {100, 100}, {150, 150})};
        const QByteArray others = hashOf(*other);
        s.editor().undoStack().clear();
        s.editor().document().reset(other);
        s.send(QEvent::MouseMove, s.logical({10, 10}), none);
        s.send(QEvent::MouseButtonRelease, s.logical({10, 10}), none);
        QCOMPARE(hashOf(s.painting()), others);
        QCOMPARE(s.steps(), 0);
    }

    void lockedStrokesStayWhereTheyAre()
    {
        auto locked = std::make_shared<Stroke>(*line(2, {300, 500}, {500, 500}));
        locked->locked = true;
        Selecting s({line(1, {300, 300}, {500, 400}), locked});
        s.select({1, 2});
        s.dragHandle({Kind::Scale, 1, 1}, {100, 50});
        QVERIFY(near(s.box(1).right, 600));
        QVERIFY(*s.painting().find(2) == *locked);
    }

    void numbersMapTheSelection()
    {
        Selecting s({line(1, {300, 300}, {500, 400})});
        s.select({1});
        auto *row = s.tool().options();
        const auto fields = row->findChildren<NumberField *>();
        QCOMPARE(fields.size(), 5);
        const auto enter = [&](int field, const QString &text) {
            fields[field]->setFocus();
            QTest::qWait(1); // the field selects its text when it gets the focus
            fields[field]->selectAll();
            QTest::keyClicks(fields[field], text);
            QTest::keyClick(fields[field], Qt::Key_Return);
        };
        QTRY_COMPARE(*fields[0]->value(), 300.0);
        enter(0, "100");
        QCOMPARE(s.box(1), Rect::of(100, 300, 200, 100));
        enter(2, "*2");
        QVERIFY(near(s.box(1).width(), 400) && near(s.box(1).height(), 100));
        row->findChild<QToolButton *>("proportions")->click();
        enter(3, "50");
        QVERIFY(near(s.box(1).width(), 200) && near(s.box(1).height(), 50));
        enter(4, "90");
        QVERIFY(near(s.box(1).width(), 50) && near(s.box(1).height(), 200));
        QCOMPARE(s.steps(), 4);
        for (int i = 0; i < 4; ++i)
            s.use(Command::Undo);
        QCOMPARE(s.box(1), Rect::of(300, 300, 200, 100));
        QTRY_COMPARE(*fields[2]->value(), 200.0);
        fields[1]->setFocus();
        QTest::keyClick(fields[1], Qt::Key_Up);
        QTest::keyClick(fields[1], Qt::Key_Up);
        QCOMPARE(s.box(1).top, 302.0);
        QCOMPARE(s.steps(), 1); // two steps of one field are one
        // As all lengths they take units and per cent.
        for (const auto &[typed, width] : {std::pair("120 u", 120.0), {"50%", 60.0}, {"+10%", 66.0}}) {
            enter(2, typed);
            QVERIFY2(near(s.box(1).width(), width), typed);
        }
        s.select({});
        QTRY_VERIFY(!fields[0]->isEnabled());
    }

    void flipsAndQuartersAreExact()
    {
        Selecting s({line(1, {300, 300}, {500, 400})});
        const QByteArray before = hashOf(s.painting());
        s.select({1});
        s.use(Command::FlipAcross);
        QVERIFY(hashOf(s.painting()) != before);
        s.use(Command::FlipAcross);
        QCOMPARE(s.box(1), Rect::of(300, 300, 200, 100));
        for (int i = 0; i < 4; ++i)
            s.use(Command::QuarterRight);
        QCOMPARE(s.box(1), Rect::of(300, 300, 200, 100));
        s.use(Command::QuarterLeft);
        QCOMPARE(s.box(1), Rect::of(350, 250, 100, 200));
        s.use(Command::FlipDown);
        QCOMPARE(s.editor().undoStack().undoText(), QString("Flip vertically"));
    }

    void alignsAndDistributes()
    {
        Selecting s(
            {line(1, {100, 100}, {200, 100}), line(2, {150, 200}, {350, 200}), line(3, {600, 300}, {650, 300})});
        s.select({1});
        QVERIFY(!s.window.action(Command::AlignLeft).isEnabled());
        // Two of them are too few to be distributed, which it says.
        s.select({1, 2});
        QSignalSpy said(s.window.findChild<Commands *>(), &Commands::said);
        s.use(Command::DistributeGapsAcross);
        QCOMPARE(said.size(), 1);
        QVERIFY(said.back()[0].toString().contains("three strokes or groups"));
        s.select({1, 2, 3});
        s.use(Command::DistributeGapsAcross);
        QCOMPARE(said.size(), 1);
        QVERIFY(near(s.seen(2).left - s.seen(1).right, s.seen(3).left - s.seen(2).right));
        QVERIFY(near(s.box(1).left, 100) && near(s.box(3).right, 650));
        const double right = s.seen(3).right;
        QVERIFY(right > 651);
        s.use(Command::AlignRight);
        for (const StrokeId id : {1, 2, 3})
            QVERIFY(near(s.seen(id).right, right));
        s.select({2});
        QVERIFY(!s.window.action(Command::AlignLeft).isEnabled());
        s.use(Command::AlignToCanvas);
        QVERIFY(s.window.action(Command::AlignLeft).isEnabled());
        s.use(Command::AlignLeft);
        QVERIFY(near(s.seen(2).left, 0)); // the paint, not the curve
        QVERIFY(s.box(2).left > 1);
        QCOMPARE(s.steps(), 3);
        while (s.editor().undoStack().canUndo())
            s.use(Command::Undo);
        QCOMPARE(s.box(2), Rect::of(150, 200, 200, 0));
    }

    void alignsToTheFirstTheLastAndTheBiggest()
    {
        Selecting s(
            {line(1, {100, 100}, {200, 100}), line(2, {150, 200}, {350, 200}), line(3, {600, 300}, {650, 300})});
        const auto leftsBy = [&](Command relative) {
            s.use(relative);
            s.use(Command::AlignLeft);
            std::array<double, 3> lefts{s.box(1).left, s.box(2).left, s.box(3).left};
            for (double &left : lefts) // boxes of paint are sums of numbers that are no binary fractions
                left = std::round(left * 1e9) / 1e9;
            s.use(Command::Undo);
            return lefts;
        };
        const auto all = [](double left) { return std::array<double, 3>{left, left, left}; };
        s.click({625, 300}, none);
        s.click({150, 100}, shift);
        s.click({250, 200}, shift);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2, 3}));
        QCOMPARE(leftsBy(Command::AlignToFirst), all(600));
        QCOMPARE(leftsBy(Command::AlignToLast), all(150));
        QCOMPARE(leftsBy(Command::AlignToBiggest), all(150));
        s.click({250, 200}, shift); // takes it away
        s.select({1, 2, 3});
        QCOMPARE(leftsBy(Command::AlignToLast), all(150));
        s.select({1, 3});
        s.select({1, 2, 3});
        s.select({1, 2});
        QCOMPARE(leftsBy(Command::AlignToFirst)[1], 100.0);
        s.select({});
        s.select({1, 2, 3}); // at once: the topmost of them
        QCOMPARE(leftsBy(Command::AlignToFirst), all(600));
        QCOMPARE(leftsBy(Command::AlignToLast), all(600));
    }

    void lockHideAndShowAgain()
    {
        Selecting s({line(1, {100, 100}, {200, 100}), line(2, {150, 200}, {350, 200})});
        s.select({1});
        s.use(Command::LockStrokes);
        QVERIFY(s.stroke(1).locked && s.selected().empty());
        s.select({2});
        s.use(Command::HideStrokes);
        QVERIFY(!s.stroke(2).visible && s.selected().empty());
        s.use(Command::ShowAll);
        s.use(Command::UnlockAll);
        QVERIFY(s.stroke(2).visible && !s.stroke(1).locked);
        s.use(Command::UnlockAll);
        QCOMPARE(s.steps(), 4); // there was nothing left to unlock
        while (s.editor().undoStack().canUndo())
            s.use(Command::Undo);
        QCOMPARE(s.selected(), std::set<StrokeId>{1}); // undo brings the selection back
    }

    /// A command in the middle of a drag that selects something else, copies for example, ends the drag there.
    void copiesMadeMeanwhileStayWhereTheyAre()
    {
        Selecting s({line(1, {200, 300}, {300, 300})});
        s.use(Command::Select);
        s.select({1});
        s.pressAndMove({{250, 300}, {270, 310}, {290, 320}}, {});
        s.use(Command::Duplicate);
        QCOMPARE(s.painting().strokes.size(), std::size_t(2));
        const PaintingPtr then = s.editor().document().painting();
        QTest::mouseMove(&s.canvas(), s.at({400, 400}));
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({400, 400}));
        QVERIFY(*s.editor().document().painting() == *then);
        QCOMPARE(s.editor().undoStack().count(), 2); // Move, Duplicate
    }

    void movesSnapToNodesAndGrid()
    {
        Selecting s({line(1, {300, 300}, {400, 300}), line(2, {500, 500}, {600, 520})});
        const double pixel = 1 / s.canvas().view().scale;
        s.select({1});
        const Point by{200 + 4 * pixel, 200 - 3 * pixel}; // its start comes near to the other's
        s.drag({{350, 300}, Point{350, 300} + by});
        QVERIFY(!near(s.box(1).left, 500, 1e-6));
        s.use(Command::Undo);
        s.use(Command::SnapToNodes);
        s.drag({{350, 300}, Point{350, 300} + by});
        QVERIFY(near(s.box(1).left, 500, 1e-6) && near(s.box(1).top, 500, 1e-6));
        s.use(Command::Undo);
        s.drag({{350, 300}, Point{350, 300} + by}, ctrl); // one axis: as it is
        QVERIFY(!near(s.box(1).left, 500, 1e-6));
        s.use(Command::Undo);

        s.use(Command::SnapToNodes);
        s.use(Command::SnapToGrid);
        CanvasAids aids = s.canvas().aids();
        QVERIFY(aids.snapToGrid && !aids.snapToNodes);
        aids.gridStep = 50;
        s.canvas().setAids(aids);
        s.drag({{350, 300}, {350 + 103 * 1.0, 300 - 148 * 1.0}});
        QVERIFY(near(s.box(1).left, 400, 1e-6) && near(s.box(1).top, 150, 1e-6));
        s.use(Command::Undo);
        s.dragHandle({Kind::Scale, 1, 1}, {148, 0});
        QVERIFY(near(s.box(1).right, 550, 1e-3));
        QVERIFY(settings::canvasAids().snapToGrid);
    }

    /// Nodes of all that is moved snap, not only those of the stroke under the pointer.
    void everyMovedNodeSnaps()
    {
        Selecting s(
            {line(1, {300, 300}, {400, 300}), line(2, {300, 400}, {400, 460}, 3), line(3, {700, 200}, {750, 210})});
        const double pixel = 1 / s.canvas().view().scale;
        s.select({1, 2});
        s.use(Command::SnapToNodes);
        const Point node{300 + 100 / 3.0, 420}, onto{700, 200}; // within the box, on the stroke that is not grabbed
        s.drag({{350, 300}, Point{350, 300} + (onto - node) + Point{3 * pixel, -2 * pixel}});
        const Stroke &moved = s.stroke(2);
        QVERIFY(length(moved.origin + moved.segments[1].bezier[0] - onto) < 1e-4);
        s.use(Command::SnapToNodes);
    }

    void snappingIsPure()
    {
        Painting painting;
        painting.strokes = {line(1, {10, 10}, {110, 10}, 1), line(2, {10, 60}, {110, 60}, 1)};
        const View view = View::ofArea(Rect::of(0, 0, 200, 200), 400, 400);
        CanvasAids aids;
        aids.snapToNodes = aids.snapToGrid = true;
        aids.gridStep = 25;
        const Snapping all(painting, aids);
        QCOMPARE(all.snap({12, 9}, view, 1).to, SnapTo::Node);
        QCOMPARE(all.snap({12, 9}, view, 1).point, (Point{10, 10}));
        const Snapping others(painting, aids,
                              [](const Stroke &stroke, int node) { return stroke.id == 1 && node == 0; });
        QCOMPARE(others.snap({12, 10}, view, 1).to, SnapTo::Nothing);
        QCOMPARE(others.snap({107, 11}, view, 1).point, (Point{110, 10}));
        QCOMPARE(others.snap({77, 90}, view, 1).point, (Point{75, 90}));  // a line of the grid
        QCOMPARE(others.snap({77, 98}, view, 1).point, (Point{75, 100})); // a crossing
        QCOMPARE(Snapping().snap({77, 98}, view, 1).to, SnapTo::Nothing);
        Point at;
        const Snap moved = all.snapMove({{0, 0}, {7, 2}}, {2, 57}, view, 1, &at);
        QCOMPARE(moved.point, (Point{3, 58}));
        QCOMPARE(at, (Point{10, 60}));
    }

    void theGridLiesOverThePictureOnly()
    {
        Selecting s({});
        QTRY_VERIFY_WITH_TIMEOUT(s.canvas().isUpToDate(), waitMs);
        const QImage before = s.canvas().grab().toImage();
        const QImage picture = s.canvas().picture();
        s.use(Command::ShowGrid);
        QVERIFY(s.canvas().grab().toImage() != before);
        QCOMPARE(s.canvas().picture(), picture);
        s.use(Command::ShowGrid);
        QCOMPARE(s.canvas().grab().toImage(), before);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestTransforming)
#include "test_transforming.moc"

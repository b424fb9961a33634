// Selecting strokes on the canvas, by the clicks and keys that a hand makes.
#include "app/panels/strokes/strokes_panel.h"
#include "app/session/selecting/pick.h"
#include "app/session/settings/settings.h"
#include "app/session/translation.h"
#include "app/tools/nodes/node_tool.h"
#include "app/tools/select/select_hints.h"
#include "model/paint/seen_paint.h"
#include "render/bench/generator.h"
#include "render/probe.h"
#include "tests/app/selecting.h"

#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QScopeGuard>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeView>

#include <random>

using namespace suffuse;

class TestSelecting : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
        QVERIFY(m_folder.isValid());
    }

    void init() { settings::store().clear(); }

    void nothingCanBeSelectedInAnEmptyPainting()
    {
        Session s;
        QVERIFY(s.painting().strokes.empty());
        QVERIFY(!s.window.action(Command::SelectAll).isEnabled());
        s.paintLine({100, 100}, {300, 120});
        s.editor().laterChanges().flush();
        QVERIFY(s.window.action(Command::SelectAll).isEnabled());
    }

    void roughPaintIsTheRealPaint()
    {
        bench::PaintingOptions options;
        options.strokes = 30;
        options.segments = 600;
        options.width = options.height = 300;
        const Painting painting = bench::makePainting(options);
        const Microseconds end = painting.end();
        std::mt19937 random(5);
        std::uniform_real_distribution<double> place(-2, 2);
        int seenPoints = 0, sameSegment = 0;
        for (int i = 0; i < 300; ++i) {
            const StrokePtr &stroke = painting.strokes[std::size_t(i % 30)];
            const Segment &chosen = stroke->segments[std::size_t(i) % stroke->segments.size()];
            const Point at = stroke->cubicOf(chosen).at(0.5) + chosen.spread(end) * Point{place(random), place(random)};
            Painting alone;
            alone.strokes = {stroke};
            const Result<Probe> exact = probe(alone, end, at.x, at.y);
            QVERIFY(bool(exact));
            const SeenPaint seen = seenPaint(*stroke, end, at);
            const double w = exact->strokes.empty() ? 0 : exact->strokes.front().opacity;
            QVERIFY2(near(seen.opacity, w, 0.01 + 0.02 * w), qPrintable(QString("%1, %2").arg(seen.opacity).arg(w)));
            if (w < visibleOpacity)
                continue;
            ++seenPoints;
            const auto &shares = exact->strokes.front().shares;
            const auto most = std::max_element(shares.begin(), shares.end(),
                                               [](const auto &a, const auto &b) { return a.share < b.share; });
            sameSegment += most->segment == seen.segment;
        }
        QVERIFY(seenPoints > 20);
        QVERIFY(sameSegment >= seenPoints - 1);
    }

    void secondClickTurnsTheHandles()
    {
        Selecting s({line(1, {200, 300}, {600, 500})});
        s.click({400, 400});
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        QCOMPARE(s.tool().handles().mode(), TransformHandles::Mode::Scale);
        QCOMPARE(s.tool().handles().handles(s.canvas().view(), 1).size(), std::size_t(8));
        s.click({400, 400});
        QCOMPARE(s.tool().handles().mode(), TransformHandles::Mode::Turn);
        QCOMPARE(s.tool().handles().handles(s.canvas().view(), 1).size(), std::size_t(9)); // 4 + 4 and the centre
        s.click({400, 400});
        QCOMPARE(s.tool().handles().mode(), TransformHandles::Mode::Scale);
        s.click({50, 50});
        QVERIFY(s.selected().empty());
        QVERIFY(s.tool().handles().handles(s.canvas().view(), 1).empty());
        QCOMPARE(s.steps(), 0);
    }

    void doubleClickSelectsTheStrokeAndAsksForItsValues()
    {
        Selecting s({line(1, {200, 300}, {600, 300})});
        QSignalSpy asked(&s.tool(), &Tool::valuesAsked);
        s.click({250, 300});
        s.send(QEvent::MouseButtonDblClick, s.logical(s.canvas().view().toPixels({250, 300})), none);
        s.send(QEvent::MouseButtonRelease, s.logical(s.canvas().view().toPixels({250, 300})), none);
        QCOMPARE(s.selection(), (Selection{{1}, {}}));
        QCOMPARE(asked.size(), 1);
        QCOMPARE(asked.front()[1].value<SegmentRef>(), (SegmentRef{1, 0}));
        QCOMPARE(s.tool().handles().mode(), TransformHandles::Mode::Scale);
    }

    /// Keys that repeat and quick taps are one step, whether or not the system says that a key is held down; after a
    /// pause, or of other strokes, they are another one.
    void nudgesThatFollowEachOtherAreOneStep()
    {
        Selecting s({line(1, {200, 300}, {400, 300}), line(2, {200, 500}, {400, 500})});
        s.canvas().setFocus();
        s.select({1});
        const auto press = [&s](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
            QTest::keyClick(&s.canvas(), key, modifiers);
        };
        for (int i = 0; i < 5; ++i)
            press(Qt::Key_Right);
        press(Qt::Key_Down, alt);
        press(Qt::Key_Down, shift);
        QCOMPARE(s.steps(), 1);
        QCOMPARE(s.stroke(1).origin.x, 205.0);
        s.select({2});
        press(Qt::Key_Right);
        QCOMPARE(s.steps(), 2);
        s.select({1});
        press(Qt::Key_Left);
        QCOMPARE(s.steps(), 3);
        QTest::qWait(1'000); // The hand pauses.
        press(Qt::Key_Left);
        QCOMPARE(s.steps(), 4);
        QTest::qWait(1'000);
        QKeyEvent held(QEvent::KeyPress, Qt::Key_Left, {}, {}, true); // but it goes on where a key is held down
        QCoreApplication::sendEvent(&s.canvas(), &held);
        QCOMPARE(s.steps(), 4);
        QCOMPARE(s.stroke(1).origin.x, 202.0);
        s.use(Command::Undo);
        QCOMPARE(s.stroke(1).origin.x, 204.0);
        for (int i = 0; i < 3; ++i)
            s.use(Command::Undo);
        QCOMPARE(s.stroke(1).origin, (Point{200, 300}));
        QCOMPARE(s.stroke(2).origin, (Point{200, 500}));
    }

    /// Redo selects what was moved, as the move itself did, whatever was selected when it was taken back.
    void redoSelectsWhatWasMoved()
    {
        Selecting s({line(1, {200, 300}, {400, 300}), line(2, {200, 500}, {400, 500})});
        s.drag({{300, 300}, {350, 340}});
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        QCOMPARE(s.steps(), 1);
        for (const std::set<StrokeId> &meanwhile : {std::set<StrokeId>{}, {2}, {1}}) {
            s.select(meanwhile);
            s.use(Command::Undo);
            QCOMPARE(s.stroke(1).origin.x, 200.0);
            s.select({});
            s.use(Command::Redo);
            QCOMPARE(s.stroke(1).origin.x, 250.0);
            QCOMPARE(s.selected(), std::set<StrokeId>{1});
        }
        s.select({1});
        s.use(Command::Duplicate);
        const std::set<StrokeId> copy = s.selected();
        QVERIFY(!copy.contains(1) && copy.size() == 1);
        s.select({});
        s.use(Command::Undo);
        s.use(Command::Redo);
        QCOMPARE(s.selected(), copy);
    }

    /// A click means what is seen most: not the halo of a stroke that lies on top and is hardly seen there.
    void aFaintHaloGivesWay()
    {
        // So far away that it is hardly seen on the line.
        const auto haloAt = [](double y) {
            Stroke halo = *line(2, {200, y}, {600, y});
            halo.style = {StyleKind::Feathering, {1, 1, 0}};
            for (Segment &segment : halo.segments) {
                segment.diffusion = 900;
                segment.density = 60;
            }
            return std::make_shared<const Stroke>(halo);
        };
        const auto isFaint = [](const Stroke &halo) {
            const double above = seenPaint(halo, halo.driesAt(), {400, 300}).opacity;
            return above >= visibleOpacity && above < 0.2;
        };
        double y = 320;
        while (y < 600 && !isFaint(*haloAt(y)))
            y += 2;
        Selecting s({line(1, {200, 300}, {600, 300}), haloAt(y)});
        const Microseconds T = s.painting().end();
        const Point faint{400, 300};
        QVERIFY(isFaint(s.stroke(2)) && seenPaint(s.stroke(1), T, faint).opacity > 0.9);
        QCOMPARE(pickTopmost(s.painting(), T, faint, 1)->stroke, StrokeId(2));
        s.click(faint);
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        s.click(faint, alt); // the halo can be had, too
        QCOMPARE(s.selected(), std::set<StrokeId>{2});
        s.click({400, y}); // where it is seen itself
        QCOMPARE(s.selected(), std::set<StrokeId>{2});
        // Faint paint is no halo where it is as strong as it gets.
        Stroke glaze = *line(2, {200, 300}, {600, 300});
        for (Segment &segment : glaze.segments)
            segment.colour.opacity = 0.12f;
        Selecting faintest({line(1, {200, 300}, {600, 300}), std::make_shared<const Stroke>(glaze)});
        faintest.click({400, 300});
        QCOMPARE(faintest.selected(), std::set<StrokeId>{2});
    }

    void altClickGoesBelow()
    {
        Selecting s(
            {line(1, {200, 300}, {600, 300}), line(2, {400, 100}, {400, 500}), line(3, {300, 200}, {500, 400})});
        s.click({400, 300});
        QCOMPARE(s.selected(), std::set<StrokeId>{3});
        s.click({400, 300}, alt);
        QCOMPARE(s.selected(), std::set<StrokeId>{2});
        QVERIFY(s.tool().hint().startsWith("Stroke 2 of 3"));
        s.click({400, 300}, alt);
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        s.click({400, 300}, alt);
        QCOMPARE(s.selected(), std::set<StrokeId>{3}); // from the lowest back to the topmost
        s.click({400, 300}, alt | shift);
        QCOMPARE(s.selected(), (std::set<StrokeId>{2, 3}));
        s.click({50, 50}, alt);
        QCOMPARE(s.selected(), (std::set<StrokeId>{2, 3}));
        s.select({1, 2, 3});
        s.use(Command::GroupStrokes);
        s.select({3});
        s.click({400, 300}, alt | ctrl); // within the group
        QCOMPARE(s.selected(), std::set<StrokeId>{2});
        s.click({400, 300}, alt);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2, 3}));
    }

    void clickTakesTheGroup()
    {
        Selecting s(
            {line(1, {200, 200}, {600, 200}), line(2, {200, 300}, {600, 300}), line(3, {200, 400}, {600, 400})});
        s.select({1, 2});
        s.use(Command::GroupStrokes);
        QCOMPARE(s.painting().groups.size(), std::size_t(1));
        s.click({50, 50});
        s.click({400, 200});
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
        s.click({400, 400}, shift);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2, 3}));
        s.click({400, 300}, shift);
        QCOMPARE(s.selected(), std::set<StrokeId>{3});
        s.click({400, 300}, ctrl);
        QCOMPARE(s.selected(), std::set<StrokeId>{2});
        s.use(Command::UngroupStrokes);
        s.click({50, 50});
        s.click({400, 300});
        QCOMPARE(s.selected(), std::set<StrokeId>{2});
        s.use(Command::Undo);
        s.use(Command::Undo);
        QVERIFY(s.painting().groups.empty());
    }

    void selectSameFindsItsLike()
    {
        auto red = std::make_shared<Stroke>(*line(2, {200, 300}, {600, 300}));
        for (Segment &segment : red->segments)
            segment.colour = {1, 0, 0, 1};
        red->brush = "chalk";
        auto edge = std::make_shared<Stroke>(*line(3, {200, 400}, {600, 400}));
        edge->style = {StyleKind::Edge, {0.5f, 0.5f, 0.4f}};
        edge->brush = "chalk";
        Selecting s({line(1, {200, 200}, {600, 200}), red, edge});
        s.select({1});
        s.use(Command::SameColour);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 3}));
        s.select({1});
        s.use(Command::SameStyle);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
        s.select({3});
        s.use(Command::SameBrush);
        QCOMPARE(s.selected(), (std::set<StrokeId>{2, 3}));
    }

    void selectsWhatHasTheSameNameOrIsFound()
    {
        StrokeList strokes;
        for (StrokeId id = 1; id <= 5; ++id) {
            auto stroke = std::make_shared<Stroke>(*line(id, {200, 100.0 * double(id)}, {600, 100.0 * double(id)}));
            stroke->name = id <= 2 ? "leaf" : id == 3 ? "pear" : "";
            strokes.push_back(std::move(stroke));
        }
        Selecting s(std::move(strokes));
        s.select({1});
        s.use(Command::SameName);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
        s.select({4});
        s.use(Command::SameName); // no name is no likeness
        QCOMPARE(s.selected(), std::set<StrokeId>{4});

        QAction &found = s.window.action(Command::SelectFound);
        QVERIFY(!found.isEnabled());
        auto *panel = s.window.findChild<StrokesPanel *>();
        for (QWidget *above = panel; above; above = above->parentWidget())
            above->show();
        panel->search()->setText("a");
        QVERIFY(found.isEnabled());
        s.canvas().setFocus();
        s.use(Command::SelectFound);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2, 3}));
        s.use(Command::SelectAll); // on the canvas all is meant
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2, 3, 4, 5}));
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        panel->view()->setFocus();
        QTest::keyClick(panel->view(), Qt::Key_A, Qt::ControlModifier); // in the dock what it shows
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2, 3}));
        panel->search()->clear();
        QVERIFY(!s.window.action(Command::SelectFound).isEnabled());
    }

    void tabGoesThroughTheStrokes()
    {
        Selecting s(
            {line(1, {200, 200}, {600, 200}), line(2, {200, 300}, {600, 300}), line(3, {200, 400}, {600, 400})});
        QTest::keyClick(&s.canvas(), Qt::Key_Tab);
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        QTest::keyClick(&s.canvas(), Qt::Key_Tab);
        QCOMPARE(s.selected(), std::set<StrokeId>{2});
        QTest::keyClick(&s.canvas(), Qt::Key_Backtab, shift);
        QTest::keyClick(&s.canvas(), Qt::Key_Backtab, shift);
        QCOMPARE(s.selected(), std::set<StrokeId>{3});
    }

    void hintFollowsTheModifiers()
    {
        Selecting s({line(1, {200, 300}, {600, 300})});
        QLabel *shown = nullptr;
        for (QLabel *label : s.window.findChildren<QLabel *>())
            if (label->text() == s.tool().hint())
                shown = label;
        QVERIFY(shown);
        QTest::keyPress(&s.canvas(), Qt::Key_Alt);
        QVERIFY(shown->text().startsWith("Alt+click"));
        QTest::keyPress(&s.canvas(), Qt::Key_Shift, alt);
        QVERIFY(shown->text().startsWith("Shift+Alt+click"));
        QTest::keyRelease(&s.canvas(), Qt::Key_Shift, alt | shift);
        QTest::keyRelease(&s.canvas(), Qt::Key_Alt, alt);
        QVERIFY(shown->text().startsWith("Click paint"));
        s.click({400, 300});
        QVERIFY(shown->text().startsWith("Drag: move"));
    }

    void hintsFitTheStatusBar_data()
    {
        QTest::addColumn<QString>("language");
        for (const QString &language : translationCodes())
            QTest::newRow(qPrintable(language)) << language;
    }
    void hintsFitTheStatusBar()
    {
        QFETCH(QString, language);
        settings::setLanguage(language);
        installTranslators();
        const auto back = qScopeGuard([] {
            settings::setLanguage("en");
            installTranslators();
        });
        Selecting s({line(1, {200, 300}, {600, 300})});
        s.window.resize(1280, 800);
        s.dry();
        QCoreApplication::processEvents();
        // The number beside it needs more room after a frame that was slow, or coarse.
        const int spare = s.window.fontMetrics().horizontalAdvance("00, coarse");
        const auto check = [&] {
            const QString hint = s.canvas().tool()->hint();
            const QLabel *shown = nullptr;
            for (const QLabel *label : s.window.findChildren<QLabel *>())
                if (label->text() == hint)
                    shown = label;
            QVERIFY2(shown, qPrintable(hint));
            const int needed = shown->fontMetrics().horizontalAdvance(hint), room = shown->contentsRect().width();
            QVERIFY2(needed + spare <= room, qPrintable(QString("%1 of %2: %3").arg(needed).arg(room).arg(hint)));
        };
        for (const bool selected : {false, true})
            for (const Command tool :
                 {Command::Brush, Command::Select, Command::Segments, Command::Shapes, Command::OutlinePen,
                  Command::LassoFill, Command::Bucket, Command::Text, Command::Redraw, Command::Push, Command::Knife,
                  Command::Eraser, Command::AttributeBrush, Command::Eyedropper, Command::Assistants, Command::Pan}) {
                s.use(tool);
                s.select(selected ? std::set<StrokeId>{1} : std::set<StrokeId>{});
                check();
            }
        if (language != "en")
            return;
        s.use(Command::Select);
        s.select({});
        QVERIFY(s.tool().hint().contains("Shift"));
        QVERIFY(s.tool().hint().contains("band"));
        s.select({1}); // the hint is fuller, and leaves the band to that of the key
        QVERIFY(s.tool().hint().contains("Shift"));
        QVERIFY(SelectHints::ofKeys(Qt::ShiftModifier, true).contains("band"));
    }

    /// The Knife keeps to what was selected at the press, also where a command takes that away in the middle.
    void theKnifeKeepsToWhatWasSelected()
    {
        Selecting s({line(1, {200, 200}, {400, 200}), line(2, {200, 300}, {400, 300})});
        s.use(Command::Knife);
        s.select({1});
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({300, 100}));
        QTest::mouseMove(&s.canvas(), s.at({300, 350}));
        s.select({});
        const Painting before = s.painting();
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({300, 350}));
        QCOMPARE(nodeCount(*s.painting().find(2)), nodeCount(*before.find(2)));
        QVERIFY(nodeCount(*s.painting().find(1)) > nodeCount(*before.find(1)));
    }

    void renamingNamesTheGroup()
    {
        Selecting s(
            {line(1, {200, 200}, {400, 200}), line(2, {200, 300}, {400, 300}), line(3, {200, 400}, {400, 400})});
        QString label, name, placeholder;
        const auto rename = [&](const QString &to) {
            QTimer::singleShot(0, this, [&, to] {
                auto *dialog = qobject_cast<QInputDialog *>(QApplication::activeModalWidget());
                QVERIFY(dialog);
                auto *field = dialog->findChild<QLineEdit *>();
                label = dialog->labelText(), name = field->text(), placeholder = field->placeholderText();
                field->selectAll();
                QTest::keyClicks(field, to);
                QTest::keyClick(field, Qt::Key_Return);
            });
            s.use(Command::RenameStrokes);
        };
        s.select({1});
        rename("petal");
        QCOMPARE(name, QString());
        QCOMPARE(placeholder, QString("Stroke 1"));
        QCOMPARE(s.stroke(1).name, QString("petal"));
        s.select({1, 2});
        rename("leaf"); // different names
        QCOMPARE(name, QString());
        QCOMPARE(s.stroke(2).name, QString("leaf"));
        s.use(Command::GroupStrokes);
        rename("blossom");
        QVERIFY2(label.contains("group"), qPrintable(label));
        QCOMPARE(placeholder, QString("Group %1").arg(s.painting().groups[0].id));
        QCOMPARE(s.painting().groups[0].name, QString("blossom"));
        QCOMPARE(s.stroke(1).name, QString("leaf"));
        rename("bloom");
        QCOMPARE(name, QString("blossom"));
        s.use(Command::Undo);
        QCOMPARE(s.painting().groups[0].name, QString("blossom"));
        s.select({1}); // a part of it
        rename("stem");
        QCOMPARE(name, QString("leaf"));
        QCOMPARE(s.stroke(1).name, QString("stem"));
        s.select({1, 2, 3}); // and more than it
        rename("all");
        QCOMPARE(s.stroke(3).name, QString("all"));
        QCOMPARE(s.painting().groups[0].name, QString("blossom"));
    }

    void whatIsPaintedLaterIsNotSelected()
    {
        Stroke later = *line(2, {300, 500}, {700, 480});
        for (Segment &segment : later.segments)
            segment.born += 60'000'000;
        Selecting s({line(1, {200, 200}, {400, 260}), std::make_shared<const Stroke>(later)});
        s.editor().clock().setManual(true);
        s.editor().clock().lookAt(30'000'000);
        s.use(Command::SelectAll);
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        const View view = s.canvas().view();
        QCOMPARE(strokesWithin(s.painting(), s.editor().clock().time(), view, Rect::of(0, 0, view.width, view.height)),
                 std::set<StrokeId>{1});
        s.editor().clock().lookAt(s.painting().end());
        s.use(Command::SelectAll);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
    }

    void aClickMeansTheWholeStrokeAgain()
    {
        Selecting s({line(1, {200, 200}, {400, 260})});
        s.editor().document().setSelection({{1}, {{1, 0}}}); // as the Segments tool left it
        s.use(Command::Select);
        const QPointF at = s.logical(s.canvas().view().toPixels({300, 230}));
        s.send(QEvent::MouseButtonPress, at, Qt::NoModifier);
        s.send(QEvent::MouseButtonRelease, at, Qt::NoModifier);
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        QVERIFY(s.editor().document().selection().segments.empty());
    }

    void theViewGoesToWhatIsSelected()
    {
        Selecting s({line(1, {200, 200}, {240, 220}), line(2, {700, 500}, {900, 500})});
        QAction &zoom = s.window.action(Command::ZoomToSelection);
        QVERIFY(!zoom.isEnabled());
        const auto shows = [&](const Rect &box) {
            const View &view = s.canvas().view();
            const Point a = view.toPixels({box.left, box.top}), b = view.toPixels({box.right, box.bottom});
            const Point across = b - a, middle = 0.5 * (a + b);
            QVERIFY(length(middle - Point{0.5 * view.width, 0.5 * view.height}) < 1);
            QVERIFY(across.x > 0.8 * view.width || across.y > 0.8 * view.height); // as large as possible
            QVERIFY(across.x < view.width && across.y < view.height);
        };
        s.select({2});
        s.editor().laterChanges().flush();
        QVERIFY(zoom.isEnabled());
        s.use(Command::ZoomToSelection);
        shows(s.seen(2));
        QVERIFY(!s.canvas().isFitted());
        s.select({1, 2});
        s.use(Command::ZoomToSelection);
        shows(s.seen(1).united(s.seen(2)));

        s.editor().document().setSelection({{2}, {{2, 3}}});
        s.use(Command::ZoomToSelection);
        Stroke end = s.stroke(2);
        end.segments = {end.segments[3]};
        shows(seenBox(end));

        s.select({1, 2});
        s.use(Command::Segments);
        dynamic_cast<NodeTool &>(*s.canvas().tool()).selectNodes({{1, 0}});
        s.use(Command::ZoomToSelection);
        shows(Rect{200, 200, 210, 205});
        QCOMPARE(s.steps(), 0);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestSelecting)
#include "test_selecting.moc"

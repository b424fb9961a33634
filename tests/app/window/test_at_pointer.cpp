// What opens where the pointer is: the menu, and what becomes of the hand's work meanwhile.
#include "app/session/colour_convert.h"
#include "app/tools/brush/brush_palette.h"
#include "app/widgets/asking/messages.h"
#include "tests/app/crossing.h"

#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>
#include <QTemporaryDir>

using namespace suffuse;

class TestAtPointer : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void menuNamesWhatLiesThereFromTheTop()
    {
        Crossing s;
        s.askAt({400, 300});
        QVERIFY(s.menu().isVisible());
        QCOMPARE(s.selected(), std::set<StrokeId>{3}); // as a click would
        const QStringList texts = s.texts();
        QVERIFY2(texts[0].endsWith("Stroke 3") && texts[1].endsWith("Stroke 2") && texts[2].endsWith("Stroke 1"),
                 qPrintable(texts.join('|')));
        QVERIFY(!s.entry("Stroke 2")->icon().isNull()); // its colour
        QVERIFY(s.entry("Stroke 3")->font().bold() && !s.entry("Stroke 2")->font().bold());
        QTest::keyClick(&s.menu(), Qt::Key_2);
        QVERIFY(!s.menu().isVisible());
        QCOMPARE(s.selected(), std::set<StrokeId>{2});
        QCOMPARE(s.steps(), 0);
    }

    /// What only bounds a fill has a colour that nobody sees.
    void menuShowsTheColourThatIsSeen()
    {
        const Colour red{1, 0, 0, 1}, blue{0, 0, 1, 1}, white{0, 0, 0, 1};
        Stroke area;
        area.id = 1;
        area.origin = {200, 200};
        area.style = {StyleKind::Uniform, {0.5f, 0.05f, 0}};
        const std::array<Point, 4> corners{Point{0, 0}, Point{400, 0}, Point{400, 200}, Point{0, 200}};
        for (std::size_t k = 0; k < 4; ++k) {
            Segment bound;
            bound.density = 0;
            bound.colour = white;
            for (std::size_t i = 0; i < 4; ++i)
                bound.bezier[i] = toOffset(corners[k] + (double(i) / 3) * (corners[(k + 1) % 4] - corners[k]), {0, 0});
            area.segments.push_back(bound);
        }
        Fill fill;
        fill.diffusion = 0;
        fill.colour = red;
        fill.gradient = Gradient{{100, 0}, {300, 0}, blue};
        area.fill = fill;
        Selecting s({std::make_shared<const Stroke>(area)});
        const auto shownAt = [&s](Point where) {
            QTest::mouseClick(&s.canvas(), Qt::RightButton, {}, s.at(where));
            QMenu &menu = *s.window.findChild<QMenu *>("canvasMenu");
            QColor shown;
            for (const QAction *action : menu.actions())
                if (!action->isSeparator() && action->text().contains("Stroke 1"))
                    shown = action->icon().pixmap(16, 16).toImage().pixelColor(8, 8);
            QTest::keyClick(&menu, Qt::Key_Escape);
            return shown.name();
        };
        QCOMPARE(shownAt({230, 300}), toOpaqueScreen(red).name());
        QCOMPARE(shownAt({570, 300}), toOpaqueScreen(blue).name());
        const QString between = shownAt({400, 300});
        QVERIFY(between != toOpaqueScreen(red).name() && between != toOpaqueScreen(blue).name());
    }

    /// As in other programs, what rulers count is chosen on them, whatever tool is in use.
    void aRulerAsksForItsUnit()
    {
        Crossing s;
        const auto askOnRuler = [&s](QPoint pixel) {
            QTest::mouseClick(&s.canvas(), Qt::RightButton, {}, pixel);
            const bool isThere = s.entry("Rulers in Millimetres") && s.entry("Add a Level Guide");
            if (s.menu().isVisible())
                QTest::keyClick(&s.menu(), Qt::Key_Escape);
            return isThere;
        };
        const QPoint onTop(300, 9), onLeft(9, 300);
        s.window.action(Command::ShowRulers).setChecked(true);
        for (const Command tool : {Command::Select, Command::Brush}) {
            s.use(tool);
            QVERIFY(askOnRuler(onTop));
            QVERIFY(askOnRuler(onLeft));
            QVERIFY(!s.palette() || !s.palette()->isVisible());
        }
        s.entry("Rulers in Millimetres")->trigger();
        QVERIFY(s.canvas().aids().rulerUnits == RulerUnits::Millimetres);
        s.entry("Rulers in Canvas Units")->trigger();
        QCOMPARE(s.selected(), std::set<StrokeId>{});
        s.use(Command::Select);
        QTest::mouseClick(&s.canvas(), Qt::RightButton, {}, s.at({250, 300}));
        QVERIFY(!s.entry("Rulers in Millimetres"));
        QTest::keyClick(&s.menu(), Qt::Key_Escape);
        s.window.action(Command::ShowRulers).setChecked(false);
        QVERIFY(!askOnRuler(onTop));
    }

    void menuDoesWhatCanBeDoneWithTheSelection()
    {
        Crossing s;
        s.askAt({250, 300});
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        for (const char *title :
             {"Copy", "Cut", "Duplicate", "Delete", "Group", "Lock", "Hide", "Arrange", "Reshape", "Edit Values Here"})
            QVERIFY2(s.entry(title), title);
        QVERIFY(!s.entry("Ungroup")); // nothing that cannot be done
        QVERIFY(!s.entry("Fit the Canvas"));
        QMenu *arrange = s.entry("Arrange")->menu();
        QVERIFY(arrange);
        for (QAction *action : arrange->actions())
            if (plainTitle(action->text()) == "Raise to Top")
                action->trigger();
        QCOMPARE(s.painting().strokes.back()->id, StrokeId(1));
        QCOMPARE(s.steps(), 1);
        QTest::keyClick(&s.menu(), Qt::Key_Escape);
        QVERIFY(!s.menu().isVisible());
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        QCOMPARE(s.steps(), 1);
        // What is selected stays so where the pointer is on it, among others or on empty paper.
        s.select({1, 2});
        s.askAt({250, 300});
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
        QTest::keyClick(&s.menu(), Qt::Key_Escape);
        s.askAt({60, 60});
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
        QVERIFY(!s.entry("Stroke"));
        QTest::keyClick(&s.menu(), Qt::Key_Escape);
    }

    void menuOfEmptyPaperIsAboutTheCanvas()
    {
        Crossing s;
        s.askAt({60, 60});
        QVERIFY(s.entry("Select All") && s.entry("Fit the Canvas") && s.entry("Show the Grid"));
        QVERIFY(!s.entry("Cut") && !s.entry("Group") && !s.entry("Stroke"));
        s.entry("Select All")->trigger();
        QCOMPARE(s.selected().size(), std::size_t(3));
        s.menu().hide();
    }

    void menuFollowsTheTool()
    {
        Crossing s;
        s.use(Command::Segments);
        s.editor().document().setSelection({{1}, {{1, 1}}});
        s.askAt({250, 300});
        QVERIFY(s.entry("Nodes", "Delete Segments"));
        QCOMPARE(s.selection().segments.size(), std::size_t(1)); // as it was
        s.menu().hide();
        s.select({});
        s.use(Command::Brush);
        s.askAt({400, 300}, shift); // without Shift it is the palette
        QVERIFY(s.menu().isVisible());
        QVERIFY(s.selected().empty()); // the Brush selects nothing by itself
        s.entry("Stroke 1")->trigger();
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        QVERIFY(s.window.action(Command::Select).isChecked()); // so that it is seen
        s.menu().hide();
    }

    /// What refines strokes is there, in menus below; each letter once.
    void menuHasWhatRefines()
    {
        Crossing s;
        s.select({1, 2});
        s.use(Command::CopyAppearance);
        s.askAt({250, 300});
        for (const auto &[menu, title] :
             std::initializer_list<std::pair<const char *, const char *>>{{"Combine and Break", "Combine"},
                                                                          {"Reshape", "Simplify"},
                                                                          {"Reshape", "Smooth"},
                                                                          {"Brush and Colours", "Apply Brush"},
                                                                          {"Brush and Colours", "Appearance"},
                                                                          {"Brush and Colours", "Recolour Artwork"}})
            QVERIFY2(s.entry(menu, title), title);
        QVERIFY(!s.entry("Combine and Break", "Break Apart")); // each is of one piece
        QVERIFY2(s.texts().size() < 22, qPrintable(s.texts().join('|')));
        QVERIFY2(sharedLetters(s.menu()).isEmpty(), qPrintable(sharedLetters(s.menu()).join('|')));
        s.entry("Combine and Break", "Combine")->trigger();
        QCOMPARE(s.painting().strokes.size(), std::size_t(2));
        QCOMPARE(s.steps(), 1);
        s.menu().hide();
        s.askAt({250, 300});
        QVERIFY(s.entry("Combine and Break", "Break Apart"));
        s.entry("Combine and Break", "Break Apart")->trigger(); // which changes the picture where the parts cross
        const QString said = s.window.statusBar()->currentMessage();
        QVERIFY2(said.startsWith("2 ") && said.contains("mixes"), qPrintable(said));
        s.use(Command::Undo);
        s.menu().hide();
        s.use(Command::Segments);
        s.editor().document().setSelection({{s.painting().strokes.front()->id}, {}});
        s.askAt({250, 300});
        QVERIFY(s.entry("Nodes", "Reverse"));
        QVERIFY2(sharedLetters(s.menu()).isEmpty(), qPrintable(sharedLetters(s.menu()).join('|')));
        s.menu().hide();
        s.select({});
        s.use(Command::Select);
        s.askAt({60, 60});
        QVERIFY(s.entry("Colours", "Recolour Artwork"));
        QVERIFY2(sharedLetters(s.menu()).isEmpty(), qPrintable(sharedLetters(s.menu()).join('|')));
        s.menu().hide();
    }

    void menuOpensByKeys()
    {
        Crossing s;
        QTest::mouseMove(&s.canvas(), s.at({400, 300}));
        s.key(Qt::Key_F10, shift);
        QVERIFY(s.menu().isVisible());
        QVERIFY(s.entry("Stroke 2"));
        QTest::keyClick(&s.menu(), Qt::Key_Escape);
        s.key(Qt::Key_Menu);
        QVERIFY(s.menu().isVisible());
        QTest::keyClick(&s.menu(), Qt::Key_Escape);
        QVERIFY(!s.menu().isVisible());
    }

    void aPressInADragAsksNothing()
    {
        Crossing s;
        s.pressAndMove({{250, 300}, {260, 330}}, none);
        QTest::mousePress(&s.canvas(), Qt::RightButton, {}, s.at({260, 330}));
        QVERIFY(!s.menu().isVisible());
        s.key(Qt::Key_Menu); // The release would run a row of the menu.
        s.key(Qt::Key_F10, shift);
        QVERIFY(!s.menu().isVisible());
        QVERIFY(s.canvas().tool()->isBusy());
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QCOMPARE(s.steps(), 0);
    }

    /// What opens takes the pointer's release, so the stroke in hand is painted as far as it has come. What would open
    /// under the pointer stays closed.
    void whatOpensFinishesTheStroke()
    {
        Crossing s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.use(Command::Brush);
        const auto begin = [&](double y) {
            s.canvas().setFocus();
            QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({250, y}));
            for (int i = 1; i <= 10; ++i) {
                s.advance(interval);
                QTest::mouseMove(&s.canvas(), s.at({250 + 10.0 * i, y}));
            }
            QVERIFY(s.canvas().tool()->isBusy());
        };
        begin(200);
        s.use(Command::CanvasMenu); // Under the pointer the release would choose something of it.
        s.use(Command::BrushPalette);
        QVERIFY(!s.menu().isVisible() && !(s.palette() && s.palette()->isVisible()));
        QVERIFY(s.canvas().tool()->isBusy());
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({350, 200}));
        QCOMPARE(s.painting().strokes.size(), std::size_t(4));
        begin(280);
        QMenu *file = s.window.menuBar()->actions().first()->menu();
        file->popup(s.window.mapToGlobal(QPoint(10, 10)));
        QTRY_VERIFY_WITH_TIMEOUT(!s.canvas().tool()->isBusy(), waitMs);
        file->hide();
        QCOMPARE(s.painting().strokes.size(), std::size_t(5));
        QVERIFY(s.painting().strokes.back()->segments.size() > 0);
        QCOMPARE(s.steps(), 2);
    }

    /// A stroke in hand when the window closes belongs to the work that is asked about.
    void closingFinishesTheStroke()
    {
        Crossing s;
        QTemporaryDir folder;
        QVERIFY(s.window.saveTo(folder.filePath("a.suffuse")));
        int asked = 0;
        MessageHooks hooks;
        hooks.unsaved = [&](const QString &) {
            ++asked;
            return SaveAnswer::Cancel;
        };
        setMessageHooks(hooks);
        const auto back = qScopeGuard([] { setMessageHooks({}); });
        s.use(Command::Brush);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({250, 200}));
        for (int i = 1; i <= 10; ++i) {
            s.advance(interval);
            QTest::mouseMove(&s.canvas(), s.at({250 + 10.0 * i, 200}));
        }
        QVERIFY(!s.window.close());
        QCOMPARE(asked, 1);
        QVERIFY(!s.canvas().tool()->isBusy());
        QCOMPARE(s.painting().strokes.size(), std::size_t(4));
    }

    /// The pen's button asks when it is let go: what opens would not let the canvas hear of it.
    void aPensButtonAsksWhenItIsLetGo()
    {
        Crossing s;
        s.use(Command::Brush);
        QPointingDevice device("test pen", 7, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen,
                               QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 2);
        const auto send = [&](QEvent::Type type, Qt::MouseButtons down) {
            const QPointF at = s.at({400, 300});
            QTabletEvent event(type, &device, at, s.canvas().mapToGlobal(at), 0.5, 0, 0, 0, 0, 0, {}, Qt::RightButton,
                               down);
            QCoreApplication::sendEvent(&s.canvas(), &event);
        };
        send(QEvent::TabletPress, Qt::RightButton);
        QVERIFY(!s.palette());
        send(QEvent::TabletRelease, Qt::NoButton);
        QVERIFY(s.palette() && s.palette()->isOpen());
        QCOMPARE(s.painting().strokes.size(), std::size_t(3));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestAtPointer)
#include "test_at_pointer.moc"

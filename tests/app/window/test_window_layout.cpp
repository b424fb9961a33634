// Where windows go, and how their docks share the room.
#include "app/panels/strokes/strokes_panel.h"
#include "app/panels/timeline/timeline_panel.h"
#include "app/panels/timeline/timeline_view.h"
#include "app/session/settings/settings.h"
#include "app/session/translation.h"
#include "app/widgets/habits/place_beside.h"
#include "app/window/layout/window_layout.h"
#include "model/formats/files.h"
#include "tests/app/shapes.h"

#include <QApplication>
#include <QDataStream>
#include <QDockWidget>
#include <QGuiApplication>
#include <QLineEdit>
#include <QMainWindow>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyle>
#include <QTemporaryDir>
#include <QToolBar>
#include <QToolButton>

#include <zlib.h>

using namespace suffuse;

class TestWindowLayout : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void init() { window_layout::reset(); }

    void rectanglesKeepToTheScreen()
    {
        const QRect screen(0, 20, 1000, 700);
        QCOMPARE(placeWithin({100, 100, 300, 200}, screen), QRect(100, 100, 300, 200));
        QCOMPARE(placeWithin({900, 600, 300, 200}, screen), QRect(700, 520, 300, 200));
        QCOMPARE(placeWithin({-50, 0, 300, 200}, screen), QRect(0, 20, 300, 200));
        QCOMPARE(placeWithin({28, 48, 1000, 900}, screen), screen);
    }

    /// No window opens exactly over another one, however many there are and however large they are.
    void windowsAreCascaded()
    {
        const QRect screen(0, 20, 1366, 748);
        QCOMPARE(placeCascaded({100, 100, 600, 400}, screen, {300, 200}, {}), QRect(128, 128, 600, 400));
        QCOMPARE(placeCascaded({100, 100, 600, 400}, screen, {300, 200}, {{128, 130, 9, 9}}), QRect(156, 156, 600, 400));
        for (const QRect &first : {QRect(100, 100, 600, 400), screen, QRect(0, 20, 1300, 700)}) {
            QList<QRect> windows = {first};
            for (int i = 0; i < 12; ++i) {
                const QRect next = placeCascaded(windows.back(), screen, {400, 300}, windows);
                QVERIFY(screen.contains(next));
                for (const QRect &other : windows)
                    QVERIFY((next.topLeft() - other.topLeft()).manhattanLength() >= 14);
                windows.append(next);
            }
        }
        Session s; // and as it is seen
        s.window.setGeometry(s.window.screen()->availableGeometry());
        s.paintLine({100, 100}, {300, 100});
        QWidget second, third;
        showLike(second, s.window);
        showLike(third, s.window);
        QVERIFY(second.pos() != s.window.pos() && third.pos() != s.window.pos() && second.pos() != third.pos());
        QVERIFY(s.window.screen()->availableGeometry().contains(third.frameGeometry()));
    }

    /// Half of 1920 pixels, which is what a screen of twice the usual density has.
    void everyLanguageFitsAScreenOf960()
    {
        for (const QString &code : translationCodes()) {
            settings::setLanguage(code);
            installTranslators();
            const auto back = qScopeGuard([] {
                settings::setLanguage("en");
                installTranslators();
            });
            Session s;
            s.window.resize(960, 560);
            for (const Command tool : {Command::Brush, Command::Select, Command::Segments, Command::Eraser}) {
                s.use(tool);
                QCoreApplication::sendPostedEvents();
                QVERIFY2(s.window.width() <= 960 && s.window.minimumSizeHint().width() <= 960,
                         qPrintable(QStringLiteral("%1: %2").arg(code).arg(s.window.width())));
            }
        }
    }

    /// No row of fields and no bar hides a part of itself behind an arrow.
    void everyBarIsWholeOnAScreenOf1280()
    {
        for (const QString &code : translationCodes()) {
            settings::setLanguage(code);
            installTranslators();
            const auto back = qScopeGuard([] {
                settings::setLanguage("en");
                installTranslators();
            });
            WaveSession s;              // with a stroke that is selected
            s.window.resize(1280, 680); // 720 less a title bar, and some as fonts differ
            QVERIFY(QTest::qWaitForWindowExposed(&s.window));
            for (const Command tool :
                 {Command::Brush, Command::Select, Command::Segments, Command::Shapes, Command::OutlinePen,
                  Command::LassoFill, Command::Bucket, Command::Text, Command::Redraw, Command::Push, Command::Knife,
                  Command::Eraser, Command::AttributeBrush, Command::Eyedropper, Command::Assistants, Command::Pan}) {
                s.use(tool);
                QTest::qWait(20);
                for (const QToolBar *bar : s.window.findChildren<QToolBar *>())
                    for (const QToolButton *arrow : bar->findChildren<QToolButton *>("qt_toolbar_ext_button"))
                        QVERIFY2(!arrow->isVisible(),
                                 qPrintable(QStringLiteral("%1, %2: %3 needs %4 of %5")
                                                .arg(code, s.window.action(tool).text(), bar->windowTitle())
                                                .arg(bar->sizeHint().width())
                                                .arg(bar->width())));
            }
        }
    }

    /// A laptop's screen of 1366 pixels has 683 at twice the usual density; a frame and a panel of the desktop need
    /// some.
    void everyLanguageLeavesRoomOnAScreenOf683()
    {
        for (const QString &code : translationCodes()) {
            settings::setLanguage(code);
            installTranslators();
            const auto back = qScopeGuard([] {
                settings::setLanguage("en");
                installTranslators();
            });
            Session s;
            s.window.resize(600, 560);
            QTest::qWait(20);
            QVERIFY2(s.window.width() <= 620, qPrintable(QStringLiteral("%1: %2").arg(code).arg(s.window.width())));
            // What of the timeline's row is cut can be scrolled to.
            auto *timeline = s.window.findChild<TimelinePanel *>();
            const auto *rows = timeline->findChild<QScrollArea *>();
            QTRY_VERIFY(rows->horizontalScrollBar()->isVisible());
            QVERIFY(rows->height() >= rows->widget()->minimumSizeHint().height());
            QVERIFY(timeline->view()->isVisible() && timeline->view()->height() > 30);
        }
    }

    /// A window that stood on another screen is no larger than this one, its frame included.
    void storedWindowsKeepToTheScreen()
    {
        const QRect room = QGuiApplication::primaryScreen()->availableGeometry();
        {
            QMainWindow large;
            large.setGeometry(QRect(room.topLeft() + QPoint(0, 20), room.size()));
            large.show();
            window_layout::save(large);
        }
        QMainWindow restored;
        QVERIFY(window_layout::restore(restored));
        const int title = restored.style()->pixelMetric(QStyle::PM_TitleBarHeight);
        QVERIFY(restored.height() <= room.height() - title);
        QVERIFY(restored.geometry().top() >= room.top() + title);
        QVERIFY(room.contains(restored.geometry()));
        // The first window of all does so, too, though its usual size may be larger.
        window_layout::reset();
        QMainWindow usual;
        usual.resize(room.size() + QSize(200, 100));
        QVERIFY(!window_layout::restore(usual));
        QVERIFY(usual.width() <= room.width() && usual.height() <= room.height() - title);
    }

    /// Qt does not restore the geometry of a screen of quite another width; docks and "maximised" are kept all the
    /// same.
    void maximisedIsKeptOnAnotherScreen()
    {
        QSettings &store = settings::store();
        {
            QMainWindow wide;
            auto *dock = new QDockWidget(&wide);
            dock->setObjectName("dock");
            wide.addDockWidget(Qt::LeftDockWidgetArea, dock);
            wide.showMaximized();
            dock->hide();
            window_layout::save(wide);
        }
        // As if it had been stored on a screen of twelve times the width.
        QByteArray body = QByteArray::fromBase64(store.value("layout/bytes").toString().toLatin1());
        const int width = QGuiApplication::primaryScreen()->geometry().width();
        QByteArray was, is;
        QDataStream(&was, QIODevice::WriteOnly) << qint32(width);
        QDataStream(&is, QIODevice::WriteOnly) << qint32(12 * width);
        constexpr qsizetype behindFlags = 4 + 4 + 4 + 16 + 16 + 4 + 2; // of the list of bytes, and of Qt's own
        QCOMPARE(body.mid(behindFlags, 4), was);
        body.replace(behindFlags, 4, is);
        store.setValue("layout/bytes", QString::fromLatin1(body.toBase64()));
        store.setValue(
            "layout/crc",
            QString::number(crc32(0, reinterpret_cast<const Bytef *>(body.constData()), uInt(body.size())), 16));
        QMainWindow restored;
        auto *dock = new QDockWidget(&restored);
        dock->setObjectName("dock");
        restored.addDockWidget(Qt::LeftDockWidgetArea, dock);
        QVERIFY(window_layout::restore(restored));
        QVERIFY(restored.isMaximized());
        QVERIFY(dock->isHidden());
        window_layout::reset();
    }

    /// A window that is opened from a maximised one is maximised, too, and has somewhere to go back to.
    void windowsOpenAsTheFirstOneStands()
    {
        const QString path = m_folder.filePath("one.suffuse");
        QVERIFY(savePainting(Painting(), path));
        for (const bool maximised : {false, true}) {
            MainWindow first;
            first.setGeometry(100, 90, 640, 520);
            maximised ? first.showMaximized() : first.show();
            const QRect screen = first.screen()->availableGeometry();
            MainWindow *own = first.openFile(path); // in it, since it is untouched
            QCOMPARE(own, &first);
            for (int k = 0; k < 3; ++k) {
                const QString other = m_folder.filePath(QString("%1-%2.suffuse").arg(maximised).arg(k));
                QVERIFY(savePainting(Painting(), other));
                MainWindow *next = first.openFile(other);
                QVERIFY(next && next != &first);
                QVERIFY(next->isVisible());
                QCOMPARE(next->isMaximized(), maximised);
                const QRect normal = maximised ? next->normalGeometry() : next->geometry();
                QVERIFY(screen.contains(normal.topLeft()) && normal.bottom() <= screen.bottom());
                QVERIFY(normal.right() <= screen.right() || normal.width() <= next->minimumSizeHint().width());
                next->close();
            }
        }
    }

    /// Half of a screen of 1920 × 1080 in each direction, less a title bar: what is left at a scale of 2.
    void allDocksFitOnALowScreen()
    {
        Session s;
        for (QDockWidget *dock : s.window.findChildren<QDockWidget *>())
            dock->show();
        s.window.resize(900, 505);
        QTest::qWait(50);
        QCOMPARE(s.window.height(), 505);
    }

    /// Hidden and shown again they are where they were, to the pixel.
    void hiddenDocksComeBackAsTheyWere()
    {
        Session s;
        const QList<QDockWidget *> docks = s.window.findChildren<QDockWidget *>();
        const auto dock = [&](const char *name) { return s.window.findChild<QDockWidget *>(name); };
        s.window.resizeDocks({dock("colourDock"), dock("inspectorDock")}, {367, 211}, Qt::Vertical);
        s.window.resizeDocks({dock("colourDock")}, {341}, Qt::Horizontal);
        s.window.resizeDocks({dock("timelineDock")}, {187}, Qt::Vertical);
        dock("brushesDock")->raise();
        QTest::qWait(50);
        const auto places = [&] {
            QList<QRect> list{s.canvas().geometry()};
            for (const QDockWidget *d : docks)
                list << (d->visibleRegion().isEmpty() ? QRect() : d->geometry()); // behind another one it has none
            return list;
        };
        const QList<QRect> before = places();
        for (int i = 0; i < 3; ++i) {
            s.use(Command::HideDocks);
            QTest::qWait(10);
            QVERIFY(places() != before);
            s.use(Command::HideDocks);
            QTest::qWait(10);
            QCOMPARE(places(), before);
        }
        s.use(Command::HideDocks);
        dock("probeDock")->show(); // opened meanwhile
        s.use(Command::HideDocks);
        QVERIFY(!dock("probeDock")->isHidden());
        QVERIFY(!dock("colourDock")->isHidden());
    }

    /// Colour and brushes are seen together on a low screen, as that of the tests is, and the canvas is the largest.
    void colourAndBrushesStandTogether()
    {
        Session s;
        s.window.resize(1366, 738);
        QTest::qWait(50);
        const auto seen = [&](const char *name) {
            return !s.window.findChild<QDockWidget *>(name)->visibleRegion().isEmpty();
        };
        QVERIFY(seen("colourDock") && seen("brushesDock") && !seen("inspectorDock"));
        const QDockWidget *colour = s.window.findChild<QDockWidget *>("colourDock");
        QVERIFY2(s.canvas().width() > 3 * colour->width(),
                 qPrintable(QString("%1 %2").arg(s.canvas().width()).arg(colour->width())));
        QVERIFY(s.canvas().height() > 0.65 * s.window.height());
        // The one of brushes and inspector is in front that the tool needs.
        s.use(Command::Select);
        QVERIFY(!seen("brushesDock") && seen("inspectorDock") && seen("colourDock"));
        s.use(Command::Brush);
        QVERIFY(seen("brushesDock") && !seen("inspectorDock"));
        // Who takes a brush by its key leaves the docks as they stand, and its tool brings them.
        s.use(Command::Select);
        QTest::keyClick(&s.canvas(), Qt::Key_2);
        QVERIFY(s.window.action(Command::Brush).isChecked());
        QVERIFY(!seen("brushesDock") && seen("inspectorDock"));
        QTest::keyClick(&s.canvas(), Qt::Key_B);
        QVERIFY(seen("brushesDock") && !seen("inspectorDock"));
        s.window.findChild<QDockWidget *>("strokesDock")->raise(); // somebody wants to see this
        s.use(Command::Select);
        s.use(Command::Brush);
        QVERIFY(seen("strokesDock"));
    }

    /// Whoever opens the timeline sees three lanes whole, and the most of the window is the canvas.
    void theTimelineShowsLanes()
    {
        Session s;
        s.window.resize(1366, 738);
        QTest::qWait(50);
        auto &view = *s.window.findChild<TimelinePanel *>()->view();
        constexpr double lane = TimelineAxes::laneHeight + TimelineAxes::laneGap;
        const int lanes = view.viewport()->height() - view.rulerHeight() - 4;
        QVERIFY2(lanes >= 3 * lane, qPrintable(QString::number(lanes / lane)));
    }

    /// Who asks for a dock that is open behind another one wants to see it; who asks for one that is seen closes it.
    void theMenuBringsDocksToTheFront()
    {
        Session s;
        s.window.resize(1300, 800);
        QVERIFY(QTest::qWaitForWindowExposed(&s.window));
        auto *front = s.window.findChild<QDockWidget *>("brushesDock");
        auto *behind = s.window.findChild<QDockWidget *>("strokesDock");
        s.window.tabifyDockWidget(front, behind);
        front->raise();
        QApplication::processEvents();
        const auto isSeen = [](const QDockWidget *dock) { return !dock->visibleRegion().isEmpty(); };
        QVERIFY(isSeen(front) && !isSeen(behind) && !behind->isHidden());
        QAction *entry = behind->toggleViewAction();
        QVERIFY(entry->isChecked());
        entry->trigger();
        QTRY_VERIFY(isSeen(behind));
        QVERIFY(entry->isChecked() && !behind->isHidden());
        entry->trigger();
        QTRY_VERIFY(behind->isHidden());
        QVERIFY(!entry->isChecked());
        entry->trigger();
        QTRY_VERIFY(isSeen(behind));
        QVERIFY(entry->isChecked());
    }

    /// Ctrl+F goes to the search of the Strokes dock, wherever that is.
    void theSearchIsReachedByAKey()
    {
        Session s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        auto *panel = s.window.findChild<StrokesPanel *>();
        s.window.findChild<QDockWidget *>("strokesDock")->hide();
        s.canvas().setFocus();
        QTest::keyClick(&s.canvas(), Qt::Key_F, Qt::ControlModifier);
        QTRY_VERIFY(panel->search()->hasFocus() && panel->isVisible());
    }

    /// The canvas would move below the pen, and the stroke would jump. Afterwards nobody expects it any more.
    void docksStayDuringTheStrokeInHand()
    {
        Session s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        const auto *dock = s.window.findChild<QDockWidget *>("colourDock");
        s.canvas().setFocus();
        const QRect place = s.canvas().geometry();
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({100, 200}));
        for (int i = 1; i <= 5; ++i) {
            s.advance(interval);
            QTest::mouseMove(&s.canvas(), s.at({100 + 20.0 * i, 200}));
        }
        QTest::keyClick(&s.canvas(), Qt::Key_Tab);
        QTest::qWait(10);
        QVERIFY(!dock->isHidden());
        QCOMPARE(s.canvas().geometry(), place);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({200, 200}));
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(s.canvas().geometry(), place);
        QTest::qWait(10);
        QVERIFY(!dock->isHidden());
        QTest::keyClick(&s.canvas(), Qt::Key_Tab);
        QTRY_VERIFY(dock->isHidden());
        QTest::keyClick(&s.canvas(), Qt::Key_Tab);
        QTRY_VERIFY(!dock->isHidden());
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestWindowLayout)
#include "test_window_layout.moc"

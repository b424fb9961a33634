// Where windows go, and how their docks share the room.
#include "app/panels/strokes/strokes_panel.h"
#include "app/panels/timeline/timeline_panel.h"
#include "app/panels/timeline/timeline_view.h"
#include "app/session/settings/settings.h"
#include "app/session/translation.h"
#include "app/widgets/habits/place_beside.h"
#include "app/widgets/look/elided_sentences.h"
#include "app/window/layout/window_layout.h"
#include "app/window/layout/workspaces.h"
#include "model/formats/files.h"
#include "tests/app/shapes.h"

#include <QApplication>
#include <QDataStream>
#include <QDockWidget>
#include <QFontMetrics>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMainWindow>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>
#include <QStyle>
#include <QTemporaryDir>
#include <QToolBar>
#include <QToolButton>
#include <QTreeView>

#include <zlib.h>

#include <map>
#include <tuple>

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
                  Command::Eraser, Command::AttributeBrush, Command::Eyedropper, Command::Pan}) {
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

    /// On a laptop's screen one reads all of what the status bar says of painting in the past.
    void whatIsSaidOfThePastFits()
    {
        for (const QString &code : translationCodes()) {
            settings::setLanguage(code);
            installTranslators();
            const auto back = qScopeGuard([] {
                settings::setLanguage("en");
                installTranslators();
            });
            Session s;
            s.window.resize(1366, 768);
            QVERIFY(QTest::qWaitForWindowExposed(&s.window));
            s.use(Command::Brush);
            s.paintLine({100, 100}, {300, 100});
            s.dry();
            const QString hint = s.canvas().tool()->hint();
            s.editor().clock().lookAt(s.painting().end() / 2);
            QVERIFY(s.editor().clock().isInPast());
            const QLabel *line = nullptr;
            for (const QLabel *label : s.window.statusBar()->findChildren<QLabel *>())
                if (label->toolTip().endsWith('\n' + hint))
                    line = label;
            QVERIFY2(line, qPrintable(code));
            QVERIFY(!line->text().isEmpty() && line->toolTip().startsWith(line->text()));
            QVERIFY2(line->fontMetrics().horizontalAdvance(line->text()) <= line->contentsRect().width(),
                     qPrintable(code));
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

    /// Whether what is written up to `right` ends in "…": ink at the foot of the line only.
    static bool endsInDots(QWidget &widget, int right)
    {
        const QImage image = widget.grab().toImage();
        const QColor ground = widget.palette().color(QPalette::Window);
        const auto topOfInk = [&](int x) {
            for (int y = 2; y < image.height(); ++y)
                if (std::abs(qGray(image.pixel(x, y)) - qGray(ground.rgb())) > 60)
                    return y;
            return -1;
        };
        int last = std::min(right, image.width() - 1);
        while (last > 0 && topOfInk(last) < 0)
            --last;
        return last > 0 && topOfInk(last) > image.height() / 2;
    }

    /// A hint that is too long ends behind a sentence, not within one.
    void hintsAreCutBehindASentence()
    {
        const QFontMetrics metrics(QApplication::font());
        const auto cut = [&](const QString &text, const QString &roomOf) {
            return elidedSentences(text, metrics, metrics.horizontalAdvance(roomOf));
        };
        const QString text = "Drag: paint. Shift+drag: 1.5 times. Ctrl+click: colour of the picture.";
        QCOMPARE(cut(text, text), text);
        QCOMPARE(cut(text, "Drag: paint. Shift+drag: 1.5 times. Ctrl+cl"),
                 QString("Drag: paint. Shift+drag: 1.5 times. …"));
        QCOMPARE(cut(text, "Drag: paint. Shift+drag"), QString("Drag: paint. …"));
        const QString wide = QStringLiteral("拖动绘画。右键打开调色板。按住 Ctrl 取颜色。");
        QCOMPARE(cut(wide, QStringLiteral("拖动绘画。右键打开调色板。按住")),
                 QStringLiteral("拖动绘画。右键打开调色板。…"));
        // A long sentence is not left out for a short one.
        const QString uneven = "Drag. Shift+drag from paint to paint: all that lies in between is taken";
        const QString line = cut(uneven, "Drag. Shift+drag from paint to paint: all that");
        QVERIFY2(line.startsWith("Drag. Shift+drag from paint") && line.endsWith(u'…'), qPrintable(line));
    }

    /// What the status bar has no room for is in the tool tip.
    void statusTextsEndInDotsWhereTheyAreCut()
    {
        Session s;
        s.window.resize(s.window.minimumSizeHint().width(), 700);
        QVERIFY(QTest::qWaitForWindowExposed(&s.window));
        QStatusBar &bar = *s.window.statusBar();
        const QString hint = s.canvas().tool()->hint();
        QLabel *line = nullptr;
        for (QLabel *label : bar.findChildren<QLabel *>())
            if (label->text() == hint)
                line = label;
        QVERIFY(line && line->isVisible());
        QVERIFY(line->fontMetrics().horizontalAdvance(hint) > line->width());
        QVERIFY(endsInDots(*line, line->width()));
        QCOMPARE(line->toolTip(), hint);
        const int right = line->geometry().right();
        const QString message(300, 'H');
        bar.showMessage(message);
        QVERIFY(!line->isVisible());
        QVERIFY(endsInDots(bar, right));
        QCOMPARE(bar.toolTip(), message);
        bar.showMessage("HHH");
        QVERIFY(!endsInDots(bar, right)); // all of it is there
        bar.clearMessage();
        QCOMPARE(bar.toolTip(), QString());
        QVERIFY(line->isVisible());
    }

    /// A message takes the room that there is, also within a sentence.
    void messagesFillTheirLine()
    {
        Session s;
        s.window.resize(1300, 700);
        QVERIFY(QTest::qWaitForWindowExposed(&s.window));
        QStatusBar &bar = *s.window.statusBar();
        int right = bar.width(); // where the numbers begin
        for (const auto *number : bar.findChildren<QLabel *>())
            if (number->objectName() != QLatin1String("hint") && number->isVisible())
                right = std::min(right, number->x());
        QString first = "H";
        while (bar.fontMetrics().horizontalAdvance(first) < 0.6 * right)
            first += 'H';
        bar.showMessage(first + ". " + QString(300, 'H') + '.');
        QVERIFY(endsInDots(bar, right));
        const QImage image = bar.grab().toImage();
        const int ground = qGray(image.pixel(right - 2, 4));
        bool isFull = false; // to the last tenth
        for (int x = int(0.9 * right); x < right; ++x)
            for (int y = 4; y < image.height() - 4; ++y)
                isFull = isFull || std::abs(qGray(image.pixel(x, y)) - ground) > 60;
        QVERIFY(isFull);
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

    /// Whatever was done to docks and tool bars, one command puts them back.
    void resetLayoutPutsAllBack()
    {
        Session s;
        s.window.resize(1000, 480); // lower than all docks one below the other
        QTest::qWait(50);
        const QSize size = s.window.size();
        const auto dock = [&](const char *name) { return s.window.findChild<QDockWidget *>(name); };
        const auto bar = [&](const char *name) { return s.window.findChild<QToolBar *>(name); };
        const QList<QDockWidget *> docks = s.window.findChildren<QDockWidget *>();
        using Place = std::tuple<Qt::DockWidgetArea, bool, bool, bool, QSet<QDockWidget *>>;
        const auto places = [&] {
            QList<Place> list;
            for (QDockWidget *d : docks) {
                const QList<QDockWidget *> tabs = s.window.tabifiedDockWidgets(d);
                list << Place{s.window.dockWidgetArea(d), d->isFloating(), d->isHidden(), d->visibleRegion().isEmpty(),
                              QSet(tabs.begin(), tabs.end())};
            }
            return list;
        };
        const QList<Place> before = places();
        const int width = dock("colourDock")->width(), height = dock("timelineDock")->height();
        for (const bool hidden : {false, true}) {
            dock("colourDock")->setFloating(true);
            s.window.addDockWidget(Qt::LeftDockWidgetArea, dock("inspectorDock"));
            s.window.resizeDocks({dock("brushesDock")}, {500}, Qt::Horizontal);
            dock("timelineDock")->hide();
            dock("probeDock")->show();
            s.window.addToolBar(Qt::RightToolBarArea, bar("tools"));
            bar("toolOptions")->hide();
            if (hidden)
                s.use(Command::HideDocks);
            QTest::qWait(20);
            QVERIFY(places() != before);
            s.use(Command::ResetLayout);
            QTest::qWait(50);
            QVERIFY(places() == before);
            QCOMPARE(s.window.size(), size);
            QVERIFY(!s.window.action(Command::HideDocks).isChecked());
            QVERIFY(std::abs(dock("colourDock")->width() - width) <= 2);
            QVERIFY(std::abs(dock("timelineDock")->height() - height) <= 2);
            QCOMPARE(s.window.toolBarArea(bar("tools")), Qt::LeftToolBarArea);
            QCOMPARE(s.window.toolBarArea(bar("toolOptions")), Qt::TopToolBarArea);
            QVERIFY(bar("tools")->isVisible() && bar("toolOptions")->isVisible());
        }
        QCOMPARE(s.editor().undoStack().count(), 0);
    }

    /// Each shows what its work needs, and leaves the most of the window to the canvas.
    void workspacesComeAlong()
    {
        Session s;
        s.window.resize(1366, 738);
        QTest::qWait(20);
        const auto shown = [&] {
            QSet<QString> names;
            for (const QDockWidget *dock : s.window.findChildren<QDockWidget *>())
                if (!dock->isHidden())
                    names << dock->objectName();
            return names;
        };
        const auto seen = [&](const char *name) {
            return !s.window.findChild<QDockWidget *>(name)->visibleRegion().isEmpty();
        };
        s.window.findChild<QDockWidget *>("probeDock")->show();
        s.use(Command::WorkspacePaint);
        QTest::qWait(20);
        QCOMPARE(shown(), (QSet<QString>{"colourDock", "brushesDock", "strokesDock"}));
        QVERIFY(seen("colourDock") && seen("brushesDock"));
        QVERIFY(s.canvas().height() > 0.8 * s.window.height());
        s.use(Command::HideDocks);
        s.use(Command::WorkspaceRefine);
        QTest::qWait(20);
        QVERIFY(!s.window.action(Command::HideDocks).isChecked());
        QCOMPARE(shown(), (QSet<QString>{"colourDock", "inspectorDock", "strokesDock", "historyDock"}));
        QVERIFY(seen("inspectorDock"));
        s.use(Command::WorkspaceTime);
        QTest::qWait(20);
        QCOMPARE(shown(), (QSet<QString>{"inspectorDock", "strokesDock", "timelineDock"}));
        const int high = s.window.findChild<QDockWidget *>("timelineDock")->height();
        s.use(Command::ResetLayout);
        QTest::qWait(20);
        QVERIFY(high > 1.3 * s.window.findChild<QDockWidget *>("timelineDock")->height());
        QCOMPARE(s.window.size(), QSize(1366, 738));
    }

    /// A workspace comes back in another window, and damaged bytes are not given to Qt.
    void workspacesAreSaved()
    {
        settings::store().remove("workspaces");
        const auto workspaces = [](Session &s) { return s.window.findChild<Workspaces *>(); };
        {
            Session s;
            s.window.findChild<QDockWidget *>("timelineDock")->hide();
            s.window.addDockWidget(Qt::LeftDockWidgetArea, s.window.findChild<QDockWidget *>("strokesDock"));
            QTest::qWait(20);
            workspaces(s)->save("Mine & yours");
            workspaces(s)->save("Äpfel");
            workspaces(s)->save("Mine & yours");
        }
        QCOMPARE(Workspaces::names(), (QStringList{"Äpfel", "Mine & yours"}));
        Session s;
        auto *timeline = s.window.findChild<QDockWidget *>("timelineDock");
        auto *strokes = s.window.findChild<QDockWidget *>("strokesDock");
        QVERIFY(!timeline->isHidden() && s.window.dockWidgetArea(strokes) == Qt::RightDockWidgetArea);
        QVERIFY(workspaces(s)->choose("Mine & yours"));
        QVERIFY(timeline->isHidden() && s.window.dockWidgetArea(strokes) == Qt::LeftDockWidgetArea);
        QVERIFY(!workspaces(s)->choose("nobody's"));
        QMenu menu;
        menu.addAction("fixed");
        for (int i = 0; i < 2; ++i) { // It is filled anew each time.
            workspaces(s)->fillMenu(menu);
            QCOMPARE(menu.actions().size(), 5);
            QCOMPARE(menu.actions()[3]->text(), QString("Mine && yours"));
        }
        s.use(Command::ResetLayout);
        menu.actions()[3]->trigger();
        QVERIFY(timeline->isHidden());
        Workspaces::remove("Äpfel");
        QCOMPARE(Workspaces::names(), QStringList{"Mine & yours"});
        QStringList stored = settings::store().value("workspaces/saved").toStringList();
        stored[0].chop(8);
        settings::store().setValue("workspaces/saved", stored);
        s.use(Command::ResetLayout);
        QVERIFY(!workspaces(s)->choose("Mine & yours"));
        QVERIFY(!timeline->isHidden());
        settings::store().remove("workspaces");
    }

    /// A layout that was stored is put back as it was, whatever the first start looks like now.
    void storedLayoutsAreKept()
    {
        const auto place = [](MainWindow &window, const char *name) {
            const auto *dock = window.findChild<QDockWidget *>(name);
            return std::tuple(window.dockWidgetArea(const_cast<QDockWidget *>(dock)), dock->isFloating(),
                              window.tabifiedDockWidgets(const_cast<QDockWidget *>(dock)).size());
        };
        const char *const names[] = {"colourDock", "brushesDock", "inspectorDock", "strokesDock", "historyDock"};
        std::map<QString, std::tuple<Qt::DockWidgetArea, bool, qsizetype>> before;
        {
            Session s;
            const auto dock = [&](const char *name) { return s.window.findChild<QDockWidget *>(name); };
            s.window.tabifyDockWidget(dock("colourDock"), dock("brushesDock")); // as it was before
            s.window.addDockWidget(Qt::LeftDockWidgetArea, dock("strokesDock"));
            dock("timelineDock")->hide();
            QTest::qWait(20);
            for (const char *name : names)
                before[name] = place(s.window, name);
            window_layout::save(s.window);
        }
        Session s; // puts it back
        QTest::qWait(20);
        for (const char *name : names)
            QVERIFY2(place(s.window, name) == before[name], name);
        QVERIFY(s.window.findChild<QDockWidget *>("timelineDock")->isHidden());
        QCOMPARE(std::get<0>(before["strokesDock"]), Qt::LeftDockWidgetArea);
        window_layout::reset();
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

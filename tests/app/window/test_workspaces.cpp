// Arrangements of docks: the usual one, that of the last start, those that come along, and those that people save.
#include "app/session/settings/settings.h"
#include "app/session/translation.h"
#include "app/window/layout/window_layout.h"
#include "app/window/layout/workspaces.h"
#include "tests/app/session.h"

#include <QDockWidget>
#include <QMenu>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>

#include <map>
#include <tuple>

using namespace suffuse;

class TestWorkspaces : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
        settings::setLanguage("en"); // by whose rules names are sorted
        installTranslators();
    }

    void init() { window_layout::reset(); }

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

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestWorkspaces)
#include "test_workspaces.moc"

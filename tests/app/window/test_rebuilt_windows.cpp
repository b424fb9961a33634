// Settings that windows are built by: other windows show the same paintings, and nothing is lost.
#include "app/dialogs/settings_dialog.h"
#include "app/panels/brushes/brush_panel.h"
#include "app/panels/strokes/strokes_panel.h"
#include "app/session/settings/brush_library.h"
#include "app/session/settings/settings.h"
#include "app/session/translation.h"
#include "app/window/layout/window_layout.h"
#include "app/window/rebuilt_windows.h"
#include "tests/app/file_dialogs.h"
#include "tests/app/shapes.h"

#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QPointer>
#include <QSpinBox>
#include <QTemporaryDir>

using namespace suffuse;

namespace {

MainWindow *onlyWindow()
{
    MainWindow *found = nullptr;
    for (QWidget *widget : QApplication::topLevelWidgets())
        if (auto *window = qobject_cast<MainWindow *>(widget); window && window->isVisible()) {
            if (found)
                return nullptr;
            found = window;
        }
    return found;
}

StrokePtr addWave(MainWindow &window, double x)
{
    Document &document = window.editor().document();
    const StrokePtr stroke = wave(document.takeStrokeId(), x, 300);
    window.editor().push(addStrokes(document, {stroke}, true), "wave");
    return stroke;
}

} // namespace

class TestRebuiltWindows : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder->filePath("settings.ini").toLocal8Bit());
        settings::setLanguage("en");
        installTranslators();
        Journal::setFolder(m_folder->filePath("journals"));
    }
    void cleanup()
    {
        settings::setLanguage("en");
        installTranslators();
        Journal::setFolder({});
    }

    void languageChangesAtOnceAndNothingIsLost()
    {
        QPointer<MainWindow> old = new MainWindow;
        old->setAttribute(Qt::WA_DeleteOnClose);
        old->setGeometry(20, 40, 1000, 600);
        old->show();
        old->editor().clock().setManual(true);
        const StrokePtr first = addWave(*old, 200);
        addWave(*old, 250);
        old->editor().undoStack().undo();
        old->editor().document().setSelection({{first->id}, {}});
        old->action(Command::Segments).trigger();
        old->action(Command::SnapToNodes).setChecked(true);
        old->canvas().setZoom(2.5);
        old->canvas().panBy({40, -30});
        old->playback().setSpeed(7);
        old->findChild<QDockWidget *>("historyDock")->raise();
        const PaintingPtr painting = old->editor().document().snapshot();
        Editor *editor = &old->editor();
        Journal *journal = &old->journal();
        const View view = old->canvas().view();
        const QString title = old->windowTitle();
        QCOMPARE(old->menuBar()->actions()[0]->text(), QString("&File"));

        settings::setLanguage("de");
        rebuildWindows();
        QTRY_VERIFY(!old);
        MainWindow *now = onlyWindow();
        QVERIFY(now);
        QCOMPARE(now->menuBar()->actions()[0]->text(), QString("&Datei"));
        QCOMPARE(now->findChild<QDockWidget *>("strokesDock")->windowTitle(), QString("Striche"));
        QCOMPARE(&now->editor(), editor);
        QCOMPARE(&now->journal(), journal);
        QCOMPARE(now->editor().document().snapshot(), painting);
        QCOMPARE(now->editor().undoStack().count(), 2);
        QVERIFY(now->editor().undoStack().canRedo());
        QCOMPARE(now->editor().document().selection(), (Selection{{first->id}, {}}));
        QVERIFY(now->action(Command::Segments).isChecked());
        QVERIFY(now->action(Command::SnapToNodes).isChecked());
        QVERIFY(now->action(Command::Copy).isEnabled());
        QCOMPARE(now->canvas().view().scale, view.scale);
        QVERIFY(length(now->canvas().view().centre - view.centre) < 1e-6);
        QCOMPARE(now->playback().speed(), 7.0);
        QCOMPARE(now->geometry(), QRect(20, 40, 1000, 600));
        QVERIFY(now->testAttribute(Qt::WA_DeleteOnClose));
        QVERIFY(now->windowTitle() != title); // it has no name: "Untitled"
        QVERIFY(now->isWindowModified());

        // It is worked on.
        now->action(Command::Redo).trigger();
        QCOMPARE(now->editor().document().painting()->strokes.size(), std::size_t(2));
        QTRY_VERIFY_WITH_TIMEOUT(now->canvas().isUpToDate(), waitMs);
        now->action(Command::Select).trigger();
        now->action(Command::SelectAll).trigger();
        now->action(Command::Delete).trigger();
        QVERIFY(now->editor().document().painting()->strokes.empty());
        now->action(Command::Undo).trigger();
        QCOMPARE(now->editor().document().painting()->strokes.size(), std::size_t(2));
        // And back.
        settings::setLanguage("zh_CN");
        rebuildWindows();
        settings::setLanguage("en");
        rebuildWindows();
        QTRY_VERIFY(onlyWindow());
        QCOMPARE(onlyWindow()->menuBar()->actions()[0]->text(), QString("&File"));
        QCOMPARE(onlyWindow()->editor().document().painting()->strokes.size(), std::size_t(2));
        onlyWindow()->journal().remove();
        delete onlyWindow();
    }

    /// Whoever changes the language goes on in the window in which it was done.
    void theWindowInFrontStaysThere()
    {
        const auto names = [] {
            QStringList titles;
            for (QWidget *widget : QApplication::topLevelWidgets())
                if (auto *window = qobject_cast<MainWindow *>(widget); window && window->isVisible())
                    titles << window->editor().document().painting()->strokes.front()->name;
            return titles;
        };
        for (const char *name : {"a", "b", "c"}) {
            auto *window = new MainWindow;
            window->setAttribute(Qt::WA_DeleteOnClose);
            window->show();
            const StrokeId id = addWave(*window, 200)->id;
            window->editor().push(changeStrokes(window->editor().document(), {id}, [&](Stroke &s) { s.name = name; }),
                                  "name");
        }
        for (const char *name : {"b", "a", "c"}) {
            MainWindow *front = nullptr;
            for (QWidget *widget : QApplication::topLevelWidgets())
                if (auto *window = qobject_cast<MainWindow *>(widget);
                    window && window->isVisible() &&
                    window->editor().document().painting()->strokes.front()->name == name)
                    front = window;
            QVERIFY(front);
            settings::setLanguage(QString(name) == "a" ? "en" : "de");
            rebuildWindowsSoon(*front);
            QTRY_VERIFY([&] {
                auto *active = qobject_cast<MainWindow *>(QApplication::activeWindow());
                return active && active != front &&
                       active->editor().document().painting()->strokes.front()->name == name;
            }());
            QCOMPARE(names().size(), 3);
        }
        QList<QPointer<MainWindow>> windows;
        for (QWidget *widget : QApplication::topLevelWidgets())
            if (auto *window = qobject_cast<MainWindow *>(widget); window && window->isVisible())
                windows << window;
        for (const QPointer<MainWindow> &window : windows) {
            window->journal().remove();
            delete window;
        }
    }

    void threadsChangeAtOnce()
    {
        int threads = -1;
        const MakeRenderer make = [&threads](const RendererOptions &options) {
            threads = options.threads;
            return makeRenderer(options);
        };
        auto *window = new MainWindow(nullptr, make);
        window->setAttribute(Qt::WA_DeleteOnClose);
        window->show();
        QTRY_VERIFY_WITH_TIMEOUT(window->canvas().isUpToDate(), waitMs);
        QCOMPARE(threads, 0);
        settings::setThreads(1);
        rebuildWindows();
        QTRY_VERIFY(onlyWindow());
        QTRY_VERIFY_WITH_TIMEOUT(onlyWindow()->canvas().isUpToDate(), waitMs);
        QCOMPARE(threads, 1);
        delete onlyWindow();
    }

    /// What windows are built by asks for other ones, and nothing else does.
    void theSettingsDialogAsksForOtherWindows()
    {
        QPointer<MainWindow> window = new MainWindow;
        window->setAttribute(Qt::WA_DeleteOnClose);
        window->show();
        int answered = 0;
        const auto change = [&](const std::function<void(SettingsDialog &)> &set) {
            whenAsked<SettingsDialog>(this, answered, [set](SettingsDialog &dialog) {
                set(dialog);
                dialog.accept();
            });
            onlyWindow()->action(Command::Settings).trigger();
            QTest::qWait(1); // the action goes with its window, so that comes later
        };
        change([](SettingsDialog &dialog) { dialog.backups()->setValue(7); });
        QCOMPARE(settings::backups(), 7);
        QCOMPARE(onlyWindow(), window.data());
        change([](SettingsDialog &dialog) { dialog.threads()->setValue(1); });
        QTRY_VERIFY(!window && onlyWindow());
        QPointer<MainWindow> second = onlyWindow();
        change([](SettingsDialog &dialog) { dialog.language()->setCurrentIndex(dialog.language()->findData("de")); });
        QTRY_VERIFY(!second && onlyWindow());
        QCOMPARE(onlyWindow()->menuBar()->actions()[0]->text(), QString("&Datei"));
        QCOMPARE(answered, 3);
        delete onlyWindow();
    }

    /// Docks that are hidden come back as they were.
    void hiddenDocksStayHidden()
    {
        auto *window = new MainWindow;
        window->setAttribute(Qt::WA_DeleteOnClose);
        window->show();
        window->action(Command::HideDocks).trigger();
        rebuildWindows();
        QTRY_VERIFY(onlyWindow());
        QVERIFY(onlyWindow()->action(Command::HideDocks).isChecked());
        QVERIFY(onlyWindow()->findChild<QDockWidget *>("colourDock")->isHidden());
        onlyWindow()->action(Command::HideDocks).trigger();
        QVERIFY(!onlyWindow()->findChild<QDockWidget *>("colourDock")->isHidden());
        delete onlyWindow();
    }

    /// A layout of a maximised window that does not fit the screen of now, as one saved at another scale. A window that
    /// takes the place of another has its layout alone: where it was given the stored one before, Qt went on with rows
    /// of that which were gone.
    void aStoredLayoutThatDoesNotFitIsNoTrap()
    {
        const auto hideDocks = [](MainWindow &window, bool hidden) {
            for (QDockWidget *dock : window.findChildren<QDockWidget *>())
                dock->setHidden(hidden);
        };
        {
            MainWindow wide;
            wide.resize(2600, 800);
            wide.show();
            for (QDockWidget *dock : wide.findChildren<QDockWidget *>()) { // one beside the other
                wide.removeDockWidget(dock);
                wide.addDockWidget(Qt::RightDockWidgetArea, dock, Qt::Horizontal);
            }
            hideDocks(wide, false);
            QApplication::processEvents();
            wide.setWindowState(Qt::WindowMaximized);
            window_layout::save(wide);
            wide.journal().remove();
        }
        auto *window = new MainWindow;
        window->setAttribute(Qt::WA_DeleteOnClose);
        window->show();
        QVERIFY(window->isMaximized());
        hideDocks(*window, true);
        QTRY_VERIFY(!settings::store().contains("layout/starting")); // the stored one was put back, and that went well
        for (const char *language : {"de", "en"}) {
            settings::setLanguage(language);
            rebuildWindows();
            QVERIFY(!settings::store().contains("layout/starting"));
            QTRY_VERIFY(onlyWindow());
            QApplication::processEvents();
            QVERIFY(onlyWindow()->isMaximized());
            QVERIFY(onlyWindow()->findChild<QDockWidget *>("colourDock")->isHidden());
        }
        onlyWindow()->journal().remove();
        delete onlyWindow();
    }

    /// The docks show what they showed: what is searched for, and the brush in hand.
    void docksGoOnWhereTheyWere()
    {
        auto *window = new MainWindow;
        window->setAttribute(Qt::WA_DeleteOnClose);
        window->setGeometry(20, 40, 1000, 600);
        window->show();
        addWave(*window, 200);
        window->findChild<QDockWidget *>("brushesDock")->raise();
        const QString last = BrushLibrary::instance().brushes().back().name;
        BrushLibrary::instance().use(window->editor(), last);
        window->findChild<StrokesPanel *>()->search()->setText("wa");
        QCoreApplication::processEvents();
        for (const char *language : {"de", "zh_CN", "en"}) {
            settings::setLanguage(language);
            rebuildWindows();
            QTRY_VERIFY(onlyWindow());
            auto *strokes = onlyWindow()->findChild<StrokesPanel *>();
            QCOMPARE(strokes->search()->text(), QString("wa"));
            QVERIFY(strokes->isSearching());
            const auto *brushes = onlyWindow()->findChild<BrushPanel *>();
            QCOMPARE(brushes->search()->text(), QString());
            QListWidget *list = brushes->list();
            QTRY_VERIFY(list->isVisible());
            QTRY_VERIFY(list->currentItem() == brushes->itemOf(last) &&
                        list->viewport()->rect().contains(list->visualItemRect(list->currentItem())));
        }
        onlyWindow()->findChild<StrokesPanel *>()->search()->clear();
        onlyWindow()->findChild<BrushPanel *>()->search()->setText("x");
        settings::setLanguage("de");
        rebuildWindows();
        QTRY_VERIFY(onlyWindow());
        QCOMPARE(onlyWindow()->findChild<BrushPanel *>()->search()->text(), QString("x"));
        QVERIFY(!onlyWindow()->findChild<StrokesPanel *>()->isSearching());
        onlyWindow()->journal().remove();
        delete onlyWindow();
    }

    /// It goes on in the new window.
    void whatPlaysGoesOn()
    {
        auto *window = new MainWindow;
        window->setAttribute(Qt::WA_DeleteOnClose);
        window->show();
        addWave(*window, 200);
        window->playback().setSpeed(0.1);
        window->playback().play();
        rebuildWindows();
        QTRY_VERIFY(onlyWindow());
        QVERIFY(onlyWindow()->playback().isPlaying());
        QCOMPARE(onlyWindow()->action(Command::Play).iconText().isEmpty(), false);
        onlyWindow()->playback().pause();
        delete onlyWindow();
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_MAIN(TestRebuiltWindows)
#include "test_rebuilt_windows.moc"

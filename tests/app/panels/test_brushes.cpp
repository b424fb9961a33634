// The brush library and the Brushes dock.
#include "app/panels/brushes/brush_panel.h"
#include "app/session/commands/commands.h"
#include "app/session/settings/brush_library.h"
#include "app/session/settings/settings.h"
#include "app/widgets/brush/brush_grid.h"
#include "app/widgets/brush/brush_preview.h"
#include "app/widgets/numbers/slider_field.h"
#include "model/brush/brush_width.h"
#include "tests/app/panel_bench.h"
#include "tests/app/session.h"

#include <QDockWidget>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QScopeGuard>
#include <QScrollBar>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QToolButton>

using namespace suffuse;

class TestBrushes : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        QStandardPaths::setTestModeEnabled(true);
        QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)).removeRecursively();
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void libraryKeepsOwnBrushes()
    {
        const QString folder = m_folder.filePath("own");
        QString name;
        {
            BrushLibrary library(folder);
            QCOMPARE(library.brushes().size(), builtinBrushes().size());
            Brush brush = builtinBrushes()[1];
            brush.name = "  Reed / pen ";
            Result<QString> added = library.add(brush);
            QVERIFY2(added, qPrintable(added.error()));
            QCOMPARE(*added, QString("Reed / pen"));
            Result<QString> again = library.add(brush);
            QCOMPARE(*again, QString("Reed / pen 2"));
            brush.name = "Reed / pen 2";
            brush.peak = 3;
            QVERIFY(library.save(brush));
            QVERIFY(!library.save(builtinBrushes()[0]));
            QVERIFY(!library.remove("ink-wash"));
            library.setFavourite("Reed / pen 2", true);
            QVERIFY(!library.rename("Reed / pen 2", "ink-wash")); // taken
            QVERIFY(library.rename("Reed / pen 2", "Quill"));
            QVERIFY(library.isFavourite("Quill") && !library.find("Reed / pen 2"));
            QVERIFY(library.remove("Reed / pen"));
            QCOMPARE(QDir(folder).entryList(QDir::Files).size(), 1);
            QVERIFY(library.exportTo("brush-pen", m_folder.filePath("out.suffuse-brush")));
        }
        QVERIFY(writeFileAtomically(folder + "/broken.suffuse-brush", "{"));
        BrushLibrary reopened(folder);
        QCOMPARE(reopened.brushes().size(), builtinBrushes().size() + 1);
        QCOMPARE(reopened.find("Quill")->peak, 3.0f);
        QVERIFY(reopened.isOwn("Quill") && !reopened.isOwn("ink-wash"));
        Result<QString> imported = reopened.import(m_folder.filePath("out.suffuse-brush"));
        QVERIFY2(imported, qPrintable(imported.error()));
        QCOMPARE(*imported, QString("Brush pen")); // built-in ones have their title outside
        QCOMPARE(reopened.find("Brush pen")->dynamics, findBrush("brush-pen")->dynamics);
        QVERIFY(!reopened.import(m_folder.filePath("nothing.myb")));
    }

    void favouritesHaveKeys()
    {
        Session s;
        const QStringList names = BrushLibrary::instance().favourites();
        QCOMPARE(names.size(), 9);
        s.use(Command::Select);
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.canvas().setFocus();
        QTest::keyClick(&s.canvas(), Qt::Key_4);
        QCOMPARE(s.editor().brush().name, names[3]);
        QVERIFY(s.window.action(Command::Brush).isChecked());
        QCOMPARE(s.window.action(Command::Favourite4).text(), brushTitle(names[3]));
        const double zoom = s.canvas().view().scale;
        QTest::keyClick(&s.canvas(), Qt::Key_1);
        QCOMPARE(s.canvas().view().scale, zoom); // Ctrl+1 is 100 %
        QCOMPARE(s.editor().brush().name, names[0]);
        BrushLibrary::instance().setFavourite(names[0], false);
        QCOMPARE(s.window.action(Command::Favourite1).text(), brushTitle(names[1]));
        QVERIFY(!s.window.action(Command::Favourite9).isVisible());
        BrushLibrary::instance().setFavourite(names[0], true);
        QCOMPARE(BrushLibrary::instance().favourites().last(), names[0]);
    }

    void brushInHandIsKept()
    {
        const QString store = m_folder.filePath("kept.ini");
        qputenv("SUFFUSE_SETTINGS", store.toLocal8Bit());
        const auto back =
            qScopeGuard([this] { qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit()); });
        Brush hand = *findBrush("soft-airbrush");
        hand.setSpread(33);
        hand.colour = {0.25f, 0.5f, 0.75f, 0.5f};
        {
            Session s;
            QCOMPARE(s.editor().brush(), builtinBrushes().front());
            s.editor().setBrush(hand);
            QTRY_COMPARE_WITH_TIMEOUT(settings::brush(), hand, waitMs); // without closing
            hand.peak *= 2;
            s.editor().setBrush(hand);
            s.editor().undoStack().clear();
            QVERIFY(s.window.close()); // at once
        }
        QCOMPARE(Session().editor().brush(), hand);
        const QByteArray whole = writeBrush(hand);
        for (const QByteArray &damaged : {QByteArray(), QByteArray("nonsense"), QByteArray("{}"), QByteArray(9000, '{'),
                                          whole.chopped(9), QByteArray(whole).replace("\"peak\":", "\"peak\":-")}) {
            settings::store().setValue("brush", QString::fromLatin1(damaged.toBase64()));
            QCOMPARE(Session().editor().brush(), builtinBrushes().front());
        }
    }

    void newWindowsTakeTheBrushInHand()
    {
        const QString path = m_folder.filePath("other.json");
        QVERIFY(writeFileAtomically(path, writePainting(Painting(), FileFormat::Text)));
        Session s;
        s.paintLine({200, 300}, {700, 300}); // else the file opens here
        Brush hand = *findBrush("glow");
        hand.setSpread(21);
        s.editor().setBrush(hand);
        const std::unique_ptr<MainWindow> other(s.window.openFile(path));
        QVERIFY(other && other.get() != &s.window);
        QCOMPARE(other->editor().brush(), hand);
        settings::store().remove("brush");
    }

    void choosingKeepsTheColour()
    {
        Bench bench;
        bench.editor.setColour({0.1f, 0.2f, 0.3f, 1});
        BrushPanel panel(bench.editor);
        showAt(panel, {280, 700});
        const Brush &preset = *findBrush("flat-marker");
        panel.list()->setCurrentItem(panel.itemOf(preset.name));
        QCOMPARE(bench.editor.brush().name, preset.name);
        QCOMPARE(bench.editor.brush().colour.blue, 0.3f);
        QCOMPARE(bench.editor.brush().colour.opacity, preset.colour.opacity);
        QVERIFY(!panel.resetButton()->isEnabled());
        type(*panel.size()->number(), "40");
        QVERIFY(std::abs(visibleWidth(bench.editor.brush()) - 40) < 1e-3);
        QCOMPARE(bench.editor.brush().peak, preset.peak);
        QVERIFY(panel.resetButton()->isEnabled());
        QTest::mouseClick(panel.resetButton(), Qt::LeftButton);
        QCOMPARE(bench.editor.brush().diffusion, preset.diffusion);
        QVERIFY(!panel.resetButton()->isEnabled());
    }

    /// As in Krita: a brush is found as it was left, until the program ends or it is reloaded.
    void changesOfABrushAreKept()
    {
        Bench bench;
        BrushPanel panel(bench.editor);
        showAt(panel, {280, 700});
        const Brush &marker = *findBrush("flat-marker"), &pencil = *findBrush("pencil");
        const auto isMarked = [&](const Brush &brush) {
            return panel.itemOf(brush.name)->toolTip().contains("Changed");
        };
        panel.list()->setCurrentItem(panel.itemOf(marker.name));
        const QImage unmarked = panel.itemOf(marker.name)->icon().pixmap(112, 44).toImage();
        type(*panel.size()->number(), "40");
        QVERIFY(isMarked(marker));
        QVERIFY(panel.itemOf(marker.name)->icon().pixmap(112, 44).toImage() != unmarked);
        panel.list()->setCurrentItem(panel.itemOf(pencil.name));
        QVERIFY(isSameBrush(bench.editor.brush(), pencil));
        QVERIFY(isMarked(marker) && !isMarked(pencil));
        bench.editor.setColour({0.1f, 0.2f, 0.3f, 1});
        panel.list()->setCurrentItem(panel.itemOf(marker.name));
        QVERIFY(std::abs(visibleWidth(bench.editor.brush()) - 40) < 1e-3);
        QCOMPARE(bench.editor.brush().colour.blue, 0.3f); // the colour belongs to the hand
        // The key of the brush in hand does not change it.
        BrushLibrary::instance().use(bench.editor, marker.name);
        QVERIFY(std::abs(visibleWidth(bench.editor.brush()) - 40) < 1e-3);

        QAction *reload = nullptr;
        emit panel.menu()->aboutToShow();
        for (QAction *action : panel.menu()->actions())
            reload = plainTitle(action->text()) == "Reload" ? action : reload;
        QVERIFY(reload && reload->isEnabled());
        reload->trigger();
        QVERIFY(isSameBrush(bench.editor.brush(), marker));
        QVERIFY(!isMarked(marker));
        emit panel.menu()->aboutToShow();
        for (const QAction *action : panel.menu()->actions())
            QVERIFY(plainTitle(action->text()) != "Reload" || !action->isEnabled());
        panel.list()->setCurrentItem(panel.itemOf(pencil.name));
        panel.list()->setCurrentItem(panel.itemOf(marker.name));
        QVERIFY(isSameBrush(bench.editor.brush(), marker));
    }

    /// Changes that were saved under another name are that brush's, and the old one is as it came.
    void changesGoIntoTheNewBrush()
    {
        BrushLibrary library(m_folder.filePath("kept"));
        Bench bench;
        library.use(bench.editor, "flat-marker");
        Brush changed = bench.editor.brush();
        changed.setSpread(33);
        bench.editor.setBrush(changed);
        library.use(bench.editor, "pencil");
        QVERIFY(library.hasChanges("flat-marker"));
        library.use(bench.editor, "flat-marker");
        QVERIFY(!library.hasChanges("flat-marker")); // they are in hand
        changed.name = "Mine";
        QCOMPARE(*library.add(changed), QString("Mine"));
        library.use(bench.editor, "Mine");
        QSignalSpy spy(&library, &BrushLibrary::changesKept);
        library.forgetChanges("flat-marker");
        QCOMPARE(spy.count(), 1);
        library.use(bench.editor, "flat-marker");
        QVERIFY(isSameBrush(bench.editor.brush(), *findBrush("flat-marker")));
    }

    void dockSearchesAndShowsFavourites()
    {
        Bench bench;
        BrushPanel panel(bench.editor);
        showAt(panel, {280, 700});
        for (const Brush &brush : builtinBrushes())
            QVERIFY2(panel.itemOf(brush.name), qPrintable(brush.name));
        panel.search()->setText("chal");
        QVERIFY(panel.itemOf("dry-chalk") && !panel.itemOf("ink-wash"));
        QCOMPARE(panel.list()->count(), 2);  // with its group's heading
        panel.search()->setText("watercol"); // a group
        QVERIFY(panel.itemOf("glaze") && panel.itemOf("two-tone"));
        panel.search()->clear();
        panel.favouritesButton()->click();
        QVERIFY(panel.itemOf("pencil") && !panel.itemOf("gouache"));
        panel.favouritesButton()->click();
        QTRY_COMPARE_WITH_TIMEOUT(panel.pendingPreviews(), 0, waitMs);
        // The brush menu: favourite on and off.
        panel.list()->setCurrentItem(panel.itemOf("gouache"));
        emit panel.menu()->aboutToShow();
        const auto actions = panel.menu()->actions();
        const auto it = std::find_if(actions.begin(), actions.end(), [](QAction *a) { return a->isCheckable(); });
        QVERIFY(it != actions.end() && !(*it)->isChecked());
        (*it)->trigger();
        QVERIFY(BrushLibrary::instance().isFavourite("gouache"));
        BrushLibrary::instance().setFavourite("gouache", false);
    }

    /// The brush that a search means most is marked and stands at the top of what is seen, below its group's heading,
    /// and is not taken before Return.
    void theBestHitIsSeen()
    {
        Bench bench;
        BrushPanel panel(bench.editor);
        showAt(panel, {200, 420});
        BrushLibrary::instance().use(bench.editor, "glow");
        const auto isOnTop = [&panel](const QString &name) {
            const QListWidgetItem *item = panel.list()->currentItem();
            if (!item || BrushGrid::brushOf(item) != name)
                return false;
            const QRect seen = panel.list()->viewport()->rect(), at = panel.list()->visualItemRect(item);
            return seen.contains(at) && at.top() < at.height();
        };
        panel.search()->setText("glaze");
        QVERIFY(isOnTop("glaze"));
        panel.search()->setText("wash"); // in the names of many, and of a group
        const QString best = BrushGrid::brushOf(panel.list()->currentItem());
        QVERIFY2(isOnTop(best) && brushTitle(best).contains("wash", Qt::CaseInsensitive), qPrintable(best));
        panel.search()->setText("s"); // many
        QVERIFY(brushTitle(BrushGrid::brushOf(panel.list()->currentItem())).startsWith("s", Qt::CaseInsensitive));
        QVERIFY(isOnTop(BrushGrid::brushOf(panel.list()->currentItem())));
        panel.search()->setText("pencil");
        QVERIFY(isOnTop("pencil"));
        QCOMPARE(bench.editor.brush().name, QString("glow"));
        QTest::keyClick(panel.search(), Qt::Key_Return);
        QCOMPARE(bench.editor.brush().name, QString("pencil"));
        panel.search()->clear();
        QCOMPARE(BrushGrid::brushOf(panel.list()->currentItem()), QString("pencil"));
    }

    /// Return in the search of the dock takes what was found, as it does in the list of the tool's row.
    void returnTakesWhatWasSearchedFor()
    {
        Bench bench;
        BrushPanel panel(bench.editor);
        showAt(panel, {280, 700});
        BrushLibrary::instance().use(bench.editor, "pencil");
        QSignalSpy chosen(&panel, &BrushPanel::chosen);
        panel.search()->setFocus();
        const auto search = [&panel](const QString &text) {
            panel.search()->clear();
            QTest::keyClicks(panel.search(), text);
            QTest::keyClick(panel.search(), Qt::Key_Return);
        };
        search("chal");
        QCOMPARE(bench.editor.brush().name, QString("dry-chalk"));
        QCOMPARE(chosen.count(), 1);
        search("wash"); // several: the first of them
        QString first;
        for (int row = 0; row < panel.list()->count() && first.isEmpty(); ++row)
            first = BrushGrid::brushOf(panel.list()->item(row));
        QCOMPARE(bench.editor.brush().name, first);
        for (const char *name : {"flat-wash", "wet-in-wet"}) { // as files and the manual write them
            search(name);
            QCOMPARE(bench.editor.brush().name, QString(name));
        }
        const int before = int(chosen.count());
        const QString inHand = bench.editor.brush().name;
        search("no such thing");
        QCOMPARE(int(chosen.count()), before);
        QCOMPARE(bench.editor.brush().name, inHand);
        // The empty list says that it is empty.
        QImage empty = panel.list()->viewport()->grab().toImage();
        const QRgb ground = empty.pixel(2, empty.height() - 3);
        bool speaks = false;
        for (int y = 0; y < empty.height() / 2 && !speaks; ++y)
            for (int x = 0; x < empty.width(); ++x)
                speaks = speaks || std::abs(qGray(empty.pixel(x, y)) - qGray(ground)) > 30;
        QVERIFY(speaks);
    }

    /// What was clicked is what the hand goes on with at the canvas.
    void clicksOnBrushesLeaveTheKeyboard()
    {
        Session s;
        auto *panel = s.window.findChild<BrushPanel *>();
        for (QWidget *parent = panel; parent; parent = parent->parentWidget())
            if (auto *dock = qobject_cast<QDockWidget *>(parent))
                dock->raise();
        QTRY_VERIFY(!panel->list()->visibleRegion().isEmpty());
        s.window.activateWindow();
        QTRY_VERIFY(s.window.isActiveWindow());
        const auto click = [&](const char *name) {
            QListWidgetItem *item = panel->itemOf(name);
            panel->list()->scrollToItem(item);
            QTest::mouseClick(panel->list()->viewport(), Qt::LeftButton, {},
                              panel->list()->visualItemRect(item).center());
        };
        click("pencil");
        QTRY_COMPARE(QApplication::focusWidget(), static_cast<QWidget *>(&s.canvas()));
        QCOMPARE(s.editor().brush().name, QString("pencil"));
        panel->search()->setFocus();
        QTest::keyClicks(panel->search(), "chal");
        click("dry-chalk");
        QTRY_COMPARE(QApplication::focusWidget(), static_cast<QWidget *>(&s.canvas()));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_V);
        QVERIFY(s.window.action(Command::Select).isChecked());
        panel->search()->clear();
    }

    void previewsArePaint()
    {
        BrushPreview preview;
        for (const Brush &brush : builtinBrushes()) {
            const QImage picture = preview.render(brush, {112, 44});
            QCOMPARE(picture.size(), QSize(112, 44));
            int painted = 0;
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x)
                    painted += qAlpha(picture.pixel(x, y)) > 24;
            QVERIFY2(painted > 100 && painted < 112 * 44 * 9 / 10, qPrintable(brush.name));
        }
    }

    /// A window that takes the place of another one gets its size bit by bit. What is in hand stays in sight, unless
    /// somebody has scrolled it away.
    void theBrushInHandStaysInSight()
    {
        Editor editor;
        const QString last = BrushLibrary::instance().brushes().back().name;
        BrushLibrary::instance().use(editor, last);
        BrushPanel panel(editor);
        showAt(panel, {312, 900});
        const QListWidget *list = panel.list();
        const auto isSeen = [&] {
            const QListWidgetItem *item = panel.itemOf(last);
            return item == list->currentItem() && list->viewport()->rect().contains(list->visualItemRect(item));
        };
        QTRY_VERIFY(isSeen());
        for (const int height : {500, 280, 330, 260}) {
            panel.resize(312, height);
            QTRY_VERIFY2(list->verticalScrollBar()->maximum() > 0, qPrintable(QString::number(height)));
            QTRY_VERIFY2(isSeen(), qPrintable(QString::number(height)));
        }
        list->verticalScrollBar()->setValue(0);
        panel.list()->viewport()->repaint();
        QVERIFY(!isSeen());
        panel.resize(312, 300);
        QTest::qWait(200); // longer than a view waits before it lays out its items
        QCOMPARE(list->verticalScrollBar()->value(), 0);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestBrushes)
#include "test_brushes.moc"

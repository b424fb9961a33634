// Brushes under the hand: library, dock, settings, tool, stabiliser and the pen's dynamics.
#include "app/panels/brushes/brush_dialog.h"
#include "app/panels/brushes/brush_panel.h"
#include "app/session/commands/commands.h"
#include "app/session/painting/stabiliser.h"
#include "app/session/settings/brush_library.h"
#include "app/session/settings/settings.h"
#include "app/tools/brush/brush_tool.h"
#include "app/widgets/brush/brush_grid.h"
#include "app/widgets/curves/response_editor.h"
#include "app/widgets/numbers/slider_field.h"
#include "model/formats/files.h"
#include "model/painting/validate.h"
#include "tests/app/panel_bench.h"
#include "tests/app/session.h"

#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QToolButton>

#include <numbers>

using namespace suffuse;

namespace {

double spreadOf(const Segment &s)
{
    return std::sqrt(4.0 * s.diffusion * s.maxAge);
}

/// A pen that is tilted.
struct TiltedPen {
    QPointingDevice device{"tilted pen",
                           8,
                           QInputDevice::DeviceType::Stylus,
                           QPointingDevice::PointerType::Pen,
                           QInputDevice::Capability::Position | QInputDevice::Capability::Pressure,
                           1,
                           1};

    void send(QWidget &widget, QEvent::Type type, QPointF at, double pressure, int tilt)
    {
        const bool down = type != QEvent::TabletRelease;
        QTabletEvent event(type, &device, at, widget.mapToGlobal(at), pressure, float(tilt), 0, 0, 0, 0, {},
                           type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton,
                           down ? Qt::LeftButton : Qt::NoButton);
        QCoreApplication::sendEvent(&widget, &event);
    }
};

} // namespace

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
        QVERIFY(std::abs(bench.editor.brush().spread() - 40) < 1e-3);
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
        QVERIFY(std::abs(bench.editor.brush().spread() - 40) < 1e-3);
        QCOMPARE(bench.editor.brush().colour.blue, 0.3f); // the colour belongs to the hand
        // The key of the brush in hand does not change it.
        BrushLibrary::instance().use(bench.editor, marker.name);
        QVERIFY(std::abs(bench.editor.brush().spread() - 40) < 1e-3);

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

    void dialogChangesTheBrushInHand()
    {
        Bench bench;
        BrushLibrary::instance().use(bench.editor, "flat-marker");
        BrushDialog dialog(bench.editor);
        dialog.show();
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.previewImage().isNull(), waitMs);
        QTableWidgetItem *cell = dialog.curves()->item(int(BrushQuantity::Size), int(BrushInput::Pressure));
        QVERIFY(!dialog.curve()->isEnabled());
        cell->setCheckState(Qt::Checked);
        const ResponseCurve *curve = bench.editor.brush().curve(BrushQuantity::Size, BrushInput::Pressure);
        QVERIFY(curve && dialog.curve()->isEnabled());
        QCOMPARE(dialog.curve()->curve(), *curve);
        // Drag the right end down by half.
        const QPoint from = dialog.curve()->toWidget({1, 1}).toPoint(),
                     to = dialog.curve()->toWidget({1, 0.5}).toPoint();
        QTest::mousePress(dialog.curve(), Qt::LeftButton, {}, from);
        QTest::mouseMove(dialog.curve(), to);
        QTest::mouseRelease(dialog.curve(), Qt::LeftButton, {}, to);
        const double end = bench.editor.brush().curve(BrushQuantity::Size, BrushInput::Pressure)->at(1);
        QVERIFY2(std::abs(end - 0.5) < 0.05, qPrintable(QString::number(end)));
        cell->setCheckState(Qt::Unchecked);
        QVERIFY(!bench.editor.brush().curve(BrushQuantity::Size, BrushInput::Pressure));
        type(*dialog.field("Taper out")->number(), "4");
        QCOMPARE(bench.editor.brush().taper.out, 4.0f);
        // The size stays when the drying time changes.
        const double spread = bench.editor.brush().spread();
        type(*dialog.field("Drying time")->number(), "3");
        QVERIFY(std::abs(bench.editor.brush().spread() - spread) < 1e-4);
        dialog.style()->setCurrentIndex(2);
        emit dialog.style()->activated(2);
        QCOMPARE(bench.editor.brush().style.kind, StyleKind::Edge);
        // ξ2 is bounded by ξ1: refused, and the brush stays in its domain.
        type(*dialog.field("ξ2")->number(), "5");
        QCOMPARE(bench.editor.brush().style.xi[1], 0.5f);
        QCOMPARE(problemOf(bench.editor.brush()), QString());
    }

    /// Esc gives a drag of the curve up, and only then closes the dialog.
    void escapeGivesUpADragOfTheCurve()
    {
        Bench bench;
        BrushLibrary::instance().use(bench.editor, "flat-marker");
        BrushDialog dialog(bench.editor);
        dialog.show();
        dialog.curves()->item(int(BrushQuantity::Size), int(BrushInput::Pressure))->setCheckState(Qt::Checked);
        ResponseEditor &curve = *dialog.curve();
        const Brush before = bench.editor.brush();
        curve.setFocus();
        QTest::mousePress(&curve, Qt::LeftButton, {}, curve.toWidget({1, 1}).toPoint());
        QTest::mouseMove(&curve, curve.toWidget({1, 0.4}).toPoint());
        QVERIFY(!(bench.editor.brush() == before)); // it works at once
        QTest::keyClick(&curve, Qt::Key_Escape);
        QCOMPARE(bench.editor.brush(), before);
        QVERIFY(dialog.isVisible());
        QTest::mouseMove(&curve, curve.toWidget({1, 0.2}).toPoint());
        QTest::mouseRelease(&curve, Qt::LeftButton, {}, curve.toWidget({1, 0.2}).toPoint());
        QCOMPARE(bench.editor.brush(), before); // the drag is over
        QTest::keyClick(&curve, Qt::Key_Escape);
        QVERIFY(!dialog.isVisible());
    }

    void penDynamicsReachTheStroke()
    {
        Session s;
        Brush brush = *findBrush("flat-marker");
        brush.setCurve(BrushQuantity::Size, BrushInput::Pressure, {{{0, 0}, {1, 1}}});
        brush.setCurve(BrushQuantity::Density, BrushInput::Tilt, {{{0, 1}, {1, 0.5f}}});
        brush.setCurve(BrushQuantity::Granulation, BrushInput::Speed, {{{0, 1}, {1, 0}}});
        brush.fullSpeed = 500;
        s.editor().setBrush(brush);
        TiltedPen pen;
        std::vector<Stroke> strokes;
        for (const auto &[pressure, tilt, pace] :
             {std::tuple(0.5, 0, 16'000), std::tuple(1.0, 60, 16'000), std::tuple(1.0, 0, 4'000)}) {
            const QPointF start = s.at({150, 200.0 + 100 * double(strokes.size())});
            pen.send(s.canvas(), QEvent::TabletPress, start, pressure, tilt);
            for (int i = 1; i <= 40; ++i) {
                s.advance(pace);
                pen.send(s.canvas(), QEvent::TabletMove, start + QPointF(8 * i, 0), pressure, tilt);
            }
            pen.send(s.canvas(), QEvent::TabletRelease, start + QPointF(320, 0), 0, tilt);
            s.dry();
            strokes.push_back(*s.painting().strokes.back());
            QCOMPARE(problemOf(strokes.back()), QString());
        }
        QCOMPARE(strokes.size(), std::size_t(3));
        const auto middle = [&](int i) {
            return strokes[std::size_t(i)].segments[strokes[std::size_t(i)].segments.size() / 2];
        };
        const double full = brush.spread();
        QVERIFY(std::abs(spreadOf(middle(0)) - 0.5 * full) < 0.02 * full);
        QVERIFY(std::abs(spreadOf(middle(1)) - full) < 1e-3);
        QVERIFY(std::abs(middle(1).density / middle(2).density - 0.5) < 0.02);
        QVERIFY(middle(2).granulation < middle(1).granulation - 0.1f); // faster
        // What was painted live is what its file holds.
        const QString path = m_folder.filePath("pen.suffuse");
        QVERIFY(savePainting(s.painting(), path));
        Result<Painting> reloaded = loadPainting(path);
        QVERIFY(reloaded && *reloaded == s.painting());
    }

    void livePictureIsThatOfTheFinishedStroke()
    {
        for (const char *name : {"brush-pen", "dry-brush", "broad-nib"}) {
            Session s;
            BrushLibrary::instance().use(s.editor(), name);
            s.paintLine({150, 200}, {700, 400});
            s.dry();
            const QImage live = s.canvas().picture();
            auto again = std::make_shared<Painting>(s.painting());
            s.editor().document().reset(std::make_shared<Painting>());
            s.editor().document().reset(again);
            s.dry();
            QVERIFY2(s.canvas().picture() == live, name);
        }
    }

    void keysAndShiftDragChangeSizeAndOpacity()
    {
        Session s;
        s.window.activateWindow(); // shortcuts are its
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        auto &tool = *static_cast<BrushTool *>(s.canvas().tool());
        s.canvas().setFocus();
        const double before = s.editor().brush().spread();
        for (int i = 0; i < 4; ++i)
            QTest::keyClick(&s.canvas(), Qt::Key_BracketRight);
        QVERIFY(std::abs(s.editor().brush().spread() / before - 2) < 1e-5);
        QVERIFY(tool.note().contains("Size"));
        QTest::keyClick(&s.canvas(), Qt::Key_BraceLeft); // typing it, Shift is a part of the key
        QVERIFY(tool.note().contains("Opacity"));
        QTRY_VERIFY_WITH_TIMEOUT(tool.note().isEmpty(), waitMs);
        const Brush brush = s.editor().brush();
        const QPoint from = s.at({300, 300});
        const auto drag = [&](QPoint by, bool release) {
            QTest::mousePress(&s.canvas(), Qt::LeftButton, Qt::ShiftModifier, from);
            QTest::mouseMove(&s.canvas(), from + by / 2);
            QTest::mouseMove(&s.canvas(), from + by);
            if (release)
                QTest::mouseRelease(&s.canvas(), Qt::LeftButton, Qt::ShiftModifier, from + by);
        };
        drag({80, 3}, true);
        QVERIFY(std::abs(s.editor().brush().spread() / brush.spread() - 2) < 1e-5);
        QCOMPARE(s.editor().brush().colour, brush.colour);
        drag({-80, 0}, true);
        QVERIFY(std::abs(s.editor().brush().spread() / brush.spread() - 1) < 1e-5);
        drag({2, 60}, true);
        QVERIFY(std::abs(s.editor().brush().colour.opacity - (brush.colour.opacity - 0.3f)) < 1e-5);
        const Brush now = s.editor().brush();
        drag({120, 0}, false);
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QCOMPARE(s.editor().brush(), now);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, Qt::ShiftModifier, from);
        QVERIFY(s.painting().strokes.empty());
        QCOMPARE(s.editor().undoStack().count(), 0);
    }

    void optionsRowFollowsTheBrush()
    {
        Session s;
        QWidget *row = s.canvas().tool()->options();
        const auto combos = row->findChildren<QComboBox *>();
        QCOMPARE(combos.size(), 2);
        const int at = combos[0]->findData("glaze");
        QVERIFY(at >= 0);
        emit combos[0]->activated(at);
        QCOMPARE(s.editor().brush().name, QString("glaze"));
        QCOMPARE(combos[0]->currentText(), QString("Glaze"));
        emit combos[1]->activated(2);
        QCOMPARE(s.editor().brush().stabiliser.kind, Stabiliser::Kind::String);
        BrushLibrary::instance().use(s.editor(), "brush-pen");
        QCOMPARE(combos[1]->currentIndex(), 1);
    }

    void weightedStabiliserSmooths()
    {
        const auto roughness = [](const Stabiliser &settings) {
            PenStabiliser stabiliser;
            double sum = 0, y = 0;
            for (int i = 0; i <= 200; ++i) {
                const PenSample pen{{3.0 * i, i % 2 ? 4.0 : -4.0}, i * 8'000};
                if (i == 0)
                    stabiliser.begin(settings, pen, 0);
                const auto out = stabiliser.take(pen);
                if (out)
                    sum += std::abs(out->position.y - std::exchange(y, out->position.y));
            }
            return sum;
        };
        const double off = roughness({}), half = roughness({Stabiliser::Kind::Weighted, 0.5f}),
                     full = roughness({Stabiliser::Kind::Weighted, 1});
        QVERIFY(off > 1500 && half < 0.12 * off && full < half);
        // The stroke ends where the pen lifts.
        PenStabiliser stabiliser;
        stabiliser.begin({Stabiliser::Kind::Weighted, 1}, {{0, 0}, 0}, 0);
        stabiliser.take({{100, 0}, 8'000});
        QCOMPARE(stabiliser.finish({{120, 0}, 16'000})->position, (Point{120, 0}));
    }

    void stringPullsTheStroke()
    {
        PenStabiliser stabiliser;
        stabiliser.begin({Stabiliser::Kind::String}, {{0, 0}, 0}, 30);
        QVERIFY(!stabiliser.take({{20, 0}, 8'000})); // slack
        QCOMPARE(*stabiliser.anchor(), (Point{0, 0}));
        const auto pulled = stabiliser.take({{50, 0}, 16'000});
        QVERIFY(pulled && std::abs(pulled->position.x - 20) < 1e-9);
        QVERIFY(!stabiliser.take({{20, 29}, 24'000})); // around the end: nothing moves
        QVERIFY(!stabiliser.finish({{45, 0}, 32'000}));
        // On the canvas: the stroke stays a string's length behind.
        Session s;
        Brush brush = *findBrush("flat-marker");
        brush.stabiliser = {Stabiliser::Kind::String, 0.5f, 50};
        s.editor().setBrush(brush);
        s.paintLine({150, 300}, {600, 300});
        const Stroke &stroke = *s.painting().strokes.back();
        const Point end = stroke.cubicOf(stroke.segments.back()).p[3];
        const double length = 50 / s.canvas().view().scale * s.canvas().devicePixelRatioF();
        QVERIFY2(std::abs(end.x - (600 - length)) < 3, qPrintable(QString::number(end.x)));
    }

    /// The status bar says so until something else is done.
    void paintBeyondTheCanvasIsNoSecret()
    {
        settings::setHasSelected(); // else it would be said how that is done
        Session s;
        const QString said = "This stroke lies beyond the canvas: View ▸ Show Paint beyond the Canvas shows it.";
        const auto hint = [&s] { return s.canvas().tool()->hint(); };
        const QString usual = hint();
        s.canvas().zoomBy(0.5);
        s.click({100, 100});
        QCOMPARE(hint(), usual);
        const QSignalSpy changed(s.canvas().tool(), &Tool::hintChanged);
        s.click({-300, 300});
        QCOMPARE(s.painting().strokes.size(), std::size_t(2)); // it is kept
        QCOMPARE(hint(), said);
        QCOMPARE(changed.size(), 1);
        s.paintLine({-200, 300}, {300, 300}); // part of it is seen
        QCOMPARE(hint(), usual);
        s.click({-300, 400});
        QCOMPARE(hint(), said);
        s.editor().undoStack().undo();
        QCOMPARE(hint(), usual);
        s.use(Command::ShowBeyond);
        s.click({-300, 400});
        QCOMPARE(hint(), usual);
        s.use(Command::ShowBeyond);
    }

    void choosingABrushTakesTheBrushTool()
    {
        Session s;
        auto *dock = s.window.findChild<QDockWidget *>("brushesDock");
        QVERIFY(dock);
        dock->raise();
        auto &panel = *s.window.findChild<BrushPanel *>();
        QListWidget &list = *panel.list();
        QTRY_VERIFY(list.isVisible());
        const auto click = [&](const QString &name, Qt::MouseButton button) {
            list.scrollToItem(panel.itemOf(name));
            QTest::mouseClick(list.viewport(), button, {}, list.visualItemRect(panel.itemOf(name)).center());
        };
        const auto inHand = [&](Command command) { return s.window.action(command).isChecked(); };
        s.use(Command::Select);
        click("gouache", Qt::LeftButton);
        QVERIFY(inHand(Command::Brush));
        QCOMPARE(s.editor().brush().name, QString("gouache"));
        s.use(Command::Eraser);
        click("gouache", Qt::LeftButton); // be it the one in hand
        QVERIFY(inHand(Command::Brush));
        s.use(Command::Select);
        click("ink-wash", Qt::RightButton); // only looks into its menu
        panel.menu()->close();
        QVERIFY(inHand(Command::Select));
        s.use(Command::Favourite1);
        QVERIFY(inHand(Command::Brush));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestBrushes)
#include "test_brushes.moc"

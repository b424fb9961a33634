// The brush in hand: its dialog, its keys, and how it answers the pen.
#include "app/panels/brushes/brush_dialog.h"
#include "app/panels/brushes/brush_panel.h"
#include "app/session/commands/commands.h"
#include "app/session/painting/stabiliser.h"
#include "app/session/settings/brush_library.h"
#include "app/session/settings/settings.h"
#include "app/tools/brush/brush_tool.h"
#include "app/widgets/curves/response_editor.h"
#include "app/widgets/numbers/slider_field.h"
#include "model/brush/brush_width.h"
#include "model/formats/files.h"
#include "model/paint/half_width.h"
#include "model/painting/validate.h"
#include "tests/app/panel_bench.h"
#include "tests/app/session.h"

#include <QComboBox>
#include <QDockWidget>
#include <QListWidget>
#include <QMenu>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTableWidget>
#include <QTemporaryDir>

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

class TestBrushInHand : public QObject {
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

    /// The circle is what a mouse paints at the usual speed of a hand, not what a slow, full line would be.
    void theCircleIsAsWideAsAMousePaints()
    {
        Session s;
        Brush brush = firstBrush();
        brush.setSpread(12);
        brush.taper = {};
        s.editor().setBrush(brush);
        QTest::mouseMove(&s.canvas(), s.at({100, 200}));
        const auto &tool = *static_cast<const BrushTool *>(s.canvas().tool());
        const double dpr = s.canvas().devicePixelRatioF(), circle = tool.circle(s.canvas().view(), dpr);
        QVERIFY(circle < 0.95 * halfWidthOf(brush));
        const double length = 300 * toSeconds(20 * interval) * dpr / s.canvas().view().scale;
        s.paintLine({100, 200}, {100 + length, 200});
        const Stroke &stroke = *s.painting().strokes.back();
        const Segment &middle = stroke.segments[stroke.segments.size() / 2];
        const double painted = halfWidth(double(middle.diffusion), double(middle.density), double(middle.maxAge),
                                         visibleCut(stroke.style));
        QVERIFY2(std::abs(circle - painted) < 0.15 * painted,
                 qPrintable(QStringLiteral("%1, painted %2").arg(circle).arg(painted)));
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

    /// The number that is typed is the width that is painted, whatever the brush's style and flow make of its spread.
    void sizeIsTheWidthThatIsPainted()
    {
        for (const char *name : {"flat-marker", "soft-airbrush", "watercolour-edge"}) {
            Session s;
            Brush brush = *findBrush(name);
            brush.dynamics.clear();
            brush.taper = {};
            brush.jitter = {};
            brush.stabiliser = {};
            brush.granulation = 1;
            brush.colour = {0, 0, 0.5f, 1};
            s.editor().setBrush(brush);
            auto *size = s.canvas().tool()->options()->findChild<NumberField *>();
            QCOMPARE(size->accessibleName(), QString("Size"));
            emit size->entered(40);
            QVERIFY(size->value() && std::abs(*size->value() - 40) < 1e-4);
            s.paintLine({200, 300}, {700, 300});
            s.dry();
            const QImage picture = s.canvas().picture();
            const Point middle = s.canvas().view().toPixels({450, 300});
            const auto darkness = [&](int y) { return 255 - qRed(picture.pixel(int(middle.x), y)); };
            int deepest = 0, first = picture.height(), last = 0; // between dark edges paint may be pale
            for (int y = 0; y < picture.height(); ++y)
                deepest = std::max(deepest, darkness(y));
            for (int y = 0; y < picture.height(); ++y)
                if (2 * darkness(y) > deepest) {
                    first = std::min(first, y);
                    last = y;
                }
            const double width = (last + 1 - first) / s.canvas().view().scale;
            QVERIFY2(std::abs(width - 40) < 3, qPrintable(QString("%1: %2").arg(name).arg(width)));
        }
    }

    /// The ways to steady the hand have the same names wherever they are chosen.
    void smoothingHasOneName()
    {
        Session s;
        BrushDialog dialog(s.editor());
        const auto namesIn = [](const QWidget &where) {
            for (const QComboBox *combo : where.findChildren<QComboBox *>())
                if (combo->accessibleName() == "Smoothing") {
                    QStringList names;
                    for (int i = 0; i < combo->count(); ++i)
                        names << combo->itemText(i);
                    return names;
                }
            return QStringList();
        };
        QCOMPARE(namesIn(dialog), namesIn(*s.canvas().tool()->options()));
        QCOMPARE(namesIn(dialog).size(), 3);
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

    /// What paints by itself stays in hand, and paints with the brush that was chosen.
    void choosingABrushKeepsAToolThatPaints()
    {
        Session s;
        const QStringList names = BrushLibrary::instance().favourites();
        auto &panel = *s.window.findChild<BrushPanel *>();
        s.window.findChild<QDockWidget *>("brushesDock")->raise();
        QTRY_VERIFY(panel.list()->isVisible());
        for (const Command tool : {Command::Shapes, Command::OutlinePen, Command::LassoFill, Command::Bucket}) {
            s.use(tool);
            const bool second = s.editor().brush().name == names[0];
            s.use(second ? Command::Favourite2 : Command::Favourite1);
            QCOMPARE(s.editor().brush().name, names[second]);
            QVERIFY(s.window.action(tool).isChecked());
            panel.list()->scrollToItem(panel.itemOf("glow"));
            QTest::mouseClick(panel.list()->viewport(), Qt::LeftButton, {},
                              panel.list()->visualItemRect(panel.itemOf("glow")).center());
            QCOMPARE(s.editor().brush().name, QString("glow"));
            QVERIFY(s.window.action(tool).isChecked());
        }
        // What only looks on between two tools does not paint, and what paints values has no use for a brush.
        for (const Command tool : {Command::Eyedropper, Command::AttributeBrush}) {
            s.use(tool);
            s.use(Command::Favourite1);
            QVERIFY(s.window.action(Command::Brush).isChecked());
        }
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestBrushInHand)
#include "test_brush_in_hand.moc"

// Values along the stroke, and the probe, by real events.
#include "app/panels/inspector/along_dialog.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/probe/probe_panel.h"
#include "app/widgets/curves/age_plot.h"
#include "app/widgets/habits/place_beside.h"
#include "app/widgets/numbers/number_field.h"
#include "model/formats/files.h"
#include "model/painting/validate.h"
#include "render/probe.h"
#include "tests/app/along_walk.h"
#include "tests/app/panel_bench.h"
#include "tests/app/session.h"
#include "undo/edits.h"

#include <QDockWidget>
#include <QMouseEvent>
#include <QScreen>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTreeWidget>

using namespace suffuse;

namespace {

/// Drags in the curve editor from one place and value to another, in ten reports.
void dragCurve(CurveEditor &curve, QPointF from, QPointF to, bool release = true)
{
    QTest::mousePress(&curve, Qt::LeftButton, {}, curve.toWidget(from).toPoint());
    for (int i = 1; i <= 10; ++i)
        QTest::mouseMove(&curve, curve.toWidget(from + (i / 10.0) * (to - from)).toPoint());
    if (release)
        QTest::mouseRelease(&curve, Qt::LeftButton, {}, curve.toWidget(to).toPoint());
}

/// A report of the pointer with no button down, which QTest::mouseMove leaves to the window system.
void hover(QWidget &widget, QPoint at)
{
    QMouseEvent event(QEvent::MouseMove, QPointF(at), widget.mapToGlobal(QPointF(at)), Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(&widget, &event);
}

} // namespace

class TestAlongAndProbe : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toUtf8());
    }

    void alongTheStrokeIsOneStep()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1});
        QTest::mouseClick(panel.alongButton(), Qt::LeftButton);
        QPointer<AlongDialog> dialog = panel.along();
        QVERIFY(dialog && dialog->isVisible());
        QCOMPARE(bench.steps(), 0); // looking changes nothing
        dialog->choose(AlongDialog::Ramp);
        QCOMPARE(bench.steps(), 0);
        type(*dialog->start(), "4");
        type(*dialog->end(), "12");
        QCOMPARE(bench.editor.undoText(), QString("Change along the stroke"));
        // Density runs on a logarithmic axis: evenly by ratio. The curve is split so finely that no step shows.
        const Stroke ramp = bench.stroke(1);
        QVERIFY(ramp.segments.size() >= 24); // 80 units, s/2 = 3.2
        for (const Segment &s : ramp.segments) {
            const double middle = 0.5 * double(s.bezier[0].x + s.bezier[3].x);
            QVERIFY(std::abs(s.density - 4 * std::pow(3.0, middle / 80)) < 1e-4);
        }
        QVERIFY(problemOf(ramp).isEmpty());
        QCOMPARE(ramp.segments.back().bezier[3], makeStroke(1, 4, 10)->segments.back().bezier[3]);
        dialog->choose(Quantity::Opacity);
        dialog->choose(AlongDialog::Constant);
        dragCurve(*dialog->curve(), {0.5, 1}, {0.3, 0.25});
        QCOMPARE(bench.steps(), 0); // nothing is decided yet
        for (const Segment &s : bench.stroke(1).segments)
            QVERIFY(std::abs(s.colour.opacity - 0.25f) < 0.02f);
        QVERIFY(bench.stroke(1).segments[0].density < 5); // what was set before stays
        QCOMPARE(bench.stroke(1).segments.size(), ramp.segments.size());
        QCOMPARE(bench.stroke(2).segments[0].colour.opacity, 1.0f);
        dialog->accept();
        QCOMPARE(bench.steps(), 1);
        bench.editor.undoStack().undo();
        QCOMPARE(bench.stroke(1), *makeStroke(1, 4, 10));
    }

    /// It does not cover the strokes that it is about.
    void itOpensBesideTheStrokes()
    {
        Session s;
        s.use(Command::Zoom100);
        s.window.move(0, 0);
        const StrokeId id = s.editor().document().takeStrokeId();
        auto stroke = std::make_shared<Stroke>(*makeStroke(id, 4, 10));
        stroke->origin = s.canvas().view().centre - Point{40, 0}; // in the middle, where dialogs open
        s.editor().push(addStrokes(s.editor().document(), {stroke}, true), "stroke");
        const QRect there = s.canvas().selectionOnScreen();
        QVERIFY(there.width() >= 80 && there.width() < 90);
        const QPoint centre = s.canvas().mapToGlobal(s.at(s.canvas().view().centre));
        QVERIFY((there.center() - centre).manhattanLength() <= 2); // whole pixels
        auto *panel = s.window.findChild<InspectorPanel *>();
        panel->alongButton()->click();
        const QRect dialog = panel->along()->frameGeometry();
        const QRect screen = panel->along()->screen()->availableGeometry();
        QVERIFY(screen.contains(dialog));
        QVERIFY(!dialog.intersects(there));
        s.canvas().panBy({-10'000, 0});
        QVERIFY(s.canvas().selectionOnScreen().isEmpty()); // out of sight
    }

    void itIsACommandThatNeedsNoInspector()
    {
        Session s;
        QAction &command = s.window.action(Command::AlongStrokes);
        QVERIFY(!command.isEnabled()); // nothing is selected
        const StrokeId id = s.editor().document().takeStrokeId();
        s.editor().push(addStrokes(s.editor().document(), {makeStroke(id, 4, 10)}, true), "stroke");
        QVERIFY(command.isEnabled());
        s.window.findChild<QDockWidget *>("inspectorDock")->hide();
        auto *panel = s.window.findChild<InspectorPanel *>();
        s.use(Command::AlongStrokes);
        QVERIFY(panel->along() && panel->along()->isVisible());
        const AlongDialog *first = panel->along();
        s.use(Command::AlongStrokes);
        QCOMPARE(panel->along(), first); // one window, brought to the front
    }

    void windowsGoWhereThereIsRoom()
    {
        const QRect screen(100, 50, 1000, 800);
        const QSize size(300, 200);
        const auto placed = [&](const QRect &what) { return QRect(placeBeside(size, what, screen), size); };
        const auto check = [&](const QRect &what, auto isBeside) {
            const QRect at = placed(what);
            return screen.contains(at) && !at.intersects(what) && isBeside(at, what);
        };
        const auto right = [](const QRect &at, const QRect &what) { return at.left() > what.right(); };
        const auto left = [](const QRect &at, const QRect &what) { return at.right() < what.left(); };
        const auto below = [](const QRect &at, const QRect &what) { return at.top() > what.bottom(); };
        const auto above = [](const QRect &at, const QRect &what) { return at.bottom() < what.top(); };
        QVERIFY(check({400, 300, 100, 100}, right));
        QVERIFY(check({400, 60, 100, 5}, right)); // at the edge of the screen
        QVERIFY(check({700, 300, 350, 100}, left));
        QVERIFY(check({120, 100, 960, 300}, below));
        QVERIFY(check({120, 500, 960, 300}, above));
        QVERIFY(screen.contains(placed(screen))); // all is covered whatever is done
        QCOMPARE(placeBeside({2000, 2000}, {400, 300, 100, 100}, screen), screen.topLeft());
    }

    void drawnAlongASelectedRun()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({2}, {{2, 1}, {2, 2}});
        QTest::mouseClick(panel.alongButton(), Qt::LeftButton);
        AlongDialog *dialog = panel.along();
        dialog->choose(Quantity::Granulation);
        dialog->choose(AlongDialog::Drawn);
        dragCurve(*dialog->curve(), {0, 0.1}, {1, 0.9});
        const Selection selected = bench.editor.document().selection();
        const Stroke &stroke = bench.stroke(2);
        for (int k = 0; k < int(stroke.segments.size()); ++k) {
            const Segment &s = stroke.segments[std::size_t(k)];
            const float middle = 0.5f * (s.bezier[0].x + s.bezier[3].x);
            const bool inRun = middle > 20 && middle < 60;
            QVERIFY(std::abs(s.granulation - (inRun ? 0.9f - 0.8f * (middle - 20) / 40 : 1)) < 0.02f);
            QCOMPARE(selected.segments.contains({2, k}), inRun); // all pieces of what was selected
        }
        dialog->choose(AlongDialog::Constant); // needs no pieces
        QCOMPARE(bench.stroke(2).segments.size(), std::size_t(4));
        QCOMPARE(bench.editor.document().selection().segments, (std::set<SegmentRef>{{2, 1}, {2, 2}}));
        dialog->choose(AlongDialog::Ramp);
        dragCurve(*dialog->curve(), {1, 0.2}, {1, 0.8});
        QVERIFY(bench.stroke(2).segments.size() > 4);
        for (int change = 0; change < 4; ++change) {
            QVERIFY(bench.stroke(2) != *makeStroke(2, 4, 20));
            bench.editor.undo();
        }
        QCOMPARE(bench.stroke(2), *makeStroke(2, 4, 20));
        QCOMPARE(bench.editor.document().selection().segments, (std::set<SegmentRef>{{2, 1}, {2, 2}}));
    }

    /// The axis of densities goes by ratios, and yet a fill alone, whose segments have density 0, shows that.
    void aDensityOfZeroIsShownAndKept()
    {
        Bench bench;
        const auto setDensity = [&](StrokeId id, const std::vector<float> &densities) {
            bench.editor.push(changeStrokes(bench.editor.document(), {id},
                                            [&](Stroke &s) {
                                                for (std::size_t k = 0; k < s.segments.size(); ++k)
                                                    s.segments[k].density = densities[k % densities.size()];
                                            }),
                              "density");
        };
        setDensity(1, {0});
        setDensity(2, {0, 0, 0.05f, 8});
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1});
        QTest::mouseClick(panel.alongButton(), Qt::LeftButton);
        QPointer<AlongDialog> dialog = panel.along();
        QCOMPARE(dialog->start()->value(), std::optional(0.0));
        QCOMPARE(dialog->end()->value(), std::optional(0.0));
        type(*dialog->scale(), "3");
        for (const Segment &s : bench.stroke(1).segments)
            QCOMPARE(s.density, 0.0f);
        dialog->choose(AlongDialog::Ramp);
        type(*dialog->end(), "4");
        QCOMPARE(dialog->start()->value(), std::optional(0.0));
        QCOMPARE(dialog->end()->value().value(), 4.0);
        QVERIFY(bench.stroke(1).segments.back().density > 3);
        type(*dialog->end(), "0");
        QCOMPARE(dialog->end()->value(), std::optional(0.0));
        for (const Segment &s : bench.stroke(1).segments)
            QCOMPARE(s.density, 0.0f);
        // Where only a part has none, that part has none after a scale.
        bench.select({2});
        QCOMPARE(dialog->start()->value(), std::optional(0.0));
        QVERIFY(std::abs(dialog->end()->value().value() - 8) < 0.1);
        type(*dialog->scale(), "2");
        for (const Segment &s : bench.stroke(2).segments)
            if (s.bezier[3].x <= 40)
                QCOMPARE(s.density, 0.0f);
        QVERIFY(std::abs(bench.stroke(2).segments.back().density - 16) < 0.1f);
        // A constant of 0 can be typed where something else was.
        bench.select({3});
        dialog->choose(AlongDialog::Constant);
        type(*dialog->start(), "0");
        QCOMPARE(dialog->start()->value(), std::optional(0.0));
        for (const Segment &s : bench.stroke(3).segments)
            QCOMPARE(s.density, 0.0f);
    }

    void cancelTakesAllBack()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1, 3});
        const PaintingPtr before = bench.editor.document().painting();
        QTest::mouseClick(panel.alongButton(), Qt::LeftButton);
        QPointer<AlongDialog> dialog = panel.along();
        dialog->choose(AlongDialog::Constant);
        dragCurve(*dialog->curve(), {0.5, 0.5}, {0.5, 0.9});
        dialog->choose(Quantity::Red);
        dragCurve(*dialog->curve(), {0.5, 0}, {0.5, 0.9});
        QVERIFY(bench.editor.canUndo());
        QVERIFY(!(*bench.editor.document().painting() == *before));
        QTest::keyClick(dialog, Qt::Key_Escape);
        QCOMPARE(bench.steps(), 0);
        QVERIFY(*bench.editor.document().painting() == *before);
        QTRY_VERIFY(!dialog);
    }

    /// What the dialog changes is what the inspector shows.
    void itFollowsTheSelection()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1});
        const PaintingPtr before = bench.editor.document().painting();
        QTest::mouseClick(panel.alongButton(), Qt::LeftButton);
        QPointer<AlongDialog> dialog = panel.along();
        QVERIFY(dialog->windowTitle().endsWith("Stroke 1"));
        dialog->choose(AlongDialog::Constant);
        dragCurve(*dialog->curve(), {0.5, 0.5}, {0.5, 0.9});
        const Stroke first = bench.stroke(1);
        QVERIFY(first != *before->find(1));

        bench.select({2});
        QVERIFY(dialog && dialog->isVisible());
        QVERIFY(dialog->windowTitle().endsWith("Stroke 2"));
        QCOMPARE(bench.steps(), 0); // the dialog decides what was done to the stroke before, too
        QCOMPARE(bench.stroke(1), first);
        dialog->choose(AlongDialog::Constant);
        dragCurve(*dialog->curve(), {0.5, 0.5}, {0.5, 0.2});
        QCOMPARE(bench.stroke(1), first);
        QVERIFY(bench.stroke(2) != *before->find(2));
        // What is in hand is not drawn on along another stroke.
        dragCurve(*dialog->curve(), {0.5, 0.2}, {0.5, 0.6}, false);
        const Stroke second = bench.stroke(2);
        bench.select({1, 3});
        QTest::mouseMove(dialog->curve(), dialog->curve()->toWidget({0.5, 0.1}).toPoint());
        QCOMPARE(bench.stroke(1), first);
        QVERIFY(dialog->windowTitle().contains(" – 2 "));

        const auto fields = dialog->findChildren<NumberField *>();
        const auto isGrey = [](const QWidget *widget) { return !widget->isEnabled(); };
        bench.select({});
        QVERIFY(dialog && isGrey(dialog->curve()) && std::ranges::all_of(fields, isGrey));
        bench.select({3});
        QVERIFY(dialog->curve()->isEnabled() && dialog->start()->isEnabled());
        QVERIFY(std::abs(dialog->start()->value().value() - 9) < 1e-6);
        dialog->accept(); // nothing was done to this one
        QCOMPARE(bench.steps(), 1);
        QCOMPARE(bench.stroke(1), first);
        QCOMPARE(bench.stroke(2), second);
        bench.editor.undo();
        QVERIFY(*bench.editor.document().painting() == *before);
    }

    /// Cancel takes back all that the dialog did, whatever is selected by then.
    void cancelTakesBackWhatWasDoneToOthers()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        const auto change = [](AlongDialog &dialog, double from, double to) {
            dialog.choose(AlongDialog::Ramp);
            type(*dialog.start(), QString::number(from));
            type(*dialog.end(), QString::number(to));
        };
        bench.select({2}, {{2, 1}, {2, 2}});
        const PaintingPtr before = bench.editor.document().painting();
        QTest::mouseClick(panel.alongButton(), Qt::LeftButton);
        QPointer<AlongDialog> dialog = panel.along();
        change(*dialog, 4, 12);
        QVERIFY(bench.stroke(2).segments.size() > before->find(2)->segments.size());
        bench.select({});
        QVERIFY(dialog && dialog->isVisible());
        bench.select({1});
        change(*dialog, 2, 5);
        bench.select({2}); // once more, which has other segments now
        change(*dialog, 7, 3);
        QVERIFY(bench.stroke(1) != *before->find(1));
        bench.select({3});
        QTest::keyClick(dialog, Qt::Key_Escape);
        QVERIFY(!dialog->isVisible());
        QVERIFY(*bench.editor.document().painting() == *before);
        QCOMPARE(bench.steps(), 0);
        QCOMPARE(bench.editor.document().selection().strokes, std::set<StrokeId>{3});
    }

    /// But not what was done elsewhere meanwhile, nor what became of it then.
    void cancelLeavesWhatWasDoneElsewhere()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1, 2});
        const PaintingPtr before = bench.editor.document().painting();
        QTest::mouseClick(panel.alongButton(), Qt::LeftButton);
        QPointer<AlongDialog> dialog = panel.along();
        dialog->choose(AlongDialog::Constant);
        type(*dialog->start(), "3");
        bench.select({3});
        bench.editor.push(
            changeStrokes(bench.editor.document(), {1}, [](Stroke &s) { s.name = QStringLiteral("one"); }), "name");
        QVERIFY(dialog && dialog->isVisible()); // it is about another stroke
        dialog->reject();
        QCOMPARE(bench.stroke(1).name, QString("one"));
        QCOMPARE(bench.stroke(1).segments[0].density, 3.0f);
        QCOMPARE(bench.stroke(2), *before->find(2));
        while (bench.editor.canUndo())
            bench.editor.undo();
        QVERIFY(*bench.editor.document().painting() == *before);
    }

    /// Esc gives up what is in hand before it means the dialog.
    void escGivesUpTheDragOfTheCurve()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1, 3});
        const PaintingPtr before = bench.editor.document().painting();
        QTest::mouseClick(panel.alongButton(), Qt::LeftButton);
        QPointer<AlongDialog> dialog = panel.along();
        dialog->choose(AlongDialog::Ramp);
        const std::vector<double> present = dialog->curve()->curve().knots;
        // The first drag: nothing was set before it.
        dragCurve(*dialog->curve(), {1, 0.5}, {1, 0.9}, false);
        QVERIFY(!(*bench.editor.document().painting() == *before));
        QTest::keyClick(dialog->curve(), Qt::Key_Escape);
        QVERIFY(dialog && dialog->isVisible());
        QCOMPARE(dialog->curve()->curve().knots, present);
        QVERIFY(*bench.editor.document().painting() == *before);
        // What the hand does until it lets go changes nothing any more.
        QTest::mouseMove(dialog->curve(), dialog->curve()->toWidget({1, 0.2}).toPoint());
        QTest::mouseRelease(dialog->curve(), Qt::LeftButton, {}, dialog->curve()->toWidget({1, 0.2}).toPoint());
        QVERIFY(*bench.editor.document().painting() == *before);
        // A later drag: what was set before it stays.
        dragCurve(*dialog->curve(), {1, 0.5}, {1, 0.8});
        const PaintingPtr set = bench.editor.document().painting();
        const std::vector<double> knots = dialog->curve()->curve().knots;
        dragCurve(*dialog->curve(), {0, 0.5}, {0, 0.1}, false);
        QTest::keyClick(dialog->curve(), Qt::Key_Escape);
        QVERIFY(*bench.editor.document().painting() == *set);
        QCOMPARE(dialog->curve()->curve().knots, knots);
        dialog->accept();
        QCOMPARE(bench.steps(), 1);
        bench.editor.undo();
        QVERIFY(*bench.editor.document().painting() == *before);
    }

    /// Undo takes back the last change of the curve, and not all that was done in the window.
    void undoGoesThroughTheChangesOfTheCurve()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1, 3});
        const PaintingPtr before = bench.editor.document().painting();
        QTest::mouseClick(panel.alongButton(), Qt::LeftButton);
        QPointer<AlongDialog> dialog = panel.along();
        dialog->choose(AlongDialog::Constant);
        dragCurve(*dialog->curve(), {0.5, 0.5}, {0.5, 0.9});
        const PaintingPtr first = bench.editor.document().painting();
        const std::vector<double> knots = dialog->curve()->curve().knots;
        dialog->choose(Quantity::Red);
        type(*dialog->start(), "40");
        const PaintingPtr second = bench.editor.document().painting();
        QVERIFY(!(*second == *first));
        bench.editor.undo();
        QVERIFY(*bench.editor.document().painting() == *first);
        QVERIFY(dialog && dialog->isVisible());
        bench.editor.undo();
        QVERIFY(*bench.editor.document().painting() == *before);
        QCOMPARE(bench.steps(), 0);
        QVERIFY(bench.editor.canRedo());
        bench.editor.redo();
        QVERIFY(*bench.editor.document().painting() == *first);
        QCOMPARE(dialog->curve()->curve().knots, knots); // of the quantity that was changed
        bench.editor.redo();
        QVERIFY(*bench.editor.document().painting() == *second);
        QVERIFY(!bench.editor.canRedo());
        bench.editor.undo();
        dialog->accept();
        QCOMPARE(bench.steps(), 1);
        QVERIFY(*bench.editor.document().painting() == *first);
    }

    /// Saving takes nothing away of what can be undone and redone in the window, nor of what was done before it.
    void savingCostsNoRedo()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1});
        const auto now = [&] { return bench.editor.document().painting(); };
        const PaintingPtr earlier = now();
        bench.editor.push(changeStrokes(bench.editor.document(), {1},
                                        [](Stroke &s) {
                                            for (Segment &segment : s.segments)
                                                segment.density = 5;
                                        }),
                          "density");
        const PaintingPtr before = now();
        QTest::mouseClick(panel.alongButton(), Qt::LeftButton);
        QPointer<AlongDialog> dialog = panel.along();
        dialog->choose(AlongDialog::Constant);
        type(*dialog->start(), "7");
        const PaintingPtr first = now();
        type(*dialog->start(), "8");
        const PaintingPtr second = now();
        bench.editor.undo();
        const QString path = m_folder.filePath("along.suffuse");
        const auto save = [&] {
            QSignalSpy saved(&bench.editor, &Editor::saved);
            bench.editor.startSaving(path, true);
            return saved.wait() && !bench.editor.isModified() && *loadPainting(path) == *now();
        };
        QVERIFY(save());
        QVERIFY(*now() == *first && dialog && dialog->isVisible());
        QVERIFY(bench.editor.canRedo());
        bench.editor.redo();
        QVERIFY(*now() == *second);
        QVERIFY(bench.editor.isModified());
        QVERIFY(save());
        bench.editor.undo();
        QVERIFY(*now() == *first);
        bench.editor.undo();
        QVERIFY(*now() == *before);
        QVERIFY(bench.editor.isModified());
        bench.editor.redo();
        QVERIFY(*now() == *first);
        bench.editor.undo();
        bench.editor.undo(); // what was done before the window
        QVERIFY(*now() == *earlier);
        QCOMPARE(bench.editor.undoStack().index(), 0);
        for (const PaintingPtr &later : {before, first, second}) {
            QVERIFY(bench.editor.canRedo());
            bench.editor.redo();
            QVERIFY(*now() == *later);
        }
        QVERIFY(!bench.editor.canRedo());
        dialog->reject(); // all that was done in the window, however often it was saved and redone
        QVERIFY(*now() == *before);
        bench.editor.undo();
        QVERIFY(*now() == *second);
    }

    /// Saving makes a step of what was done; Cancel takes it back by one more.
    void cancelTakesBackWhatWasSaved()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1});
        const auto now = [&] { return bench.editor.document().painting(); };
        const PaintingPtr before = now();
        QTest::mouseClick(panel.alongButton(), Qt::LeftButton);
        QPointer<AlongDialog> dialog = panel.along();
        dialog->choose(AlongDialog::Constant);
        type(*dialog->start(), "7");
        const PaintingPtr saved = now();
        save(bench.editor);
        QTest::keyClick(dialog, Qt::Key_Escape);
        QVERIFY(!dialog->isVisible());
        QVERIFY(*now() == *before && bench.editor.isModified());
        QCOMPARE(bench.steps(), 2);
        bench.editor.undo();
        QVERIFY(*now() == *saved && !bench.editor.isModified());
        bench.editor.undo();
        QVERIFY(*now() == *before);
    }

    void savingInTheMiddleOfADragGoesOnWithIt()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1});
        const auto now = [&] { return bench.editor.document().painting(); };
        const PaintingPtr before = now();
        QTest::mouseClick(panel.alongButton(), Qt::LeftButton);
        QPointer<AlongDialog> dialog = panel.along();
        dialog->choose(AlongDialog::Constant);
        type(*dialog->start(), "7");
        const PaintingPtr first = now();
        dialog->choose(AlongDialog::Ramp);
        const QPointF end{1, dialog->curve()->curve().at(1)};
        dragCurve(*dialog->curve(), end, {1, 0.9}, false);
        const PaintingPtr second = now();
        QVERIFY(*second != *first && dialog->curve()->isDragging());
        const QString path = m_folder.filePath("dragged.suffuse");
        QSignalSpy saved(&bench.editor, &Editor::saved);
        bench.editor.startSaving(path, true);
        QVERIFY(saved.wait());
        QVERIFY(*loadPainting(path) == *second && !bench.editor.isModified());
        QVERIFY(dialog && dialog->curve()->isDragging());
        QTest::mouseMove(dialog->curve(), dialog->curve()->toWidget({1, 0.3}).toPoint());
        QVERIFY(*now() != *second && *now() != *first);
        QTest::mouseRelease(dialog->curve(), Qt::LeftButton, {}, dialog->curve()->toWidget({1, 0.3}).toPoint());
        const PaintingPtr third = now();
        QVERIFY(bench.editor.isModified());
        bench.editor.undo();
        QVERIFY(*now() == *second);
        bench.editor.redo();
        QVERIFY(*now() == *third);
        bench.editor.undo();
        bench.editor.undo();
        QVERIFY(*now() == *first || *now() == *before); // a ramp of one value is a change of its own, or none
        while (bench.editor.canUndo())
            bench.editor.undo();
        QVERIFY(*now() == *before);
    }

    /// Esc gives up what came after it was saved, as on the canvas.
    void escGivesUpWhatADragDidAfterItWasSaved()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1});
        const auto now = [&] { return bench.editor.document().painting(); };
        const PaintingPtr before = now();
        QTest::mouseClick(panel.alongButton(), Qt::LeftButton);
        QPointer<AlongDialog> dialog = panel.along();
        CurveEditor &curve = *dialog->curve();
        dialog->choose(AlongDialog::Constant);
        type(*dialog->start(), "7");
        dragCurve(curve, {0.5, curve.curve().at(0.5)}, {0.5, 0.9}, false);
        const PaintingPtr saved = now();
        const PlaceCurve asSaved = curve.curve();
        for (const bool moves : {true, false}) {
            save(bench.editor);
            if (moves) {
                QVERIFY(curve.isDragging());
                QTest::mouseMove(&curve, curve.toWidget({0.5, 0.3}).toPoint());
                QVERIFY(*now() != *saved);
                QVERIFY(bench.editor.isModified());
                QTest::keyClick(&curve, Qt::Key_Escape);
                QTest::mouseMove(&curve, curve.toWidget({0.5, 0.2}).toPoint());
                QTest::mouseRelease(&curve, Qt::LeftButton, {}, curve.toWidget({0.5, 0.2}).toPoint());
            } else {
                dragCurve(curve, {0.5, 0.9}, {0.5, 0.9}, false);
                save(bench.editor);
                QTest::keyClick(&curve, Qt::Key_Escape); // before it moves on
            }
            QVERIFY(dialog && dialog->isVisible());
            QVERIFY(*now() == *saved && !bench.editor.isModified());
            QCOMPARE(curve.curve(), asSaved);
            QCOMPARE(bench.steps(), 2);
        }
        bench.editor.undo();
        bench.editor.undo();
        QVERIFY(*now() == *before);
        dialog->reject();
        QVERIFY(*now() == *before);
    }

    /// What the window shows of a painting, undo and redo bring back with it.
    void undoAndRedoBringBackTheCurveAsItWas_data()
    {
        QTest::addColumn<bool>("saves");
        QTest::newRow("in the window") << false;
        QTest::newRow("of steps that were saved") << true;
    }
    void undoAndRedoBringBackTheCurveAsItWas()
    {
        QFETCH(bool, saves);
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.editor.push(changeStrokes(bench.editor.document(), {1},
                                        [value = 7.3f](Stroke &s) mutable {
                                            for (Segment &segment : s.segments)
                                                segment.density = value *= 1.7f;
                                        }),
                          "density");
        bench.select({1}, {{1, 1}, {1, 2}, {1, 3}});
        QTest::mouseClick(panel.alongButton(), Qt::LeftButton);
        QPointer<AlongDialog> dialog = panel.along();
        struct Shown {
            Painting painting;
            PlaceCurve curve;
            QString start, end;
            bool operator==(const Shown &) const = default;
        };
        const auto shown = [&] {
            return Shown{*bench.editor.document().painting(), dialog->curve()->curve(), dialog->start()->text(),
                         dialog->end()->text()};
        };
        std::vector<Shown> states{shown()};
        type(*dialog->start(), "21.27");
        states.push_back(shown());
        dragCurve(*dialog->curve(), {0.4, dialog->curve()->curve().at(0.4)}, {0.43, 0.2});
        states.push_back(shown());
        dragCurve(*dialog->curve(), {1, dialog->curve()->curve().at(1)}, {1, 0.7});
        states.push_back(shown());
        if (saves)
            save(bench.editor);
        QVERIFY(shown() == states.back());
        for (int times = 0; times < 2; ++times) {
            for (std::size_t k = states.size() - 1; k-- > 0;) {
                bench.editor.undo();
                QVERIFY(shown() == states[k]);
            }
            for (std::size_t k = 1; k < states.size(); ++k) {
                bench.editor.redo();
                QVERIFY(shown() == states[k]);
            }
        }
        dialog->reject();
        QVERIFY(*bench.editor.document().painting() == states.front().painting);
    }

    void whateverIsDoneInItComesBack()
    {
        for (unsigned seed = 0; seed < 200; ++seed) {
            AlongWalk walk(seed, m_folder.filePath("walk.suffuse"));
            QString wrong;
            for (int k = 0; k < 12 && wrong.isEmpty(); ++k)
                wrong = walk.act();
            if (wrong.isEmpty())
                wrong = walk.close(seed % 2 == 0);
            QVERIFY2(wrong.isEmpty(), qPrintable(QString("%1: %2: %3").arg(seed).arg(walk.trail(), wrong)));
        }
    }

    /// Undo goes on to what was done before the window, and redo comes back through all that was done in it.
    void undoBeyondTheWindowCanBeRedone()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1});
        const auto now = [&] { return bench.editor.document().painting(); };
        std::vector<PaintingPtr> states{now()};
        bench.editor.push(changeStrokes(bench.editor.document(), {1},
                                        [](Stroke &s) {
                                            for (Segment &segment : s.segments)
                                                segment.density = 5;
                                        }),
                          "density");
        states.push_back(now());
        QTest::mouseClick(panel.alongButton(), Qt::LeftButton);
        QPointer<AlongDialog> dialog = panel.along();
        dialog->choose(AlongDialog::Constant);
        for (const char *value : {"7", "8", "8", "9"}) { // One of them changes nothing.
            type(*dialog->start(), value);
            if (*now() != *states.back())
                states.push_back(now());
        }
        QCOMPARE(states.size(), std::size_t(5));
        bench.editor.redo(); // There is nothing to redo, and nothing comes of it.
        QVERIFY(*now() == *states.back());
        for (int tries = 0; tries < 10 && bench.editor.canUndo(); ++tries)
            bench.editor.undo();
        QVERIFY(*now() == *states.front());
        QVERIFY(dialog && dialog->isVisible());
        for (std::size_t k = 1; k < states.size(); ++k) {
            QVERIFY(bench.editor.canRedo());
            bench.editor.redo();
            QVERIFY(*now() == *states[k]);
        }
        QVERIFY(!bench.editor.canRedo());
        for (std::size_t k = states.size() - 1; k-- > 0;) {
            bench.editor.undo();
            QVERIFY(*now() == *states[k]);
        }
    }

    /// What else changes the strokes leaves the window open, which goes on from there.
    void stepsBeforeItLeaveItOpen()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1});
        const PaintingPtr before = bench.editor.document().painting();
        bench.editor.push(changeStrokes(bench.editor.document(), {1},
                                        [](Stroke &s) {
                                            for (Segment &segment : s.segments)
                                                segment.density = 5;
                                        }),
                          "density");
        QTest::mouseClick(panel.alongButton(), Qt::LeftButton);
        QPointer<AlongDialog> dialog = panel.along();
        QVERIFY(std::abs(dialog->start()->value().value() - 5) < 1e-6);
        bench.editor.undo();
        QVERIFY(dialog && dialog->isVisible());
        QVERIFY(std::abs(dialog->start()->value().value() - 9) < 1e-6);
        QVERIFY(*bench.editor.document().painting() == *before);
        dialog->choose(AlongDialog::Constant);
        type(*dialog->start(), "7");
        bench.editor.commit(); // as saving does
        bench.editor.undo();
        QVERIFY(dialog && dialog->isVisible());
        QVERIFY(*bench.editor.document().painting() == *before);
        QVERIFY(std::abs(dialog->start()->value().value() - 9) < 1e-6);
        dialog->reject();
        QVERIFY(*bench.editor.document().painting() == *before);
    }

    void commandsWorkInWindowsThatStayOpen()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        const PaintingPtr before = s.editor().document().painting();
        s.use(Command::Select);
        s.editor().document().setSelection({{s.painting().strokes.front()->id}, {}});
        auto *panel = s.window.findChild<InspectorPanel *>();
        s.use(Command::AlongStrokes);
        QPointer<AlongDialog> dialog = panel->along();
        QVERIFY(QTest::qWaitForWindowActive(dialog));
        dialog->choose(AlongDialog::Constant);
        dragCurve(*dialog->curve(), {0.5, 0.5}, {0.5, 0.9});
        const PaintingPtr changed = s.editor().document().painting();
        QVERIFY(!(*changed == *before));
        QTest::keyClick(dialog->curve(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(*s.editor().document().painting() == *before);
        QTest::keyClick(dialog->curve(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(*s.editor().document().painting() == *changed);
        const QTemporaryDir folder;
        const QString file = folder.filePath("a.suffuse");
        QVERIFY(s.window.saveTo(file));
        type(*dialog->start(), "3");
        dialog->start()->selectAll();
        QTest::keyClicks(dialog->start(), "4"); // Return is not needed before it is saved.
        QTest::keyClick(dialog->start(), Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(!s.editor().isSaving(), waitMs);
        QVERIFY(hashOf(*loadPainting(file)) == hashOf(s.painting()));
        QVERIFY(!s.editor().isModified());
        QCOMPARE(s.painting().strokes.front()->segments[0].density, 4.0f);
        QVERIFY(dialog && dialog->isVisible());
        dialog->reject();
    }

    void strokesGoUnderAnOpenCurveEditor()
    {
        for (const bool undo : {false, true}) {
            Bench bench;
            InspectorPanel panel(bench.editor);
            showAt(panel);
            bench.select({1});
            QTest::mouseClick(panel.alongButton(), Qt::LeftButton);
            QPointer<AlongDialog> dialog = panel.along();
            dialog->choose(AlongDialog::Constant);
            dragCurve(*dialog->curve(), {0.5, 0.5}, {0.5, 0.9}, false);
            if (undo)
                bench.editor.undo();
            else
                bench.editor.push(deleteSelection(bench.editor.document()), "delete");
            QCOMPARE(dialog && dialog->isVisible(), undo); // it goes with its stroke
            const PaintingPtr after = bench.editor.document().painting();
            if (dialog)
                QTest::mouseMove(dialog->curve(), dialog->curve()->toWidget({0.5, 0.1}).toPoint());
            QCOMPARE(bench.editor.document().painting(), after);
            if (undo) {
                QCOMPARE(bench.stroke(1).segments[0].density, 9.0f);
                dialog->reject();
            } else {
                QVERIFY(!bench.editor.document().painting()->find(1));
            }
            QTRY_VERIFY(!dialog);
        }
    }

    void probeListsWhatLiesUnderThePointer()
    {
        Session session;
        Editor &editor = session.editor();
        auto painting = std::make_shared<Painting>();
        for (StrokeId id = 1; id <= 3; ++id) {
            Stroke stroke = *makeStroke(id, 8, 40);
            stroke.origin = {id == 3 ? 700.0 : 300.0, 300};
            for (Segment &s : stroke.segments)
                s.density = 20, s.colour.opacity = id == 2 ? 0.5f : 1;
            painting->strokes.push_back(std::make_shared<const Stroke>(stroke));
        }
        editor.document().reset(painting);
        editor.clock().setTime(5'000'000);
        QDockWidget *dock = session.window.findChild<QDockWidget *>("probeDock");
        auto *panel = session.window.findChild<ProbePanel *>();
        QVERIFY(dock && panel && dock->isHidden());
        hover(session.canvas(), session.at({360, 300}));
        QCOMPARE(panel->view()->topLevelItemCount(), 0); // nothing is computed for a dock that is not seen
        dock->show();
        dock->raise();
        QTRY_VERIFY(panel->isVisible());
        hover(session.canvas(), session.at({362, 301}));
        QTRY_COMPARE(panel->view()->topLevelItemCount(), 3); // 2, 1, canvas
        QTRY_VERIFY(panel->isUpToDate());
        const auto text = [&](int row, int column) { return panel->view()->topLevelItem(row)->text(column); };
        QVERIFY(text(0, 0).contains('2') && text(1, 0).contains('1'));
        const auto shareOf = [&](int row) { return text(row, ProbePanel::ShareColumn).split(' ').front().toDouble(); };
        QVERIFY(std::abs(shareOf(0) - 50) < 2); // half covers, and the one below has the rest
        QVERIFY(std::abs(shareOf(0) + shareOf(1) + shareOf(2) - 100) < 1.6);

        // Segments by their share of the density; a click selects.
        QTreeWidgetItem *stroke = panel->view()->topLevelItem(1);
        QVERIFY(stroke->childCount() >= 3);
        stroke->setExpanded(true);
        const QString nearest = stroke->child(0)->text(0);
        QVERIFY2(nearest.contains('4'), qPrintable(nearest)); // 350 … 370 from the stroke's start at 300: the fourth
        QTest::mouseClick(panel->view()->viewport(), Qt::LeftButton, {},
                          panel->view()->visualItemRect(stroke->child(0)).center());
        QCOMPARE(session.selection().segments, (std::set<SegmentRef>{{1, 3}}));
        QVERIFY(!panel->plot()->points().empty());
        QTest::mouseClick(panel->view()->viewport(), Qt::LeftButton, {},
                          panel->view()->visualItemRect(panel->view()->topLevelItem(0)).center());
        QCOMPARE(session.selection().strokes, std::set<StrokeId>{2});
        QVERIFY(session.selection().segments.empty());

        // φ(t): nothing at first, most while the paint is fresh, and at the end what the solver says.
        const std::vector<QPointF> ages = panel->plot()->points();
        const Point at = session.canvas().view().toCanvas(
            session.canvas().devicePixelRatioF() *
            Point{double(session.at({362, 301}).x()), double(session.at({362, 301}).y())});
        const Result<Probe> truth = probe(session.painting(), 1'000'000, at.x, at.y);
        QVERIFY(std::abs(ages.back().y() - truth->strokes[1].density) < 2e-3);
        QCOMPARE(ages.back().x(), 1.0);

        // A change shows at the same place.
        editor.push(changeSegments(editor.document(), targetSegments(editor.document()),
                                   [](Segment &s) { s.colour.opacity = 1; }),
                    "opacity");
        QTRY_VERIFY(shareOf(0) > 95);
        // A fill has a row of its own.
        editor.push(changeStrokes(editor.document(), {2},
                                  [](Stroke &s) {
                                      for (Segment &segment : s.segments)
                                          segment.density = 0;
                                      s.segments.back().bezier[3].y += 300;
                                      Fill fill;
                                      fill.density = 9;
                                      s.fill = fill;
                                  }),
                    "fill");
        QTRY_VERIFY(panel->view()->topLevelItem(0)->childCount() == 1 &&
                    panel->view()->topLevelItem(0)->child(0)->text(0) == "Fill");
        session.advance(1);
        QTRY_VERIFY(panel->isUpToDate());
    }

    void probeGoesBackToWhereThePointerRested()
    {
        Session session;
        session.editor().document().reset(std::make_shared<Painting>(*Bench(1).editor.document().painting()));
        auto *panel = session.window.findChild<ProbePanel *>();
        session.window.findChild<QDockWidget *>("probeDock")->show();
        session.window.findChild<QDockWidget *>("probeDock")->raise();
        QTRY_VERIFY(panel->isVisible());
        session.editor().clock().setTime(5'000'000);
        panel->setPoint({80, 100});
        QTRY_VERIFY(panel->rested() == (Point{80, 100}));
        panel->setPoint({700, 600}); // on the way to the dock
        QVERIFY(panel->point() == (Point{700, 600}));
        panel->leaveCanvas();
        QVERIFY(panel->point() == (Point{80, 100}));
        QTRY_VERIFY(panel->isUpToDate());
        QCOMPARE(panel->view()->topLevelItemCount(), 2);
    }

private:
    /// To the file of this test; what is there may be replaced.
    void save(Editor &editor)
    {
        QSignalSpy saved(&editor, &Editor::saved);
        editor.startSaving(m_folder.filePath("along.suffuse"), true);
        QVERIFY(saved.wait() && !editor.isModified());
        QVERIFY(*loadPainting(editor.filePath()) == *editor.document().painting());
    }

    QTemporaryDir m_folder;
};

QTEST_MAIN(TestAlongAndProbe)
#include "test_along_and_probe.moc"

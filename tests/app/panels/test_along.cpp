// Values along the stroke, by real events.
#include "app/panels/inspector/along/along_dialog.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/widgets/habits/place_beside.h"
#include "app/widgets/numbers/number_field.h"
#include "model/formats/files.h"
#include "model/painting/validate.h"
#include "tests/app/along_walk.h"
#include "tests/app/panel_bench.h"
#include "tests/app/session.h"
#include "undo/edits.h"

#include <QDockWidget>
#include <QScreen>
#include <QTemporaryDir>
#include <QToolButton>

using namespace suffuse;

class TestAlong : public QObject {
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

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestAlong)
#include "test_along.moc"

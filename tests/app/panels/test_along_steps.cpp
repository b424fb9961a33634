// Cancel, undo, redo and saving while the window "Along the Stroke" is open, by real events.
#include "app/panels/inspector/along/along_dialog.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/widgets/numbers/number_field.h"
#include "model/formats/files.h"
#include "tests/app/along_walk.h"
#include "tests/app/panel_bench.h"
#include "tests/app/session.h"
#include "undo/edits.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>

using namespace suffuse;

class TestAlongSteps : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toUtf8());
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

QTEST_MAIN(TestAlongSteps)
#include "test_along_steps.moc"

// Whatever is given up leaves the painting and its steps, those to be redone too, as they were.
#include "app/panels/inspector/along/along_dialog.h"
#include "app/panels/inspector/segment_section.h"
#include "app/panels/timeline/timeline_view.h"
#include "app/widgets/numbers/bar_slider.h"
#include "app/widgets/numbers/number_field.h"
#include "app/widgets/numbers/slider_field.h"
#include "tests/app/panel_bench.h"
#include "tests/app/shapes.h"

#include <QTemporaryDir>

using namespace suffuse;

namespace {

/// A painting, and the steps that led to it and would lead on.
struct State {
    Painting painting;
    QStringList steps;
    int index = 0, clean = 0;
    bool canUndo = false, canRedo = false, modified = false;
    QString undoText, redoText;

    explicit State(Editor &editor) : painting(*editor.document().painting())
    {
        const QUndoStack &stack = editor.undoStack();
        for (int i = 0; i < stack.count(); ++i)
            steps << stack.text(i);
        index = stack.index(), clean = stack.cleanIndex();
        canUndo = stack.canUndo(), canRedo = stack.canRedo(), modified = editor.isModified();
        undoText = stack.undoText(), redoText = stack.redoText();
    }
    friend bool operator==(const State &, const State &) = default;
};

/// A wave, and three steps after it, two of which are undone; the first of these was saved.
struct Undone : WaveSession {
    QTemporaryDir folder;
    std::optional<State> before;
    Painting last; ///< where redoing leads

    Undone()
    {
        for (int k = 1; k <= 3; ++k) {
            editor().push(changeStrokes(editor().document(), {id}, [k](Stroke &s) { s.name = QString::number(k); }),
                          QStringLiteral("name %1").arg(k));
            if (k == 2) {
                editor().startSaving(folder.filePath("wave.suffuse"));
                QTRY_VERIFY(!editor().isSaving());
            }
        }
        last = painting();
        editor().undoStack().undo();
        editor().undoStack().undo();
        before.emplace(editor());
    }
    void escape() { QTest::keyClick(&canvas(), Qt::Key_Escape); }
    void check()
    {
        QVERIFY(State(editor()) == *before);
        editor().undoStack().redo();
        QVERIFY(!editor().isModified()); // where it was saved
        editor().undoStack().redo();
        QVERIFY(painting() == last);
        QVERIFY(!editor().undoStack().canRedo());
        editor().undoStack().undo();
        editor().undoStack().undo();
        QVERIFY(State(editor()) == *before);
    }
    /// Where the pointer must be for the tool to say so, in a square around a place.
    std::optional<Point> find(const QString &hint, Point around, double reach)
    {
        for (double y = -reach; y <= reach; y += 2)
            for (double x = -reach; x <= reach; x += 2) {
                hover(around + Point{x, y});
                if (canvas().tool()->hint().startsWith(hint))
                    return around + Point{x, y};
            }
        return {};
    }
    bool alters() { return !(painting() == before->painting); }
};

} // namespace

class TestCancel : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void dragsOfTools_data()
    {
        QTest::addColumn<Command>("tool");
        QTest::addColumn<QPointF>("from");
        QTest::addColumn<QPointF>("to");
        const auto row = [](const char *name, Command tool, QPointF from, QPointF to) {
            QTest::newRow(name) << tool << from << to;
        };
        row("move", Command::Select, {250, 320}, {300, 400});
        row("scale", Command::Select, {600, 340}, {700, 420}); // the corner
        row("node", Command::Segments, {300, 340}, {320, 400});
        row("curve", Command::Segments, {350, 320}, {360, 380});
        row("erase", Command::Eraser, {350, 200}, {350, 450});
        row("push", Command::Push, {350, 300}, {350, 380});
        row("redraw", Command::Redraw, {250, 320}, {450, 320});
        row("attribute", Command::AttributeBrush, {250, 320}, {400, 320});
        row("paint", Command::Brush, {300, 500}, {500, 500});
        row("shape", Command::Shapes, {300, 500}, {500, 560});
        row("pen", Command::OutlinePen, {300, 500}, {500, 560});
        row("lasso", Command::LassoFill, {300, 500}, {500, 560});
        row("knife", Command::Knife, {350, 200}, {350, 450});
    }

    void dragsOfTools()
    {
        QFETCH(Command, tool);
        QFETCH(QPointF, from);
        QFETCH(QPointF, to);
        Undone session;
        session.use(tool);
        Point start{from.x(), from.y()};
        if (tool == Command::Select && from.x() == 600) { // the handles stand beside the box
            const std::optional<Point> handle = session.find("Drag: scale", start, 30);
            QVERIFY(handle);
            start = *handle;
        }
        session.drag(start, {to.x(), to.y()}, {}, false);
        QVERIFY(session.canvas().tool()->isBusy());
        const bool pushes = tool != Command::Brush && tool != Command::Shapes && tool != Command::OutlinePen &&
                            tool != Command::LassoFill && tool != Command::Knife && tool != Command::Redraw;
        QCOMPARE(session.alters(), pushes);
        session.escape();
        QVERIFY(!session.canvas().tool()->isBusy());
        session.check();
        QTest::mouseRelease(&session.canvas(), Qt::LeftButton, {}, session.at({to.x(), to.y()}));
        session.check();
    }

    void commandsGiveADragUp()
    {
        for (const Command tool : {Command::Select, Command::Brush})
            for (const Command command : {Command::Undo, Command::Delete}) {
                Undone session;
                session.use(tool);
                session.drag({250, 320}, {300, 400}, {}, false);
                QVERIFY(session.canvas().tool()->isBusy());
                session.use(command);
                QVERIFY(!session.canvas().tool()->isBusy());
                QTest::mouseRelease(&session.canvas(), Qt::LeftButton, {}, session.at({300, 400}));
                session.check();
            }
    }

    /// There is nothing to redo while something is in hand, and it stays there.
    void redoLeavesADrag()
    {
        for (const Command tool : {Command::Select, Command::Brush}) {
            Undone session;
            session.use(tool);
            session.drag({250, 320}, {300, 400}, {}, false);
            session.use(Command::Redo);
            QVERIFY(session.canvas().tool()->isBusy());
            session.escape();
            session.check();
        }
    }

    void aDragBackToItsStart()
    {
        Undone session;
        session.use(Command::Select);
        session.drag({250, 320}, {300, 400}, {}, false);
        session.move({250, 320});
        QTest::mouseRelease(&session.canvas(), Qt::LeftButton, {}, session.at({250, 320}));
        session.check();
    }

    void aStepThatChangesNothing()
    {
        Undone session;
        Edit same;
        same.strokes[session.id] = std::make_shared<const Stroke>(session.stroke());
        session.editor().push(std::move(same), "nothing");
        session.check();
    }

    void whatIsDoneDropsThem()
    {
        Undone session;
        session.use(Command::Select);
        session.drag({250, 320}, {300, 400});
        QVERIFY(!session.editor().undoStack().canRedo());
        const int done = session.editor().undoStack().count();
        session.drag({300, 400}, {350, 420}, {}, false); // another one, given up
        session.escape();
        QCOMPARE(session.editor().undoStack().count(), done);
        QVERIFY(!session.editor().undoStack().canRedo());
        // Undone, it is what can be redone, not what there was before.
        session.use(Command::Undo);
        QCOMPARE(session.editor().undoStack().count(), done);
        session.drag({250, 320}, {300, 400}, {}, false);
        session.escape();
        QCOMPARE(session.editor().undoStack().count(), done);
        QCOMPARE(session.editor().undoStack().redoText(), QStringLiteral("Move"));
    }

    void alongTheStroke()
    {
        Undone session;
        AlongDialog dialog(session.editor(), &session.window);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        dialog.choose(AlongDialog::Ramp);
        emit dialog.start()->entered(3);
        emit dialog.end()->entered(30);
        QVERIFY(session.alters());
        dialog.reject();
        session.check();
    }

    /// A click beside the strokes changes what the dialog is about, and decides nothing.
    void alongTheStrokeAndNothingSelected()
    {
        Undone session;
        session.use(Command::Select);
        AlongDialog dialog(session.editor(), &session.window);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        emit dialog.start()->entered(3);
        const PaintingPtr changed = session.editor().document().painting();
        const Selection selection = session.selection();
        session.click({600, 40});
        QVERIFY(session.selection().strokes.empty());
        QCOMPARE(*session.editor().document().painting(), *changed);
        dialog.reject();
        session.editor().document().setSelection(selection);
        session.check();
    }

    void sliders_data()
    {
        QTest::addColumn<bool>("mixed");
        QTest::addColumn<QKeySequence>("key");
        QTest::newRow("one value") << false << QKeySequence(Qt::Key_Escape);
        QTest::newRow("mixed values") << true << QKeySequence(Qt::Key_Escape);
        QTest::newRow("one value, Undo") << false << QKeySequence("Ctrl+Z");
        QTest::newRow("mixed values, Undo") << true << QKeySequence("Ctrl+Z");
    }

    void sliders()
    {
        QFETCH(bool, mixed);
        QFETCH(QKeySequence, key);
        Undone session;
        if (mixed) {
            session.editor().push(changeSegments(session.editor().document(), {{session.id, 1}},
                                                 [](Segment &segment) { segment.density = 3; }),
                                  "mixed");
            session.editor().push(changeStrokes(session.editor().document(), {session.id},
                                                [](Stroke &s) { s.name = QStringLiteral("redo me"); }),
                                  "name");
            session.editor().undoStack().undo();
            session.before.emplace(session.editor());
        }
        auto *section = session.window.findChild<SegmentSection *>();
        QVERIFY(section);
        QTRY_VERIFY(section->density()->slider()->isVisible());
        BarSlider &slider = *section->density()->slider();
        QTest::mousePress(&slider, Qt::LeftButton, {}, sliderPoint(slider, 0.2));
        for (const double share : {0.3, 0.5, 0.8})
            QTest::mouseMove(&slider, sliderPoint(slider, share));
        QVERIFY(session.alters());
        QTest::keyClick(session.window.windowHandle(), key[0].key(), key[0].keyboardModifiers());
        QVERIFY(State(session.editor()) == *session.before);
        QTest::mouseMove(&slider, sliderPoint(slider, 0.6)); // the button is still down
        QTest::mouseRelease(&slider, Qt::LeftButton, {}, sliderPoint(slider, 0.6));
        QVERIFY(State(session.editor()) == *session.before);
        QCOMPARE(session.editor().document().selection().strokes, std::set<StrokeId>{session.id});
        if (!mixed)
            session.check();
    }

    void numbersThatAreTyped()
    {
        Undone session;
        auto *section = session.window.findChild<SegmentSection *>();
        NumberField &field = *section->density()->number();
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, "7");
        QTest::keyClick(&field, Qt::Key_Escape);
        session.check();
    }

    void theTimeline()
    {
        Undone session;
        auto *view = session.window.findChild<TimelineView *>();
        QVERIFY(view);
        for (QWidget *above = view; above; above = above->parentWidget())
            above->show();
        view->fit();
        QTRY_VERIFY(view->drawnRect(session.id).isValid() || view->drawnRect(session.id).height() > 0);
        const QPoint at = view->drawnRect(session.id).center().toPoint() + QPoint(2, 0);
        QTest::mousePress(view->viewport(), Qt::LeftButton, {}, at);
        for (int i = 1; i <= 4; ++i)
            QTest::mouseMove(view->viewport(), at + QPoint(15 * i, 0));
        QVERIFY(session.alters());
        QTest::keyClick(view, Qt::Key_Escape);
        QTest::mouseRelease(view->viewport(), Qt::LeftButton, {}, at + QPoint(60, 0));
        session.check();
    }

    void theWidthHandle()
    {
        Undone session;
        session.use(Command::Segments);
        const std::optional<Point> found = session.find("Drag to set the width", {450, 320}, 80);
        QVERIFY(found);
        session.drag(*found, *found + Point{0, -20}, {}, false);
        if (!session.alters())
            session.move(*found + Point{0, 20});
        QVERIFY(session.alters());
        session.escape();
        session.check();
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestCancel)
#include "test_cancel.moc"

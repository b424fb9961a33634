// Every drag of a tool or a panel, interrupted at each report, with no event in between: whoever reads, draws, saves or
// undoes finds a true state.
#include "app/panels/inspector/along/along_dialog.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/inspector/segment_section.h"
#include "app/panels/timeline/timeline_view.h"
#include "app/session/files/opened_file.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/numbers/bar_slider.h"
#include "app/widgets/paper/canvas_section.h"
#include "model/painting/validate.h"
#include "tests/app/panel_bench.h"
#include "tests/app/shapes.h"
#include "tests/app/worker_frames.h"

#include <QTemporaryDir>

using namespace suffuse;

namespace {

/// One drag: a press, reports that each change something, and the release.
struct Drag {
    std::function<void()> press;
    std::function<void(int)> report; ///< from 1
    std::function<void()> release;
};

/// A wave, a step before it, and one that can be redone.
struct Dragging : WaveSession {
    QTemporaryDir folder;
    Painting start;

    Dragging()
    {
        rename("one");
        rename("two");
        editor().undo();
        start = painting();
    }
    void rename(const QString &name)
    {
        editor().push(changeStrokes(editor().document(), {id}, [&](Stroke &s) { s.name = name; }), "name");
    }
    /// Where the pointer must be for the tool to say so, in a square around a place.
    Point find(const QString &hint, Point around, double reach)
    {
        for (double y = -reach; y <= reach; y += 2)
            for (double x = -reach; x <= reach; x += 2) {
                hover(around + Point{x, y});
                if (canvas().tool()->hint().startsWith(hint))
                    return around + Point{x, y};
            }
        return {};
    }
    Drag onCanvas(Command tool, Point from, Point way)
    {
        use(tool);
        if (from.x == 600) // the handles stand beside the box
            from = find("Drag: scale", from, 30);
        if (from.x == 450)
            from = find("Drag to set the width", from, 80);
        return {[this, from] { QTest::mousePress(&canvas(), Qt::LeftButton, {}, at(from)); },
                [this, from, way](int k) { move(from + double(k) * way); },
                [this, from, way] { QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, at(from + 4.0 * way)); }};
    }
    Drag onSlider(BarSlider &slider)
    {
        for (QWidget *above = &slider; above; above = above->parentWidget())
            above->show();
        return {[&slider] { QTest::mousePress(&slider, Qt::LeftButton, {}, sliderPoint(slider, 0.9)); },
                [&slider](int k) { QTest::mouseMove(&slider, sliderPoint(slider, 0.9 - 0.17 * k)); },
                [&slider] { QTest::mouseRelease(&slider, Qt::LeftButton, {}, sliderPoint(slider, 0.2)); }};
    }
    Drag onTimeline()
    {
        auto *view = window.findChild<TimelineView *>();
        for (QWidget *above = view; above; above = above->parentWidget())
            above->show();
        view->fit();
        const QPoint place = view->drawnRect(id).center().toPoint() + QPoint(2, 0);
        return {[=] { QTest::mousePress(view->viewport(), Qt::LeftButton, {}, place); },
                [=](int k) { QTest::mouseMove(view->viewport(), place + QPoint(20 * k, 0)); },
                [=] { QTest::mouseRelease(view->viewport(), Qt::LeftButton, {}, place + QPoint(80, 0)); }};
    }
    Drag inDialog()
    {
        auto *dialog = new AlongDialog(editor(), &window);
        dialog->show();
        dialog->choose(AlongDialog::Constant);
        CurveEditor &curve = *dialog->curve();
        const auto place = [&curve](int k) { return curve.toWidget({0.5, 0.2 + 0.15 * k}).toPoint(); };
        return {[&curve, place] { QTest::mousePress(&curve, Qt::LeftButton, {}, place(0)); },
                [&curve, place](int k) { QTest::mouseMove(&curve, place(k)); },
                [&curve, place, dialog] {
                    QTest::mouseRelease(&curve, Qt::LeftButton, {}, place(4));
                    dialog->accept();
                }};
    }
    Drag dragOf(const QString &kind)
    {
        SegmentSection *segments = window.findChild<SegmentSection *>();
        if (kind == "move")
            return onCanvas(Command::Select, {250, 320}, {9, 14});
        if (kind == "scale")
            return onCanvas(Command::Select, {600, 340}, {15, 12});
        if (kind == "node")
            return onCanvas(Command::Segments, {300, 340}, {5, 15});
        if (kind == "curve")
            return onCanvas(Command::Segments, {350, 320}, {3, 15});
        if (kind == "width")
            return onCanvas(Command::Segments, {450, 320}, {1, 6});
        if (kind == "erase")
            return onCanvas(Command::Eraser, {215, 302}, {18, 8});
        if (kind == "attribute")
            return onCanvas(Command::AttributeBrush, {250, 320}, {6, 0});
        if (kind == "slider")
            return onSlider(*segments->density()->slider());
        if (kind == "colour")
            return onSlider(*segments->colour()->row(ColourRows::Blue)->slider());
        if (kind == "born")
            return onSlider(*segments->born()->slider());
        if (kind == "background") {
            editor().document().setSelection({});
            return onSlider(*window.findChild<InspectorPanel *>()->canvasSection()->background()->row(0)->slider());
        }
        return kind == "timeline" ? onTimeline() : inDialog();
    }
    Pixels<std::uint32_t> pixels(PaintingPtr painting)
    {
        return pixelsOf({std::move(painting), editor().clock().time(), View::ofArea(Rect::of(0, 0, 900, 600), 90, 60),
                         false, false});
    }
    void undoAllAndRedo(const Painting &first)
    {
        const Painting last = painting();
        const int index = editor().undoStack().index();
        while (editor().canUndo())
            editor().undo();
        QCOMPARE(painting(), first);
        while (editor().undoStack().index() < index)
            editor().redo();
        QCOMPARE(painting(), last);
    }
};

} // namespace

class TestGestures : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void readAtEachReport_data() { drags(); }
    void readAtEachReport()
    {
        QFETCH(QString, drag);
        Dragging s;
        const Drag d = s.dragOf(drag);
        const int index = s.editor().undoStack().index(), count = s.steps();
        d.press();
        Painting before = s.start;
        for (int k = 1; k <= 4; ++k) {
            d.report(k);
            QVERIFY2(s.painting() != before, qPrintable(QString::number(k)));
            before = s.painting();
            QCOMPARE(problemOf(before), QString());
            QCOMPARE(*s.editor().shown(), before);
            QCOMPARE(s.pixels(s.editor().shown()), s.pixels(std::make_shared<const Painting>(before)));
            QCOMPARE(s.editor().undoStack().index(), index);
            QCOMPARE(s.steps(), count); // those to be redone are still there
            QVERIFY(s.editor().canUndo() && !s.editor().canRedo());
        }
        d.release();
        QCOMPARE(s.steps(), index + 1);
        QVERIFY(!s.editor().isDragging());
        if (drag == "erase") // the end of a path that takes paint away is fitted when the pen is lifted, as the brush's
            QVERIFY(s.painting() != s.start && problemOf(s.painting()).isEmpty());
        else
            QCOMPARE(s.painting(), before);
        s.editor().undo();
        QCOMPARE(s.painting(), s.start);
    }

    void undoneAtEachReport_data() { drags(); }
    void undoneAtEachReport()
    {
        QFETCH(QString, drag);
        for (const bool byStack : {false, true}) {
            Dragging s;
            const Painting first = firstOf(s);
            const Drag d = s.dragOf(drag);
            d.press();
            for (int k = 1; k <= 4; ++k) {
                d.report(k);
                const Painting now = s.painting();
                if (byStack) { // given up, and the step before undone and done again
                    s.editor().undoStack().undo();
                    s.editor().undoStack().redo();
                } else {
                    s.editor().undo();
                    s.editor().redo();
                    QCOMPARE(s.painting(), now);
                }
                QCOMPARE(problemOf(s.painting()), QString());
            }
            d.release();
            s.undoAllAndRedo(first);
        }
    }

    void savedAtEachReport_data() { drags(); }
    void savedAtEachReport()
    {
        QFETCH(QString, drag);
        Dragging s;
        const Painting first = firstOf(s);
        const QString path = s.folder.filePath("a.suffuse");
        const Drag d = s.dragOf(drag);
        d.press();
        for (int k = 1; k <= 4; ++k) {
            d.report(k);
            const Painting now = s.painting();
            s.editor().startSaving(path, true);
            QTRY_VERIFY(!s.editor().isSaving());
            const Result<OpenedFile> file = readOpenedFile(path);
            QVERIFY(bool(file));
            QCOMPARE(file->document.painting, now);
            QCOMPARE(s.editor().isModified(), s.painting() != now); // a brush goes on while it stays
        }
        d.release();
        s.undoAllAndRedo(first);
    }

    void elsewhereAtEachReport_data() { drags(); }
    void elsewhereAtEachReport()
    {
        QFETCH(QString, drag);
        Dragging s;
        const Painting first = firstOf(s);
        const StrokeId other = s.addWave(200, 100, false);
        const Drag d = s.dragOf(drag);
        d.press();
        for (int k = 1; k <= 4; ++k) {
            d.report(k);
            const StrokePtr dragged = s.painting().find(s.id);
            s.editor().push(changeStrokes(s.editor().document(), {other},
                                          [k](Stroke &stroke) { stroke.name = QString::number(k); }),
                            "other");
            QCOMPARE(s.painting().find(other)->name, QString::number(k));
            QCOMPARE(s.painting().find(s.id), dragged);
        }
        d.release();
        s.undoAllAndRedo(first);
    }

private:
    static void drags()
    {
        QTest::addColumn<QString>("drag");
        for (const char *drag : {"move", "scale", "node", "curve", "width", "erase", "attribute", "slider", "colour",
                                 "born", "background", "timeline", "along the stroke"})
            QTest::newRow(drag) << drag;
    }
    /// The painting before all steps.
    static Painting firstOf(Dragging &s)
    {
        const int index = s.editor().undoStack().index();
        s.editor().undoStack().setIndex(0);
        const Painting first = s.painting();
        s.editor().undoStack().setIndex(index);
        s.editor().clock().setTime(s.painting().end());
        return first;
    }

    QTemporaryDir m_folder;
};

QTEST_MAIN(TestGestures)
#include "test_gestures.moc"

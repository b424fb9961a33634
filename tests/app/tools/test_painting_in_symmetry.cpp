// Painting in a symmetry: each copy is a stroke, all of them are one step, and the axes can be dragged.
#include "app/canvas/handles/symmetry_handle.h"
#include "app/session/current_layer.h"
#include "app/session/drawing_aids.h"
#include "app/window/layout/workspace_view.h"
#include "model/shaping/transform.h"
#include "tests/app/session.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace suffuse;

namespace {

void setSymmetry(Session &s, SymmetryKind kind, int arms = 6)
{
    Symmetry symmetry = s.editor().aids().symmetry();
    symmetry.isOn = true;
    symmetry.kind = kind;
    symmetry.arms = arms;
    symmetry.centre = {500, 400};
    s.editor().aids().setSymmetry(symmetry);
}

std::optional<SymmetryHandle::Grips> gripsOf(Session &s)
{
    CanvasView view;
    view.resize(s.canvas().view().width, s.canvas().view().height);
    view.lookThrough(s.canvas().view());
    const double dpr = s.canvas().devicePixelRatioF();
    return SymmetryHandle(
               s.editor().aids(), view, [] { return true; }, [dpr] { return dpr; })
        .grips();
}

QPoint logical(Session &s, Point pixel)
{
    const double dpr = s.canvas().devicePixelRatioF();
    return {qRound(pixel.x / dpr), qRound(pixel.y / dpr)};
}

} // namespace

class TestPaintingInSymmetry : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void allCopiesAreOneStep()
    {
        Session s;
        setSymmetry(s, SymmetryKind::Kaleidoscope, 3);
        s.paintLine({300, 300}, {420, 340});
        QCOMPARE(s.painting().strokes.size(), std::size_t(6));
        const std::vector<Affine> maps = s.editor().aids().symmetry().copies();
        const StrokePtr first = s.painting().strokes[0];
        for (std::size_t i = 0; i < maps.size(); ++i) {
            Stroke wanted = transformed(*first, maps[i], SpreadRule::Scales);
            wanted.id = s.painting().strokes[i + 1]->id;
            QVERIFY(*s.painting().strokes[i + 1] == wanted);
        }
        QCOMPARE(s.editor().undoStack().count(), 1);
        s.use(Command::Undo);
        QVERIFY(s.painting().strokes.empty());
        s.use(Command::Redo);
        QCOMPARE(s.painting().strokes.size(), std::size_t(6));
    }

    /// And they are those that come into the painting, so that nothing jumps when the pen lifts.
    void copiesShowWhileOneDraws()
    {
        Session s;
        setSymmetry(s, SymmetryKind::Across);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({300, 300}));
        for (int i = 1; i <= 20; ++i) {
            s.advance(interval);
            QTest::mouseMove(&s.canvas(), s.at({300 + 5.0 * i, 300}));
        }
        const PaintingPtr shown = s.editor().shown();
        QCOMPARE(shown->strokes.size(), std::size_t(2));
        QVERIFY(curveBox(*shown->strokes[1]).left > 590);
        const StrokeId copy = shown->strokes[1]->id;
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({400, 300}));
        QCOMPARE(s.painting().strokes.size(), std::size_t(2));
        QCOMPARE(s.painting().strokes[1]->id, copy);
        s.dry();
        const QImage picture = s.canvas().picture();
        const auto darkAt = [&](Point p) {
            const Point at = s.canvas().view().toPixels(p);
            return qGray(picture.pixel(int(at.x), int(at.y))) < 200;
        };
        QVERIFY(darkAt({350, 300}) && darkAt({650, 300}) && !darkAt({500, 300}));
    }

    void escLeavesNothing()
    {
        Session s;
        setSymmetry(s, SymmetryKind::Turns, 5);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({300, 300}));
        s.advance(interval);
        QTest::mouseMove(&s.canvas(), s.at({350, 300}));
        QCOMPARE(s.editor().shown()->strokes.size(), std::size_t(5));
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QVERIFY(s.editor().shown()->strokes.empty());
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({350, 300}));
        QVERIFY(s.painting().strokes.empty());
    }

    /// In the layer that is painted on, below what lies above it.
    void copiesComeIntoTheLayer()
    {
        Session s;
        s.paintLine({200, 500}, {300, 500});
        s.editor().document().setSelection({{s.painting().strokes[0]->id}, {}});
        s.use(Command::GroupStrokes);
        const GroupId group = s.painting().groups[0].id;
        s.editor().document().setSelection({});
        s.editor().layer().choose(0);
        s.paintLine({200, 600}, {300, 600});
        const StrokeId above = s.painting().strokes[1]->id;
        s.editor().layer().choose(group);
        setSymmetry(s, SymmetryKind::Both);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({300, 300}));
        s.advance(interval);
        QTest::mouseMove(&s.canvas(), s.at({350, 300}));
        const PaintingPtr shown = s.editor().shown();
        QCOMPARE(shown->strokes.size(), std::size_t(6));
        QCOMPARE(shown->strokes[5]->id, above);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({350, 300}));
        QCOMPARE(s.painting().strokes.size(), std::size_t(6));
        for (int i = 0; i < 5; ++i)
            QCOMPARE(s.painting().strokes[std::size_t(i)]->group, group);
        QCOMPARE(s.painting().strokes[5]->id, above);
    }

    /// What is painted in the past comes to its place in time with all of its copies, and shows there meanwhile.
    void copiesComeIntoThePast()
    {
        Session s;
        s.paintLine({200, 500}, {300, 500});
        s.dry();
        s.paintLine({200, 600}, {300, 600});
        s.dry();
        const StrokeId last = s.painting().strokes[1]->id;
        s.editor().clock().lookAt(s.painting().strokes[1]->born() - 1'000);
        setSymmetry(s, SymmetryKind::Turns, 3);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({300, 300}));
        QTest::mouseMove(&s.canvas(), s.at({350, 300}));
        const PaintingPtr shown = s.editor().shown();
        QCOMPARE(shown->strokes.size(), std::size_t(5));
        QCOMPARE(shown->strokes[4]->id, last);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({350, 300}));
        QCOMPARE(s.painting().strokes.size(), std::size_t(5));
        QCOMPARE(s.painting().strokes[4]->id, last);
        s.use(Command::Undo);
        QCOMPARE(s.painting().strokes.size(), std::size_t(2));
    }

    void shapesComeInCopies()
    {
        Session s;
        setSymmetry(s, SymmetryKind::Turns, 4);
        s.use(Command::Shapes);
        s.paintLine({300, 300}, {380, 340});
        QCOMPARE(s.painting().strokes.size(), std::size_t(4));
        QVERIFY(std::ranges::all_of(s.painting().strokes, [](const StrokePtr &stroke) { return bool(stroke->fill); }));
        QCOMPARE(s.selection().strokes.size(), std::size_t(4));
        s.use(Command::Undo);
        QVERIFY(s.painting().strokes.empty());
    }

    void theSquareMovesTheAxis()
    {
        Session s;
        setSymmetry(s, SymmetryKind::Across);
        const auto before = gripsOf(s);
        QVERIFY(before);
        const QPointF over = logical(s, before->move);
        QMouseEvent hover(QEvent::MouseMove, over, s.canvas().mapToGlobal(over), Qt::NoButton, Qt::NoButton, {});
        QCoreApplication::sendEvent(&s.canvas(), &hover);
        QCOMPARE(s.canvas().cursor().shape(), Qt::SizeAllCursor);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, logical(s, before->move));
        const QPoint to = logical(s, before->move) + QPoint(60, 0);
        QTest::mouseMove(&s.canvas(), to);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, to);
        const double moved = 60 * s.canvas().devicePixelRatioF() / s.canvas().view().scale;
        QVERIFY(std::abs(s.editor().aids().symmetry().centre.x - 500 - moved) < 1e-6);
        QCOMPARE(s.editor().aids().symmetry().centre.y, 400.0);
        QVERIFY(s.painting().strokes.empty());
        QCOMPARE(s.editor().undoStack().count(), 0);
        // Without the axes in view the press belongs to the tool.
        s.window.action(Command::ShowSymmetry).setChecked(false);
        QTest::mouseClick(&s.canvas(), Qt::LeftButton, {}, logical(s, gripsOf(s)->move));
        QVERIFY(!s.painting().strokes.empty());
        s.window.action(Command::ShowSymmetry).setChecked(true);
    }

    void theDiscTurnsItAndEscTakesBack()
    {
        Session s;
        setSymmetry(s, SymmetryKind::Down);
        const auto grips = gripsOf(s);
        QVERIFY(grips);
        const Point at = s.canvas().view().toPixels({500, 400});
        const Point from = grips->turn - at;
        const QPoint to = logical(s, at + 0.3 * Point{-from.y, from.x} + 0.3 * from); // 45° further
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, logical(s, grips->turn));
        QTest::mouseMove(&s.canvas(), to, Qt::ShiftModifier);
        QVERIFY(std::abs(s.editor().aids().symmetry().angle - std::numbers::pi / 4) < 0.02);
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QCOMPARE(s.editor().aids().symmetry().angle, 0.0);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, to);
        QCOMPARE(s.editor().aids().symmetry().angle, 0.0);
    }

    /// What is dragged while another painting is opened leaves no trace in that.
    void anotherPaintingBeginsAnew()
    {
        Session s;
        setSymmetry(s, SymmetryKind::Across);
        const QPoint grip = logical(s, gripsOf(s)->move);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, grip);
        QTest::mouseMove(&s.canvas(), grip + QPoint(60, 0));
        s.editor().newPainting(Editor::usualCanvas());
        QTest::mouseMove(&s.canvas(), grip + QPoint(90, 0));
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, grip + QPoint(90, 0));
        const Symmetry usual = DrawingAids::usualSymmetry(s.painting().canvas.area());
        QVERIFY(s.editor().aids().symmetry() == usual);
    }

    void commandsSwitchAndFilesKeepIt()
    {
        Session s;
        QVERIFY(!workspaceOf(s.canvas(), s.editor()));
        s.use(Command::SymmetryKaleidoscope);
        QVERIFY(s.window.action(Command::PaintInSymmetry).isChecked());
        QVERIFY(s.window.action(Command::SymmetryKaleidoscope).isChecked());
        QVERIFY(s.window.action(Command::SymmetryArms).isEnabled());
        s.use(Command::SymmetryKaleidoscope); // It stays what it is.
        QVERIFY(s.window.action(Command::SymmetryKaleidoscope).isChecked());
        s.use(Command::SymmetryAcross);
        QVERIFY(!s.window.action(Command::SymmetryKaleidoscope).isChecked());
        QVERIFY(!s.window.action(Command::SymmetryArms).isEnabled());
        const auto kept = workspaceOf(s.canvas(), s.editor());
        QVERIFY(kept && kept->symmetry);
        s.use(Command::PaintInSymmetry);
        QVERIFY(!s.window.action(Command::SymmetryAcross).isChecked());
        QVERIFY(!s.editor().aids().symmetry().isOn);
        Session other;
        showWorkspace(*kept, other.canvas(), other.editor());
        QVERIFY(other.editor().aids().symmetry() == *kept->symmetry);
        QVERIFY(other.window.action(Command::SymmetryAcross).isChecked());
        other.editor().newPainting(Editor::usualCanvas());
        QVERIFY(!other.editor().aids().symmetry().isOn);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestPaintingInSymmetry)
#include "test_painting_in_symmetry.moc"

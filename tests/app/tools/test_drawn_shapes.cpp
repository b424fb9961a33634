// Rectangles, ellipses, polygons and stars under the hand.
#include "app/tools/shapes/shape_tool.h"
#include "model/paint/seen_paint.h"
#include "model/painting/validate.h"
#include "tests/app/session.h"
#include "undo/fill_edits.h"

#include <QComboBox>
#include <QTemporaryDir>

using namespace suffuse;

namespace {

constexpr Qt::KeyboardModifiers none = {};

struct Drawing : Session {
    Drawing() { use(Command::Shapes); }

    ShapeTool &tool() { return *qobject_cast<ShapeTool *>(canvas().tool()); }
    void take(ShapeKind kind)
    {
        ShapeForm form;
        form.kind = kind;
        tool().setForm(form);
    }
    void drag(Point from, Point to, Qt::KeyboardModifiers modifiers = none)
    {
        QTest::mousePress(&canvas(), Qt::LeftButton, modifiers, at(from));
        for (int i = 1; i <= 5; ++i) {
            advance(interval);
            const QPoint pixel = at(from + (i / 5.0) * (to - from));
            QMouseEvent move(QEvent::MouseMove, pixel, canvas().mapToGlobal(pixel), Qt::NoButton, Qt::LeftButton,
                             modifiers);
            QCoreApplication::sendEvent(&canvas(), &move);
        }
        QTest::mouseRelease(&canvas(), Qt::LeftButton, modifiers, at(to));
    }
    Rect last()
    {
        Rect box;
        const Stroke &stroke = *painting().strokes.back();
        for (const Segment &segment : stroke.segments)
            for (int i = 0; i <= 16; ++i)
                box.include(stroke.cubicOf(segment).at(i / 16.0));
        return box;
    }
    int steps() { return editor().undoStack().count(); }
};

bool isNear(const Rect &box, const Rect &wanted)
{
    constexpr double pixels = 2.5; // the mouse goes in whole ones, of which one is some canvas units
    return std::abs(box.left - wanted.left) < pixels && std::abs(box.top - wanted.top) < pixels &&
           std::abs(box.right - wanted.right) < pixels && std::abs(box.bottom - wanted.bottom) < pixels;
}

} // namespace

class TestDrawnShapes : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void aDragDrawsAndSelects()
    {
        Drawing s;
        s.take(ShapeKind::Rectangle);
        s.drag({200, 200}, {500, 350});
        QCOMPARE(s.steps(), 1);
        QCOMPARE(s.editor().undoText(), QString("Rectangle"));
        QVERIFY(isNear(s.last(), {200, 200, 500, 350}));
        QCOMPARE(s.selection().strokes, std::set<StrokeId>{s.painting().strokes.back()->id});
        QCOMPARE(s.painting().strokes.back()->segments.size(), std::size_t(4));
        QCOMPARE(s.painting().strokes.back()->brush, s.editor().brush().name);
        s.drag({500, 200}, {300, 260}, Qt::ShiftModifier); // a square towards the left
        QVERIFY(isNear(s.last(), {300, 200, 500, 400}));
        s.drag({400, 300}, {450, 320}, Qt::ControlModifier); // from the middle
        QVERIFY(isNear(s.last(), {350, 280, 450, 320}));
        s.use(Command::Undo);
        QCOMPARE(s.painting().strokes.size(), std::size_t(2));
    }

    void whatIsPaintedIsChosen()
    {
        Drawing s;
        for (const ShapePaint paint : {ShapePaint::Outline, ShapePaint::Fill, ShapePaint::Both}) {
            s.tool().setForm({});
            s.tool().setPaint(paint);
            s.drag({200, 200}, {500, 350});
            const Stroke &stroke = *s.painting().strokes.back();
            QCOMPARE(bool(stroke.fill), paint != ShapePaint::Outline);
            QCOMPARE(stroke.segments.front().density > 0, paint != ShapePaint::Fill);
            if (stroke.fill)
                QCOMPARE(stroke.fill->colour, s.editor().brush().colour);
        }
    }

    /// A brush whose paint spreads farther than the shape is wide would leave nothing to be seen.
    void aThinFillShows()
    {
        Drawing s;
        s.editor().setBrush(*findBrush("flat-marker"));
        s.drag({300, 300}, {306, 400});
        s.editor().document().setSelection({});
        const Stroke thin = *s.painting().strokes.back();
        const Rect box = s.last();
        QVERIFY(box.right - box.left < 12);
        const SeenPaint middle = seenPaint(thin, s.painting().end(), box.centre());
        QVERIFY2(middle.opacity > 0.9 * double(thin.fill->colour.opacity), qPrintable(QString::number(middle.opacity)));
        s.drag({400, 200}, {700, 500}); // Where there is room the brush has its own spread.
        const Stroke &wide = *s.painting().strokes.back();
        QVERIFY(wide.fill->diffusion > 2 * thin.fill->diffusion);
        Stroke outline = wide;
        outline.fill = {};
        QCOMPARE(wide.fill->diffusion, usualFill(outline).diffusion);
    }

    void eachKindHasItsOutline()
    {
        Drawing s;
        s.take(ShapeKind::Ellipse);
        s.drag({200, 200}, {400, 300});
        QVERIFY(isNear(s.last(), {200, 200, 400, 300}));
        QCOMPARE(s.editor().undoText(), QString("Ellipse"));
        s.take(ShapeKind::Polygon);
        s.drag({400, 300}, {500, 310}, Qt::ShiftModifier); // to the right exactly
        QVERIFY(std::abs(s.last().right - 500) < 3);
        QCOMPARE(s.painting().strokes.back()->segments.size(), std::size_t(5));
        const Point tip = s.painting().strokes.back()->origin;
        QVERIFY(std::abs(tip.y - 300) < 2.5);
        s.take(ShapeKind::Star);
        s.drag({400, 300}, {400, 200});
        QCOMPARE(s.painting().strokes.back()->segments.size(), std::size_t(10));
        QCOMPARE(s.steps(), 3);
    }

    /// From the drag to the key: two shapes become one.
    void shapesAreCombinedByKeys()
    {
        Drawing s;
        s.take(ShapeKind::Rectangle);
        s.drag({200, 200}, {400, 350});
        s.drag({300, 300}, {500, 450});
        s.use(Command::SelectAll);
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.canvas().setFocus();
        QTest::keyClick(&s.canvas(), Qt::Key_Asterisk, Qt::ControlModifier);
        QCOMPARE(s.steps(), 3);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QVERIFY(isNear(s.last(), {300, 300, 400, 350}));
        QTest::keyClick(&s.canvas(), Qt::Key_Z, Qt::ControlModifier);
        QTest::keyClick(&s.canvas(), Qt::Key_Plus, Qt::ControlModifier | Qt::AltModifier);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QVERIFY(isNear(s.last(), {200, 200, 500, 450}));
    }

    void aClickOrALineDrawsNothing()
    {
        Drawing s;
        s.take(ShapeKind::Ellipse);
        s.click({300, 300});
        s.drag({300, 300}, {400, 300});
        QCOMPARE(s.steps(), 0);
        QVERIFY(!s.editor().document().draft());
        QVERIFY(!s.canvas().tool()->isBusy());
    }

    void escGivesItUp()
    {
        Drawing s;
        QTest::mousePress(&s.canvas(), Qt::LeftButton, none, s.at({200, 200}));
        QTest::mouseMove(&s.canvas(), s.at({300, 300}));
        QVERIFY(s.editor().document().draft()); // it shows as paint
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QVERIFY(!s.editor().document().draft());
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, none, s.at({300, 300}));
        QCOMPARE(s.steps(), 0);
        QVERIFY(s.painting().strokes.empty());
    }

    void returnDrawsOneInTheMiddle()
    {
        Drawing s;
        s.take(ShapeKind::Rectangle);
        s.drag({200, 200}, {300, 260});
        const Rect first = s.last();
        s.canvas().setFocus();
        QTest::keyClick(&s.canvas(), Qt::Key_Return);
        QCOMPARE(s.steps(), 2);
        QVERIFY(std::abs(s.last().width() - first.width()) < 1e-3);
        const Point middle{0.5 * (s.last().left + s.last().right), 0.5 * (s.last().top + s.last().bottom)};
        QVERIFY(length(middle - s.canvas().view().centre) < 1e-3);
    }

    void theRowShowsWhatBelongsToTheKind()
    {
        Drawing s;
        const QWidget *row = s.tool().options();
        const auto shown = [&] {
            QStringList names;
            for (const QWidget *field : row->findChildren<QWidget *>(QString(), Qt::FindDirectChildrenOnly))
                if (field->isVisible() && field->property("shapes").isValid())
                    names << field->objectName();
            names.sort();
            return names.join(' ');
        };
        auto *kinds = row->findChild<QComboBox *>("kind");
        const QStringList wanted{"radius", "from pie sweep", "corners rounding", "corners inner rounding"};
        for (int i = 0; i < 4; ++i) {
            kinds->setCurrentIndex(i);
            emit kinds->activated(i);
            QCOMPARE(shown(), wanted[i]);
            QCOMPARE(s.tool().form().kind, ShapeKind(i));
        }
        ShapeForm form = s.tool().form();
        form.corners = 9;
        s.tool().setForm(form);
        Drawing next; // it is remembered
        QCOMPARE(next.tool().form().corners, 9);
        QCOMPARE(next.tool().form().kind, ShapeKind::Star);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestDrawnShapes)
#include "test_drawn_shapes.moc"

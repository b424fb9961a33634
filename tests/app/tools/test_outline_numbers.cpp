// Outlines whose nodes are typed, in the row over the canvas.
#include "app/tools/shapes/next_node.h"
#include "app/tools/shapes/pen_tool.h"
#include "app/widgets/numbers/number_field.h"
#include "model/area/outline.h"
#include "model/shaping/nodes/reshape.h"
#include "tests/app/session.h"

#include <QTemporaryDir>
#include <QToolButton>

#include <numbers>

using namespace suffuse;

namespace {

using Number = NextNode::Number;

bool isAt(Point a, Point b)
{
    return length(a - b) < 1e-3; // nodes are kept as 32-bit offsets
}

struct Typing : Session {
    explicit Typing(ShapePaint paint = ShapePaint::Outline)
    {
        use(Command::Zoom100);
        use(Command::OutlinePen);
        tool().setPaint(paint);
        window.activateWindow();
        active = QTest::qWaitForWindowActive(&window);
    }

    PenTool &tool() { return *qobject_cast<PenTool *>(canvas().tool()); }
    NumberField &field(const char *name) { return *tool().options()->findChild<NumberField *>(QLatin1String(name)); }
    QToolButton &close() { return *tool().options()->findChild<QToolButton *>("closeOutline"); }
    const char *focused()
    {
        for (const char *name : {"x", "y", "length", "angle"})
            if (field(name).hasFocus())
                return name;
        return canvas().hasFocus() ? "canvas" : "something else";
    }
    /// Types into the field that has the keyboard; a tabulator goes on, and \n is Return.
    void keys(const char *text)
    {
        for (; *text; ++text) {
            QWidget *widget = QApplication::focusWidget();
            if (*text == '\t')
                QTest::keyClick(widget, Qt::Key_Tab);
            else if (*text == '\n')
                QTest::keyClick(widget, Qt::Key_Return);
            else
                QTest::keyClick(widget, *text);
        }
    }
    void begin(const char *name)
    {
        field(name).setFocus();
        field(name).selectAll();
    }
    void clickAt(Point where) { QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at(where), 1000); }
    void hover(Point to)
    {
        const QPoint pixel = at(to);
        QMouseEvent event(QEvent::MouseMove, pixel, canvas().mapToGlobal(pixel), Qt::NoButton, Qt::NoButton, {});
        QCoreApplication::sendEvent(&canvas(), &event);
    }
    const Stroke &last() { return *painting().strokes.back(); }
    Point node(int i) { return nodePosition(last(), i); }
    int steps() { return editor().undoStack().count(); }

    bool active = false;
};

} // namespace

class TestOutlineNumbers : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void placesAndWaysExcludeEachOther()
    {
        NextNode node;
        QVERIFY(!node.isAnyTyped() && node.needsPointer(true) && node.needsPointer(false));
        node.type(Number::X, 30);
        QVERIFY(node.needsPointer(true) && !node.needsPointer(false));
        QVERIFY(isAt(node.place({1, 2}, Point{10, 10}), {30, 2}));
        node.type(Number::Y, 40);
        QVERIFY(!node.needsPointer(true));
        QVERIFY(isAt(node.place({1, 2}, std::nullopt), {30, 40}));
        node.type(Number::Length, 5);
        QVERIFY(!node.typed(Number::X) && !node.typed(Number::Y) && node.isWayTyped());
        QVERIFY(isAt(node.place({10, 40}, Point{10, 10}), {10, 15})); // to where the pointer is
        node.type(Number::Angle, std::numbers::pi);
        QVERIFY(isAt(node.place({10, 40}, Point{10, 10}), {5, 10}));
        node.forget(Number::Length); // as far as the pointer is
        QVERIFY(isAt(node.place({10, 40}, Point{10, 10}), {-20, 10}));
        node.type(Number::X, 7);
        QVERIFY(!node.isWayTyped());
        QVERIFY(isAt(node.place({10, 40}, Point{10, 10}), {7, 40}));
    }

    void aWholeOutlineIsTyped()
    {
        Typing s;
        QVERIFY(s.active);
        QVERIFY(!s.field("length").isEnabled() && !s.close().isEnabled());
        s.begin("x");
        s.keys("300\n"); // The first node needs both.
        QVERIFY(!s.tool().isBusy());
        QCOMPARE(s.focused(), "y");
        s.keys("200.5\n");
        QVERIFY(s.tool().isBusy());
        QCOMPARE(s.focused(), "x");
        QVERIFY(s.field("length").isEnabled() && !s.close().isEnabled());
        s.keys("+100\t\n"); // from the node before, whose y stays
        QCOMPARE(s.focused(), "x");
        s.begin("length");
        s.keys("50\t90\n");
        QCOMPARE(s.focused(), "length");
        QVERIFY(s.editor().document().draft()); // it shows as paint
        QCOMPARE(s.steps(), 0);
        s.keys("\n"); // Nothing is typed: it ends.
        QVERIFY(!s.tool().isBusy());
        QCOMPARE(s.focused(), "canvas");
        QCOMPARE(s.steps(), 1);
        QCOMPARE(s.editor().undoText(), QString("Outline"));
        QCOMPARE(s.last().segments.size(), std::size_t(2));
        QVERIFY(isAt(s.node(0), {300, 200.5}));
        QVERIFY(isAt(s.node(1), {400, 200.5}));
        QVERIFY(isAt(s.node(2), {400, 250.5}));
    }

    /// By the place of the first node, by Shift+Return, and by the button.
    void itIsClosedByKeys()
    {
        for (const int way : {0, 1, 2, 3}) {
            Typing s(ShapePaint::Fill);
            s.begin("x");
            s.keys("100\t100\n200\t100\n200\t180\n");
            QVERIFY(s.tool().isBusy() && s.close().isEnabled());
            if (way == 0)
                s.keys("100\t100\n");
            else if (way == 1)
                QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return, Qt::ShiftModifier);
            else if (way == 2)
                QTest::mouseClick(&s.close(), Qt::LeftButton);
            else {
                s.canvas().setFocus();
                QTest::keyClick(&s.canvas(), Qt::Key_Return, Qt::ShiftModifier);
            }
            QVERIFY2(!s.tool().isBusy(), qPrintable(QString::number(way)));
            QCOMPARE(s.steps(), 1);
            QCOMPARE(s.last().segments.size(), std::size_t(3));
            QVERIFY(s.last().segments.front().bezier[0] == s.last().segments.back().bezier[3]);
            QVERIFY(isFillAlone(s.last()));
            QVERIFY(isAt(s.node(1), {200, 100}) && isAt(s.node(2), {200, 180}));
            QCOMPARE(s.focused(), "canvas");
            QVERIFY(!s.close().isEnabled() && !s.field("length").isEnabled());
        }
    }

    /// The rest of its place is the pointer's.
    void aClickSetsWhatIsTyped()
    {
        Typing s;
        s.clickAt({300, 300});
        s.begin("x");
        s.keys("450");
        s.clickAt({500, 340});
        s.begin("length");
        s.keys("80\t");
        s.hover({450, 600});
        QVERIFY(std::abs(*s.field("angle").value() - std::numbers::pi / 2) < 0.02); // it follows the pointer
        QCOMPARE(*s.field("length").value(), 80.0);
        s.clickAt({450, 600});
        s.clickAt({300, 500}); // What was typed counts once.
        s.canvas().setFocus();
        QTest::keyClick(&s.canvas(), Qt::Key_Return);
        QCOMPARE(s.last().segments.size(), std::size_t(3));
        QVERIFY(isAt({s.node(1).x, 0}, {450, 0}) && std::abs(s.node(1).y - 340) < 1);
        QVERIFY(std::abs(length(s.node(2) - s.node(1)) - 80) < 1e-3);
        QVERIFY(std::abs(s.node(2).x - 450) < 1.5 && s.node(2).y > s.node(1).y);
        QVERIFY(length(s.node(3) - Point{300, 500}) < 1);
    }

    /// Its handle counts from the node, which is not where the pointer is.
    void aDragFromATypedNodePullsItsHandle()
    {
        Typing s;
        s.clickAt({300, 300});
        s.begin("x");
        s.keys("400\t300");
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({600, 500}), 1000);
        const QPoint to = s.at({640, 470});
        QMouseEvent move(QEvent::MouseMove, to, s.canvas().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&s.canvas(), &move);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, to);
        s.clickAt({500, 300});
        QTest::keyClick(&s.canvas(), Qt::Key_Return);
        QVERIFY(isAt(s.node(1), {400, 300}));
        QVERIFY(length(*handlePosition(s.last(), 1, true) - Point{440, 270}) < 1.5);
    }

    /// A number may be the one that the field shows anyhow, and a deleted one is the pointer's again.
    void whatIsTypedStaysUntilItIsDeleted()
    {
        Typing s;
        s.begin("x");
        s.keys("300\t300\n300\t"); // x is what it was
        s.hover({420, 380});
        QCOMPARE(*s.field("x").value(), 300.0);
        QVERIFY(std::abs(*s.field("y").value() - 380) < 1);
        s.begin("x");
        QTest::keyClick(&s.field("x"), Qt::Key_Delete);
        s.keys("\t");
        s.hover({421, 380});
        QVERIFY(std::abs(*s.field("x").value() - 421) < 1);
        s.begin("y");
        s.keys("nowhere\n"); // refused: nothing is set
        QCOMPARE(s.focused(), "y");
        QCOMPARE(s.editor().document().draft(), nullptr);
        s.keys("7");
        QTest::keyClick(&s.field("y"), Qt::Key_Escape); // takes it back
        s.canvas().setFocus();
        s.hover({300, 400});
        QVERIFY(std::abs(*s.field("y").value() - 400) < 1);
        s.clickAt({300, 400});
        QTest::keyClick(&s.canvas(), Qt::Key_Return);
        QVERIFY(length(s.node(1) - Point{300, 400}) < 1);
    }

    /// Undo takes back typed nodes like others, Return on the canvas sets one that is typed, and Esc forgets all.
    void typedNodesAreNodesLikeOthers()
    {
        Typing s;
        s.begin("x");
        s.keys("100\t100\n200\t100\n200\t250\n");
        s.use(Command::Undo);
        QCOMPARE(s.editor().document().draft()->segments.size(), std::size_t(1));
        QCOMPARE(*s.field("x").value(), 200.0);
        QCOMPARE(*s.field("y").value(), 100.0);
        s.begin("y");
        s.keys("300");
        s.field("y").takeTyped();
        s.canvas().setFocus();
        QTest::keyClick(&s.canvas(), Qt::Key_Return);
        QVERIFY(s.tool().isBusy());
        QTest::keyClick(&s.canvas(), Qt::Key_Return);
        QVERIFY(!s.tool().isBusy());
        QCOMPARE(s.last().segments.size(), std::size_t(2));
        QVERIFY(isAt(s.node(2), {200, 300}));
        s.begin("x");
        s.keys("10\t10\n20\t");
        s.canvas().setFocus();
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QVERIFY(!s.tool().isBusy());
        QVERIFY(!s.field("x").value() && !s.field("y").value() && !s.field("angle").isEnabled());
        QCOMPARE(s.steps(), 1);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestOutlineNumbers)
#include "test_outline_numbers.moc"

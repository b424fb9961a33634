// The canvas as a screen reader finds it, and painting without a mouse.
#include "app/canvas/reading/canvas_reading.h"
#include "app/session/colour/colour_words.h"
#include "app/session/colour_convert.h"
#include "app/session/selecting/stroke_words.h"
#include "app/session/colour/colour_target.h"
#include "app/session/settings/settings.h"
#include "app/session/translation.h"
#include "app/window/layout/window_layout.h"
#include "tests/app/panel_bench.h"
#include "tests/app/window/hands_on_widgets.h"
#include "undo/layers/group_edits.h"

#include <QAccessible>
#include <QLabel>
#include <QStatusBar>

using namespace suffuse;

namespace {

/// What readers are told; it must outlive what is done.
struct Heard {
    QList<std::pair<QAccessible::Event, StrokeId>> events;
    explicit Heard(Session &s)
    {
        QObject::connect(s.window.findChild<CanvasReading *>(), &CanvasReading::told, &s.canvas(),
                         [this](QAccessible::Event what, const TreeItem &about) { events << std::pair(what, about.stroke); });
    }
    bool has(QAccessible::Event what, StrokeId stroke) const { return events.contains(std::pair(what, stroke)); }
};

QAccessibleInterface *readingOf(Session &s)
{
    return QAccessible::queryAccessibleInterface(&s.canvas());
}

struct BlackSession : Session {
    BlackSession()
    {
        editor().setColour({1, 1, 1, 1});
        QAccessible::setActive(true); // as if a screen reader ran
    }
};

QString said(Session &s)
{
    return s.window.statusBar()->currentMessage();
}

} // namespace

class TestWorkingByKeys : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        keepSettingsIn(m_folder);
        settings::setLanguage("en");
        installTranslators();
    }
    void init() { window_layout::reset(); }

    void coloursHaveNames_data()
    {
        QTest::addColumn<QColor>("screen");
        QTest::addColumn<QString>("word");
        for (const auto &[colour, word] : std::initializer_list<std::pair<const char *, const char *>>{
                 {"#000000", "black"}, {"#ffffff", "white"}, {"#808080", "grey"}, {"#303030", "dark grey"},
                 {"#d0d0d0", "light grey"}, {"#e01010", "red"}, {"#701010", "dark red"}, {"#f08010", "orange"},
                 {"#704010", "brown"}, {"#f0e020", "yellow"}, {"#209020", "dark green"}, {"#20c020", "green"},
                 {"#20c0c0", "turquoise"}, {"#2050d0", "blue"}, {"#101060", "dark blue"}, {"#b0c0ff", "light blue"},
                 {"#8030d0", "violet"}, {"#d020b0", "magenta"}, {"#ffb0d0", "pink"}})
            QTest::newRow(colour) << QColor(colour) << QString(word);
    }

    void coloursHaveNames()
    {
        QFETCH(QColor, screen);
        QFETCH(QString, word);
        QCOMPARE(wordOf(fromScreen(screen)), word);
    }

    /// Names, places, states and what can be done with strokes; those of a group are its children.
    void strokesAreAList()
    {
        BlackSession s;
        s.paintLine({100, 100}, {300, 100});
        s.paintLine({100, 200}, {300, 200});
        s.paintLine({100, 300}, {300, 300});
        QAccessibleInterface *canvas = readingOf(s);
        QCOMPARE(canvas->childCount(), 3);
        const auto name = [](QAccessibleInterface *of) { return of->text(QAccessible::Name); };
        const int segments = int(s.painting().strokes[1]->segments.size());
        QCOMPARE(name(canvas->child(1)), QString("stroke 2, even, black, %1 segments").arg(segments));
        QCOMPARE(canvas->child(1)->role(), QAccessible::ListItem);
        QCOMPARE(canvas->indexOfChild(canvas->child(1)), 1);
        QCOMPARE(canvas->child(1)->parent(), canvas);
        const QPoint middle = s.canvas().mapToGlobal(s.at({200, 200}));
        QVERIFY(canvas->child(1)->rect().contains(middle));
        QVERIFY(!canvas->child(0)->rect().contains(middle));
        s.dry();
        QCOMPARE(canvas->childAt(middle.x(), middle.y()), canvas->child(1));

        QVERIFY(!canvas->child(1)->state().selected && canvas->child(1)->state().selectable);
        QAccessibleActionInterface *actions = canvas->child(1)->actionInterface();
        QVERIFY(actions && actions->actionNames().contains("select"));
        actions->doAction("select");
        QCOMPARE(s.selection().strokes, std::set<StrokeId>{2});
        QVERIFY(canvas->child(1)->state().selected);
        canvas->child(2)->actionInterface()->doAction(QAccessibleActionInterface::toggleAction());
        QCOMPARE(s.selection().strokes, (std::set<StrokeId>{2, 3}));
        s.editor().push(groupSelection(s.editor().document(), "leaves"), "group");
        s.editor().laterChanges().flush();
        QCOMPARE(canvas->childCount(), 2);
        QAccessibleInterface *group = canvas->child(1);
        QCOMPARE(name(group), QString("leaves"));
        QCOMPARE(group->childCount(), 2);
        QCOMPARE(name(group->child(0)), QString("stroke 2, even, black, %1 segments").arg(segments));
        QCOMPARE(group->child(0)->parent(), group);
        QVERIFY(group->state().selected);
        s.use(Command::HideStrokes);
        s.editor().laterChanges().flush();
        QVERIFY(canvas->child(1)->child(0)->state().invisible);
        QVERIFY(canvas->child(1)->child(0)->actionInterface()->actionNames().isEmpty());
    }

    void whatIsGoneIsNotRead()
    {
        BlackSession s;
        s.paintLine({100, 100}, {300, 100});
        s.paintLine({100, 200}, {300, 200});
        QAccessibleInterface *canvas = readingOf(s), *first = canvas->child(0);
        const QAccessible::Id id = QAccessible::uniqueId(first);
        Heard heard(s);
        s.editor().document().setSelection({{1}, {}});
        s.editor().laterChanges().flush();
        QVERIFY(heard.has(QAccessible::SelectionAdd, 1));
        s.use(Command::Select);
        s.use(Command::Delete);
        s.editor().laterChanges().flush();
        QVERIFY(!QAccessible::accessibleInterface(id));
        QCOMPARE(canvas->childCount(), 1);
        QVERIFY(heard.has(QAccessible::ObjectDestroyed, 1));
        s.use(Command::Undo);
        s.editor().laterChanges().flush();
        QCOMPARE(canvas->childCount(), 2);
        QVERIFY(heard.has(QAccessible::ObjectCreated, 1));
        s.editor().colourTarget().setPaint(fromScreen(QColor("#e01010")));
        s.editor().laterChanges().flush();
        QVERIFY(heard.has(QAccessible::NameChanged, 1));
        QVERIFY(canvas->child(0)->text(QAccessible::Name).startsWith("stroke 1, even, red"));
        s.editor().newPainting(Editor::usualCanvas());
        s.editor().laterChanges().flush();
        QCOMPARE(canvas->childCount(), 0);
    }

    /// Nothing is made for strokes that nobody asks for.
    void aLargePaintingIsReadInPieces()
    {
        BlackSession s;
        Painting painting = s.painting();
        for (int i = 1; i <= 20'000; ++i)
            painting.strokes.push_back(makeStroke(StrokeId(i), 1, 10));
        s.editor().document().reset(std::make_shared<const Painting>(std::move(painting)));
        s.editor().laterChanges().flush();
        QAccessibleInterface *canvas = readingOf(s);
        QCOMPARE(canvas->childCount(), 20'000);
        QVERIFY(canvas->child(19'999)->text(QAccessible::Name).startsWith("stroke 20000, "));
        QCOMPARE(canvas->indexOfChild(canvas->child(12'345)), 12'345);
        Heard heard(s);
        s.use(Command::SelectAll);
        s.editor().laterChanges().flush();
        QVERIFY(heard.events.size() < 20 && heard.has(QAccessible::SelectionWithin, 0));
    }

    void aStrokeIsPaintedByKeys()
    {
        BlackSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.canvas().setFocus();
        const auto key = [&](Qt::Key which, Qt::KeyboardModifiers modifiers = {}) {
            QTest::keyClick(&s.canvas(), which, modifiers);
            s.advance(interval);
        };
        const int steps = s.editor().undoStack().count();
        key(Qt::Key_P, Qt::ControlModifier | Qt::AltModifier);
        QVERIFY(s.canvas().keyboardPen().isOn());
        QVERIFY(said(s).contains("Space"));
        const auto *hint = s.window.statusBar()->findChild<QLabel *>("hint");
        QVERIFY2(hint && hint->text().startsWith("Arrow keys"), qPrintable(hint->text()));
        const Point from = s.canvas().keyboardPen().point();
        key(Qt::Key_Space);
        QVERIFY(s.canvas().isPressed());
        for (int i = 0; i < 5; ++i)
            key(Qt::Key_Right);
        key(Qt::Key_Down, Qt::ShiftModifier);
        key(Qt::Key_Left, Qt::AltModifier);
        key(Qt::Key_Space);
        QVERIFY(!s.canvas().isPressed());
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(s.editor().undoStack().count(), steps + 1);
        const Stroke &stroke = *s.painting().strokes.front();
        const double unit = s.canvas().devicePixelRatioF() / s.canvas().view().scale; // of a logical pixel
        const Cubic last = stroke.cubicOf(stroke.segments.back()), first = stroke.cubicOf(stroke.segments.front());
        QVERIFY(length(first.at(0) - from) < 2 * unit);
        QVERIFY(length(last.at(1) - (from + Point{49 * unit, 100 * unit})) < 4 * unit);
        QVERIFY2(said(s).startsWith("Pen up at ") && said(s).contains("stroke 1, even, black"), qPrintable(said(s)));
        QCOMPARE(readingOf(s)->text(QAccessible::Description), said(s));

        key(Qt::Key_Space); // given up
        key(Qt::Key_Right);
        key(Qt::Key_Escape);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QVERIFY(s.canvas().keyboardPen().isOn());
        key(Qt::Key_Escape);
        QVERIFY(!s.canvas().keyboardPen().isOn());
        QVERIFY(!s.window.action(Command::PaintWithKeys).isChecked());
    }

    /// Delete and Undo give up what is in hand, as with a mouse; the pen, which no hand lets go of, is up then.
    void whatGivesUpLiftsThePen()
    {
        for (const Command command : {Command::Delete, Command::Undo}) {
            BlackSession s;
            QVERIFY(QTest::qWaitForWindowActive(&s.window));
            s.canvas().setFocus();
            s.use(Command::PaintWithKeys);
            const auto stroke = [&] {
                QTest::keyClick(&s.canvas(), Qt::Key_Space);
                for (int i = 0; i < 4; ++i) {
                    QTest::keyClick(&s.canvas(), Qt::Key_Right);
                    s.advance(interval);
                }
            };
            stroke();
            s.use(command);
            QVERIFY(!s.canvas().isPressed() && !s.canvas().keyboardPen().isDown());
            QCOMPARE(said(s), QString("Given up."));
            QVERIFY(s.painting().strokes.empty());
            stroke(); // and goes on as ever
            QTest::keyClick(&s.canvas(), Qt::Key_Space);
            QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        }
    }

    /// What the pressure does is the brush's affair.
    void keysPressMoreAndLess()
    {
        BlackSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.canvas().setFocus();
        s.use(Command::PaintWithKeys);
        for (int i = 0; i < 7; ++i)
            QTest::keyClick(&s.canvas(), Qt::Key_Minus);
        QCOMPARE(s.canvas().keyboardPen().pressure(), 0.3);
        QCOMPARE(said(s), QString("Pressure 30 %"));
        QTest::keyClick(&s.canvas(), Qt::Key_Plus);
        QCOMPARE(s.canvas().keyboardPen().pressure(), 0.4);
        const double scale = s.canvas().view().scale;
        QCOMPARE(scale, s.canvas().view().scale); // they zoom without the pen
    }

    /// Two arrow keys that are held go aslant; the view follows.
    void thePenGoesAslantAndStaysInSight()
    {
        BlackSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.canvas().setFocus();
        s.use(Command::PaintWithKeys);
        const auto pixel = [&] { return s.canvas().view().toPixels(s.canvas().keyboardPen().point()); };
        const Point from = pixel();
        const double dpr = s.canvas().devicePixelRatioF();
        QTest::keyPress(&s.canvas(), Qt::Key_Right);
        QTest::keyPress(&s.canvas(), Qt::Key_Up);
        QVERIFY(length(pixel() - (from + Point{20 * dpr, -10 * dpr})) < 1e-6);
        QTest::keyRelease(&s.canvas(), Qt::Key_Right);
        QTest::keyRelease(&s.canvas(), Qt::Key_Up);
        for (int i = 0; i < 30; ++i)
            QTest::keyClick(&s.canvas(), Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(pixel().x >= 0 && pixel().x <= s.canvas().view().width);
    }

    /// Every tool takes it: this one moves a stroke that it drags.
    void thePenDragsWithOtherTools()
    {
        BlackSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.paintLine({400, 300}, {600, 300});
        s.dry();
        s.use(Command::Select);
        s.canvas().setFocus();
        QTest::mouseMove(&s.canvas(), s.at({500, 300}));
        s.use(Command::PaintWithKeys);
        QTest::keyClick(&s.canvas(), Qt::Key_Space);
        QTest::keyClick(&s.canvas(), Qt::Key_Down, Qt::ShiftModifier);
        QTest::keyClick(&s.canvas(), Qt::Key_Space);
        const double unit = s.canvas().devicePixelRatioF() / s.canvas().view().scale;
        const Stroke &stroke = *s.painting().strokes.front();
        QVERIFY(std::abs(stroke.cubicOf(stroke.segments.front()).at(0).y - (300 + 100 * unit)) < 3 * unit);
    }

    /// Tab says which stroke it has come to, an arrow key where it lies now.
    void selectingAndMovingIsSaid()
    {
        BlackSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.paintLine({100, 100}, {300, 100});
        s.paintLine({100, 200}, {300, 200});
        s.dry();
        s.use(Command::Select);
        s.canvas().setFocus();
        Heard heard(s);
        QTest::keyClick(&s.canvas(), Qt::Key_Tab);
        QVERIFY2(said(s).startsWith("stroke 1, even, black"), qPrintable(said(s)));
        QVERIFY(said(s).contains("1 of 2"));
        s.editor().laterChanges().flush();
        QVERIFY(heard.has(QAccessible::Focus, 1));
        QVERIFY(readingOf(s)->focusChild()->state().focused);
        QTest::keyClick(&s.canvas(), Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY2(said(s).startsWith("stroke 1") && said(s).contains("10, 0"), qPrintable(said(s)));
    }

    /// With the Brush nothing shows what is selected once one paints: the first Delete shows it, the second deletes.
    void whatIsNotSeenIsNotDeletedAtOnce()
    {
        BlackSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.paintLine({100, 100}, {300, 100});
        s.paintLine({100, 200}, {300, 200});
        s.editor().document().setSelection({{1}, {}});
        s.canvas().setFocus();
        QVERIFY(s.canvas().showsOutlines()); // it was selected a moment ago
        s.paintLine({100, 300}, {300, 300});
        QVERIFY(!s.canvas().showsOutlines());
        QCOMPARE(s.selection().strokes, std::set<StrokeId>{1});
        QTest::keyClick(&s.canvas(), Qt::Key_Delete);
        QCOMPARE(s.painting().strokes.size(), std::size_t(3));
        QVERIFY(s.canvas().showsOutlines());
        QCOMPARE(said(s), QString("1 stroke selected. Delete once more deletes."));
        QTest::keyClick(&s.canvas(), Qt::Key_Delete);
        QCOMPARE(s.painting().strokes.size(), std::size_t(2));
        QVERIFY(!s.painting().find(1));
        QTest::keyClick(&s.canvas(), Qt::Key_A, Qt::ControlModifier); // seen at once
        QTest::keyClick(&s.canvas(), Qt::Key_Delete);
        QVERIFY(s.painting().strokes.empty());
    }

    /// Whatever the pen pressed: a brush that paints one colour leaves a stroke of one.
    void aStrokeOfOneColourIsOne()
    {
        for (const Brush &brush : builtinBrushes()) {
            if (!QStringList{"round-wash", "pastel", "two-tone", "flat-marker"}.contains(brush.name))
                continue;
            Session s;
            s.editor().setBrush(brush);
            if (brush.name == "round-wash")
                s.editor().setColour({0.32f, 0.22f, 1, 0.95f}); // A saturated blue shows most of what it strays.
            Pen pen;
            pen.send(s.canvas(), QEvent::TabletPress, s.at({100, 100}), 0.2);
            for (int i = 1; i <= 30; ++i) {
                s.advance(interval);
                const Point at{100.0 + 10 * i, 100 + 40 * std::sin(i / 5.0)};
                pen.send(s.canvas(), QEvent::TabletMove, s.at(at), 0.2 + i / 50.0);
            }
            pen.send(s.canvas(), QEvent::TabletRelease, s.at({400, 100}), 0);
            s.use(Command::SelectAll);
            s.editor().laterChanges().flush();
            const ColourSummary &found = s.editor().colourTarget().selected();
            QVERIFY2(found.several == (brush.name == "two-tone"), qPrintable(brush.name));
        }
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestWorkingByKeys)
#include "test_working_by_keys.moc"

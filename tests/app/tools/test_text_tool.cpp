// The Text tool by real events: keys, mouse, input methods, its row.
#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_panel.h"
#include "app/session/settings/settings.h"
#include "app/tools/text/text_row.h"
#include "app/tools/text/text_tool.h"
#include "tests/app/selecting.h"
#include "undo/group_edits.h"
#include "undo/text_edits.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QInputMethodEvent>
#include <QPaintEvent>
#include <QScopeGuard>
#include <QScreen>
#include <QStyleHints>
#include <QTemporaryDir>
#include <QTest>

using namespace suffuse;

namespace {

/// A window with the Text tool in hand.
struct Typing : Selecting {
    explicit Typing(StrokeList strokes = {}) : Selecting(std::move(strokes))
    {
        use(Command::Text);
        canvas().setFocus();
        editor().setColour({0.25f, 0.5f, 0, 1});
    }
    TextTool &tool() { return *static_cast<TextTool *>(canvas().tool()); }
    void type(const QString &keys) { QTest::keyClicks(&canvas(), keys); }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&canvas(), key, modifiers); }
    QString names()
    {
        QString all;
        for (const StrokePtr &stroke : painting().strokes)
            all += stroke->name;
        return all;
    }
    QString string()
    {
        for (const Group &group : painting().groups)
            if (group.text)
                return group.text->string;
        return {};
    }
    GroupId group() { return painting().groups.empty() ? 0 : painting().groups.back().id; }
    StrokePtr letter(int index) { return painting().strokes[std::size_t(index)]; }
    Point inkOf(int index) { return curveBox(*letter(index)).centre(); }
    /// The middle of the caret before a character of the text in hand, or of the first one that there is.
    Point placeOf(qsizetype position)
    {
        const SharedText text = textOf(painting(), group());
        const CaretLine caret = TextLayout().lay(*text).caretAt(position);
        return text->place(0.5 * (caret[0] + caret[1]));
    }
    void write(const QString &keys, Point where = {200, 300})
    {
        click(where);
        type(keys);
        key(Qt::Key_Escape);
        editor().clock().setTime(painting().end()); // paint that is not there yet is not clicked
        // The next click is no second one of a double click.
        QTest::qWait(QApplication::doubleClickInterval() + 20);
    }
    void doubleClick(Point where)
    {
        click(where);
        const QPointF at = this->at(where);
        send(QEvent::MouseButtonDblClick, at, {});
        send(QEvent::MouseButtonRelease, at, {});
    }
    QWidget &row() { return *window.findChild<TextRow *>(); }
};

const Colour red{1, 0.2f, 0, 1};

/// What an input method hears when it asks.
QVariant asked(QWidget &widget, Qt::InputMethodQuery query)
{
    QInputMethodQueryEvent event(query);
    QCoreApplication::sendEvent(&widget, &event);
    return event.value(query);
}

int darkPixels(const QImage &image)
{
    int dark = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            dark += image.pixelColor(x, y).green() < 128;
    return dark;
}

void recolour(Typing &s, int letter)
{
    const StrokeId id = s.letter(letter)->id;
    s.editor().push(changeStrokes(s.editor().document(), {id},
                                  [](Stroke &stroke) {
                                      Fill fill = *stroke.fill;
                                      fill.colour = red;
                                      stroke.fill = fill;
                                  }),
                    "red");
}

} // namespace

class TestTextTool : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toUtf8());
        if (!LineShaper().hasFamily("DejaVu Sans"))
            QSKIP("DejaVu Sans is not installed");
    }
    void init()
    {
        settings::store().clear();
        settings::store().setValue("tools/text/family", "DejaVu Sans");
    }

    void typingIsOneStep()
    {
        Typing s;
        s.click({200, 300});
        QVERIFY(s.tool().takesText());
        s.type("Tab ov"); // keys of tools and held keys among them
        QCOMPARE(s.names(), QString("Tabov"));
        QVERIFY(qobject_cast<TextTool *>(s.canvas().tool()));
        QCOMPARE(s.steps(), 0);
        QVERIFY(s.editor().canUndo());
        s.key(Qt::Key_Return);
        s.type("x");
        QCOMPARE(s.string(), QString("Tab ov\nx"));
        s.key(Qt::Key_Escape);
        QCOMPARE(s.steps(), 1);
        QVERIFY(!s.tool().takesText());
        QCOMPARE(s.selected().size(), std::size_t(6));
        QCOMPARE(s.letter(0)->fill->colour, (Colour{0.25f, 0.5f, 0, 1}));
        s.use(Command::Undo);
        QVERIFY(s.painting().strokes.empty() && s.painting().groups.empty());
        s.use(Command::Redo);
        QCOMPARE(s.names(), QString("Tabovx"));
    }

    /// A key has the picture painted where it differs, and the caret; the screen shows what painting all would show.
    void keysPaintWhatDiffers()
    {
        const int flash = QGuiApplication::styleHints()->cursorFlashTime();
        QGuiApplication::styleHints()->setCursorFlashTime(0); // the caret stays as it is between two looks
        const auto restore = qScopeGuard([flash] { QGuiApplication::styleHints()->setCursorFlashTime(flash); });
        Typing s;
        s.click({200, 300});
        s.type("first line");
        s.key(Qt::Key_Return);
        s.type("second line");
        const auto settle = [&s] {
            s.advance(20'000'000); // paint comes with time
            QTRY_VERIFY_WITH_TIMEOUT(s.canvas().isUpToDate(), waitMs);
            QTest::qWait(50); // what lies over the picture is painted up to a frame later
        };
        const auto shown = [&s] {
            return s.window.screen()
                ->grabWindow(s.window.winId())
                .toImage()
                .copy(QRect(s.canvas().mapTo(&s.window, QPoint()), s.canvas().size()));
        };
        settle();
        QVERIFY(darkPixels(shown()) > 500);
        struct Watch : QObject {
            QRegion painted;
            bool eventFilter(QObject *, QEvent *event) override
            {
                if (event->type() == QEvent::Paint)
                    painted += static_cast<QPaintEvent *>(event)->region();
                return false;
            }
        } watch;
        for (QWidget *child : s.canvas().findChildren<QWidget *>())
            child->installEventFilter(&watch);
        s.canvas().installEventFilter(&watch);
        const auto check = [&](const char *what) {
            settle();
            const QImage before = shown();
            s.canvas().update();
            for (QWidget *child : s.canvas().findChildren<QWidget *>())
                child->update();
            QCoreApplication::processEvents();
            QVERIFY2(shown() == before, what);
        };
        check("before");
        watch.painted = {};
        s.type("x");
        settle();
        QVERIFY(!watch.painted.isEmpty());
        qint64 pixels = 0;
        for (const QRect &part : watch.painted)
            pixels += qint64(part.width()) * part.height();
        QVERIFY2(4 * pixels < qint64(s.canvas().width()) * s.canvas().height(), qPrintable(QString::number(pixels)));
        check("a letter");
        s.type("  ");
        check("spaces");
        s.key(Qt::Key_Home);
        s.type("y");
        check("at the start of a line");
        s.key(Qt::Key_Up);
        s.key(Qt::Key_Backspace);
        s.key(Qt::Key_Return);
        check("lines that move");
        s.key(Qt::Key_Left, Qt::ShiftModifier);
        check("a selected place");
        s.type("z");
        check("typed over");
        QVERIFY(s.tool().takeBack());
        check("taken back");
        s.key(Qt::Key_Escape);
        check("left");
        s.row().findChild<QCheckBox *>("vertical")->click(); // the frame around it is another one
        check("the row");
        s.use(Command::Undo);
        check("undone");
    }

    /// Panels follow when the letters are on the screen, and before anything is done that they have a part in.
    void panelsFollowLater()
    {
        Typing s;
        StrokesModel &model = *s.window.findChild<StrokesPanel *>()->model();
        const auto title = [&model] { return model.index(0, StrokesModel::NameColumn).data().toString(); };
        s.click({200, 300});
        s.type("abc");
        QTRY_VERIFY_WITH_TIMEOUT(title().contains("abc"), waitMs);
        s.type("d");
        QTRY_VERIFY_WITH_TIMEOUT(title().contains("abcd"), waitMs);
        s.type("e");
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({210, 300}));
        QVERIFY(title().contains("abcde"));
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({210, 300}));
        s.type("f");
        s.key(Qt::Key_Escape); // types nothing
        QTRY_VERIFY_WITH_TIMEOUT(title().size() > 4 && s.string().contains('f') && title().contains('f'), waitMs);
    }

    void keysTypeOnlyThen()
    {
        Typing s;
        s.write("ab");
        s.key(Qt::Key_B); // the Brush now
        QVERIFY(!qobject_cast<TextTool *>(s.canvas().tool()));
        QCOMPARE(s.names(), QString("ab"));
    }

    void aClickElsewhereIsDone()
    {
        Typing s;
        s.click({200, 300});
        s.type("ab");
        s.click({700, 600});
        QVERIFY(!s.tool().takesText());
        QCOMPARE(s.steps(), 1);
    }

    void anotherToolIsDone()
    {
        Typing s;
        s.click({200, 300});
        s.type("ab");
        s.use(Command::Brush);
        QCOMPARE(s.steps(), 1);
        QCOMPARE(s.names(), QString("ab"));
        QCOMPARE(s.selected().size(), std::size_t(2));
    }

    void nothingTypedIsNothing()
    {
        Typing s;
        s.click({200, 300});
        s.key(Qt::Key_Escape);
        s.click({300, 300});
        s.type("  ");
        s.key(Qt::Key_Escape);
        s.click({300, 400});
        s.type("a");
        s.key(Qt::Key_Backspace);
        s.key(Qt::Key_Escape);
        QCOMPARE(s.steps(), 0);
        QVERIFY(s.painting().strokes.empty() && s.painting().groups.empty());
    }

    void emptiedTextsGo()
    {
        Typing s;
        s.write("ab");
        s.click(s.placeOf(1));
        s.key(Qt::Key_A, Qt::ControlModifier);
        s.key(Qt::Key_Delete);
        s.key(Qt::Key_Escape);
        QVERIFY(s.painting().strokes.empty() && s.painting().groups.empty());
        s.use(Command::Undo);
        QCOMPARE(s.names(), QString("ab"));
    }

    /// It is the same text while the caret stands in it, with its own values in its own place.
    void emptiedTextsComeBack()
    {
        Typing s;
        s.write("ab");
        recolour(s, 0);
        recolour(s, 1);
        const GroupId group = s.group();
        const StrokeId above = s.editor().document().takeStrokeId();
        s.editor().push(addStrokes(s.editor().document(), {line(above, {200, 450}, {600, 450})}, false), "line");
        s.editor().clock().setTime(s.painting().end());
        const int steps = s.editor().undoStack().index();
        s.click(s.placeOf(2));
        QVERIFY(s.tool().entry().isOpen());
        s.key(Qt::Key_Backspace);
        s.key(Qt::Key_Backspace);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        s.type("xy");
        QCOMPARE(s.names(), QString("xy"));
        QCOMPARE(s.painting().strokes.back()->id, above);
        QCOMPARE(s.group(), group);
        for (const int k : {0, 1})
            QCOMPARE(s.letter(k)->fill->colour, red);
        // All at once, saved while nothing is there, and taken back.
        s.key(Qt::Key_A, Qt::ControlModifier);
        s.key(Qt::Key_Delete);
        s.tool().settle();
        s.type(" z");
        QCOMPARE(s.names(), QString("z"));
        QCOMPARE(s.painting().strokes.back()->id, above);
        QCOMPARE(s.letter(0)->fill->colour, red);
        s.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        s.key(Qt::Key_Escape);
        QCOMPARE(s.editor().undoStack().index(), steps + 1);
        // Once it is left, another text begins with the brush's values.
        s.write("n");
        QCOMPARE(s.painting().strokes.front()->id, above);
        QVERIFY(s.letter(1)->fill->colour != red);
    }

    void undoInTheMiddle()
    {
        Typing s;
        s.write("old");
        s.click({200, 500});
        s.type("one two");
        s.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(s.names(), QString("oldone"));
        s.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(s.names(), QString("oldonetwo"));
        s.use(Command::Undo); // the menu does the same
        s.use(Command::Undo);
        QCOMPARE(s.names(), QString("old"));
        QVERIFY(s.tool().takesText());
        QCOMPARE(s.steps(), 1);
        s.type("x");
        QCOMPARE(s.names(), QString("oldx"));
        s.key(Qt::Key_Z, Qt::ControlModifier);
        s.key(Qt::Key_Z, Qt::ControlModifier); // nothing is typed: the step before
        QCOMPARE(s.names(), QString());
        s.key(Qt::Key_Escape);
        QCOMPARE(s.editor().undoStack().index(), 0);
    }

    /// What comes back has its colours, its times and its numbers: it is what it was.
    void takenBackAreTheSameLetters()
    {
        Typing s;
        s.write("abc");
        recolour(s, 1);
        const Painting before = s.painting();
        s.editor().clock().setTime(before.end() + 5'000'000);
        s.click(s.placeOf(1));
        s.key(Qt::Key_A, Qt::ControlModifier);
        s.type("x");
        const Painting typed = s.painting();
        s.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(s.painting(), before);
        s.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(s.painting(), typed);
        s.key(Qt::Key_Z, Qt::ControlModifier);
        s.key(Qt::Key_Home);
        s.key(Qt::Key_Right);
        s.key(Qt::Key_Delete);
        QCOMPARE(s.names(), QString("ac"));
        s.key(Qt::Key_Z, Qt::ControlModifier);
        s.key(Qt::Key_Escape);
        QCOMPARE(s.painting(), before);
    }

    /// An older step that is undone takes nothing typed out of what can be redone.
    void redoneAfterAnOlderStep()
    {
        Typing s;
        s.write("ab");
        recolour(s, 1);
        const Painting before = s.painting();
        s.click(s.placeOf(2));
        s.key(Qt::Key_End);
        s.type("c");
        s.type(" d");
        const Painting typed = s.painting();
        for (int i = 0; i < 3; ++i) // two words, and the colour
            s.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!(s.letter(1)->fill->colour == red));
        QCOMPARE(s.names(), QString("ab"));
        while (s.editor().canRedo())
            s.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(s.painting(), typed);
        s.use(Command::Undo);
        QCOMPARE(s.painting(), before);
    }

    void theCaretStandsWhereTheRedoneEnds()
    {
        Typing s;
        s.write("ab");
        recolour(s, 1);
        s.click(s.placeOf(2));
        s.key(Qt::Key_End);
        s.type("cd");
        s.key(Qt::Key_Z, Qt::ControlModifier);
        s.key(Qt::Key_Z, Qt::ControlModifier); // the colour
        while (s.editor().canRedo())
            s.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(s.string(), QString("abcd"));
        s.type("e");
        QCOMPARE(s.string(), QString("abcde"));
    }

    void redoneAfterItWasLeft()
    {
        Typing s;
        s.click({200, 300});
        s.type("one two");
        const Painting typed = s.painting();
        s.key(Qt::Key_Z, Qt::ControlModifier);
        const Painting one = s.painting();
        s.key(Qt::Key_Escape);
        QCOMPARE(s.painting(), one);
        QVERIFY(s.editor().canRedo());
        s.editor().redo();
        QCOMPARE(s.painting(), typed);
    }

    /// What somebody else changes while a text is in hand is not taken back together with what is typed.
    void takenBackAfterSomethingElse()
    {
        Typing s;
        s.write("ab");
        s.click(s.placeOf(2));
        s.key(Qt::Key_End);
        s.type("c");
        recolour(s, 0);
        s.type("d");
        s.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(s.names(), QString("abc"));
        QCOMPARE(s.letter(0)->fill->colour, red);
    }

    void savedInTheMiddle()
    {
        Typing s;
        s.click({200, 300});
        s.type("ab");
        s.canvas().settleTool();
        QCOMPARE(s.steps(), 1);
        QVERIFY(!s.tool().isBusy());
        QCOMPARE(s.names(), QString("ab"));
        s.type("c"); // it is typed on
        QCOMPARE(s.names(), QString("abc"));
        s.key(Qt::Key_Escape);
        QCOMPARE(s.steps(), 2);
        s.use(Command::Undo);
        QCOMPARE(s.names(), QString("ab"));
    }

    void somethingElseInTheMiddle()
    {
        Typing s;
        s.click({200, 300});
        s.type("abc");
        recolour(s, 1); // as a dock would
        QCOMPARE(s.steps(), 2);
        QVERIFY(s.tool().takesText());
        s.type("d");
        QCOMPARE(s.names(), QString("abcd"));
        QCOMPARE(s.letter(1)->fill->colour, red);
        s.key(Qt::Key_Escape);
        QCOMPARE(s.steps(), 3);
        for (int i = 0; i < 3; ++i)
            s.use(Command::Undo);
        QVERIFY(s.painting().strokes.empty());
    }

    void aTextThatIsUndoneIsLeft()
    {
        Typing s;
        s.write("ab");
        s.click(s.placeOf(1));
        QVERIFY(s.tool().takesText());
        s.editor().undo();
        QVERIFY(!s.tool().takesText());
        s.type("c");
        QVERIFY(s.painting().strokes.empty());
    }

    void typedInAgain()
    {
        Typing s;
        s.write("Hello");
        recolour(s, 1);
        const StrokePtr first = s.letter(0);
        s.click(s.placeOf(2));
        QCOMPARE(s.tool().entry().caret(), qsizetype(2));
        s.type("XY");
        s.key(Qt::Key_Escape);
        QCOMPARE(s.string(), QString("HeXYllo"));
        QCOMPARE(s.names(), QString("HeXYllo"));
        QCOMPARE(s.letter(0), first);
        QCOMPARE(s.letter(1)->fill->colour, red);
        QCOMPARE(s.letter(2)->fill->colour, red); // as the letter before it
        QVERIFY(!(s.letter(4)->fill->colour == red));
        QCOMPARE(s.painting().groups.size(), std::size_t(1));
    }

    void typedOverLettersKeepTheirLook()
    {
        Typing s;
        s.write("abc");
        recolour(s, 1);
        s.click(s.placeOf(2));
        s.key(Qt::Key_Left, Qt::ShiftModifier);
        s.type("xy");
        QCOMPARE(s.names(), QString("axyc"));
        QCOMPARE(s.letter(1)->fill->colour, red);
        QCOMPARE(s.letter(2)->fill->colour, red);
        QVERIFY(!(s.letter(3)->fill->colour == red));
    }

    void theBrushColoursWhatIsTyped()
    {
        Typing s;
        s.write("ab");
        s.click(s.placeOf(2));
        s.editor().setColour(red);
        s.type("c");
        QCOMPARE(s.letter(2)->fill->colour, red);
        s.key(Qt::Key_Home);
        s.type("d");
        QVERIFY(!(s.letter(0)->fill->colour == red));
    }

    void caretsAndSelections()
    {
        Typing s;
        s.write("one two");
        s.click(s.placeOf(0));
        s.key(Qt::Key_End);
        QCOMPARE(s.tool().entry().caret(), qsizetype(7));
        s.key(Qt::Key_Left);
        s.key(Qt::Key_Left, Qt::ShiftModifier);
        QCOMPARE(s.tool().entry().selectedString(), QString("w"));
        QCOMPARE(s.selected(), (std::set<StrokeId>{s.letter(4)->id})); // what docks change now
        s.key(Qt::Key_Delete);
        QCOMPARE(s.string(), QString("one to"));
        s.key(Qt::Key_Left, Qt::ControlModifier);
        QCOMPARE(s.tool().entry().caret(), qsizetype(4));
        s.key(Qt::Key_Home, Qt::ShiftModifier);
        QCOMPARE(s.tool().entry().selectedString(), QString("one "));
        s.key(Qt::Key_X, Qt::ControlModifier);
        QCOMPARE(s.string(), QString("to"));
        QCOMPARE(QApplication::clipboard()->text(), QString("one "));
        s.key(Qt::Key_End);
        s.key(Qt::Key_V, Qt::ControlModifier);
        s.key(Qt::Key_Backspace);
        QCOMPARE(s.string(), QString("toone"));
        s.key(Qt::Key_A, Qt::ControlModifier);
        s.key(Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text(), QString("toone"));
        QCOMPARE(s.selected().size(), std::size_t(5));
        s.type("z");
        QCOMPARE(s.string(), QString("z"));
    }

    /// The menu means what the keys mean.
    void commandsOfTheEditMenu()
    {
        Typing s;
        s.click({200, 300});
        s.type("one two");
        s.key(Qt::Key_Left, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(s.tool().entry().selectedString(), QString("two"));
        s.use(Command::Copy);
        QCOMPARE(QApplication::clipboard()->text(), QString("two"));
        s.use(Command::Cut);
        QCOMPARE(s.string(), QString("one "));
        s.use(Command::Paste);
        s.use(Command::Paste);
        QCOMPARE(s.string(), QString("one twotwo"));
        s.use(Command::SelectAll);
        QCOMPARE(s.tool().entry().selectedString(), QString("one twotwo"));
        s.use(Command::Delete);
        QCOMPARE(s.string(), QString());
        s.use(Command::Undo);
        QCOMPARE(s.string(), QString("one twotwo"));
        s.key(Qt::Key_Escape);
        QCOMPARE(s.editor().undoStack().index(), 1);
        QVERIFY(s.editor().canRedo());
    }

    void linesUpAndDown()
    {
        Typing s;
        s.write("abcdef");
        s.click(s.placeOf(3));
        s.key(Qt::Key_End);
        s.key(Qt::Key_Return);
        s.type("ab");
        s.key(Qt::Key_Return);
        s.type("abcdef");
        s.key(Qt::Key_Left);
        s.key(Qt::Key_Up);
        QCOMPARE(s.tool().entry().caret(), qsizetype(9)); // the end of a shorter line
        s.key(Qt::Key_Up);
        QCOMPARE(s.tool().entry().caret(), qsizetype(5)); // the column is kept
        s.key(Qt::Key_Down, Qt::ShiftModifier);
        QCOMPARE(s.tool().entry().selectedString(), QString("f\nab"));
    }

    void theMouseSelects()
    {
        Typing s;
        s.write("one two three");
        s.click(s.placeOf(0));
        const Point from = s.placeOf(4), to = s.placeOf(7);
        s.drag({from, to});
        QCOMPARE(s.tool().entry().selectedString(), QString("two"));
        QTest::qWait(QApplication::doubleClickInterval() + 20);
        s.doubleClick(s.inkOf(8));
        QCOMPARE(s.tool().entry().selectedString(), QString("three"));
        QTest::qWait(QApplication::doubleClickInterval() + 20);
        s.click(s.placeOf(1));
        s.click(s.placeOf(3), Qt::ShiftModifier);
        QCOMPARE(s.tool().entry().selectedString(), QString("ne"));
    }

    void aDoubleClickWithSelect()
    {
        Typing s;
        s.write("lift");
        s.use(Command::Select);
        s.doubleClick(s.inkOf(0));
        QVERIFY(qobject_cast<TextTool *>(s.canvas().tool()));
        QVERIFY(s.tool().takesText());
        s.type("-");
        QVERIFY(s.string().contains('-'));
        QVERIFY(s.window.action(Command::Text).isChecked());
    }

    /// Nobody hits letters of a few pixels: a line of them is clicked as a whole.
    void smallTextsAreClickedByTheirLines()
    {
        Typing s;
        s.write("i   i");
        const std::set<StrokeId> letters = strokesWithin(s.painting(), s.group());
        const SharedText text = textOf(s.painting(), s.group());
        const Point between = 0.5 * (s.placeOf(1) + s.placeOf(4)); // the spaces have no paint
        s.use(Command::Select);
        s.select({});
        const auto showEmAs = [&](double pixels) { // logical ones
            s.canvas().zoomBy(pixels * s.canvas().devicePixelRatioF() / (text->size * s.canvas().view().scale));
        };
        const auto clickBetween = [&] {
            s.select({});
            s.click(between);
            QTest::qWait(QApplication::doubleClickInterval() + 20); // no double click
        };
        showEmAs(20);
        clickBetween();
        QCOMPARE(s.selected(), letters);
        // Paint below it does not count, paint above it does.
        for (const bool above : {false, true}) {
            const StrokeId id = s.editor().document().takeStrokeId();
            const StrokePtr bar = line(id, between - Point{30, 0}, between + Point{30, 0});
            s.editor().push(addStrokes(s.editor().document(), {bar}, false), "bar");
            s.editor().clock().setTime(s.painting().end());
            if (!above) {
                s.select({id});
                s.use(Command::Bottom);
            }
            clickBetween();
            QCOMPARE(s.selected(), above ? std::set<StrokeId>{id} : letters);
            s.editor().undo();
            if (!above)
                s.editor().undo();
        }
        // Beside the line, and where the letters are large, it is paint alone that counts.
        s.select({});
        s.click(between - Point{0, 2 * text->size});
        QVERIFY(s.selected().empty());
        showEmAs(60);
        clickBetween();
        QVERIFY(s.selected().empty());
    }

    void theViewFollowsTheCaret()
    {
        Typing s;
        s.click({200, 300});
        const View before = s.canvas().view();
        const auto isSeen = [&s] {
            return s.canvas().rect().contains(asked(s.canvas(), Qt::ImCursorRectangle).toRectF().toAlignedRect());
        };
        s.type("inside");
        QCOMPARE(s.canvas().view(), before);
        s.type(QString(50, QLatin1Char('m')));
        QVERIFY(isSeen() && s.canvas().view().centre.x > before.centre.x);
        QVERIFY(near(s.canvas().view().scale, before.scale));
        s.key(Qt::Key_Home);
        QVERIFY(isSeen());
        for (int i = 0; i < 20; ++i)
            s.key(Qt::Key_Return);
        QVERIFY(isSeen() && s.canvas().view().centre.y > before.centre.y);
        s.key(Qt::Key_Home, Qt::ControlModifier);
        QVERIFY(isSeen());
        // Whoever scrolls away stays there until the caret moves.
        s.canvas().panBy({0, 5000});
        const View away = s.canvas().view();
        s.editor().setColour(red);
        QCOMPARE(s.canvas().view(), away);
        s.key(Qt::Key_Right);
        QVERIFY(isSeen());
    }

    void inputMethods()
    {
        Typing s;
        QVERIFY(!s.canvas().testAttribute(Qt::WA_InputMethodEnabled));
        s.click({200, 300});
        QVERIFY(s.canvas().testAttribute(Qt::WA_InputMethodEnabled));
        QVERIFY(asked(s.canvas(), Qt::ImEnabled).toBool());
        s.type("a");
        QInputMethodEvent composing("shui", {{QInputMethodEvent::Cursor, 2, 1}});
        QCoreApplication::sendEvent(&s.canvas(), &composing);
        QCOMPARE(s.names(), QString("ashui")); // it shows
        QCOMPARE(s.tool().entry().caret(), qsizetype(3));
        const QRectF rectangle = asked(s.canvas(), Qt::ImCursorRectangle).toRectF();
        QVERIFY(rectangle.height() > 10 && QRectF(s.canvas().rect()).contains(rectangle.center()));
        QInputMethodEvent decided(QString(), {});
        decided.setCommitString("水");
        QCoreApplication::sendEvent(&s.canvas(), &decided);
        QCOMPARE(s.string(), QString("a水"));
        QCOMPARE(asked(s.canvas(), Qt::ImSurroundingText).toString(), QString("a水"));
        QInputMethodEvent more("mo", {});
        QCoreApplication::sendEvent(&s.canvas(), &more);
        s.key(Qt::Key_Escape); // what is not decided is left out
        QCOMPARE(s.string(), QString("a水"));
        QCOMPARE(s.steps(), 1);
        QVERIFY(!s.canvas().testAttribute(Qt::WA_InputMethodEnabled));
    }

    void theRowChangesTheTextInHand()
    {
        Typing s;
        s.click({200, 300});
        s.type("ab");
        const double width = curveBox(*s.letter(0)).width();
        auto *weights = s.row().findChild<QComboBox *>("weight");
        weights->setCurrentIndex(5);
        emit weights->activated(5);
        QVERIFY(curveBox(*s.letter(0)).width() > width);
        QCOMPARE(textOf(s.painting(), s.group())->weight, 700.0f);
        s.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(textOf(s.painting(), s.group())->weight, 400.0f);
        s.key(Qt::Key_Escape);
        QCOMPARE(s.editor().undoStack().index(), 1);
    }

    void theRowChangesTheSelectedText()
    {
        Typing s;
        s.write("ab");
        QCOMPARE(s.steps(), 1);
        recolour(s, 0);
        s.select(strokesWithin(s.painting(), s.group()));
        s.row().findChild<QCheckBox *>("vertical")->click();
        QCOMPARE(s.steps(), 3);
        QVERIFY(textOf(s.painting(), s.group())->vertical);
        QVERIFY(s.inkOf(1).y > s.inkOf(0).y + 20);
        QCOMPARE(s.letter(0)->fill->colour, red);
        s.use(Command::Undo);
        QVERIFY(!textOf(s.painting(), s.group())->vertical);
        // The next text is vertical, too.
        s.select({});
        s.write("c", {600, 300});
        QVERIFY(s.painting().groups.back().text->vertical);
    }

    void onASelectedStroke()
    {
        Typing s({line(1, {100, 500}, {500, 500})});
        s.select({1});
        s.editor().laterChanges().flush(); // as any click does
        s.row().findChild<QAbstractButton *>("bend")->click();
        QVERIFY(s.tool().takesText());
        s.type("ab");
        QCOMPARE(s.letter(0)->name, QString());
        QVERIFY(std::abs(curveBox(*s.letter(1)).bottom - 500) < 2);
        QVERIFY(s.inkOf(1).x > 100 && s.inkOf(1).x < 140);
        QVERIFY(!textOf(s.painting(), s.group())->curve.empty());
        s.row().findChild<QAbstractButton *>("straighten")->click();
        QVERIFY(textOf(s.painting(), s.group())->curve.empty());
        QVERIFY(std::abs(curveBox(*s.letter(1)).bottom - 500) < 2);
        s.key(Qt::Key_Escape);
        QCOMPARE(s.steps(), 1);
    }

    void whatIsMovedIsTypedInThere()
    {
        Typing s;
        s.write("lbc");
        s.use(Command::Select);
        s.select(strokesWithin(s.painting(), s.group()));
        s.drag({s.inkOf(0), s.inkOf(0) + Point{100, 150}});
        s.use(Command::FlipAcross);
        const Point first = s.inkOf(0), last = s.inkOf(2);
        QVERIFY(last.x < first.x);
        s.use(Command::Text);
        s.click(s.placeOf(3));
        QCOMPARE(s.tool().entry().caret(), qsizetype(3));
        s.type("d");
        QVERIFY(s.inkOf(3).x < last.x); // mirrored as they are
        QCOMPARE(s.inkOf(0), first);
        s.key(Qt::Key_Escape);
    }

    void byTheKeyboardAlone()
    {
        Typing s;
        s.key(Qt::Key_Return);
        QVERIFY(s.tool().takesText());
        s.type("mid");
        s.key(Qt::Key_Escape);
        QCOMPARE(s.names(), QString("mid"));
        s.key(Qt::Key_Return); // into the selected one
        s.type("d");
        s.key(Qt::Key_Escape);
        QCOMPARE(s.string(), QString("midd"));
        QCOMPARE(s.painting().groups.size(), std::size_t(1));
    }

    void aFontThatIsNotThere()
    {
        Typing s;
        s.write("abc");
        auto painting = std::make_shared<Painting>(s.painting());
        Text text = *painting->groups[0].text;
        text.family = "No Such Family At All";
        painting->groups[0].text = text;
        s.editor().document().reset(painting);
        s.click(s.placeOf(3));
        const StrokePtr first = s.letter(0);
        s.type("d");
        QCOMPARE(s.string(), QString("abc")); // the first key says so
        QVERIFY(s.tool().hint().contains("No Such Family"));
        s.type("d");
        QCOMPARE(s.string(), QString("abcd"));
        QCOMPARE(s.letter(0), first);
        s.key(Qt::Key_Escape);
    }

    /// Not even by typing in the rest of its text.
    void aLockedLetterStays()
    {
        Typing s;
        s.write("abc");
        const StrokeId b = s.letter(1)->id;
        s.editor().push(setLocked(s.editor().document(), {b}, true), "lock");
        const Painting before = s.painting();
        s.click(s.inkOf(0));
        QVERIFY(!s.tool().takesText());
        QVERIFY(s.tool().hint().contains("locked"));
        s.type("x");
        QCOMPARE(s.painting(), before);
        s.editor().document().setSelection({{s.letter(0)->id, s.letter(2)->id}, {}});
        s.row().findChild<QCheckBox *>("vertical")->click();
        QCOMPARE(s.painting(), before);
        QVERIFY(s.tool().hint().contains("locked"));
        s.editor().push(setLocked(s.editor().document(), {b}, false), "unlock");
        s.click(s.inkOf(0));
        QVERIFY(s.tool().takesText());
        s.editor().push(setLocked(s.editor().document(), {b}, true), "lock");
        QVERIFY(!s.tool().takesText()); // by a dock, while it is in hand
    }

    void lockedTextsAreLeftAlone()
    {
        Typing s;
        s.write("abc");
        s.use(Command::LockStrokes);
        s.click(s.placeOf(1));
        QCOMPARE(s.tool().entry().text().string, QString());
        s.key(Qt::Key_Escape);
        QCOMPARE(s.string(), QString("abc"));
    }

    void textToStrokes()
    {
        Typing s;
        s.write("abc");
        QVERIFY(s.window.action(Command::TextToStrokes).isEnabled());
        s.use(Command::TextToStrokes);
        QVERIFY(!s.painting().groups[0].text);
        QVERIFY(!s.window.action(Command::TextToStrokes).isEnabled());
        s.use(Command::Undo);
        QVERIFY(s.painting().groups[0].text);
    }

    /// Where letters stand wide apart a click between them means the text, and begins no other one there.
    void aClickBetweenLettersThatStandWideApart()
    {
        Typing s;
        s.write("ab");
        const Text text = *textOf(s.painting(), s.group());
        Text wide = text;
        wide.letterSpacing = 1;
        const LaidText before = TextLayout().lay(text), after = TextLayout().lay(wide);
        s.editor().push(setText(s.editor().document(), s.group(), wide, &before, after, {}), "wide");
        const std::array<Point, 4> b = after.clusters[1].corners();
        const double left = std::min({b[0].x, b[1].x, b[2].x, b[3].x}), middle = 0.5 * (b[0].y + b[2].y);
        s.click(wide.place(Point{left - 0.5 * double(wide.size), middle}));
        s.type("x");
        QCOMPARE(s.painting().groups.size(), std::size_t(1));
        QCOMPARE(s.string(), QString("axb"));
    }

    /// The gap behind a letter belongs to it, as the half of it does that is nearer to the gap.
    void aClickOnTheHalfOfALetterThatStandsApart_data()
    {
        QTest::addColumn<double>("share"); // of the letter's own width, from its left
        QTest::addColumn<QString>("string");
        QTest::newRow("left half") << 0.3 << "xab";
        QTest::newRow("right half") << 0.7 << "axb";
        QTest::newRow("right of it") << 1.2 << "axb";
        QTest::newRow("left of the next one") << 2.4 << "axb";
    }
    void aClickOnTheHalfOfALetterThatStandsApart()
    {
        QFETCH(double, share);
        QFETCH(QString, string);
        Typing s;
        s.write("ab");
        const Text text = *textOf(s.painting(), s.group());
        Text wide = text;
        wide.letterSpacing = 1.2f;
        const LaidText before = TextLayout().lay(text), after = TextLayout().lay(wide);
        s.editor().push(setText(s.editor().document(), s.group(), wide, &before, after, {}), "wide");
        s.click(s.placeOf(2));
        QVERIFY(s.tool().takesText());
        QTest::qWait(QApplication::doubleClickInterval() + 20);
        const std::array<Point, 4> a = after.clusters[0].corners();
        s.click(wide.place(a[0] + share * (a[1] - a[0]) + 0.5 * (a[3] - a[0])));
        s.type("x");
        QCOMPARE(s.string(), string);
    }

    /// Also where the painting ended later before something was undone or taken away.
    void lettersAreBornWhenTheyAreTyped_data()
    {
        QTest::addColumn<QString>("before");
        QTest::newRow("after an undo") << "undo";
        QTest::newRow("in a text that was emptied") << "delete";
        QTest::newRow("over a text") << "over";
        QTest::newRow("after a step of typing was taken back") << "back";
    }
    void lettersAreBornWhenTheyAreTyped()
    {
        QFETCH(QString, before);
        Typing s;
        Brush slow = s.editor().brush();
        slow.maxAge = 30;
        s.editor().setBrush(slow);
        if (before == "undo") {
            s.use(Command::Brush);
            s.paintLine({200, 100}, {400, 100});
            s.advance(60'000'000);
            s.editor().clock().setManual(false);
            s.use(Command::Undo);
            s.use(Command::Text);
            s.click({200, 300});
        } else {
            s.click({200, 300});
            s.type("ab");
            s.advance(60'000'000);
            s.editor().clock().setManual(false);
            if (before == "back")
                s.key(Qt::Key_Z, Qt::ControlModifier);
            else
                s.key(Qt::Key_A, Qt::ControlModifier);
            if (before == "delete")
                s.key(Qt::Key_Delete);
        }
        QElapsedTimer typing;
        typing.start();
        for (const QString letter : {"r", "s", "t", "u", "v"}) {
            s.type(letter);
            QTest::qWait(30);
        }
        QCOMPARE(s.names(), QString("rstuv"));
        for (int k = 1; k < 5; ++k)
            QVERIFY(s.letter(k)->born() > s.letter(k - 1)->born());
        QVERIFY(s.letter(4)->born() - s.letter(0)->born() <= typing.nsecsElapsed() / 1000);
    }

    void takenBackLettersAreDry()
    {
        Typing s;
        s.click({200, 300});
        for (const QString letter : {"a", "b", "c"}) {
            s.type(letter);
            s.advance(100'000);
        }
        PaintingClock &clock = s.editor().clock();
        clock.setTime(s.painting().end());
        clock.setManual(false);
        QTRY_VERIFY(!clock.isRunning());
        s.key(Qt::Key_Backspace);
        s.key(Qt::Key_End); // another step
        s.key(Qt::Key_Backspace);
        QCOMPARE(s.names(), QString("a"));
        s.key(Qt::Key_Z, Qt::ControlModifier);
        s.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(s.names(), QString("abc"));
        QVERIFY(!clock.isRunning());
        QCOMPARE(clock.time(), s.painting().end());
    }

    void copiedAndPasted()
    {
        Typing s;
        s.write("abc");
        s.use(Command::Copy);
        s.use(Command::PasteInPlace);
        QCOMPARE(s.painting().groups.size(), std::size_t(2));
        QVERIFY(s.painting().groups[0].text == s.painting().groups[1].text);
        // Some of its letters are no text, and one of them is no group.
        s.select({s.letter(0)->id, s.letter(1)->id});
        s.use(Command::Copy);
        s.use(Command::PasteInPlace);
        QCOMPARE(s.painting().groups.size(), std::size_t(3));
        QVERIFY(!s.painting().groups.back().text);
        s.select({s.letter(0)->id});
        s.use(Command::Copy);
        s.use(Command::PasteInPlace);
        QCOMPARE(s.painting().groups.size(), std::size_t(3));
        QCOMPARE(s.painting().strokes.back()->group, GroupId(0));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestTextTool)
#include "test_text_tool.moc"

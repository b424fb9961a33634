// What is typed as steps: taken back and redone, saved in the middle, typed anew; when its letters are born.
#include "tests/app/typed_text.h"

#include <QTemporaryDir>

using namespace suffuse;

class TestTextSteps : public QObject {
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

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestTextSteps)
#include "test_text_steps.moc"

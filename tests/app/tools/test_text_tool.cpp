// The Text tool by real events: keys, mouse, input methods, its row.
#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_panel.h"
#include "tests/app/typed_text.h"

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

    void copiedAndPasted()
    {
        Typing s;
        s.write("abc");
        s.use(Command::Copy);
        s.use(Command::PasteInPlace);
        QCOMPARE(s.painting().groups.size(), std::size_t(2));
        QVERIFY(s.painting().groups[0].text == s.painting().groups[1].text);
        // Some of its letters are no text, and no group.
        s.select({s.letter(0)->id, s.letter(1)->id});
        s.use(Command::Copy);
        s.use(Command::PasteInPlace);
        QCOMPARE(s.painting().groups.size(), std::size_t(2));
        QCOMPARE(s.painting().strokes.back()->group, GroupId(0));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestTextTool)
#include "test_text_tool.moc"

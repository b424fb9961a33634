// Where the pointer means a text, a letter of it, or the place between two.
#include "tests/app/typed_text.h"
#include "undo/layers/group_edits.h"

#include <QCheckBox>
#include <QTemporaryDir>

using namespace suffuse;

class TestTextClicks : public QObject {
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

    void aClickElsewhereIsDone()
    {
        Typing s;
        s.click({200, 300});
        s.type("ab");
        s.click({700, 600});
        QVERIFY(!s.tool().takesText());
        QCOMPARE(s.steps(), 1);
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
        QCOMPARE(textOf(s.painting(), s.group())->follows, StrokeId(1));
        s.row().findChild<QAbstractButton *>("straighten")->click();
        QVERIFY(textOf(s.painting(), s.group())->curve.empty());
        QCOMPARE(textOf(s.painting(), s.group())->follows, StrokeId(0));
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

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestTextClicks)
#include "test_text_clicks.moc"

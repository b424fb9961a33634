// A stroke under the hand, and a text along it: the letters follow while it is dragged.
#include "model/shaping/baseline_curve.h"
#include "tests/app/nodes.h"
#include "undo/lettering/text_layout.h"
#include "undo/text_edits.h"

#include <QTemporaryDir>

using namespace suffuse;

namespace {

/// A wave with a text along it, the Segments tool in hand.
struct Following : NodeSession {
    GroupId text = 0;
    int stepsBefore = 0;
    Painting before;
    QImage pictureBefore;

    /// `from`, `to`: the part of the wave's length along which the text stands.
    explicit Following(double from = 0, double to = 1)
    {
        Text set;
        set.string = QStringLiteral("along it");
        set.family = QStringLiteral("DejaVu Sans");
        set.size = 50;
        const BaselineCurve curve(baselineOf(stroke()));
        set.curve =
            from > 0 || to < 1 ? curve.between(from * curve.length(), to * curve.length()) : baselineOf(stroke());
        set.follows = id;
        text = editor().document().takeGroupId();
        Brush brush = builtinBrushes().front();
        brush.colour = {0.1f, 0.8f, 0.2f, 1};
        const TextChange change{{}, letterWith(brush, set.size, 0), true};
        editor().push(setText(editor().document(), text, set, nullptr, TextLayout().lay(set), change), "text");
        editor().document().setSelection({{id}, {}});
        pictureBefore = pictureNow();
        before = painting();
        stepsBefore = steps();
    }
    Text set() { return *textOf(painting(), text); }
    /// How far the letters are from where the text is set along the stroke as it is now, at most.
    double stray()
    {
        const Text as = set();
        const LaidText laid = TextLayout().lay(as);
        const std::vector<StrokeId> ids = lettersOf(painting(), text, laid);
        double most = 0;
        std::size_t k = 0;
        for (const LaidCluster &cluster : laid.clusters)
            if (cluster.hasInk()) {
                const Stroke &letter = stroke(ids.at(k++));
                const Point begin = (as.place * cluster.place)(cluster.outline->front().front().p[0]);
                most = std::max(most, length(letter.cubicOf(letter.segments.front()).p[0] - begin));
            }
        return k > 0 ? most : HUGE_VAL;
    }
    /// Whether all letters stand where they did.
    bool lettersAreAsBefore()
    {
        return std::ranges::all_of(before.strokes, [this](const StrokePtr &stroke) {
            return stroke->group != text || *painting().find(stroke->id) == *stroke;
        });
    }
    void press(Point where) { QTest::mousePress(&canvas(), Qt::LeftButton, {}, at(where)); }
    void release(Point where) { QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, at(where)); }
    /// One undo gives back all that there was, one redo what there is.
    void checkOneStep()
    {
        QCOMPARE(steps(), stepsBefore + 1);
        const Painting after = painting();
        use(Command::Undo);
        QVERIFY(painting() == before);
        use(Command::Redo);
        QVERIFY(painting() == after);
        use(Command::Undo);
        QCOMPARE(largestDifference(pictureNow(), pictureBefore), 0);
    }
};

} // namespace

class TestTextFollowing : public QObject {
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

    /// At each report of the mouse, in the painting and in the picture.
    void lettersFollowADraggedNode()
    {
        Following s;
        s.press(nodePlace[2]);
        for (int i = 1; i <= 6; ++i) {
            const std::vector<Cubic> curve = s.set().curve;
            s.move(nodePlace[2] + i * Point{4, 15});
            QVERIFY(s.set().curve != curve);
            QVERIFY(s.set().curve == baselineOf(s.stroke()));
            QVERIFY2(s.stray() < 1e-3, qPrintable(QString::number(s.stray())));
        }
        QVERIFY(!s.lettersAreAsBefore());
        QCOMPARE(s.steps(), s.stepsBefore);
        const QImage during = s.pictureNow();
        QVERIFY(largestDifference(during, s.pictureBefore) > 50);
        s.release(nodePlace[2] + Point{24, 90});
        QCOMPARE(largestDifference(s.pictureNow(), during), 0);
        s.checkOneStep();
    }

    void lettersFollowADraggedCurve()
    {
        Following s;
        const Point place = s.stroke().cubicOf(s.stroke().segments[2]).at(0.5);
        s.drag(place, place + Point{10, 60}, {}, false);
        QVERIFY(s.set().curve == baselineOf(s.stroke()) && !s.lettersAreAsBefore());
        QVERIFY(s.stray() < 1e-3);
        s.release(place + Point{10, 60});
        s.checkOneStep();
    }

    /// A text on a part of the stroke stays on that part, though each report cuts it anew.
    void lettersStayOnTheirPart()
    {
        Following s(0.25, 0.9);
        s.press(nodePlace[3]);
        for (int i = 1; i <= 20; ++i)
            s.move(nodePlace[3] + i * Point{3, 4});
        const BaselineCurve whole(baselineOf(s.stroke()));
        const auto ends = whole.endsOf(BaselineCurve(s.set().curve));
        QVERIFY(ends);
        QVERIFY(std::abs(ends->first / whole.length() - 0.25) < 1e-4);
        QVERIFY(std::abs(ends->second / whole.length() - 0.9) < 1e-4);
        QVERIFY(s.stray() < 1e-3);
        s.release(nodePlace[3] + 20 * Point{3, 4});
        s.checkOneStep();
    }

    void escGivesLettersBack()
    {
        Following s;
        s.drag(nodePlace[2], {430, 380}, {}, false);
        QVERIFY(!s.lettersAreAsBefore());
        s.key(Qt::Key_Escape);
        QVERIFY(s.painting() == s.before);
        QCOMPARE(largestDifference(s.pictureNow(), s.pictureBefore), 0);
        s.move({440, 390});
        s.release({440, 390});
        QVERIFY(s.painting() == s.before);
        QCOMPARE(s.steps(), s.stepsBefore);
    }

    /// So does undo while the button is down, and a drag that comes back to where it began.
    void undoGivesLettersBack()
    {
        Following s;
        s.drag(nodePlace[2], {430, 380}, {}, false);
        s.use(Command::Undo);
        QVERIFY(s.painting() == s.before);
        s.release({430, 380});
        QCOMPARE(s.steps(), s.stepsBefore);
        s.drag(nodePlace[2], {430, 380}, {}, false);
        s.move(nodePlace[2]);
        s.release(nodePlace[2]);
        QVERIFY(s.painting() == s.before);
        QCOMPARE(s.steps(), s.stepsBefore);
    }

    /// What is moved as a whole floats over the picture otherwise; what leads a text does not.
    void lettersFollowAMovedStroke()
    {
        Following s;
        s.use(Command::Select);
        const StrokePtr letter = s.painting().strokes.back();
        QCOMPARE(letter->group, s.text);
        const Point place = s.stroke().cubicOf(s.stroke().segments[0]).at(0.1);
        s.press(place);
        for (int i = 1; i <= 5; ++i) {
            s.move(place + i * Point{6, 12});
            QVERIFY(i == 1 || !s.lettersAreAsBefore());
            QVERIFY(s.set().curve == baselineOf(s.stroke()));
        }
        QVERIFY(length(s.stroke(letter->id).origin - letter->origin - Point{30, 60}) < 1.5);
        QVERIFY(s.stray() < 1e-3);
        s.key(Qt::Key_Escape);
        QVERIFY(s.painting() == s.before);
        s.release(place + Point{30, 60});
        QCOMPARE(s.steps(), s.stepsBefore);
        s.drag(place, place + Point{-20, 40});
        QVERIFY(!s.lettersAreAsBefore());
        s.checkOneStep();
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestTextFollowing)
#include "test_text_following.moc"

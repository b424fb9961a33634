// Undo steps that go through a file.
#include "model/formats/files.h"
#include "model/painting/validate.h"
#include "tests/trials.h"
#include "tests/undo/random_edits.h"
#include "tests/undo/steps.h"
#include "undo/history/kept_history.h"

#include <QTest>
#include <QUndoStack>

using namespace suffuse;

namespace {

/// A document with its stack.
struct Session {
    Document document;
    QUndoStack stack;

    void push(Edit edit, const QString &text = QStringLiteral("edit"))
    {
        if (!edit.isEmpty())
            pushStep(stack, document, std::move(edit), text);
    }
    void paint(unsigned seed, int edits)
    {
        RandomEdits random(document, seed);
        for (int k = 0; k < edits; ++k)
            push(random.next(), QStringLiteral("edit %1").arg(k));
    }
    QByteArray bytes() const { return writeHistory(historyOf(stack), *document.painting()); }
    QByteArray hash() const { return hashOf(*document.painting()); }
};

/// Into another session by way of a file. Empty, or what went wrong.
QString reopened(const Session &from, Session &to)
{
    DocumentExtras extras;
    extras.history = from.bytes();
    const QByteArray file = writeSuffuseFile(*from.document.painting(), extras);
    const auto loaded = readDocument(file, QStringLiteral("a.suffuse"));
    if (!loaded)
        return loaded.error();
    const auto history = readHistory(loaded->extras.history, loaded->painting);
    if (!history)
        return history.error();
    to.document.reset(std::make_shared<const Painting>(loaded->painting));
    restoreHistory(to.stack, to.document, *history);
    return {};
}

} // namespace

class TestKeptHistory : public QObject {
    Q_OBJECT

private slots:
    void everyStepComesBack()
    {
        for (unsigned walk = 0; walk < 60; ++walk) {
            Session a, b;
            a.document.reset(makePainting(5));
            a.paint(walk, 60);
            a.stack.setIndex(a.stack.index() - int(walk % 7));
            const QString problem = reopened(a, b);
            QVERIFY2(problem.isEmpty(), qPrintable(problem));
            QCOMPARE(b.stack.count(), a.stack.count());
            QCOMPARE(b.stack.index(), a.stack.index());
            QVERIFY(b.stack.isClean());
            QCOMPARE(b.hash(), a.hash());
            b.document.setSelection(a.document.selection()); // files hold none
            for (const int to : {0, a.stack.count(), a.stack.index()}) {
                while (a.stack.index() != to) {
                    a.stack.setIndex(a.stack.index() + (a.stack.index() < to ? 1 : -1));
                    b.stack.setIndex(a.stack.index());
                    QCOMPARE(b.hash(), a.hash());
                    QVERIFY(b.document.selection() == a.document.selection());
                    QCOMPARE(b.stack.undoText(), a.stack.undoText());
                }
            }
        }
    }

    void paintingGoesOn()
    {
        Session a, b;
        a.document.reset(makePainting(4));
        const QByteArray first = a.hash();
        a.paint(5, 30);
        QVERIFY(reopened(a, b).isEmpty());
        const int steps = b.stack.count();
        b.paint(6, 30);
        QVERIFY(b.stack.count() > steps);
        QVERIFY(!b.stack.isClean());
        checkUndoAllAndRedo(b.stack, b.document, first);
        Session c;
        QVERIFY(reopened(b, c).isEmpty());
        checkUndoAllAndRedo(c.stack, c.document, first);
    }

    /// A stroke that was erased keeps its id to itself.
    void idsAreNotGivenAwayAgain()
    {
        Session a, b;
        a.document.reset(makePainting(3));
        const StrokeId id = a.document.takeStrokeId();
        a.push(addStrokes(a.document, {makeStroke(id, 0, 0)}, true));
        a.push(deleteSelection(a.document));
        QVERIFY(!a.document.painting()->find(id));
        QVERIFY(reopened(a, b).isEmpty());
        QVERIFY(b.document.takeStrokeId() > id);
    }

    void statesAreStoredOnce()
    {
        Session s;
        auto p = std::make_shared<Painting>();
        p->strokes.push_back(makeStroke(1, 0, 0, 2000));
        p->strokes.push_back(makeStroke(2, 0, 50, 2000));
        s.document.reset(p);
        for (int k = 0; k < 40; ++k) { // there and back
            s.push(changeSegments(s.document, {{1, 2}}, [=](Segment &g) { g.density = k % 2 ? 12 : 30; }));
        }
        QCOMPARE(s.stack.count(), 40);
        const qsizetype one = writeSuffuseFile(*s.document.painting()).size();
        QVERIFY2(s.bytes().size() < 2 * one, qPrintable(QString::number(s.bytes().size())));
    }

    void theNearestStepsAreKept()
    {
        Session a, b;
        a.document.reset(makePainting(2));
        for (int k = 0; k < 1300; ++k)
            a.push(changeSegments(a.document, {{1, 2}}, [=](Segment &g) { g.density = float(10 + k); }),
                   QString::number(k));
        a.stack.setIndex(1200);
        QVERIFY(reopened(a, b).isEmpty());
        QCOMPARE(b.stack.count(), int(mostHistorySteps));
        QCOMPARE(b.stack.count() - b.stack.index(), 100);
        QCOMPARE(b.stack.undoText(), QStringLiteral("1199"));
        QCOMPARE(b.stack.redoText(), QStringLiteral("1200"));
        b.stack.setIndex(0);
        a.stack.setIndex(300);
        QCOMPARE(b.hash(), a.hash());
    }

    void noStepsNoBytes()
    {
        Session s;
        s.document.reset(makePainting(2));
        QVERIFY(s.bytes().isEmpty());
    }

    void imagesOfStepsComeBack()
    {
        Session a, b;
        a.document.reset(makePainting(2));
        const auto image = [](char c) {
            return std::make_shared<const QByteArray>(QByteArray("\x89PNG\r\n\x1a\n") + QByteArray(3000, c));
        };
        for (const char c : {'a', 'b', 'a'}) {
            Edit edit;
            edit.canvas = a.document.painting()->canvas;
            edit.canvas->paper.kind = PaperKind::Image;
            edit.canvas->paper.image = image(c);
            a.push(std::move(edit));
            auto underlay = std::make_shared<Underlay>();
            underlay->image = image(c);
            underlay->area = Rect::of(0, 0, 10, 10);
            Edit under;
            under.underlay = underlay;
            a.push(std::move(under));
            Picture picture;
            picture.image = image(char(c + 1));
            picture.sha256 = sha256Of(*picture.image);
            a.push(changeStrokes(a.document, {StrokeId(c == 'b' ? 2 : 1)}, [&](Stroke &s) { s.picture = picture; }));
            a.push(changeStrokes(a.document, {1}, [](Stroke &s) { s.picture = {}; }));
        }
        QVERIFY(reopened(a, b).isEmpty());
        while (a.stack.canUndo()) {
            QCOMPARE(b.hash(), a.hash());
            for (const StrokePtr &stroke : b.document.painting()->strokes)
                QVERIFY(!stroke->picture || sha256Of(*stroke->picture->image) == stroke->picture->sha256);
            a.stack.undo();
            b.stack.undo();
        }
        QCOMPARE(b.hash(), a.hash());
    }

    void anotherPaintingIsRefused()
    {
        Session a;
        a.document.reset(makePainting(3));
        a.paint(1, 20);
        const QByteArray bytes = a.bytes();
        QVERIFY(readHistory(bytes, *a.document.painting()));
        Painting other = *a.document.painting();
        other.canvas.width += 1;
        const auto refused = readHistory(bytes, other);
        QVERIFY(!refused && refused.error().contains(QLatin1String("belongs to another painting")));
        QVERIFY(!readHistory({}, other));
    }

    void stepsThatDoNotFitAreRefused()
    {
        const PaintingPtr p = makePainting(3);
        const auto refuses = [&](const Edit &edit, std::size_t done) {
            const UndoHistory history{{{QStringLiteral("x"), edit}}, done};
            return !readHistory(writeHistory(history, *p), *p);
        };
        for (const std::size_t done : {0, 1}) {
            Edit edit;
            edit.strokes[9] = makeStroke(9, 0, 0);
            QVERIFY(refuses(edit, done)); // comes without a place
            edit.places = OrderDifference{{0, 9}};
            QVERIFY(!refuses(edit, done));
            edit.places = OrderDifference{{0, 9}, {1, 9}};
            QVERIFY(refuses(edit, done)); // twice
            edit.places = OrderDifference{{0, 8}};
            QVERIFY(refuses(edit, done)); // another one
            edit.strokes[9] = makeStroke(9, 0, 0, 2, 4);
            edit.places = OrderDifference{{0, 9}};
            QVERIFY(refuses(edit, done)); // in a group that is not there
            Edit gone;
            gone.strokes[2] = nullptr;
            QVERIFY(refuses(gone, done));
            gone.places.emplace();
            QVERIFY(!refuses(gone, done));
            gone.strokes[7] = nullptr; // it came and went within the step
            QVERIFY(!refuses(gone, done));
            Edit wrong;
            wrong.canvas = Canvas();
            wrong.canvas->width = -1;
            QVERIFY(refuses(wrong, done));
            Edit cycle;
            cycle.groups = {{1, QString(), 2, true, false}, {2, QString(), 1, true, false}};
            QVERIFY(refuses(cycle, done));
            Edit bad;
            auto stroke = std::make_shared<Stroke>(*p->strokes[0]);
            stroke->segments[0].diffusion = -1;
            bad.strokes[1] = stroke;
            QVERIFY(refuses(bad, done));
        }
    }

    /// Each either is refused, or can be walked to both ends over good paintings. SUFFUSE_LONG=1: 201,000 of them.
    void hostileBytesDoNoHarm_data()
    {
        QTest::addColumn<quint32>("seed");
        const quint32 rows = isLongRun() ? 67 : 1;
        for (quint32 seed = 11; seed < 11 + rows; ++seed)
            QTest::newRow(qPrintable(QString::number(seed))) << seed;
    }
    void hostileBytesDoNoHarm()
    {
        QFETCH(quint32, seed);
        constexpr int trials = 3'000;
        Session a;
        a.document.reset(makePainting(3));
        a.paint(3, 25);
        a.stack.setIndex(a.stack.index() - 3);
        const QByteArray bytes = a.bytes();
        std::mt19937 random(seed);
        int refused = 0;
        for (int trial = 0; trial < trials; ++trial) {
            QByteArray changed = bytes;
            const auto at = qsizetype(random() % std::size_t(bytes.size()));
            if (trial % 4 == 0)
                changed.truncate(at);
            else if (trial % 4 == 1)
                changed[at] = char(random());
            else
                changed[at] = char(changed[at] ^ (1 << random() % 8));
            const auto history = readHistory(changed, *a.document.painting());
            refused += !history;
            if (!history)
                continue;
            Session b;
            b.document.reset(a.document.painting());
            restoreHistory(b.stack, b.document, *history);
            b.stack.setIndex(0);
            QCOMPARE(problemOf(*b.document.painting()), QString());
            b.stack.setIndex(b.stack.count());
            QCOMPARE(problemOf(*b.document.painting()), QString());
        }
        QVERIFY(refused > trials / 2);
    }
};

QTEST_APPLESS_MAIN(TestKeptHistory)
#include "test_kept_history.moc"

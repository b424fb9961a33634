// File ▸ Import Strokes…: what other files hold comes into the open painting.
#include "app/session/files/clipboard.h"
#include "app/session/files/import_strokes.h"
#include "app/widgets/asking/messages.h"
#include "model/shaping/transform.h"
#include "tests/app/selecting.h"
#include "undo/edits.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>
#include <QMimeData>
#include <QStatusBar>
#include <QTemporaryDir>

using namespace suffuse;

namespace {

const char drawing[] = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 200'>"
                       "<path d='M50 100h200' fill='none' stroke='red' stroke-width='20' stroke-linecap='round'/>"
                       "<circle cx='150' cy='60' r='30' fill='blue'/><text>words</text></svg>";

QByteArray recording()
{
    QByteArray csv = "x,y,time,pressure\n";
    for (int i = 0; i < 40; ++i)
        csv += QByteArray::number(10 + 5 * i) + ",40," + QByteArray::number(0.016 * i) + ",0.7\n";
    return csv;
}

/// Two strokes, one hidden, one in a locked group.
Painting another()
{
    Painting painting;
    auto hidden = std::make_shared<Stroke>(*line(1, {20, 20}, {220, 20}));
    hidden->visible = false;
    hidden->name = "sky";
    auto grouped = std::make_shared<Stroke>(*line(2, {20, 60}, {220, 60}));
    grouped->group = 5;
    painting.groups = {{5, "Trees", 0, true, true}};
    painting.strokes = {hidden, grouped};
    painting.canvas.width = 3000;
    return painting;
}

} // namespace

class TestImportStrokes : public QObject {
    Q_OBJECT

    QString write(const QString &name, const QByteArray &bytes)
    {
        const QString path = m_folder.filePath(name);
        return writeFileAtomically(path, bytes) ? path : QString();
    }

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
        setMessageHooks({[this](const QString &message) { m_errors << message; }});
    }
    void cleanupTestCase() { setMessageHooks({}); }
    void init() { m_errors.clear(); }

    /// What says how large it is on paper stays as large on paper that says it, with its spread and its text; else it
    /// keeps its canvas units.
    void theSizeOnPaperStays()
    {
        const auto paintingOf = [](Editor &editor, double resolution) {
            editor.newPainting(Editor::usualCanvas(), resolution);
        };
        const StrokePtr wide = line(1, {100, 200}, {300, 200});
        Editor from;
        paintingOf(from, 300);
        from.push(addStrokes(from.document(), {wide}, true), "line");
        clipboard::copy(from);
        const QMimeData &data = *QGuiApplication::clipboard()->mimeData();
        const struct {
            double resolution, factor;
        } rows[] = {{150, 0.5}, {300, 1}, {600, 2}, {0, 1}};
        for (const auto &[resolution, factor] : rows) {
            Editor to;
            paintingOf(to, resolution);
            const int steps = to.undoStack().count();
            QCOMPARE(clipboard::paste(to, data, {}), QString());
            QCOMPARE(to.undoStack().count(), steps + 1);
            const Stroke pasted = *to.document().painting()->strokes[0];
            const Rect box = curveBox(pasted);
            QCOMPARE(box.left, 100 * factor);
            QCOMPARE(box.width(), 200 * factor);
            const Segment &was = wide->segments[0], &is = pasted.segments[0];
            QVERIFY(std::abs(is.spread(is.driesAt()) / was.spread(was.driesAt()) - factor) < 1e-5);
            to.undoStack().undo();
            QVERIFY(to.document().painting()->strokes.empty());
        }
        Text text;
        text.string = "a";
        Painting lettered;
        lettered.groups = {{1, "a"}};
        lettered.groups[0].text = text;
        QCOMPARE(atRealSize(lettered, 300, 150).groups[0].text->place.a, 0.5);
        QCOMPARE(atRealSize(lettered, 300, 0), lettered);
    }

    void aFileIsImportedAtItsSizeOnPaper()
    {
        DocumentExtras extras;
        extras.resolution = 300;
        const QString path = m_folder.filePath("sized.suffuse");
        QVERIFY(bool(saveDocument(another(), extras, path)));
        Editor to;
        to.newPainting(Editor::usualCanvas(), 150);
        QVERIFY(bool(importStrokes(to, path, {400, 300})));
        QCOMPARE(curveBox(*to.document().painting()->strokes[0]).width(), 100.0);
    }

    void everyKindIsOneStepAndSelected_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("strokes");
        QTest::newRow("SVG") << "a.svg" << QByteArray(drawing) << 2;
        QTest::newRow("recording") << "a.csv" << recording() << 1;
        QTest::newRow("text form") << "a.json" << writePainting(another(), FileFormat::Text) << 2;
        QTest::newRow("painting") << "a.suffuse" << writePainting(another(), FileFormat::Suffuse) << 2;
    }

    void everyKindIsOneStepAndSelected()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        QFETCH(int, strokes);
        Selecting s({line(1, {200, 200}, {600, 200}), line(2, {200, 300}, {600, 300})});
        const PaintingPtr before = s.editor().document().painting();
        s.window.importStrokes(write(name, bytes));
        QVERIFY2(m_errors.isEmpty(), qPrintable(m_errors.join('\n')));
        QCOMPARE(int(s.painting().strokes.size()), 2 + strokes);
        QCOMPARE(s.steps(), 1);
        QCOMPARE(s.painting().strokes[0], before->strokes[0]); // on top of what was there
        QCOMPARE(s.painting().canvas, before->canvas);
        QCOMPARE(int(s.selected().size()), strokes);
        const Microseconds now = s.editor().clock().time();
        for (int i = 0; i < strokes; ++i) {
            const Stroke &stroke = *s.painting().strokes[std::size_t(2 + i)];
            QVERIFY(s.selected().contains(stroke.id));
            QVERIFY(s.painting().isVisible(stroke) && !s.painting().isLocked(stroke));
            for (const Segment &segment : stroke.segments)
                QVERIFY(segment.born <= now);
        }
        s.use(Command::Undo);
        QCOMPARE(s.painting().strokes.size(), std::size_t(2));
        QVERIFY(s.painting().groups.empty());
    }

    void drawingsGetTheBrushInHandAndSayWhatIsMissing()
    {
        Selecting s({});
        Brush brush = *findBrush("soft-airbrush");
        s.editor().setBrush(brush);
        s.window.importStrokes(write("b.svg", drawing));
        QCOMPARE(s.painting().strokes[0]->brush, brush.name);
        const QString said = s.window.statusBar()->currentMessage();
        QVERIFY2(said.contains("1 text(s) were left out"), qPrintable(said));
    }

    void groupsKeepTheirNames()
    {
        Selecting s({});
        s.window.importStrokes(write("c.d.suffuse", writePainting(another(), FileFormat::Suffuse)));
        const std::vector<Group> &groups = s.painting().groups;
        QCOMPARE(groups.size(), std::size_t(2));
        QCOMPARE(groups[0].name, QString("Trees"));
        QCOMPARE(groups[1].name, QString("c.d")); // all of it is one group
        QCOMPARE(groups[0].parent, groups[1].id);
        QCOMPARE(groups[1].parent, GroupId(0));
        QCOMPARE(s.painting().strokes[1]->group, groups[0].id);
        QCOMPARE(s.painting().strokes[0]->group, groups[1].id);
        QCOMPARE(s.painting().strokes[0]->name, QString("sky"));
    }

    void arrivesInTheMiddleOfTheViewWithTheSelectToolInHand_data() { everyKindIsOneStepAndSelected_data(); }
    void arrivesInTheMiddleOfTheViewWithTheSelectToolInHand()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        Selecting s({line(1, {200, 200}, {600, 200})});
        s.use(Command::Brush);
        View view = s.canvas().view();
        view.centre = view.centre + Point{731, -252};
        view.scale = 1.7;
        s.canvas().lookThrough(view);
        s.window.importStrokes(write(name, bytes));
        QVERIFY(s.window.action(Command::Select).isChecked());
        QVERIFY(dynamic_cast<SelectTool *>(s.canvas().tool()));
        Rect box;
        for (const StrokeId id : s.selected())
            box = box.united(controlBox(s.stroke(id)));
        QVERIFY2(length(box.centre() - s.canvas().view().toCanvas(
                                           {0.5 * s.canvas().view().width, 0.5 * s.canvas().view().height})) < 1e-3,
                 qPrintable(QString("%1 %2").arg(box.centre().x).arg(box.centre().y)));
        // One group: a click on one takes all.
        std::set<GroupId> outermost;
        for (const StrokeId id : s.selected()) {
            GroupId group = s.stroke(id).group;
            for (bool isInner = true; isInner;) {
                isInner = false;
                for (const Group &g : s.painting().groups)
                    if (g.id == group && g.parent)
                        group = g.parent, isInner = true;
            }
            outermost.insert(group);
        }
        QVERIFY(outermost.size() == 1 && *outermost.begin() != 0);
    }

    /// Two strokes that were painted one after the other, the second with a fill.
    Painting twoMoments()
    {
        Stroke early = *line(1, {20, 20}, {220, 20}), late = *line(2, {20, 60}, {220, 60});
        for (Segment &segment : early.segments)
            segment.born = 1'000'000;
        for (Segment &segment : late.segments)
            segment.born = 9'000'000;
        Fill fill;
        fill.born = 12'000'000;
        late.fill = fill;
        Painting painting;
        painting.strokes = {std::make_shared<const Stroke>(early), std::make_shared<const Stroke>(late)};
        return painting;
    }

    void anEmptyPaintingTakesOverTheTimes()
    {
        Selecting s({});
        s.editor().clock().setManual(false);
        const Painting file = twoMoments();
        s.window.importStrokes(write("times.suffuse", writePainting(file, FileFormat::Suffuse)));
        QVERIFY2(m_errors.isEmpty(), qPrintable(m_errors.join('\n')));
        QCOMPARE(s.painting().strokes[0]->segments[0].born, Microseconds(1'000'000));
        QCOMPARE(s.painting().strokes[1]->segments[0].born, Microseconds(9'000'000));
        QCOMPARE(s.painting().strokes[1]->fill->born, Microseconds(12'000'000));
        // All is dry, as in the file when it is opened.
        QCOMPARE(s.editor().clock().time(), file.end());
        QVERIFY(!s.editor().clock().isRunning() && !s.editor().clock().isInPast());
        QCOMPARE(s.window.statusBar()->currentMessage(), QString());
        s.use(Command::Undo);
        QVERIFY(s.painting().strokes.empty());
        QCOMPARE(s.editor().clock().time(), Microseconds(0));
        s.use(Command::Redo);
        QCOMPARE(s.editor().clock().time(), file.end());
    }

    void timesThatAreBroughtBackAreSaid()
    {
        Selecting s({line(1, {200, 200}, {600, 200})});
        const Microseconds now = s.editor().clock().time();
        QVERIFY(now < 12'000'000);
        s.window.importStrokes(write("later.suffuse", writePainting(twoMoments(), FileFormat::Suffuse)));
        const Microseconds by = 12'000'000 - now;
        QCOMPARE(s.painting().strokes[2]->fill->born, now);
        QCOMPARE(s.painting().strokes[2]->segments[0].born, std::max(Microseconds(0), 9'000'000 - by));
        const QString said = s.window.statusBar()->currentMessage();
        QVERIFY2(said.contains("brought back to this moment"), qPrintable(said));
        s.window.importStrokes(write("now.svg", drawing)); // is painted now
        QVERIFY(!s.window.statusBar()->currentMessage().contains("brought back"));
    }

    void mistakesAreShownAndChangeNothing()
    {
        Selecting s({line(1, {200, 200}, {600, 200})});
        s.window.importStrokes(m_folder.filePath("gone.svg"));
        QVERIFY(m_errors.size() == 1 && m_errors[0].contains("gone.svg"));
        s.window.importStrokes(write("empty.json", writePainting(Painting(), FileFormat::Text)));
        QVERIFY(m_errors.size() == 2 && m_errors[1].contains("empty.json"));
        s.window.importStrokes(write("words.txt", "hello"));
        QCOMPARE(m_errors.size(), 3);
        QCOMPARE(s.steps(), 0);
    }

private:
    QTemporaryDir m_folder;
    QStringList m_errors;
};

QTEST_MAIN(TestImportStrokes)
#include "test_import_strokes.moc"

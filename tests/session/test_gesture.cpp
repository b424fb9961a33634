// A gesture without a window: whoever reads, saves, undoes or draws at any step of it finds a true state.
#include "app/session/editor.h"
#include "app/session/files/opened_file.h"
#include "render/backends.h"
#include "tests/undo/random_edits.h"
#include "undo/node_edits.h"

#include <QSignalSpy>
#include <QTemporaryDir>

using namespace suffuse;

namespace {

/// Lifts whatever it is asked to, and counts.
class Pictures : public FloatingView {
public:
    explicit Pictures(Editor &editor) : m_editor(editor) { editor.setFloatingView(this); }
    ~Pictures() override { m_editor.setFloatingView(nullptr); }

    void lift(const std::set<StrokeId> &) override { m_from = m_editor.unsettledShown(); }
    void endLift() override { m_from.reset(); }
    bool isLifted() const override { return m_from && m_from == m_editor.unsettledShown(); }
    void showFloating(const Affine &map) override { shown.push_back(map); }
    void settleFloating() override { m_from = m_editor.unsettledShown(), ++settled; }
    bool coversFloating(const Affine &) const override { return covers; }

    std::vector<Affine> shown;
    int settled = 0;
    bool covers = true;

private:
    Editor &m_editor;
    PaintingPtr m_from;
};

/// What a gesture does in its step k; step 0 brings it back to its start.
enum class Kind { Edits, Strokes, Maps, Floats };

void showStep(Editor &editor, Gesture &gesture, Kind kind, int k)
{
    if (kind == Kind::Edits)
        gesture.show(changeSegments(editor.document(), {{1, 2}}, [k](Segment &s) { s.density = float(11 + k); }));
    else if (kind == Kind::Strokes)
        gesture.show([k](const Stroke &stroke) { return withNodeMoved(stroke, {1}, {3.0 * k, 5.0 * k}); });
    else
        gesture.floatBy(Affine::translation({4.0 * k, -2.0 * k}), SpreadRule::Scales);
}

/// The painting that is meant by it.
Painting expected(const Painting &start, Kind kind, int k)
{
    Painting painting = start;
    for (std::size_t i = 0; i < painting.strokes.size(); ++i) {
        Stroke stroke = *start.strokes[i];
        if (stroke.id > 2 || (kind == Kind::Edits && stroke.id > 1))
            continue;
        if (kind == Kind::Edits)
            stroke.segments[2].density = float(11 + k);
        else if (kind == Kind::Strokes)
            stroke = withNodeMoved(stroke, {1}, {3.0 * k, 5.0 * k});
        else
            stroke = transformed(stroke, Affine::translation({4.0 * k, -2.0 * k}), SpreadRule::Scales);
        painting.strokes[i] = std::make_shared<const Stroke>(stroke);
    }
    return painting;
}

/// An editor with three strokes, a step that is done, one that is saved, and two that are undone.
struct Desk {
    QTemporaryDir folder;
    Editor editor;
    std::optional<Pictures> pictures;
    Painting start, last;
    QStringList steps;

    explicit Desk(Kind kind)
    {
        qputenv("SUFFUSE_SETTINGS", folder.filePath("settings.ini").toLocal8Bit());
        editor.document().reset(makePainting(3));
        editor.clock().setManual(true);
        editor.clock().setTime(start.end());
        for (int k = 1; k <= 4; ++k) {
            rename(3, QString::number(k));
            if (k == 2)
                save();
        }
        last = painting();
        editor.undoStack().setIndex(2);
        start = painting();
        for (int i = 0; i < stack().count(); ++i)
            steps << stack().text(i);
        if (kind == Kind::Floats)
            pictures.emplace(editor);
    }
    QUndoStack &stack() { return editor.undoStack(); }
    const Painting &painting() { return *editor.document().painting(); }
    void rename(StrokeId id, const QString &name)
    {
        editor.push(changeStrokes(editor.document(), {id}, [&](Stroke &s) { s.name = name; }), "name " + name);
    }
    void save()
    {
        editor.startSaving(folder.filePath("a.suffuse"), true);
        QTRY_VERIFY(!editor.isSaving());
    }
    Painting saved()
    {
        const Result<OpenedFile> file = readOpenedFile(folder.filePath("a.suffuse"));
        return file ? file->document.painting : Painting();
    }
    Gesture begin(const QString &name = "gesture")
    {
        if (pictures)
            pictures->lift({1, 2});
        Gesture gesture = editor.begin(name);
        gesture.take({1, 2});
        return gesture;
    }
    /// Nothing is left of the gesture, and all that was before it is there.
    void checkUntouched()
    {
        QVERIFY(!editor.isDragging());
        QCOMPARE(painting(), start);
        QStringList now;
        for (int i = 0; i < stack().count(); ++i)
            now << stack().text(i);
        QCOMPARE(now, steps);
        QCOMPARE(stack().index(), 2);
        QVERIFY(!editor.isModified());
        QVERIFY(editor.canRedo());
        editor.redo();
        editor.redo();
        QCOMPARE(painting(), last);
        editor.undo();
        editor.undo();
        QCOMPARE(painting(), start);
        QVERIFY(!editor.isModified());
    }
    /// From here everything is undone, and done again.
    void checkWalk()
    {
        const Painting now = painting();
        const int index = stack().index();
        while (editor.canUndo())
            editor.undo();
        QCOMPARE(painting(), *makePainting(3));
        while (stack().index() < index)
            editor.redo();
        QCOMPARE(painting(), now);
    }
};

std::vector<std::uint32_t> pictureOf(PaintingPtr painting)
{
    RenderRequest request;
    request.painting = std::move(painting);
    request.time = request.painting->end();
    request.view = View::ofArea(Rect::of(0, -60, 300, 120), 150, 60);
    auto renderer = makeRenderer({.backend = Backend::Cpu, .threads = 1});
    Picture8 picture;
    if (!renderer || !(*renderer)->render(request, picture))
        return {};
    return picture.argb;
}

constexpr int steps = 4;

} // namespace

class TestGesture : public QObject {
    Q_OBJECT

private slots:
    void readAtEachStep_data() { kinds(); }
    void readAtEachStep();
    void committed_data() { kinds(); }
    void committed();
    void givenUp_data() { kinds(); }
    void givenUp();
    void destroyed_data() { kinds(); }
    void destroyed();
    void backAtItsStart_data() { kinds(); }
    void backAtItsStart();
    void savedMeanwhile_data() { kinds(); }
    void savedMeanwhile();
    void undoneMeanwhile_data() { kinds(); }
    void undoneMeanwhile();
    void redoneMeanwhile_data() { kinds(); }
    void redoneMeanwhile();
    void stepsOfTheStackMeanwhile_data() { kinds(); }
    void stepsOfTheStackMeanwhile();
    void pushedMeanwhile_data() { kinds(); }
    void pushedMeanwhile();
    void anotherGesture_data() { kinds(); }
    void anotherGesture();
    void aStrokeGoesMeanwhile_data() { kinds(); }
    void aStrokeGoesMeanwhile();
    void anotherPainting_data() { kinds(); }
    void anotherPainting();
    void whoeverKeepsAJournalHears_data() { kinds(); }
    void whoeverKeepsAJournalHears();
    void theSelectionComesBack();
    void whatFloatsIsSettledByReading();
    void strokesAreLiftedAnew();
    void aHandleMoves();
    void theEditorGoesFirst();
    void dragsOfFields();
    void stepsOfFields();
    void anythingInBetween_data();
    void anythingInBetween();

private:
    static void kinds()
    {
        QTest::addColumn<Kind>("kind");
        QTest::newRow("edits") << Kind::Edits;
        QTest::newRow("strokes") << Kind::Strokes;
        QTest::newRow("maps") << Kind::Maps;
        QTest::newRow("floats") << Kind::Floats;
    }
};

void TestGesture::readAtEachStep()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture gesture = desk.begin();
    QVERIFY(!desk.editor.isDragging()); // nothing is shown yet
    for (int k = 1; k <= steps; ++k) {
        showStep(desk.editor, gesture, kind, k);
        const Painting wanted = expected(desk.start, kind, k);
        QCOMPARE(pictureOf(desk.editor.shown()), pictureOf(std::make_shared<const Painting>(wanted)));
        QCOMPARE(desk.painting(), wanted);
        QCOMPARE(desk.stack().count(), 4);
        QVERIFY(desk.editor.isModified());
        QVERIFY(desk.editor.canUndo() && !desk.editor.canRedo());
        QCOMPARE(desk.editor.undoText(), QString("gesture"));
    }
    gesture.giveUp();
    desk.checkUntouched();
}

void TestGesture::committed()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture gesture = desk.begin();
    for (int k = 1; k <= steps; ++k)
        showStep(desk.editor, gesture, kind, k);
    gesture.commit();
    QVERIFY(!gesture.isOpen() && !desk.editor.isDragging());
    QCOMPARE(desk.painting(), expected(desk.start, kind, steps));
    QCOMPARE(desk.stack().count(), 3);
    QCOMPARE(desk.editor.undoText(), QString("gesture"));
    showStep(desk.editor, gesture, kind, 1); // it is over
    QCOMPARE(desk.painting(), expected(desk.start, kind, steps));
    desk.editor.undo();
    QCOMPARE(desk.painting(), desk.start);
    QVERIFY(!desk.editor.isModified());
    desk.editor.redo();
    QCOMPARE(desk.painting(), expected(desk.start, kind, steps));
    desk.checkWalk();
}

void TestGesture::givenUp()
{
    QFETCH(Kind, kind);
    for (int shown = 0; shown <= steps; ++shown) {
        Desk desk(kind);
        const PaintingPtr before = desk.editor.document().painting();
        Gesture gesture = desk.begin();
        for (int k = 1; k <= shown; ++k)
            showStep(desk.editor, gesture, kind, k);
        gesture.giveUp();
        QVERIFY(!gesture.isOpen());
        for (std::size_t i = 0; i < 3; ++i) // the very same strokes
            QCOMPARE(desk.painting().strokes[i], before->strokes[i]);
        desk.checkUntouched();
    }
}

void TestGesture::destroyed()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    {
        Gesture gesture = desk.begin();
        showStep(desk.editor, gesture, kind, 3);
    }
    desk.checkUntouched();
}

void TestGesture::backAtItsStart()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture gesture = desk.begin();
    for (const int k : {1, 2, 3, 0})
        showStep(desk.editor, gesture, kind, k);
    gesture.commit();
    desk.checkUntouched();
}

void TestGesture::savedMeanwhile()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture gesture = desk.begin();
    for (int k = 1; k <= steps; ++k) {
        showStep(desk.editor, gesture, kind, k);
        desk.save();
        QCOMPARE(desk.saved(), expected(desk.start, kind, k));
        QVERIFY(!desk.editor.isModified());
    }
    showStep(desk.editor, gesture, kind, steps + 1);
    gesture.giveUp(); // what was saved was done
    QCOMPARE(desk.painting(), expected(desk.start, kind, steps));
    QVERIFY(!desk.editor.isModified());
    QCOMPARE(desk.stack().count(), 2 + steps);
    desk.checkWalk();
}

void TestGesture::undoneMeanwhile()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture gesture = desk.begin();
    for (int k = 1; k <= steps; ++k) {
        showStep(desk.editor, gesture, kind, k);
        desk.editor.undo();
        QCOMPARE(desk.painting(), expected(desk.start, kind, k - 1));
        QCOMPARE(desk.editor.isModified(), k > 1);
        desk.editor.redo();
        QCOMPARE(desk.painting(), expected(desk.start, kind, k));
    }
    gesture.commit();
    QCOMPARE(desk.stack().count(), 2 + steps);
    desk.checkWalk();
}

void TestGesture::redoneMeanwhile()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture gesture = desk.begin();
    for (int k = 1; k <= steps; ++k) {
        showStep(desk.editor, gesture, kind, k);
        desk.editor.redo(); // there is nothing
        QCOMPARE(desk.painting(), expected(desk.start, kind, k));
    }
    gesture.commit();
    QCOMPARE(desk.stack().count(), 2 + steps);
    desk.checkWalk();
}

/// The list of steps, and whoever has the stack, does them without the editor.
void TestGesture::stepsOfTheStackMeanwhile()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture gesture = desk.begin();
    for (int k = 1; k <= steps; ++k) {
        showStep(desk.editor, gesture, kind, k);
        desk.stack().redo();
        desk.stack().redo();
        QCOMPARE(desk.painting(), desk.last);
        showStep(desk.editor, gesture, kind, k);
        desk.stack().setIndex(2);
        QCOMPARE(desk.painting(), desk.start);
        showStep(desk.editor, gesture, kind, k);
        desk.stack().undo();
        QCOMPARE(desk.stack().index(), 1);
        desk.stack().redo();
        QCOMPARE(desk.painting(), desk.start);
    }
    gesture.commit();
    desk.checkUntouched();
}

void TestGesture::pushedMeanwhile()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture gesture = desk.begin();
    for (int k = 1; k <= steps; ++k) {
        showStep(desk.editor, gesture, kind, k);
        desk.rename(3, QString("while %1").arg(k));
        Painting wanted = expected(desk.start, kind, k);
        Stroke named = *wanted.strokes.at(2);
        named.name = QString("while %1").arg(k);
        wanted.strokes[2] = std::make_shared<const Stroke>(named);
        QCOMPARE(desk.painting(), wanted);
        QCOMPARE(desk.stack().count(), 2 + 2 * k);
    }
    gesture.giveUp();
    QCOMPARE(desk.stack().count(), 2 + 2 * steps);
    desk.checkWalk();
}

void TestGesture::anotherGesture()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture one = desk.begin("one");
    showStep(desk.editor, one, kind, 2);
    Gesture two = desk.begin("two");
    QCOMPARE(desk.stack().undoText(), QString("one"));
    QCOMPARE(desk.painting(), expected(desk.start, kind, 2));
    const Painting between = desk.painting();
    two.show(changeStrokes(desk.editor.document(), {3}, [](Stroke &s) { s.origin.x += 7; }));
    showStep(desk.editor, one, kind, 3); // and on
    QCOMPARE(desk.stack().undoText(), QString("two"));
    two.giveUp(); // it is a step already
    one.giveUp();
    QCOMPARE(desk.stack().count(), 4);
    desk.editor.undo();
    QCOMPARE(desk.painting(), between);
    desk.checkWalk();
}

void TestGesture::aStrokeGoesMeanwhile()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    Gesture gesture = desk.begin();
    showStep(desk.editor, gesture, kind, 1);
    desk.editor.document().setSelection({{2}, {}});
    desk.editor.push(deleteSelection(desk.editor.document()), "delete");
    QVERIFY(!desk.painting().find(2));
    showStep(desk.editor, gesture, kind, 2);
    QCOMPARE(*desk.painting().find(1), *expected(desk.start, kind, 2).find(1));
    QVERIFY(!desk.painting().find(2));
    gesture.commit();
    QCOMPARE(desk.stack().count(), 5);
    desk.checkWalk();
}

void TestGesture::anotherPainting()
{
    QFETCH(Kind, kind);
    for (const bool byFile : {false, true}) {
        Desk desk(kind);
        Gesture gesture = desk.begin();
        showStep(desk.editor, gesture, kind, 1);
        if (byFile)
            desk.editor.newPainting({});
        else
            desk.editor.document().reset(std::make_shared<const Painting>());
        QVERIFY(!desk.editor.isDragging() && !desk.editor.undecided());
        if (kind != Kind::Edits)
            showStep(desk.editor, gesture, kind, 2);
        gesture.giveUp();
        QVERIFY(desk.painting().strokes.empty());
    }
}

void TestGesture::whoeverKeepsAJournalHears()
{
    QFETCH(Kind, kind);
    Desk desk(kind);
    QSignalSpy edited(&desk.editor, &Editor::edited), ended(&desk.editor, &Editor::dragEnded);
    Gesture gesture = desk.begin();
    showStep(desk.editor, gesture, kind, 1);
    showStep(desk.editor, gesture, kind, 2);
    QCOMPARE(edited.count(), 0);
    gesture.rest();
    QCOMPARE(edited.count(), 1);
    QCOMPARE(ended.count(), 1);
    QVERIFY(!desk.editor.isDragging());
    QCOMPARE(*desk.editor.unsettled().painting(), expected(desk.start, kind, 2));
    showStep(desk.editor, gesture, kind, 3);
    QVERIFY(desk.editor.isDragging());
    gesture.giveUp();
    QCOMPARE(edited.count(), 2); // it has what is not there any more
    gesture = desk.begin();
    showStep(desk.editor, gesture, kind, 3);
    gesture.commit();
    QCOMPARE(edited.count(), 3);
    desk.editor.undo();
    desk.editor.redo();
    QCOMPARE(edited.count(), 5);
}

void TestGesture::theSelectionComesBack()
{
    Desk desk(Kind::Edits);
    const Selection before{{1}, {{1, 3}}};
    desk.editor.document().setSelection(before);
    Gesture gesture = desk.begin();
    gesture.show(deleteSelection(desk.editor.document()));
    QVERIFY(desk.editor.selection() != before);
    gesture.giveUp();
    QCOMPARE(desk.editor.selection(), before);
    gesture = desk.begin();
    gesture.show(deleteSelection(desk.editor.document()));
    gesture.commit();
    desk.editor.document().setSelection({{3}, {}});
    desk.editor.undo();
    QCOMPARE(desk.editor.selection(), before);
}

void TestGesture::whatFloatsIsSettledByReading()
{
    Desk desk(Kind::Floats);
    Pictures &pictures = *desk.pictures;
    Gesture gesture = desk.begin();
    for (int k = 1; k <= steps; ++k)
        showStep(desk.editor, gesture, Kind::Floats, k);
    QCOMPARE(pictures.shown.size(), std::size_t(steps));
    QCOMPARE(*desk.editor.unsettled().painting(), desk.start);
    QCOMPARE(pictures.settled, 0);
    QCOMPARE(desk.painting(), expected(desk.start, Kind::Floats, steps));
    QCOMPARE(pictures.settled, 1);
    showStep(desk.editor, gesture, Kind::Floats, 2); // it goes on afloat
    QCOMPARE(*desk.editor.unsettled().painting(), expected(desk.start, Kind::Floats, steps));
    QCOMPARE(desk.painting(), expected(desk.start, Kind::Floats, 2));
    QCOMPARE(pictures.settled, 2);
    // What the picture cannot show is shown by edits.
    gesture.floatBy(Affine::scaling({}, 2, 1), SpreadRule::Stays);
    QVERIFY(*desk.editor.unsettled().painting() != expected(desk.start, Kind::Floats, 2));
    QCOMPARE(pictures.settled, 2);
    showStep(desk.editor, gesture, Kind::Floats, 3);
    desk.editor.clock().setTime(desk.editor.clock().time() + 1'000'000); // another moment
    QCOMPARE(*desk.editor.unsettled().painting(), expected(desk.start, Kind::Floats, 3));
    gesture.giveUp();
    QVERIFY(!pictures.isLifted());
    desk.checkUntouched();
}

void TestGesture::strokesAreLiftedAnew()
{
    Desk desk(Kind::Floats);
    Gesture gesture = desk.begin();
    showStep(desk.editor, gesture, Kind::Floats, 3);
    desk.pictures->covers = false;
    desk.editor.rest();
    QVERIFY(desk.pictures->isLifted());
    showStep(desk.editor, gesture, Kind::Floats, 5);
    QCOMPARE(desk.pictures->shown.back(), Affine::translation({8, -4})); // since it was lifted
    QCOMPARE(desk.painting(), expected(desk.start, Kind::Floats, 5));
    gesture.commit();
    desk.checkWalk();
}

void TestGesture::aHandleMoves()
{
    Desk desk(Kind::Strokes);
    Gesture first = desk.begin();
    showStep(desk.editor, first, Kind::Strokes, 1);
    Gesture second = std::move(first);
    QVERIFY(second.isOpen() && desk.editor.isDragging());
    showStep(desk.editor, second, Kind::Strokes, 2);
    QCOMPARE(desk.painting(), expected(desk.start, Kind::Strokes, 2));
    second = {};
    desk.checkUntouched();
    Gesture nothing;
    showStep(desk.editor, nothing, Kind::Strokes, 1);
    nothing.commit();
    desk.checkUntouched();
}

void TestGesture::theEditorGoesFirst()
{
    Gesture gesture;
    {
        Desk desk(Kind::Floats);
        gesture = desk.begin();
        showStep(desk.editor, gesture, Kind::Floats, 1);
    }
    gesture.floatBy(Affine(), SpreadRule::Scales);
    gesture.commit();
    QVERIFY(!gesture.isOpen());
}

void TestGesture::dragsOfFields()
{
    Desk desk(Kind::Edits);
    const auto enter = [&](ValueEntry &entry, float density) {
        desk.editor.push(changeSegments(desk.editor.document(), {{1, 2}}, [=](Segment &s) { s.density = density; }),
                         "value", &entry);
    };
    ValueEntry entry;
    entry.beginDrag();
    QVERIFY(!desk.editor.isDragging()); // nothing has come
    enter(entry, 20);
    enter(entry, 30);
    QCOMPARE(desk.painting().find(1)->segments[2].density, 30.0f);
    entry.giveUpDrag();
    desk.checkUntouched();
    entry.beginDrag();
    enter(entry, 20);
    enter(entry, 11);
    entry.commitDrag();
    desk.checkUntouched();
    entry.beginDrag();
    enter(entry, 20);
    enter(entry, 30);
    entry.commitDrag();
    QCOMPARE(desk.stack().count(), 3);
    desk.checkWalk();
}

void TestGesture::stepsOfFields()
{
    Desk desk(Kind::Edits);
    const auto enter = [&](ValueEntry &entry, float density) {
        desk.editor.push(changeSegments(desk.editor.document(), {{1, 2}}, [=](Segment &s) { s.density = density; }),
                         "value", &entry);
    };
    ValueEntry entry, other;
    enter(entry, 20);
    QVERIFY(!desk.editor.isStepping());
    enter(entry, 21);
    QVERIFY(desk.editor.isStepping()); // a hand that goes on
    QVERIFY(!desk.editor.isDragging());
    QCOMPARE(desk.stack().count(), 3); // one step, done at once
    enter(entry, 11);                  // back at its start it is none
    QCOMPARE(desk.stack().count(), 2);
    QCOMPARE(desk.painting(), desk.start);
    QVERIFY(!desk.editor.isModified());
    enter(entry, 22);
    enter(other, 23);
    enter(entry, 24); // another one came between
    QCOMPARE(desk.stack().count(), 5);
    desk.save();
    enter(entry, 25); // what is in a file stays a step
    QCOMPARE(desk.stack().count(), 6);
    desk.editor.undo();
    enter(entry, 26);
    QCOMPARE(desk.stack().count(), 6);
    enter(entry, 27);
    entry.endSteps();
    enter(entry, 28);
    QCOMPARE(desk.stack().count(), 7);
    desk.checkWalk();
}

void TestGesture::anythingInBetween_data()
{
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= 40; ++seed)
        QTest::newRow(qPrintable(QString::number(seed))) << seed;
}

/// Two hands, and all else at random: undoing all gives the first painting back, and redoing all the last one.
void TestGesture::anythingInBetween()
{
    QFETCH(unsigned, seed);
    std::mt19937 random(seed);
    const auto below = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
    Desk desk(Kind::Floats);
    Gesture hands[2];
    ValueEntry entry;
    for (int i = 0; i < 300; ++i) {
        Gesture &hand = hands[below(2)];
        switch (below(14)) {
        case 0:
            hand = desk.begin();
            break;
        case 1:
            hand.commit();
            break;
        case 2:
            hand.giveUp();
            break;
        case 3:
            desk.editor.undo();
            break;
        case 4:
            desk.editor.redo();
            break;
        case 5:
            below(2) ? desk.stack().undo() : desk.stack().redo();
            break;
        case 6:
            desk.rename(StrokeId(1 + below(3)), QString::number(i));
            break;
        case 7:
            desk.editor.push(reorder(desk.editor.document(), {StrokeId(1 + below(3))}, below(3)), "order", &entry);
            break;
        case 8:
            desk.editor.rest();
            break;
        case 9:
            desk.pictures->lift({1, 2});
            break;
        default:
            showStep(desk.editor, hand, Kind(below(4)), below(5));
        }
        QVERIFY(desk.editor.unsettled().painting()->strokes.size() == 3);
    }
    hands[0].commit();
    hands[1].giveUp();
    while (desk.editor.canRedo())
        desk.editor.redo();
    desk.checkWalk();
}

QTEST_GUILESS_MAIN(TestGesture)
#include "test_gesture.moc"

// What nobody means to do: undo, Esc or another painting in the middle of a drag, edits while a picture is being
// rendered, nodes dropped onto each other, dialogs about strokes that go.
#include "app/panels/inspector/along/along_dialog.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/tools/nodes/node_tool.h"
#include "app/tools/select/select_tool.h"
#include "model/formats/files.h"
#include "model/painting/validate.h"
#include "model/shaping/curves/split.h"
#include "render/backends.h"
#include "tests/app/shapes.h"

#include <QTemporaryDir>
#include <QToolButton>

#include <semaphore>

using namespace suffuse;

namespace {

/// Holds its first picture back until it is told to go on.
class HeldRenderer : public Renderer {
public:
    HeldRenderer(std::unique_ptr<Renderer> own, std::binary_semaphore &begun, std::binary_semaphore &mayEnd)
        : m_own(std::move(own)), m_begun(begun), m_mayEnd(mayEnd)
    {}
    Backend backend() const override { return m_own->backend(); }
    QString deviceName() const override { return m_own->deviceName(); }
    Result<RenderStats> render(const RenderRequest &request, Target &target, const std::atomic<bool> *cancel) override
    {
        if (!std::exchange(m_held, true)) {
            m_begun.release();
            m_mayEnd.acquire();
        }
        return m_own->render(request, target, cancel);
    }
    void invalidate() override { m_own->invalidate(); }

private:
    std::unique_ptr<Renderer> m_own;
    std::binary_semaphore &m_begun, &m_mayEnd;
    bool m_held = false;
};

struct Grab {
    Command tool;
    Point from, to;
    bool turns = false; ///< the handles that turn
};

/// Where each tool takes hold of the wave of a WaveSession.
Grab grabOf(WaveSession &s, const QString &what)
{
    static const std::map<QString, Grab> grabs{{"brush", {Command::Brush, {200, 200}, {500, 250}}},
                                               {"extend", {Command::Brush, {600, 300}, {700, 400}}},
                                               {"move", {Command::Select, {300, 340}, {330, 420}}},
                                               {"band", {Command::Select, {150, 200}, {650, 450}}},
                                               {"scale", {Command::Select, {0, 0}, {720, 420}}},
                                               {"turn", {Command::Select, {0, 0}, {720, 420}, true}},
                                               {"node", {Command::Segments, {300, 340}, {330, 400}}},
                                               {"handle", {Command::Segments, {333.333, 340}, {350, 400}}},
                                               {"curve", {Command::Segments, {250, 320}, {260, 380}}},
                                               {"redraw", {Command::Redraw, {250, 320}, {450, 320}}},
                                               {"push", {Command::Push, {350, 300}, {350, 380}}},
                                               {"shape", {Command::Shapes, {200, 200}, {500, 250}}},
                                               {"pen", {Command::OutlinePen, {200, 200}, {500, 250}}},
                                               {"lasso", {Command::LassoFill, {200, 200}, {500, 250}}},
                                               {"bucket", {Command::Bucket, {200, 200}, {500, 250}}},
                                               {"knife", {Command::Knife, {350, 250}, {345, 400}}},
                                               {"eraser", {Command::Eraser, {350, 270}, {350, 380}}},
                                               {"attributes", {Command::AttributeBrush, {250, 320}, {450, 320}}},
                                               {"eyedropper", {Command::Eyedropper, {250, 320}, {450, 320}}},
                                               {"assistant", {Command::Assistants, {200, 200}, {500, 250}}},
                                               {"hand", {Command::Pan, {250, 320}, {270, 330}}}};
    Grab grab = grabs.at(what);
    s.use(grab.tool);
    if (auto *select = qobject_cast<SelectTool *>(s.canvas().tool()); select && grab.from == Point()) {
        if (grab.turns)
            s.click({250, 320});
        const TransformHandle corner{grab.turns ? TransformHandle::Kind::Rotate : TransformHandle::Kind::Scale, 1, 1};
        grab.from = s.canvas().view().toCanvas(
            select->handles().place(corner, s.canvas().view(), s.canvas().devicePixelRatioF()));
    }
    if (auto *nodes = qobject_cast<NodeTool *>(s.canvas().tool()); nodes && what == "handle")
        nodes->selectNodes({{s.id, 1}});
    return grab;
}

bool hasNewPoints(const Stroke &stroke)
{
    return std::any_of(stroke.segments.begin(), stroke.segments.end(), isPoint);
}

} // namespace

/// What `grabOf` knows.
constexpr const char *gestures[] = {"brush",  "extend", "move",  "band",   "scale",      "turn",       "node",
                                    "handle", "curve",  "shape", "pen",    "lasso",  "bucket", "knife", "eraser", "attributes", "eyedropper", "assistant", "hand"};

class TestBadUse : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void aDragThatIsBroken_data()
    {
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("how");
        for (const char *what : gestures)
            for (const char *how : {"undo", "redo", "escape", "delete", "new", "open"})
                QTest::addRow("%s, %s", what, how) << what << how;
    }
    void aDragThatIsBroken();
    void aToolChosenDuringADragWaits_data()
    {
        QTest::addColumn<QString>("what");
        for (const char *what : gestures)
            QTest::newRow(what) << what;
    }
    void aToolChosenDuringADragWaits();
    void editsWhileAPictureIsRendered();
    void nodesDroppedOntoEachOther_data();
    void nodesDroppedOntoEachOther();
    void handlesDroppedOntoNodes();
    void anotherPaintingUnderAnOpenDialog_data();
    void anotherPaintingUnderAnOpenDialog();
    void anotherPaintingUnderASelection();

private:
    QString saved();

    QTemporaryDir m_folder;
};

/// A painting of one wave in a file.
QString TestBadUse::saved()
{
    const QString path = m_folder.filePath("other.suffuse");
    Painting painting;
    painting.strokes.push_back(wave(1, 100, 100));
    return savePainting(painting, path) ? path : QString();
}

/// Whatever breaks a drag: the strokes are as they were (or those of the other painting), the stack has no step more,
/// the rest of the drag does nothing, and the next drag works.
void TestBadUse::aDragThatIsBroken()
{
    QFETCH(QString, what);
    QFETCH(QString, how);
    WaveSession s;
    const Grab grab = grabOf(s, what);
    Painting expected = s.painting();
    int steps = s.steps();
    s.drag(grab.from, grab.to, {what == "extend" ? Qt::ShiftModifier : Qt::NoModifier}, false);
    QVERIFY(s.canvas().tool()->isBusy());
    if (how == "undo")
        s.use(Command::Undo);
    else if (how == "redo")
        s.editor().undoStack().canRedo() ? s.use(Command::Redo) : s.canvas().tool()->cancel();
    else if (how == "escape")
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
    else if (how == "delete")
        s.use(Command::Delete);
    else if (how == "new")
        s.editor().newPainting(Canvas{});
    else if (const QString path = saved(); !path.isEmpty())
        QVERIFY(s.editor().open(path));
    if (how == "new" || how == "open") {
        QCOMPARE(s.painting().strokes.size(), std::size_t(how == "open"));
        expected = s.painting();
        steps = 0;
    }
    QVERIFY(!s.editor().document().draft());
    QVERIFY(s.painting() == expected);
    QCOMPARE(s.steps(), steps);
    s.move(grab.to + Point{10, 10});
    QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at(grab.to + Point{10, 10}));
    QVERIFY(s.painting() == expected);
    QCOMPARE(s.steps(), steps);
    QVERIFY(!s.canvas().tool()->isBusy());
    s.use(Command::Brush);
    s.drag({100, 100}, {200, 120});
    QCOMPARE(s.painting().strokes.size(), expected.strokes.size() + 1);
}

/// The drag goes on to its end, one step at most; then the other tool is there.
void TestBadUse::aToolChosenDuringADragWaits()
{
    QFETCH(QString, what);
    WaveSession s;
    const Grab grab = grabOf(s, what);
    const Painting before = s.painting();
    const int steps = s.steps();
    s.drag(grab.from, grab.to, {what == "extend" ? Qt::ShiftModifier : Qt::NoModifier}, false);
    const Tool *tool = s.canvas().tool();
    s.use(grab.tool == Command::Pan ? Command::Brush : Command::Pan);
    QCOMPARE(s.canvas().tool(), tool);
    s.move(grab.to + Point{10, 10});
    QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at(grab.to + Point{10, 10}));
    QVERIFY(s.canvas().tool() != tool);
    QVERIFY(!s.canvas().tool()->isBusy());
    QVERIFY(s.steps() <= steps + 1);
    s.editor().undoStack().setIndex(steps);
    QVERIFY(s.painting() == before);
}

void TestBadUse::editsWhileAPictureIsRendered()
{
    std::binary_semaphore begun{0}, mayEnd{0};
    Session s([&](const RendererOptions &options) -> Result<std::unique_ptr<Renderer>> {
        RendererOptions cpu = options;
        cpu.backend = Backend::Cpu;
        return std::unique_ptr<Renderer>(std::make_unique<HeldRenderer>(std::move(*makeRenderer(cpu)), begun, mayEnd));
    });
    auto painting = std::make_shared<Painting>();
    painting->strokes = {wave(1, 100, 200), wave(2, 100, 400)};
    s.editor().document().reset(painting);
    bool hasBegun = false;
    QTRY_VERIFY_WITH_TIMEOUT(hasBegun = hasBegun || begun.try_acquire(), waitMs);
    // The picture of the first painting is in the making from here on.
    s.editor().document().setSelection({{1}, {}});
    s.use(Command::Delete);
    s.paintLine({100, 600}, {700, 650});
    s.editor().document().setSelection({{2}, {}});
    s.use(Command::FlipDown);
    s.use(Command::Undo);
    s.use(Command::Undo);
    QVERIFY(!s.canvas().isUpToDate());
    mayEnd.release();
    s.dry();
    QCOMPARE(s.painting().strokes.size(), std::size_t(1));
    Picture8 picture;
    const RenderRequest request{s.editor().document().snapshot(), s.editor().clock().time(), s.canvas().view()};
    QVERIFY((*makeRenderer({.backend = Backend::Cpu}))->render(request, picture));
    const QImage shown = s.canvas().picture();
    QCOMPARE(shown.sizeInBytes(), qsizetype(picture.argb.size() * 4));
    QVERIFY(std::equal(picture.argb.begin(), picture.argb.end(),
                       reinterpret_cast<const std::uint32_t *>(shown.constBits())));
}

void TestBadUse::nodesDroppedOntoEachOther_data()
{
    QTest::addColumn<int>("node");
    QTest::addColumn<int>("onto");
    for (const auto &[node, onto] : {std::pair{1, 0}, {1, 2}, {0, 1}, {4, 3}, {4, 0}, {2, 4}})
        QTest::addRow("%d onto %d", node, onto) << node << onto;
}

/// A node that snaps onto another of its own stroke: no segment becomes a point, the stroke stays valid, and the node
/// can be dragged away again.
void TestBadUse::nodesDroppedOntoEachOther()
{
    QFETCH(int, node);
    QFETCH(int, onto);
    WaveSession s;
    s.use(Command::Segments);
    s.canvas().setAids({.snapToNodes = true});
    const Stroke before = s.stroke();
    const Point target = nodePosition(before, onto);
    s.drag(nodePosition(before, node), target + Point{2, 1});
    QCOMPARE(problemOf(s.painting()), QString());
    QVERIFY(!hasNewPoints(s.stroke()));
    QCOMPARE(nodeCount(s.stroke()), nodeCount(before));
    QVERIFY2(length(nodePosition(s.stroke(), node) - target) < 1e-3, "it did not snap");
    // Its handles come along to the neighbour, too.
    for (const bool after : {false, true})
        if (const std::optional<Point> handle = handlePosition(s.stroke(), node, after)) {
            s.drag(*handle, target);
            QCOMPARE(problemOf(s.painting()), QString());
            QVERIFY(!hasNewPoints(s.stroke()));
        }
    const Point away = target + Point{40, 130};
    s.canvas().setAids({});
    s.drag(nodePosition(s.stroke(), node), away);
    QCOMPARE(problemOf(s.painting()), QString());
    const int steps = s.steps();
    for (int i = 1; i < steps; ++i)
        s.use(Command::Undo);
    QVERIFY(s.stroke() == before);
}

/// Both handles of a segment on its ends, then all of it in one place but for a hair.
void TestBadUse::handlesDroppedOntoNodes()
{
    WaveSession s;
    s.use(Command::Segments);
    auto &tool = *qobject_cast<NodeTool *>(s.canvas().tool());
    tool.selectNodes({{s.id, 1}, {s.id, 2}});
    const auto drop = [&](int node, bool after, Point to) {
        s.drag(*handlePosition(s.stroke(), node, after), to, Qt::ShiftModifier);
        QCOMPARE(problemOf(s.painting()), QString());
        QVERIFY(!hasNewPoints(s.stroke()));
    };
    drop(1, true, nodePosition(s.stroke(), 1));
    drop(2, false, nodePosition(s.stroke(), 2));
    tool.selectNodes({{s.id, 2}});
    s.canvas().setAids({.snapToNodes = true});
    s.drag(nodePosition(s.stroke(), 2), nodePosition(s.stroke(), 1));
    QCOMPARE(problemOf(s.painting()), QString());
    QVERIFY(!hasNewPoints(s.stroke()));
    s.use(Command::NodeSmooth);
    s.use(Command::NodeSymmetric);
    s.use(Command::InsertNodes);
    s.use(Command::Delete);
    QCOMPARE(problemOf(s.painting()), QString());
    s.dry();
}

void TestBadUse::anotherPaintingUnderAnOpenDialog_data()
{
    QTest::addColumn<bool>("opens");
    QTest::newRow("new") << false;
    QTest::newRow("open") << true;
}

/// "Along the Stroke", in mid-drag, when the window's painting is replaced.
void TestBadUse::anotherPaintingUnderAnOpenDialog()
{
    QFETCH(bool, opens);
    WaveSession s;
    auto *inspector = s.window.findChild<InspectorPanel *>();
    inspector->alongButton()->click();
    QPointer<AlongDialog> dialog = inspector->along();
    QVERIFY(dialog);
    dialog->choose(AlongDialog::Constant);
    const auto at = [&](double share) { return dialog->curve()->toWidget({0.5, share}).toPoint(); };
    QTest::mousePress(dialog->curve(), Qt::LeftButton, {}, at(0.5));
    QTest::mouseMove(dialog->curve(), at(0.9));
    QCOMPARE(s.editor().undoText(), QString("Change along the stroke")); // it is not decided yet
    if (opens)
        QVERIFY(s.editor().open(saved()));
    else
        s.editor().newPainting(Canvas{});
    const Painting expected = s.painting();
    if (dialog) {
        QTest::mouseMove(dialog->curve(), at(0.2));
        QTest::mouseRelease(dialog->curve(), Qt::LeftButton, {}, at(0.2));
    }
    QTRY_VERIFY(!dialog);
    QVERIFY(s.painting() == expected);
    QCOMPARE(s.steps(), 0);
}

/// Strokes of the other painting have the same ids: nothing of the old selection may mean them.
void TestBadUse::anotherPaintingUnderASelection()
{
    WaveSession s;
    s.addWave(200, 450, true);
    s.use(Command::Segments);
    auto &tool = *qobject_cast<NodeTool *>(s.canvas().tool());
    tool.selectNodes({{s.id + 1, 0}, {s.id + 1, 4}});
    QVERIFY(s.editor().open(saved()));
    const Painting expected = s.painting();
    QVERIFY(s.selection().isEmpty());
    QVERIFY(tool.nodes().empty());
    for (const Command command : {Command::Delete, Command::NodeCorner, Command::BreakNodes, Command::ReverseStrokes,
                                  Command::Duplicate, Command::FlipAcross, Command::GroupStrokes})
        s.use(command);
    QTest::keyClick(&s.canvas(), Qt::Key_Right);
    QVERIFY(s.painting() == expected);
    QCOMPARE(s.steps(), 0);
}

QTEST_MAIN(TestBadUse)
#include "test_bad_use.moc"

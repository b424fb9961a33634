// Random tool events and actions on the real window: after each round, undoing all gives the first painting back and
// redoing all the last one, every stroke is valid, and what was redrawn in parts is what is drawn as a whole.
// SUFFUSE_MONKEY_EVENTS and SUFFUSE_MONKEY_SEED ask for more or other events; SUFFUSE_LONG for 50,000;
// SUFFUSE_MONKEY_COUNTS says how often each was made, and which undo steps came of them.
#include "model/painting/validate.h"
#include "render/backends.h"
#include "tests/app/monkey.h"
#include "tests/app/shapes.h"
#include "tests/trials.h"
#include "undo/fill_edits.h"

#include <QTemporaryDir>

using namespace suffuse;

namespace {

constexpr int roundEvents = 500;
constexpr int checkEvery = 100;
constexpr std::size_t mostSegments = 3000; ///< a painting that has grown larger ends its round

/// A few strokes, some grouped, filled, locked or hidden.
PaintingPtr startingPainting(Monkey &monkey)
{
    auto painting = std::make_shared<Painting>();
    painting->canvas.width = 600;
    painting->canvas.height = 400;
    painting->groups = {{1, "outer", 0, true, false}, {2, "inner", 1, true, false}};
    for (int i = 1; i <= 9; ++i) {
        Stroke stroke = *wave(StrokeId(i), monkey.real(0, 200), monkey.real(20, 350));
        stroke.group = i > 6 ? 0 : i > 3 ? 1 : i > 1 ? 2 : 0;
        stroke.locked = i == 8;
        stroke.visible = i != 9;
        stroke.style.kind = StyleKind(i % 3);
        stroke.style.xi = i % 3 == 2 ? std::array{0.4f, 0.2f, 0.5f} : std::array{0.4f, 1.0f, 0.0f};
        if (i % 4 == 0)
            stroke.segments.front().anisotropyRatio = 4;
        if (i % 3 == 1) {
            Fill fill = usualFill(stroke);
            if (i % 2 == 0)
                fill.gradient = Gradient{{0, 0}, {90, 40}, {0.2f, 0.8f, 0, 0.5f}};
            stroke.fill = fill;
        }
        painting->strokes.push_back(std::make_shared<const Stroke>(std::move(stroke)));
    }
    return painting;
}

/// A small picture that is redrawn in parts, beside one that is drawn as a whole each time.
class PictureCheck {
public:
    PictureCheck()
    {
        m_parts = std::move(*makeRenderer({.backend = Backend::Cpu, .threads = 1}));
        m_whole = std::move(*makeRenderer({.backend = Backend::Cpu, .threads = 1}));
    }
    bool isSame(const PaintingPtr &painting, Microseconds time)
    {
        const RenderRequest request{painting, time, View::ofArea(Rect::of(0, 0, 600, 400), 96, 64)};
        m_whole->invalidate();
        return m_parts->render(request, m_inParts) && m_whole->render(request, m_atOnce) &&
               m_inParts.argb == m_atOnce.argb;
    }

private:
    std::unique_ptr<Renderer> m_parts, m_whole;
    Picture8 m_inParts, m_atOnce;
};

int wantedEvents()
{
    const int asked = qEnvironmentVariableIntValue("SUFFUSE_MONKEY_EVENTS");
    return asked > 0 ? asked : isLongRun() ? 50'000 : 1'500;
}

} // namespace

class TestMonkey : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }
    void undoAllGivesTheFirstPaintingBack();

private:
    QTemporaryDir m_folder;
};

void TestMonkey::undoAllGivesTheFirstPaintingBack()
{
    const int seed = std::max(1, qEnvironmentVariableIntValue("SUFFUSE_MONKEY_SEED"));
    const int events = wantedEvents();
    Session s;
    s.window.resize(900, 700);
    Monkey monkey(s, unsigned(seed));
    PictureCheck picture;
    QUndoStack &stack = s.editor().undoStack();
    int steps = 0;
    connect(&stack, &QUndoStack::indexChanged, this, [&, last = 0](int index) mutable {
        if (index > last) { // done or redone
            ++steps;
            monkey.count(QStringLiteral("step: ") + stack.text(index - 1));
        }
        last = index;
    });
    for (int done = 0; done < events;) {
        stack.clear(); // the document is replaced under whatever is in hand
        s.editor().document().reset(startingPainting(monkey));
        s.editor().clock().setTime(s.painting().end());
        const QByteArray first = hashOf(s.painting());
        for (int i = 0; i < roundEvents && done < events && s.painting().segmentCount() < mostSegments; ++i, ++done) {
            monkey.act();
            if (done % checkEvery != 0)
                continue;
            const QString problem = problemOf(s.painting());
            QVERIFY2(problem.isEmpty(), qPrintable(problem + '\n' + monkey.trail()));
            QVERIFY2(picture.isSame(s.editor().document().snapshot(), s.editor().clock().time()),
                     qPrintable(monkey.trail()));
        }
        const bool inHand = s.canvas().tool()->isBusy(); // sometimes it goes on into the next round
        if (!inHand || monkey.below(2) == 0)
            monkey.letGo();
        else
            s.canvas().tool()->cancel();
        // A dialog that is still open holds a gesture, which the stack's own undo would have given up.
        s.editor().commit();
        const QByteArray last = hashOf(s.painting());
        const int index = stack.index();
        stack.setIndex(0);
        QVERIFY2(hashOf(s.painting()) == first, qPrintable(QStringLiteral("event %1\n").arg(done) + monkey.trail()));
        stack.setIndex(stack.count());
        QCOMPARE(problemOf(s.painting()), QString());
        stack.setIndex(index);
        QVERIFY2(hashOf(s.painting()) == last, qPrintable(QStringLiteral("event %1\n").arg(done) + monkey.trail()));
    }
    monkey.letGo();
    qInfo("%d events, %d undo steps", events, steps);
    if (qEnvironmentVariableIsSet("SUFFUSE_MONKEY_COUNTS"))
        qInfo().noquote() << monkey.counts();
    QVERIFY(steps > events / 20);
}

int main(int argc, char **argv)
{
    QApplication app(argc, argv);
    TestMonkey test;
    return QTest::qExec(&test, argc, argv);
}

#include "test_monkey.moc"

// Exact frames put nothing on the board but what belongs to the view that is shown.
#include "app/session/frames/coarse_frames.h"
#include "app/session/frames/exact_frames.h"
#include "render/backends.h"

#include <QTest>

using namespace suffuse;

namespace {

/// The CPU's renderer; while `givesUp`, it says of a finished picture that it was cancelled.
class GivingUp : public Renderer {
public:
    explicit GivingUp(const bool &givesUp) : m_givesUp(givesUp) {}

    Backend backend() const override { return Backend::Cpu; }
    QString deviceName() const override { return m_cpu->deviceName(); }
    Result<RenderStats> render(const RenderRequest &request, Target &target, const std::atomic<bool> *cancel) override
    {
        Result<RenderStats> stats = m_cpu->render(request, target, cancel);
        if (stats)
            stats->cancelled = m_givesUp;
        return stats;
    }
    void invalidate() override { m_cpu->invalidate(); }

private:
    const bool &m_givesUp;
    std::unique_ptr<Renderer> m_cpu = std::move(*makeRenderer({.backend = Backend::Cpu, .threads = 1}));
};

FrameTask taskOf(int width, int height)
{
    auto painting = std::make_shared<Painting>();
    FrameTask task{.kind = FrameTask::Kind::Exact};
    task.job.request.painting = std::move(painting);
    task.job.request.view = View::ofArea(Rect::of(0, 0, width, height), width, height);
    task.job.serial = 1;
    return task;
}

/// What the presenters would send to the screen lies in the picture that is shown.
bool liesInPicture(FrameBoard &board)
{
    bool lies = true;
    board.with([&](ShownFrame &shown) {
        for (const PixelRect &r : shown.dirty)
            lies &= r.x >= 0 && r.y >= 0 && r.x + r.width <= shown.width() && r.y + r.height <= shown.height();
        shown.dirty.clear();
    });
    return lies;
}

} // namespace

class TestExactFrames : public QObject {
    Q_OBJECT

private slots:
    /// A window that was large for a moment, until its frame was given up, leaves nothing behind.
    void whatWasGivenUpBelongsToItsView()
    {
        bool givesUp = false;
        FrameBoard board;
        ExactFrames exact(
            {},
            [&](const RendererOptions &) -> Result<std::unique_ptr<Renderer>> {
                return std::unique_ptr<Renderer>(std::make_unique<GivingUp>(givesUp));
            },
            board);
        FrameInfo frame;
        QCOMPARE(exact.show(taskOf(90, 60), nullptr, frame).outcome, FrameOutcome::Done);
        QVERIFY(liesInPicture(board));
        givesUp = true;
        QCOMPARE(exact.show(taskOf(200, 150), nullptr, frame).outcome, FrameOutcome::Cancelled);
        givesUp = false;
        QCOMPARE(exact.show(taskOf(90, 60), nullptr, frame).outcome, FrameOutcome::Done);
        QVERIFY(liesInPicture(board));
    }

    /// Nor do coarse frames of views that moved on.
    void patchesBelongToTheirView()
    {
        FrameBoard board;
        const RendererOptions options{.backend = Backend::Cpu, .threads = 1};
        ExactFrames exact(options, makeRenderer, board);
        CoarseFrames coarse(options, makeRenderer);
        FrameInfo frame;
        const auto moveTo = [&](int width, int height) {
            FrameTask task = taskOf(width, height);
            task.kind = FrameTask::Kind::Coarse;
            task.before = taskOf(10, 10).job.request;
            return coarse.show(task, board, frame).outcome;
        };
        QCOMPARE(exact.show(taskOf(200, 150), nullptr, frame).outcome, FrameOutcome::Done);
        QCOMPARE(moveTo(200, 150), FrameOutcome::Done);
        board.with([](ShownFrame &shown) { shown.picture.resize(90, 60); }); // as a frame of a smaller window does
        QCOMPARE(moveTo(90, 60), FrameOutcome::Done);
        for (const PixelRect &r : board.takePatches())
            QVERIFY(r.x + r.width <= 90 && r.y + r.height <= 60);
    }
};

QTEST_GUILESS_MAIN(TestExactFrames)
#include "test_exact_frames.moc"

#include "render/bench/measure.h"

#include "model/formats/files.h"
#include "render/bench/generator.h"
#include "render/elapsed.h"
#include "render/threads/parallel.h"

#include <QCoreApplication>
#include <QTemporaryDir>

#include <algorithm>

namespace suffuse::bench {

namespace {

Error stopped()
{
    return Error{QCoreApplication::translate("Bench", "stopped before all was measured")};
}

/// A target as the canvas has it: the picture stays on the device if possible, and comes to memory otherwise.
class CanvasPicture : public Picture8 {
public:
    bool takesDeviceFrames() const override { return true; }
};

/// One renderer with the picture that it keeps up to date, as a window has it.
class Session {
public:
    static Result<Session> make(const Job &job)
    {
        Result<std::unique_ptr<Renderer>> renderer = job.make(job.renderer);
        if (!renderer)
            return Error{renderer.error()};
        return Session(job, std::move(*renderer));
    }
    Result<RenderStats> draw(PaintingPtr painting, Microseconds time, bool interactive = false)
    {
        return draw(std::move(painting), time, m_job->view, interactive);
    }
    Result<RenderStats> draw(PaintingPtr painting, Microseconds time, const View &view, bool interactive = false)
    {
        RenderRequest request;
        request.painting = std::move(painting);
        request.time = time;
        request.view = view;
        request.interactive = interactive;
        Result<RenderStats> stats = m_renderer->render(request, *m_picture, m_job->cancel);
        if (stats && stats->cancelled)
            return stopped();
        if (m_job->renderer.backend == Backend::Cuda && !m_renderer->notice().isEmpty())
            return Error{m_renderer->notice()};
        if (stats && stats->frame)
            if (const Result<void> published = stats->frame->publish(stats->dirty); !published)
                return Error{published.error()};
        return stats;
    }
    Result<RenderStats> draw() { return draw(m_job->painting, m_job->time); }
    Renderer &renderer() { return *m_renderer; }

private:
    Session(const Job &job, std::unique_ptr<Renderer> renderer)
        : m_job(&job), m_renderer(std::move(renderer)), m_picture(std::make_unique<CanvasPicture>())
    {}
    const Job *m_job;
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<CanvasPicture> m_picture;
};

/// The time for sorting and pixels; on a device it is measured by its own clock.
double fullRenderMs(const RenderStats &stats)
{
    return stats.deviceMs > 0 ? stats.deviceMs : stats.binningMs + stats.tilesMs;
}

/// The painting with a factor on the density of a stroke's segments [from, to), made by an edit as the document does
/// it.
PaintingPtr withDensity(const Painting &painting, int index, std::size_t from, std::size_t to, float factor)
{
    Painting out = painting;
    StrokePtr &place = out.strokes[std::size_t(index)];
    Stroke stroke = *place;
    for (std::size_t i = from; i < to; ++i)
        stroke.segments[i].density *= factor;
    place = std::make_shared<const Stroke>(std::move(stroke));
    return std::make_shared<const Painting>(std::move(out));
}

/// The painting with the node between the first two segments of a stroke moved.
PaintingPtr withNode(const Painting &painting, int index, Offset by)
{
    Painting out = painting;
    StrokePtr &place = out.strokes[std::size_t(index)];
    Stroke stroke = *place;
    Offset &node = stroke.segments[1].bezier[0];
    node = stroke.segments[0].bezier[3] = {node.x + by.x, node.y + by.y};
    place = std::make_shared<const Stroke>(std::move(stroke));
    return std::make_shared<const Painting>(std::move(out));
}

/// Measures frames of paintings that come from each other by edit(painting, step).
template <class Edit>
Result<Timing> measureFrames(const Job &job, Edit edit)
{
    Result<Session> session = Session::make(job);
    if (!session)
        return Error{session.error()};
    if (const Result<RenderStats> drawn = session->draw(); !drawn)
        return Error{drawn.error()};
    std::vector<double> times;
    PaintingPtr before = job.painting; // It is freed outside of the measured time, as the editor's worker does.
    for (int step = 0; step < job.dragSteps; ++step) {
        QElapsedTimer timer;
        timer.start();
        PaintingPtr after = edit(*before, step);
        const Result<RenderStats> drawn = session->draw(after, job.time, true);
        times.push_back(milliseconds(timer));
        if (!drawn)
            return Error{drawn.error()};
        before = std::move(after);
    }
    return timingOf(times);
}

/// Measures frames in which the density of a stroke's segments [from, to) changes.
Result<Timing> measureEdits(const Job &job, int index, std::size_t from, std::size_t to)
{
    return measureFrames(job, [=](const Painting &before, int step) {
        return withDensity(before, index, from, to, step % 2 == 0 ? 1.03f : 0.98f);
    });
}

Error nothingToDrag()
{
    return Error{QCoreApplication::translate("Bench", "there is no stroke to drag in this painting")};
}

} // namespace

Job jobOf(PaintingPtr painting, int width, const RendererOptions &renderer, MakeRenderer make)
{
    Job job;
    const Rect area = painting->canvas.area();
    job.view = View::ofArea(area, width, std::max(1, heightForWidth(area, width)));
    job.time = painting->end();
    job.painting = std::move(painting);
    job.renderer = renderer;
    job.make = std::move(make);
    return job;
}

Result<StageTimings> measureStages(const Job &job)
{
    std::vector<double> nodes, first, binning, full;
    bool onDevice = false;
    for (int run = 0; run < job.runs; ++run) {
        Result<Session> session = Session::make(job);
        if (!session)
            return Error{session.error()};
        const Result<RenderStats> fresh = session->draw();
        if (!fresh)
            return Error{fresh.error()};
        session->renderer().invalidate();
        const Result<RenderStats> again = session->draw();
        if (!again)
            return Error{again.error()};
        nodes.push_back(fresh->nodesMs);
        first.push_back(fresh->totalMs);
        binning.push_back(again->binningMs);
        full.push_back(fullRenderMs(*again));
        onDevice = again->deviceMs > 0;
    }
    StageTimings out{timingOf(nodes), timingOf(binning), timingOf(full), timingOf(first)};
    if (onDevice) { // The clock rate of a device rises with use.
        const Result<Timing> warm = measureFullRender(job);
        if (!warm)
            return Error{warm.error()};
        out.fullRender = *warm;
    }
    return out;
}

Result<Timing> measureFullRender(const Job &job)
{
    Result<Session> session = Session::make(job);
    if (!session)
        return Error{session.error()};
    constexpr int warmUps = 3;
    std::vector<double> times;
    for (int run = -warmUps; run < job.runs; ++run) {
        session->renderer().invalidate();
        const Result<RenderStats> drawn = session->draw();
        if (!drawn)
            return Error{drawn.error()};
        if (run >= 0)
            times.push_back(fullRenderMs(*drawn));
    }
    return timingOf(times);
}

Result<Timing> measureZoom(const Job &job)
{
    Result<Session> session = Session::make(job);
    if (!session)
        return Error{session.error()};
    View other = job.view;
    other.scale *= 2;
    constexpr int warmUps = 2;
    std::vector<double> times;
    for (int run = -warmUps; run < job.runs; ++run) {
        if (const Result<RenderStats> away = session->draw(job.painting, job.time, other); !away)
            return Error{away.error()};
        const Result<RenderStats> back = session->draw();
        if (!back)
            return Error{back.error()};
        if (run >= 0)
            times.push_back(back->totalMs);
    }
    return timingOf(times);
}

Result<Timing> measureOpen(const Job &job)
{
    const QTemporaryDir folder;
    if (!folder.isValid())
        return Error{QCoreApplication::translate("Bench", "no temporary folder can be made: %1. Set TMPDIR to a "
                                                          "folder that can be written.")
                         .arg(folder.errorString())};
    const QString path = folder.filePath(QStringLiteral("bench.suffuse"));
    if (const Result<void> saved = savePainting(*job.painting, path); !saved)
        return Error{saved.error()};
    std::vector<double> times;
    for (int run = 0; run <= job.runs; ++run) {
        QElapsedTimer timer;
        timer.start();
        Result<Painting> painting = loadPainting(path);
        if (!painting)
            return Error{painting.error()};
        Result<Session> session = Session::make(job);
        if (!session)
            return Error{session.error()};
        const Result<RenderStats> drawn =
            session->draw(std::make_shared<const Painting>(std::move(*painting)), job.time);
        if (!drawn)
            return Error{drawn.error()};
        if (run > 0) // The first run warms the caches.
            times.push_back(milliseconds(timer));
    }
    return timingOf(times);
}

Result<Timing> measureDrag(const Job &job, StrokeId stroke)
{
    const int index = job.painting->indexOf(stroke);
    if (index < 0)
        return nothingToDrag();
    return measureEdits(job, index, 0, job.painting->strokes[std::size_t(index)]->segments.size());
}

Result<Timing> measureSegmentEdit(const Job &job, StrokeId stroke)
{
    const int index = job.painting->indexOf(stroke);
    if (index < 0)
        return nothingToDrag();
    const std::size_t middle = job.painting->strokes[std::size_t(index)]->segments.size() / 2;
    return measureEdits(job, index, middle, middle + 1);
}

Result<Timing> measureNodeDrag(const Job &job, StrokeId stroke)
{
    const int index = job.painting->indexOf(stroke);
    if (index < 0 || job.painting->strokes[std::size_t(index)]->segments.size() < 2)
        return nothingToDrag();
    return measureFrames(job, [=](const Painting &before, int step) {
        constexpr float by = 0.75f;
        const float along[4] = {by, by, -by, -by}, down[4] = {by, -by, -by, by};
        return withNode(before, index, {along[step % 4], down[step % 4]});
    });
}

Result<Timing> measureLiveStroke(const Job &job, double spread, int end, float maxAge)
{
    const int begin = end - 140;
    Result<Session> session = Session::make(job);
    if (!session)
        return Error{session.error()};
    const Microseconds start = job.painting->end() + 1'000'000;
    if (const Result<RenderStats> drawn = session->draw(job.painting, start); !drawn)
        return Error{drawn.error()};
    std::vector<double> times;
    const StrokeId id = job.painting->nextStrokeId();
    PaintingPtr before;
    for (int segments = begin; segments <= end; ++segments) {
        const Microseconds now = start + Microseconds(segments) * 1'000'000 / 60;
        Stroke live = makeLiveStroke(job.painting->canvas, spread, segments, id, start);
        for (Segment &s : live.segments) {
            s.maxAge = maxAge;
            s.diffusion /= maxAge; // It is so wide when it has dried.
        }
        auto stroke = std::make_shared<const Stroke>(std::move(live));
        QElapsedTimer timer;
        timer.start();
        Painting painting = *job.painting;
        painting.strokes.push_back(std::move(stroke));
        PaintingPtr after = std::make_shared<const Painting>(std::move(painting));
        const Result<RenderStats> drawn = session->draw(after, now);
        if (segments > begin) // The first frame draws all of the stroke.
            times.push_back(milliseconds(timer));
        if (!drawn)
            return Error{drawn.error()};
        before = std::move(after);
    }
    return timingOf(times);
}

Result<Timing> measureGroupOpacity(const Job &job, GroupId group)
{
    return measureFrames(job, [=](const Painting &before, int step) {
        Painting after = before;
        std::ranges::find(after.groups, group, &Group::id)->opacity = step % 2 == 0 ? 0.75f : 0.625f;
        return std::make_shared<const Painting>(std::move(after));
    });
}

StrokePtr middleStroke(const Painting &painting)
{
    std::vector<StrokePtr> visible;
    const Visibility isVisible(painting.groups);
    for (const StrokePtr &s : painting.strokes)
        if (isVisible(*s))
            visible.push_back(s);
    if (visible.empty())
        return nullptr;
    const std::size_t middle = visible.size() / 2, from = middle - std::min<std::size_t>(middle, 5);
    const std::size_t to = std::min(visible.size(), middle + 5);
    std::vector<StrokePtr> ten(visible.begin() + std::ptrdiff_t(from), visible.begin() + std::ptrdiff_t(to));
    std::stable_sort(ten.begin(), ten.end(),
                     [](const StrokePtr &a, const StrokePtr &b) { return a->segments.size() < b->segments.size(); });
    return ten[ten.size() / 2];
}

Painting amongOthers(const Painting &painting, const StrokePtr &stroke, std::size_t count)
{
    Painting out;
    out.canvas = painting.canvas;
    out.strokes = repeatedStrokes(painting, count, 2);
    Stroke dragged = *stroke;
    dragged.id = 1;
    dragged.group = 0;
    out.strokes.insert(out.strokes.begin() + std::ptrdiff_t(out.strokes.size() / 2),
                       std::make_shared<const Stroke>(std::move(dragged)));
    return out;
}

Painting inLayers(Painting painting, std::size_t groups, bool clips)
{
    const std::size_t count = painting.strokes.size();
    painting.groups.clear();
    for (std::size_t g = 0; g < groups; ++g) {
        Group group;
        group.id = g + 1;
        group.blend = BlendMode(g % std::size_t(BlendMode::DestinationIn));
        group.opacity = g % 3 == 0 ? 0.5f : 1;
        group.isolated = true;
        group.clips = clips && g > 0 && g % 3 == 0;
        painting.groups.push_back(group);
    }
    for (std::size_t i = 0; i < count; ++i) {
        Stroke stroke = *painting.strokes[i];
        stroke.group = 1 + i * groups / count;
        painting.strokes[i] = std::make_shared<const Stroke>(std::move(stroke));
    }
    return painting;
}

Result<Row> rowFor(const Job &job, const QString &name, const QString &paintingName)
{
    const Result<std::unique_ptr<Renderer>> renderer = job.make(job.renderer);
    if (!renderer)
        return Error{renderer.error()};
    Row row;
    row.name = name;
    row.backend = nameOf((*renderer)->backend());
    row.device = (*renderer)->deviceName();
    row.painting = paintingName;
    row.width = job.view.width;
    row.height = job.view.height;
    row.threads = Threads(job.renderer.threads).count();
    return row;
}

} // namespace suffuse::bench

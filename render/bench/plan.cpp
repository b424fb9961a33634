#include "render/bench/plan.h"

#include <QCoreApplication>

#include <algorithm>

namespace suffuse::bench {

namespace {

const QString growthName = QStringLiteral("growth");

/// Collects the rows of one device.
class Runner {
public:
    Runner(const Plan &plan, const RendererOptions &device, const std::function<void(const QString &)> &progress,
           std::vector<Row> &rows)
        : m_plan(plan), m_device(device), m_progress(progress), m_rows(rows)
    {}
    /// These functions return false if a figure could not be measured; `error` says why.
    bool stages(const PaintingPtr &painting, const QString &name);
    bool open(const PaintingPtr &painting);
    bool drag(const PaintingPtr &painting);
    bool layers(const Painting &painting, const StrokePtr &stroke, const QString &fewName, double few);
    bool liveStroke(const PaintingPtr &painting);
    bool growth(const PaintingPtr &painting);
    const QString &error() const { return m_error; }

private:
    bool wanted(const QString &name) const { return m_plan.only.isEmpty() || m_plan.only.contains(name); }
    Job job(const PaintingPtr &painting, int width, int threads) const
    {
        RendererOptions options = m_device;
        options.threads = threads;
        Job out = jobOf(painting, width, options, m_plan.make);
        out.runs = m_plan.runs;
        out.dragSteps = std::max(3 * m_plan.runs, 10);
        out.cancel = m_plan.cancel;
        return out;
    }
    Job mainJob(const PaintingPtr &painting) const
    {
        return job(painting, m_plan.widths.front(), m_plan.threads.back());
    }
    void say(const QString &name) const
    {
        if (m_progress)
            m_progress(QCoreApplication::translate("Bench", "measuring %1").arg(name));
    }
    bool add(const Job &job, const QString &name, const QString &painting, const Timing &timing);
    bool addCompared(const Job &job, const QString &name, const Timing &timing, const QString &with, double median);
    bool failed(const QString &message)
    {
        m_error = message;
        return false;
    }

    const Plan &m_plan;
    const RendererOptions m_device;
    const std::function<void(const QString &)> &m_progress;
    std::vector<Row> &m_rows;
    QString m_error;
};

bool Runner::add(const Job &job, const QString &name, const QString &painting, const Timing &timing)
{
    Result<Row> row = rowFor(job, name, painting);
    if (!row)
        return failed(row.error());
    row->timing = timing;
    m_rows.push_back(std::move(*row));
    return true;
}

bool Runner::addCompared(const Job &job, const QString &name, const Timing &timing, const QString &with, double median)
{
    const bool same = m_plan.painting || !name.startsWith(growthName);
    if (!add(job, name, same ? m_plan.name : QStringLiteral("generated"), timing))
        return false;
    if (median > 0) {
        m_rows.back().baseline = with;
        m_rows.back().ratio = timing.medianMs / median;
    }
    return true;
}

bool Runner::stages(const PaintingPtr &painting, const QString &name)
{
    static const QString full = QStringLiteral("full-render"), nodes = QStringLiteral("node-build"),
                         binning = QStringLiteral("binning"), cold = QStringLiteral("cold-render"),
                         zoom = QStringLiteral("zoom-render");
    const bool parts = wanted(full) || wanted(cold) || wanted(nodes) || wanted(binning);
    if (!parts && !wanted(zoom))
        return true;
    const bool onDevice = m_device.backend == Backend::Cuda; // On a device the number of threads hardly matters.
    const std::vector<int> threadCounts = onDevice ? std::vector{m_plan.threads.back()} : m_plan.threads;
    for (int width : m_plan.widths)
        for (int threads : threadCounts) {
            const Job j = job(painting, width, threads);
            say(QStringLiteral("%1, %2, %3×%4").arg(full, name).arg(j.view.width).arg(j.view.height));
            if (wanted(zoom)) {
                const Result<Timing> timing = measureZoom(j);
                if (!timing)
                    return failed(timing.error());
                if (!add(j, zoom, name, *timing))
                    return false;
            }
            if (!parts)
                continue;
            const Result<StageTimings> timings = measureStages(j);
            if (!timings)
                return failed(timings.error());
            if ((wanted(full) && !add(j, full, name, timings->fullRender)) ||
                (wanted(cold) && !add(j, cold, name, timings->first)) ||
                (wanted(nodes) && !add(j, nodes, name, timings->nodeBuild)) ||
                (wanted(binning) && !add(j, binning, name, timings->binning)))
                return false;
        }
    return true;
}

bool Runner::open(const PaintingPtr &painting)
{
    const QString name = QStringLiteral("open");
    if (!wanted(name))
        return true;
    say(name);
    const Job j = mainJob(painting);
    const Result<Timing> timing = measureOpen(j);
    return timing ? add(j, name, m_plan.name, *timing) : failed(timing.error());
}

bool Runner::drag(const PaintingPtr &painting)
{
    const StrokePtr stroke = middleStroke(*painting);
    if (!stroke)
        return true; // An empty painting has nothing to drag.
    for (const auto &[name, measure] :
         {std::pair(QStringLiteral("drag"), &measureDrag), {QStringLiteral("edit-segment"), &measureSegmentEdit}}) {
        if (!wanted(name))
            continue;
        say(name);
        const Job j = mainJob(painting);
        const Result<Timing> timing = measure(j, stroke->id);
        if (!timing)
            return failed(timing.error());
        if (!add(j, name, m_plan.name, *timing))
            return false;
    }
    double few = 0;
    const QString fewName = QStringLiteral("drag-among-100");
    for (int others : {100, 10'000}) {
        const QString name = QStringLiteral("drag-among-%1").arg(others);
        if (!wanted(name))
            continue;
        say(name);
        const Job j = mainJob(std::make_shared<const Painting>(amongOthers(*painting, stroke, std::size_t(others))));
        const Result<Timing> timing = measureDrag(j, 1);
        if (!timing)
            return failed(timing.error());
        if (!addCompared(j, name, *timing, fewName, few))
            return false;
        if (others == 100)
            few = timing->medianMs;
    }
    return layers(*painting, stroke, fewName, few);
}

/// The same stroke and 10,000 others in 20 groups, of which some may be clipped, and the opacity of a group that has
/// half of all.
bool Runner::layers(const Painting &painting, const StrokePtr &stroke, const QString &fewName, double few)
{
    const QString dragName = QStringLiteral("drag-in-20-layers"), clippedName = QStringLiteral("drag-in-20-clipped"),
                  opacityName = QStringLiteral("layer-opacity");
    if (!wanted(dragName) && !wanted(clippedName) && !wanted(opacityName))
        return true;
    const Painting others = amongOthers(painting, stroke, 10'000);
    for (const auto &[name, clips] : {std::pair(dragName, false), {clippedName, true}}) {
        if (!wanted(name))
            continue;
        say(name);
        const Job j = mainJob(std::make_shared<const Painting>(inLayers(others, 20, clips)));
        const Result<Timing> timing = measureDrag(j, 1);
        if (!timing)
            return failed(timing.error());
        if (!addCompared(j, name, *timing, fewName, few))
            return false;
    }
    if (!wanted(opacityName))
        return true;
    say(opacityName);
    const Job j = mainJob(std::make_shared<const Painting>(inLayers(others, 2)));
    const Result<Timing> timing = measureGroupOpacity(j, 1);
    return timing ? add(j, opacityName, m_plan.name, *timing) : failed(timing.error());
}

bool Runner::liveStroke(const PaintingPtr &painting)
{
    const double spread = 0.5 * (m_plan.generated.spreadLow + m_plan.generated.spreadHigh) * m_plan.generated.unit;
    const QString shortName = QStringLiteral("live-stroke");
    double before = 0;
    for (const auto &[name, segments] : {std::pair(shortName, 200), {QStringLiteral("live-stroke-2000"), 2000}}) {
        if (!wanted(name))
            continue;
        say(name);
        const Job j = mainJob(painting);
        const Result<Timing> timing = measureLiveStroke(j, spread, segments);
        if (!timing)
            return failed(timing.error());
        if (!addCompared(j, name, *timing, shortName, before))
            return false;
        before = timing->medianMs;
    }
    return true;
}

bool Runner::growth(const PaintingPtr &painting)
{
    QString before;
    double median = 0;
    for (int segments : m_plan.growth) {
        const QString name = QStringLiteral("growth-%1").arg(segments);
        if (!wanted(name) && !wanted(growthName))
            continue;
        say(name);
        PaintingOptions o = m_plan.generated;
        o.strokes = std::max(1, segments / 23);
        o.segments = segments;
        Painting grown = m_plan.painting ? repeatedPainting(*painting, std::size_t(segments)) : makePainting(o);
        Job j = mainJob(std::make_shared<const Painting>(std::move(grown)));
        if (segments >= 500'000)
            j.runs = std::min(j.runs, 3);
        const Result<StageTimings> timings = measureStages(j);
        if (!timings)
            return failed(timings.error());
        if (!addCompared(j, name, timings->fullRender, before, median))
            return false;
        before = name;
        median = timings->fullRender.medianMs;
    }
    return true;
}

} // namespace

QStringList rowNames()
{
    return {"full-render",
            "cold-render",
            "zoom-render",
            "node-build",
            "binning",
            "open",
            "drag",
            "edit-segment",
            "drag-among-100",
            "drag-among-10000",
            "drag-in-20-layers",
            "drag-in-20-clipped",
            "layer-opacity",
            "live-stroke",
            "live-stroke-2000",
            growthName};
}

Result<std::vector<Row>> run(const Plan &plan, const std::function<void(const QString &)> &progress)
{
    std::vector<Row> rows;
    const PaintingPtr painting =
        plan.painting ? plan.painting : std::make_shared<const Painting>(makePainting(plan.generated));
    for (const RendererOptions &device : plan.devices) {
        Runner runner(plan, device, progress, rows);
        bool good = runner.stages(painting, plan.name) && runner.open(painting) && runner.drag(painting) &&
                    runner.liveStroke(painting) && runner.growth(painting);
        for (const Table2Size &size : table2()) {
            if (!good || !plan.table2 || QLatin1String(size.name) == plan.name)
                continue;
            PaintingOptions options = plan.generated;
            options.strokes = size.strokes;
            options.segments = size.segments;
            good = runner.stages(std::make_shared<const Painting>(makePainting(options)), QLatin1String(size.name));
        }
        if (!good)
            return Error{runner.error()};
    }
    return rows;
}

} // namespace suffuse::bench

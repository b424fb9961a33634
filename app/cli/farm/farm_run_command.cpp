#include "app/cli/farm/farm_claim.h"
#include "app/cli/farm/farm_commands.h"
#include "app/cli/progress.h"
#include "model/document/timelapse.h"
#include "model/environment.h"
#include "render/backends.h"
#include "render/sequence.h"
#include "render/tiles/render_tiles.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>

#include <algorithm>
#include <atomic>
#include <functional>

namespace suffuse::cli {

namespace {

/// The pieces of task i of n: neighbours, which have most in common.
struct Share {
    qint64 from = 0, to = 0;
};

Result<Share> shareOf(const QString &task, qint64 pieces)
{
    const QStringList parts = task.split('/');
    bool one = false, all = false;
    const qint64 i = parts.value(0).toLongLong(&one), n = parts.value(1).toLongLong(&all);
    if (parts.size() != 2 || !one || !all || n < 1 || i < 1 || i > n || n > 1'000'000)
        return Error{QCoreApplication::translate("Cli", "--task %1: give i/n, e.g. 3/8, from 1/8 to 8/8").arg(task)};
    const auto border = [&](qint64 k) { return qint64(double(pieces) / double(n) * double(k)); };
    return Share{border(i - 1), i == n ? pieces : border(i)};
}

Backend backendOf(const QJsonObject &by)
{
    for (const Backend backend : {Backend::Cpu, Backend::Cuda, Backend::Reference})
        if (by["backend"].toString() == nameOf(backend))
            return backend;
    return Backend::Auto;
}

/// Has the CPU compute by the instructions of the plan, where this machine knows more.
void followSimd(const QJsonObject &by)
{
    const QString device = by["device"].toString();
    if (backendOf(by) == Backend::Cpu && !environment::isSet(environment::Variable::Simd))
        environment::set(environment::Variable::Simd,
                         device == QLatin1String("AVX-512") ? std::string("AVX3") : device.toStdString());
}

/// Empty, or in what this machine differs from the plan.
QString differenceOf(const QJsonObject &plan, const QJsonObject &here)
{
    for (const char *key : {"build", "backend", "device", "encoder"})
        if (const QString a = plan[QLatin1String(key)].toString(), b = here[QLatin1String(key)].toString(); a != b)
            return QCoreApplication::translate("Cli",
                                               "the plan is for %1 \"%2\", and this machine has \"%3\", which makes "
                                               "other bits. Use the same program on all machines, or make a new plan")
                .arg(QLatin1String(key), a, b);
    return {};
}

/// One run of a task.
class FarmWork {
public:
    FarmWork(const FarmPlan &plan, FarmRecords records, const std::vector<std::unique_ptr<Renderer>> &renderers,
             int threads, const Share &share)
        : m_plan(plan), m_records(std::move(records)), m_renderers(renderers), m_threads(threads), m_share(share)
    {}

    Result<void> run()
    {
        ProgressLine progress(QCoreApplication::translate("Cli", "drawing"), true);
        for (const FarmPainting &p : m_plan.paintings) {
            const qint64 from = std::max(m_share.from, p.first), to = std::min(m_share.to, p.first + p.pieces);
            std::vector<qint64> missing;
            for (qint64 piece = from; piece < to && !interrupted(); ++piece) {
                if (isPieceWhole(m_plan, m_records, piece))
                    progress.show(++m_kept + m_drawn, m_share.to - m_share.from);
                else
                    missing.push_back(piece - p.first);
            }
            if (missing.empty())
                continue;
            if (const Result<void> opened = open(); !opened)
                return opened;
            m_progress = [&, all = m_share.to - m_share.from] { progress.show(++m_drawn + m_kept, all); };
            Result<Painting> painting = paintingOf(p.path);
            if (!painting)
                return Error{painting.error()};
            const auto whole = std::make_shared<const Painting>(std::move(*painting));
            const PaintingPtr drawn = p.tiles.drafts || p.frames.drafts ? whole : withoutDrafts(whole);
            if (hashOf(*drawn) != p.hash)
                return Error{QCoreApplication::translate("Cli",
                                                         "%1: the painting has changed since it was planned. Bring it "
                                                         "back, or make a new plan.")
                                 .arg(p.path)};
            if (const Result<void> done = p.isFrames ? drawFrames(p, drawn, missing) : drawTiles(p, drawn, missing);
                !done)
                return done;
        }
        // What is written into files that were removed is nowhere.
        const Result<FarmPlan> still = readPlan(m_plan.folder);
        if (!still || still->identity != m_plan.identity || (m_journal.isOpen() && !QFile::exists(m_journal.path())))
            return Error{QCoreApplication::translate("Cli", "%1: the folder is gone. Is the shared folder there?")
                             .arg(m_plan.folder)};
        return {};
    }
    qint64 drawn() const { return m_drawn; }
    qint64 kept() const { return m_kept; }

private:
    /// Opens files of its own, when there is something to draw: no two workers write into the same one, even if they do
    /// the same task.
    Result<void> open()
    {
        if (m_journal.isOpen())
            return {};
        const QString name = FarmPlan::workerName(m_share.from, m_share.to);
        const bool packs = std::any_of(m_plan.paintings.begin(), m_plan.paintings.end(),
                                       [](const FarmPainting &p) { return !p.isFrames && p.tiles.isTiff(); });
        if (packs)
            if (const Result<void> opened = m_pack.open(m_plan.packs() + '/' + name + QStringLiteral(".pack")); !opened)
                return opened;
        return m_journal.open(m_plan.journals() + '/' + name + QStringLiteral(".journal"), m_plan.identity);
    }

    Result<void> drawTiles(const FarmPainting &p, const PaintingPtr &painting, const std::vector<qint64> &sheets)
    {
        const TiledPicture picture = p.picture();
        TilesRequest request;
        request.picture = requestOf(painting, p.tiles);
        request.threads = m_threads;
        request.count = qint64(sheets.size());
        request.sheet = [&](qint64 i) { return sheets[std::size_t(i)]; };
        request.cancel = &interrupted();
        request.progress = [this](qint64, qint64) { m_progress(); };
        // What is missing has no records that count.
        std::unique_ptr<TileStore> store;
        if (p.tiles.isTiff())
            store = std::make_unique<PackStore>(PackRecords(), m_journal, m_pack, p.first);
        else
            store = std::make_unique<DeepZoomStore>(picture, SheetRecords(), m_journal, p.first);
        const Result<TilesStats> stats = renderTiles(m_renderers, request, picture, *store);
        return stats ? Result<void>() : Error{stats.error()};
    }

    Result<void> drawFrames(const FarmPainting &p, const PaintingPtr &painting, const std::vector<qint64> &frames)
    {
        const std::vector<Microseconds> all = timelapseMoments(*painting, {p.frames.frames, p.frames.idle});
        std::vector<Microseconds> moments;
        for (const qint64 frame : frames)
            moments.push_back(all[std::size_t(frame)]);
        RenderRequest request;
        request.painting = painting;
        request.view = View::ofArea(p.frames.area, p.frames.width, p.frames.height);
        request.transparent = p.frames.transparent;
        const auto use = [&](std::size_t i, const FloatPicture &picture) -> Result<void> {
            for (const auto &renderer : m_renderers)
                if (const QString notice = renderer->notice(); !notice.isEmpty())
                    return Error{QCoreApplication::translate("Cli",
                                                             "%1 What another backend draws has other bits, and is "
                                                             "not mixed in. Start the task again.")
                                     .arg(notice)};
            const QString path = p.frames.pathOf(frames[i]);
            const Result<QByteArray> bytes = encodeImage(imageFormatForPath(path), picture, p.frames.image(), path);
            if (!bytes)
                return Error{bytes.error()};
            if (const Result<void> written = replaceFile(path, *bytes, false); !written)
                return written;
            m_progress();
            return m_journal.add(sheetRecord(p.first + frames[i], 0, {*bytes}));
        };
        const Result<SequenceStats> stats =
            renderSequence(m_renderers, request, moments, m_threads, use, &interrupted());
        return stats ? Result<void>() : Error{stats.error()};
    }

    const FarmPlan &m_plan;
    const FarmRecords m_records;
    const std::vector<std::unique_ptr<Renderer>> &m_renderers;
    const int m_threads;
    const Share m_share;
    TileJournal m_journal;
    PackFile m_pack;
    std::function<void()> m_progress;
    std::atomic<qint64> m_drawn{0}, m_kept{0};
};

} // namespace

int farmRunCommand(const QStringList &arguments)
{
    CommandLine line("farm run",
                     QCoreApplication::translate("Cli", "Draws what is missing of a task; as often as is liked."),
                     {"FOLDER"});
    line.add({"task"}, QCoreApplication::translate("Cli", "Which part: i/n, from 1/n to n/n (default 1/1)."), "I/N");
    line.add({"devices"},
             QCoreApplication::translate("Cli", "With CUDA: GPUs that share the picture, all or a number (default 1)."),
             "N");
    line.add({"threads"}, QCoreApplication::translate("Cli", "Number of threads (default: one a core)."), "N");
    line.add({"stats"}, QCoreApplication::translate("Cli", "Prints times and counts as JSON."));
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    QElapsedTimer clock;
    clock.start();
    Result<RendererOptions> options = rendererOptions(line);
    if (!options)
        return failUsage("farm run", options.error());
    const Result<FarmPlan> plan = readPlan(line.argument(0));
    if (!plan)
        return fail(plan.error());
    if (const QString problem = problemOfClaims(*plan); !problem.isEmpty())
        return fail(problem);
    const QString task = line.isSet("task") ? line.value("task") : QStringLiteral("1/1");
    const Result<Share> share = shareOf(task, plan->pieces());
    if (!share)
        return failUsage("farm run", share.error());
    followSimd(plan->by);
    options->backend = backendOf(plan->by);
    const auto renderers = makeRenderers(*options);
    if (!renderers)
        return fail(renderers.error());
    const TileEncoding *encoding = plan->isFrames() ? nullptr : &plan->paintings.front().tiles.encoding;
    for (const auto &renderer : *renderers)
        if (const QString difference = differenceOf(plan->by, drawnBy(*renderer, encoding)); !difference.isEmpty())
            return fail(difference);
    Result<FarmRecords> records = readRecords(*plan, share->from, share->to);
    if (!records)
        return fail(records.error());
    FarmWork work(*plan, std::move(*records), *renderers, options->threads, *share);
    const double startMs = double(clock.nsecsElapsed()) * 1e-6;
    const Result<void> done = work.run();
    if (interrupted())
        return fail(
            QCoreApplication::translate("Cli", "stopped; what is finished is kept, and the same command goes on"));
    if (!done)
        return fail(done.error());
    if (line.isSet("stats"))
        return printJson({{"task", task},
                          {"pieces", share->to - share->from},
                          {"drawn", work.drawn()},
                          {"kept", work.kept()},
                          {"ms", QJsonObject{{"start", startMs}, {"total", double(clock.nsecsElapsed()) * 1e-6}}}});
    return print(QCoreApplication::translate("Cli", "task %1: %2 drawn, %3 there already")
                     .arg(task)
                     .arg(work.drawn())
                     .arg(work.kept()) +
                 '\n');
}

} // namespace suffuse::cli

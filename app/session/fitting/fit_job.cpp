#include "app/session/fitting/fit_job.h"

#include "app/session/settings/renderer_options.h"
#include "render/fitting/picture_metrics.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cmath>
#include <new>
#include <set>
#include <tuple>

namespace suffuse {

namespace {

constexpr double leastPause = 0.1; ///< s, from one picture shown to the next
/// The picture takes no more than this share of the time.
constexpr double pictureShare = 0.2;

QImage imageOf(const fitting::FitPicture &picture)
{
    QImage image(picture.width, picture.height, QImage::Format_RGB32);
    const auto byte = [](float v) { return int(std::clamp(v, 0.0f, 1.0f) * 255 + 0.5f); };
    for (int y = 0; y < picture.height; ++y) {
        auto *row = reinterpret_cast<QRgb *>(image.scanLine(y));
        for (int x = 0; x < picture.width; ++x) {
            const float *v = picture.at(x, y);
            row[x] = qRgb(byte(v[0]), byte(v[1]), byte(v[2]));
        }
    }
    return image;
}

std::size_t coloursOf(const std::vector<fitting::FitStroke> &strokes)
{
    std::set<std::tuple<double, double, double>> colours;
    for (const fitting::FitStroke &s : strokes)
        colours.emplace(s[fitting::Red], s[fitting::Yellow], s[fitting::Blue]);
    return colours.size();
}

} // namespace

FitJob::FitJob(QObject *parent) : QObject(parent) {}

FitJob::~FitJob()
{
    join();
}

void FitJob::join()
{
    m_cancel = true;
    if (m_thread.joinable())
        m_thread.join();
    m_cancel = false;
    m_running = m_isBusy = false;
    ++m_run;
    m_untold = false;
}

void FitJob::cancel()
{
    m_cancel = true;
    m_running = false;
}

void FitJob::abandon()
{
    cancel();
    m_isAbandoned = true;
    if (!m_isBusy)
        deleteLater();
}

void FitJob::setPicture(EncodedImage image, const QString &place, const QString &name)
{
    if (!image)
        return setTarget({}, name);
    setTarget(
        [image = std::move(image), place](int pixels, const std::atomic<bool> *cancel) {
            try {
                return fitting::readFitTarget(*image, place, pixels, cancel);
            } catch (const std::bad_alloc &) {
                return Result<fitting::FitTarget>(Error{tr("%1: there is not enough memory to fit it.").arg(place)});
            }
        },
        name);
}

void FitJob::setTarget(ReadTarget read, const QString &name)
{
    join();
    m_read = std::move(read);
    m_name = name;
    m_target.reset();
    m_fit.reset();
    m_original = {};
    m_news = {};
    m_size = {};
    m_seconds = 0;
}

void FitJob::start(const FitWish &wish)
{
    join();
    if (!m_read)
        return;
    m_running = m_isBusy = true;
    m_thread = std::jthread([this, wish] { run(wish); });
}

void FitJob::stop()
{
    if (!m_running)
        return;
    join();
    if (m_fit && m_target) {
        m_news.strokes = int(m_fit->strokes().strokes.size());
        m_news.seconds = m_seconds;
    }
    emit ended({});
}

void FitJob::run(const FitWish &wish)
{
    Result<void> done;
    try {
        done = work(wish);
    } catch (const std::bad_alloc &) {
        m_fit.reset();
        done = Error{tr("%1: there is not enough memory to fit it.").arg(m_name)};
    }
    QMetaObject::invokeMethod(
        this,
        [this, run = m_run, error = done ? QString() : done.error()] {
            if (run != m_run)
                return; // Whoever stopped it knows.
            m_isBusy = false;
            if (m_isAbandoned)
                deleteLater();
            if (!m_running)
                return;
            m_running = false;
            emit ended(error);
        },
        Qt::QueuedConnection);
}

/// Reads the picture, if that is to be, and makes the fit that goes on or begins.
Result<void> FitJob::prepare(const FitWish &wish)
{
    const bool isNew = !m_target || m_pixels != wish.pixels;
    std::shared_ptr<const fitting::FitTarget> target = m_target;
    if (isNew) {
        Result<fitting::FitTarget> read = m_read(wish.pixels, &m_cancel);
        if (!read)
            return Error{read.error()};
        target = std::make_shared<const fitting::FitTarget>(std::move(*read));
    }
    const double scale = target->picture.width / target->canvasWidth;
    fitting::FitOptions options;
    options.strokes = wish.strokes;
    options.steps = wish.steps;
    options.paints = wish.paints;
    options.seed = wish.seed;
    options.limits.style = wish.style;
    options.limits.leastWidth = wish.leastWidth * scale;
    options.limits.greatestWidth = wish.greatestWidth * scale;
    if (m_fit && wish == m_wish && !isNew && !m_fit->isDone()) {
        m_fit->stopWith(&m_cancel);
        return {};
    }
    if (!m_differentiator) { // A GPU takes some time to start: once for all fits.
        const Backend backend = settings::rendererOptions().backend;
        if (Result<std::unique_ptr<gradient::Differentiator>> made =
                makeDifferentiator(backend == Backend::Cpu ? Backend::Cpu : Backend::Auto, Threads()))
            m_differentiator = std::move(*made);
    }
    if (m_fit && wish.goesOnFrom(m_wish)) {
        // Strokes go to another size of the picture by way of the canvas.
        Result<fitting::FittedStrokes> start =
            isNew ? fitting::fittedStrokesOf(m_fit->painting(), *target) : m_fit->strokes();
        if (!start)
            return Error{start.error()};
        m_fit = std::make_unique<fitting::Fitting>(*target, options, std::move(*start), m_differentiator);
    } else {
        m_fit = std::make_unique<fitting::Fitting>(*target, options, m_differentiator);
        m_seconds = 0;
    }
    if (isNew)
        m_original = imageOf(target->picture);
    m_target = std::move(target);
    m_pixels = wish.pixels;
    m_wish = wish;
    m_fit->stopWith(&m_cancel);
    return {};
}

Result<void> FitJob::work(const FitWish &wish)
{
    QElapsedTimer clock;
    clock.start();
    if (const Result<void> ready = prepare(wish); !ready)
        return m_cancel ? Result<void>() : ready;
    const double begun = m_seconds;
    tell();
    double next = 0;
    const auto now = [&] { return double(clock.elapsed()) * 1e-3; };
    while (!m_cancel && m_fit->step()) {
        const double time = now();
        if (time < next || m_untold)
            continue;
        m_seconds = begun + time;
        tell();
        next = now() + std::max(leastPause, (now() - time) * (1 / pictureShare - 1));
    }
    m_seconds = begun + now();
    if (!m_cancel)
        tell();
    return {};
}

/// Draws what there is and sends it to the caller's thread.
void FitJob::tell()
{
    FitNews news;
    news.original = m_original;
    news.strokes = int(m_fit->strokes().strokes.size());
    news.progress = m_fit->progress();
    news.seconds = m_seconds;
    const fitting::FitPicture drawn = m_fit->picture();
    if (drawn.isEmpty())
        return; // It was stopped.
    news.picture = imageOf(drawn);
    news.peakRatio = fitting::peakRatio(fitting::meanSquare(drawn, m_target->picture, m_target->weight));
    m_untold = true;
    QMetaObject::invokeMethod(
        this,
        [this, run = m_run, size = QSizeF(m_target->canvasWidth, m_target->canvasHeight), news = std::move(news)] {
            if (run != m_run || !m_running)
                return;
            m_untold = false;
            m_news = news;
            m_size = size;
            emit progressed();
        },
        Qt::QueuedConnection);
}

FitResult FitJob::result() const
{
    if (m_running || !m_fit)
        return {};
    if (m_wish.paints == 0 || coloursOf(m_fit->strokes().strokes) <= std::size_t(m_wish.paints))
        return {m_fit->painting(), m_name};
    // It was stopped before it had come to its paints.
    fitting::FittedStrokes few = m_fit->strokes();
    const fitting::FitPalette palette(few.strokes, few.style, m_wish.paints, m_wish.seed);
    return {fitting::paintingOf(few, *m_target, palette.paints()), m_name};
}

} // namespace suffuse

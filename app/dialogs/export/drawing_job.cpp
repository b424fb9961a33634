#include "app/dialogs/export/drawing_job.h"

#include "model/formats/picture_links.h"
#include "render/backends.h"

#include <QFileInfo>

#include <new>

namespace suffuse {

DrawingJob::DrawingJob(QObject *parent) : QObject(parent) {}

DrawingJob::~DrawingJob()
{
    m_cancel = true;
    if (m_thread.joinable())
        m_thread.join();
}

void DrawingJob::begin(Work work)
{
    if (m_thread.joinable())
        m_thread.join();
    m_cancel = false;
    m_work = work;
}

void DrawingJob::prepare(const PaintingPtr &painting, const DrawingOptions &options)
{
    Q_ASSERT(!isWriting());
    m_ready.reset();
    m_order = {painting, options};
    m_isNew = m_work == Work::Preparing;
    if (m_isNew)
        m_cancel = true;
    else
        prepareNext();
}

void DrawingJob::prepareNext()
{
    begin(Work::Preparing);
    m_isNew = false;
    m_thread = std::jthread([this, order = m_order] {
        auto drawing = std::make_shared<Result<PreparedDrawing>>(draw(order));
        QMetaObject::invokeMethod(
            this, [this, drawing] { takePrepared(std::move(*drawing)); }, Qt::QueuedConnection);
    });
}

Result<PreparedDrawing> DrawingJob::draw(const Order &order)
{
    try {
        const auto renderer = makeRenderer({.backend = Backend::Auto, .threads = order.options.threads});
        if (!renderer)
            return Error{renderer.error()};
        DrawingOptions options = order.options;
        options.cancel = &m_cancel;
        options.progress = [this, shown = std::make_shared<std::atomic<int>>(0)](int done, int all) {
            const int now = int(1000 * qint64(done) / std::max(all, 1));
            if (shown->exchange(now) != now)
                QMetaObject::invokeMethod(
                    this, [this, now] { emit progressed(now); }, Qt::QueuedConnection);
        };
        return prepareDrawing(order.painting, options, **renderer);
    } catch (const std::bad_alloc &) {
        return Error{tr("The drawing does not fit into memory.")};
    }
}

void DrawingJob::takePrepared(Result<PreparedDrawing> drawing)
{
    m_work = Work::None;
    if (m_isNew) {
        prepareNext();
        return;
    }
    if (drawing)
        m_ready = std::move(*drawing);
    emit prepared(drawing ? QString() : drawing.error());
}

void DrawingJob::write(const QString &path, const OnPaper &sheet)
{
    Q_ASSERT(m_ready && m_work == Work::None);
    m_ready->paper = sheet.paper;
    m_ready->resolution = sheet.resolution;
    m_ready->about = sheet.about;
    begin(Work::Writing);
    m_thread = std::jthread([this, path] {
        Result<void> written;
        try {
            // Links in the painting hold from the drawing's folder.
            const Painting within = withRelativeLinks(*m_order.painting, QFileInfo(path).absolutePath());
            written = saveDrawing(*m_ready, within, path, &m_cancel);
        } catch (const std::bad_alloc &) {
            written = Error{tr("The drawing does not fit into memory.")};
        }
        QMetaObject::invokeMethod(
            this,
            [this, isWritten = bool(written), error = written || m_cancel ? QString() : written.error()] {
                m_work = Work::None;
                emit finished(isWritten, error);
            },
            Qt::QueuedConnection);
    });
}

} // namespace suffuse

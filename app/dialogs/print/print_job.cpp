#include "app/dialogs/print/print_job.h"

#include "render/backends.h"
#include "render/image_io/file_replacement.h"

#include <QDataStream>
#include <QPainter>
#include <QPdfWriter>
#include <QTemporaryFile>

#include <new>

namespace suffuse {

namespace {

/// A file that is written beside its target, as Qt's writers want it.
class ReplacingDevice : public QIODevice {
public:
    explicit ReplacingDevice(FileReplacement &file) : m_file(file)
    {
        open(QIODevice::WriteOnly | QIODevice::Unbuffered);
    }
    bool isSequential() const override { return true; }

protected:
    qint64 readData(char *, qint64) override { return -1; }
    qint64 writeData(const char *bytes, qint64 count) override
    {
        const auto written = qint64(m_file.write(bytes, std::size_t(count), m_size));
        m_size += written;
        return written == count ? count : -1;
    }

private:
    FileReplacement &m_file;
    qint64 m_size = 0;
};

/// Pieces that wait on disk until all of them are there.
class Spool {
public:
    bool open()
    {
        m_stream.setDevice(&m_file);
        return m_file.open();
    }
    void put(const QPoint &at, const QImage &piece)
    {
        constexpr int quick = 1; // of zlib: it waits for a moment only
        m_stream << at << piece.size() << qCompress(piece.constBits(), int(piece.sizeInBytes()), quick);
    }
    bool isWhole()
    {
        m_file.flush();
        return m_stream.status() == QDataStream::Ok && m_file.error() == QFileDevice::NoError;
    }
    QString problem() const { return m_file.errorString(); }
    /// Gives all of them away; false where they cannot be read again.
    bool play(const PutPiece &put, const std::function<void(int)> &progress)
    {
        const qint64 all = m_file.size();
        for (m_file.seek(0); !m_stream.atEnd();) {
            QPoint at;
            QSize size;
            QByteArray packed;
            m_stream >> at >> size >> packed;
            const QByteArray bits = qUncompress(packed);
            if (m_stream.status() != QDataStream::Ok || bits.size() != qsizetype(4) * size.width() * size.height())
                return false;
            put(at, QImage(reinterpret_cast<const uchar *>(bits.constData()), size.width(), size.height(),
                           4 * size.width(), QImage::Format_RGB32));
            progress(int(1000 * m_file.pos() / std::max<qint64>(all, 1)));
        }
        return true;
    }

private:
    QTemporaryFile m_file;
    QDataStream m_stream;
};

/// Draws pieces as they are, dot by dot. Programs that read PDF take an image which ends where a dot does for a dot
/// wider, and stretch it; so each is inset by less than anybody sees.
PutPiece onto(QPainter &painter)
{
    constexpr double inset = 1e-3; // dots
    painter.setRenderHint(QPainter::LosslessImageRendering);
    return [&painter](const QPoint &at, const QImage &piece) {
        painter.drawImage(QRectF(at, piece.size()).adjusted(inset, inset, -inset, -inset), piece);
    };
}

} // namespace

PrintJob::PrintJob(QObject *parent) : QObject(parent) {}

PrintJob::~PrintJob()
{
    m_cancel = true;
    if (m_thread.joinable())
        m_thread.join();
}

void PrintJob::begin(Work work)
{
    if (m_thread.joinable())
        m_thread.join();
    m_cancel = false;
    m_work = work;
}

void PrintJob::preview(const PageOrder &order, double dpi)
{
    Q_ASSERT(!isPrinting());
    m_look = {order, dpi};
    m_isNew = m_work == Work::Previewing;
    if (m_isNew)
        m_cancel = true;
    else
        previewNext();
}

void PrintJob::previewNext()
{
    begin(Work::Previewing);
    m_isNew = false;
    m_thread = std::jthread([this, look = m_look] {
        auto sheet = std::make_shared<Result<QImage>>(draw(look));
        QMetaObject::invokeMethod(
            this, [this, sheet] { takePreview(std::move(*sheet)); }, Qt::QueuedConnection);
    });
}

Result<QImage> PrintJob::draw(const SheetOrder &look)
{
    try {
        // A device takes longer to start than this picture takes.
        const auto renderer = makeRenderer({.backend = Backend::Cpu, .threads = look.order.threads});
        if (!renderer)
            return Error{renderer.error()};
        QImage sheet(look.order.plan.sheet(look.dpi), QImage::Format_RGB32);
        sheet.fill(Qt::white);
        QPainter painter(&sheet);
        const PutPiece put = [&painter](const QPoint &at, const QImage &piece) { painter.drawImage(at, piece); };
        const Result<void> drawn = drawPage(look.order, look.dpi, **renderer, put, m_cancel);
        return drawn ? Result<QImage>(sheet) : Error{drawn.error()};
    } catch (const std::bad_alloc &) {
        return Error{tr("The page does not fit into memory.")};
    }
}

void PrintJob::takePreview(Result<QImage> sheet)
{
    if (m_work != Work::Previewing) // A page has been printed meanwhile.
        return;
    m_work = Work::None;
    if (m_isNew)
        return previewNext();
    if (sheet)
        emit previewed(*sheet);
    else if (!sheet.error().isEmpty())
        emit previewFailed(sheet.error());
}

void PrintJob::print(const PageOrder &order, const PrintTarget &target)
{
    Q_ASSERT(!isPrinting());
    m_cancel = true; // what is only looked at
    m_isNew = false;
    begin(Work::Printing);
    m_thread = std::jthread([this, order, target] {
        Result<void> printed;
        try {
            printed = work(order, target);
        } catch (const std::bad_alloc &) {
            printed = Error{tr("The page does not fit into memory.")};
        }
        QMetaObject::invokeMethod(
            this,
            [this, isPrinted = bool(printed), error = printed.error()] {
                m_work = Work::None;
                emit finished(isPrinted, m_cancel ? QString() : error);
            },
            Qt::QueuedConnection);
    });
}

Result<void> PrintJob::work(const PageOrder &order, const PrintTarget &target)
{
    const auto renderer = makeRenderer({.backend = Backend::Auto, .threads = order.threads});
    if (!renderer)
        return Error{renderer.error()};
    return target.printer ? giveToPrinter(order, target, **renderer) : writeFile(order, target, **renderer);
}

Result<void> PrintJob::writeFile(const PageOrder &order, const PrintTarget &target, Renderer &renderer)
{
    FileReplacement file(target.file);
    if (const Result<void> opened = file.open(); !opened)
        return opened;
    {
        ReplacingDevice device(file);
        QPdfWriter writer(&device);
        writer.setTitle(target.title);
        writer.setCreator(QStringLiteral("Suffuse"));
        writer.setResolution(int(target.dpi));
        QPageLayout whole = target.layout;
        whole.setMode(QPageLayout::FullPageMode);
        writer.setPageLayout(whole);
        QPainter painter(&writer);
        if (const auto drawn =
                drawPage(order, target.dpi, renderer, onto(painter), m_cancel, [this](int k) { show(k); });
            !drawn)
            return drawn;
    }
    if (m_cancel)
        return Error{};
    return file.problem().isEmpty() ? file.commit() : Error{file.problem()};
}

/// Nothing can be taken back from a printer, so it gets the page when there is all of it.
Result<void> PrintJob::giveToPrinter(const PageOrder &order, const PrintTarget &target, Renderer &renderer)
{
    constexpr int drawnShare = 800; // per mille of the bar
    Spool spool;
    if (!spool.open())
        return Error{tr("There is no room for the page on the disk: %1").arg(spool.problem())};
    const auto put = [&](const QPoint &at, const QImage &piece) { spool.put(at, piece); };
    const auto drawn =
        drawPage(order, target.dpi, renderer, put, m_cancel, [this](int k) { show(k * drawnShare / 1000); });
    if (!drawn)
        return drawn;
    if (!spool.isWhole())
        return Error{tr("There is no room for the page on the disk: %1").arg(spool.problem())};
    QMetaObject::invokeMethod(this, &PrintJob::handedOver, Qt::QueuedConnection);
    QPainter painter;
    if (!painter.begin(target.printer.get()))
        return Error{tr("The printer does not take the page. See whether it is there, or print to a file.")};
    const bool isWhole =
        spool.play(onto(painter), [this](int k) { show(drawnShare + k * (1000 - drawnShare) / 1000); });
    if (!painter.end() || !isWhole)
        return Error{tr("The printer does not take the page. See whether it is there, or print to a file.")};
    return {};
}

void PrintJob::show(int perMille)
{
    QMetaObject::invokeMethod(
        this, [this, perMille] { emit progressed(perMille); }, Qt::QueuedConnection);
}

} // namespace suffuse

#include "model/journal/journal_writer.h"

#include "model/journal/recovery.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>

#include <atomic>

namespace suffuse {

namespace {

/// A journal is begun anew when it gets larger than so many times the whole painting, and so many bytes more.
constexpr qint64 growth = 4;
constexpr qint64 freeGrowth = qint64(4) << 20;

} // namespace

JournalWriter::JournalWriter(QString folder, Reports reports)
    : m_folder(std::move(folder)), m_reports(std::move(reports)), m_thread([this] { run(); })
{}

JournalWriter::~JournalWriter()
{
    {
        const std::lock_guard lock(m_mutex);
        m_stop = true;
    }
    m_wake.notify_one();
    m_thread.join();
}

void JournalWriter::begin(JournalHead head, PaintingPtr painting, bool modified, std::shared_ptr<JournalFile> replaced)
{
    Order order;
    order.task = Task::Begin;
    order.head = std::move(head);
    order.painting = std::move(painting);
    order.modified = modified;
    order.replaced = std::move(replaced);
    add(std::move(order));
}

quint64 JournalWriter::record(PaintingPtr painting, bool modified)
{
    Order order;
    order.task = Task::Record;
    order.painting = std::move(painting);
    order.modified = modified;
    order.serial = ++m_serial;
    add(std::move(order));
    return m_serial;
}

void JournalWriter::saved(JournalHead head, bool modified)
{
    Order order;
    order.task = Task::Saved;
    order.head = std::move(head);
    order.modified = modified;
    add(std::move(order));
}

void JournalWriter::remove()
{
    Order order;
    order.task = Task::Remove;
    add(std::move(order));
}

void JournalWriter::flush()
{
    std::unique_lock lock(m_mutex);
    m_idle.wait(lock, [this] { return m_orders.empty() && !m_busy; });
}

void JournalWriter::add(Order order)
{
    order.now = QDateTime::currentMSecsSinceEpoch();
    {
        const std::lock_guard lock(m_mutex);
        if (order.task == Task::Record && !m_orders.empty() && m_orders.back().task == Task::Record) {
            // It may be the last painting that has many strokes, so it is freed on the writer's thread.
            m_superseded.push_back(std::move(m_orders.back().painting));
            m_orders.back() = std::move(order);
        } else {
            m_orders.push_back(std::move(order));
        }
    }
    m_wake.notify_one();
}

void JournalWriter::run()
{
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_wake.wait(lock, [this] { return m_stop || !m_orders.empty(); });
        if (m_orders.empty())
            return;
        Order order = std::move(m_orders.front());
        m_orders.pop_front();
        std::vector<PaintingPtr> superseded = std::move(m_superseded);
        m_superseded.clear();
        m_busy = true;
        lock.unlock();
        superseded.clear();
        if (const Result<void> done = carryOut(order); done) {
            if (order.task == Task::Record && m_reports.written)
                m_reports.written(order.serial);
        } else if (!m_complained && m_reports.failed) {
            m_complained = true;
            m_reports.failed(done.error());
        }
        order = {};
        lock.lock();
        m_busy = false;
        m_idle.notify_all();
    }
}

Result<void> JournalWriter::carryOut(Order &order)
{
    switch (order.task) {
    case Task::Begin:
        return begin(order);
    case Task::Record:
        return record(order);
    case Task::Saved:
        m_head = order.head;
        return m_file ? append(m_encoder.saved(m_head, order.modified, order.now)) : Result<void>();
    case Task::Remove:
        if (m_file)
            m_file->remove();
        m_file.reset();
        break;
    }
    return {};
}

Result<void> JournalWriter::begin(Order &order)
{
    if (m_file)
        m_file->remove(); // The document before was closed in the regular way.
    m_file.reset();
    m_head = order.head;
    m_replaced = std::move(order.replaced);
    if (order.painting->strokes.empty() && !order.modified)
        return {};
    return startFile(order.painting, order.modified, order.now);
}

Result<void> JournalWriter::record(const Order &order)
{
    if (!m_file || isTooLarge(*order.painting))
        return startFile(order.painting, order.modified, order.now);
    return append(m_encoder.edit(order.painting, order.modified, order.now));
}

Result<void> JournalWriter::append(const QByteArray &bytes)
{
    if (bytes.isEmpty())
        return {};
    Result<void> done = m_file->append(bytes);
    if (done)
        m_encoder.kept();
    return done;
}

Result<void> JournalWriter::startFile(const PaintingPtr &painting, bool modified, qint64 now)
{
    const QString place = m_file ? m_file->path() : freeName();
    JournalEncoder encoder;
    const QByteArray bytes = encoder.begin(m_head, painting, modified, now);
    Result<std::unique_ptr<JournalFile>> file = JournalFile::create(place + QLatin1String(unfinishedEnding));
    if (!file)
        return Error{file.error()};
    Result<void> done = (*file)->append(bytes);
    if (done)
        done = (*file)->renameTo(place);
    if (!done) {
        (*file)->remove();
        return done;
    }
    encoder.kept();
    m_encoder = std::move(encoder);
    m_file = std::move(*file);
    m_startBytes = m_file->size();
    if (m_replaced)
        m_replaced->remove();
    m_replaced.reset();
    return {};
}

bool JournalWriter::isTooLarge(const Painting &painting) const
{
    return m_file->size() > growth * m_startBytes + freeGrowth ||
           m_encoder.ordering() + 2 * painting.strokes.size() > JournalEncoder::mostOrdering;
}

/// A name that says when, and by which process, the journal was made.
QString JournalWriter::freeName() const
{
    static std::atomic<int> count = 0;
    const QString name = QStringLiteral("%1-%2-%3")
                             .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss")))
                             .arg(QCoreApplication::applicationPid())
                             .arg(++count);
    return QDir(m_folder).filePath(name + QLatin1String(journalEnding));
}

} // namespace suffuse

#include "app/saving.h"

#include "app/saving_preview.h"
#include "model/formats/atomic_save.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QFileInfo>
#include <QImage>

namespace suffuse {

namespace {

/// Larger paintings keep the preview that they have: drawing one would take longer than saving.
constexpr std::size_t mostPreviewed = 200'000;

QByteArray previewPng(const PaintingPtr &painting)
{
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    const QImage image = previewImage(painting, 256);
    return image.save(&buffer, "PNG") ? png : QByteArray();
}

} // namespace

SaveOutcome carryOut(const SaveOrder &order)
{
    SaveOutcome outcome;
    outcome.path = QFileInfo(order.path).absoluteFilePath();
    const auto failed = [&](const QString &message) {
        outcome.kind = SaveOutcome::Kind::Failed;
        outcome.message = message;
        return outcome;
    };
    const auto isOther = [&] {
        const std::optional<QByteArray> there = hashOfFile(order.path);
        if (order.expected.isEmpty() || !there || *there == order.expected)
            return false;
        outcome.kind = SaveOutcome::Kind::ChangedOutside;
        outcome.hash = *there;
        return true;
    };
    if (isOther())
        return outcome;
    const FileFormat format = formatForSaving(order.path);
    if (format == FileFormat::Unknown) // says which endings there are
        return failed(saveDocument(*order.painting, order.extras, order.path).error());
    DocumentExtras extras = order.extras;
    if (format == FileFormat::Suffuse && order.painting->segmentCount() <= mostPreviewed)
        extras.preview = previewPng(order.painting);
    extras.history = order.history ? writeHistory(*order.history, *order.painting) : QByteArray();
    const QByteArray bytes = writeDocument(*order.painting, extras, format);
    if (isOther()) // drawing and packing took their time
        return outcome;
    const Result<void> kept = keepBackups(order.path, order.backups);
    if (const Result<void> written = writeFileAtomically(order.path, bytes); !written)
        return failed(written.error());
    outcome.message = kept.error();
    outcome.hash = QCryptographicHash::hash(bytes, QCryptographicHash::Sha256);
    outcome.bytes = bytes.size();
    outcome.historyBytes = format == FileFormat::Suffuse ? extras.history.size() : 0;
    outcome.withHistory = order.history.has_value();
    return outcome;
}

Saver::Saver(QObject *parent) : QObject(parent), m_thread([this] { run(); }) {}

Saver::~Saver()
{
    {
        const std::lock_guard lock(m_mutex);
        m_stop = true;
    }
    m_wake.notify_one();
    m_thread.join();
}

void Saver::save(SaveOrder order)
{
    {
        const std::lock_guard lock(m_mutex);
        m_open += m_order ? 0 : 1;
        m_order = std::move(order);
    }
    m_wake.notify_one();
}

void Saver::run()
{
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_wake.wait(lock, [this] { return m_stop || m_order; });
        if (!m_order)
            return;
        const SaveOrder order = std::move(*m_order);
        m_order.reset();
        lock.unlock();
        const SaveOutcome outcome = carryOut(order);
        QMetaObject::invokeMethod(
            this,
            [this, outcome] {
                --m_open;
                emit finished(outcome);
            },
            Qt::QueuedConnection);
        lock.lock();
    }
}

} // namespace suffuse

#include "app/session/files/saving.h"

#include "app/session/files/saving_preview.h"
#include "model/formats/atomic_save.h"
#include "model/formats/picture_links.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QFileInfo>
#include <QImage>

namespace suffuse {

namespace {

/// Larger paintings keep the preview that they have, since drawing one would take longer than saving.
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
    outcome.isCopy = order.isCopy;
    outcome.serial = order.serial;
    const auto failed = [&](const QString &message) {
        outcome.kind = SaveOutcome::Kind::Failed;
        outcome.message = message;
        return outcome;
    };
    std::optional<QByteArray> there;
    const auto isOther = [&] {
        there = hashOfFile(order.path);
        if (order.expected.isEmpty() || !there || *there == order.expected)
            return false;
        outcome.kind = SaveOutcome::Kind::ChangedOutside;
        outcome.hash = *there;
        return true;
    };
    if (isOther())
        return outcome;
    if (order.isThere && there && *there == order.expected) {
        outcome.wasThere = true;
        outcome.hash = *there;
        outcome.bytes = QFileInfo(order.path).size();
        return outcome;
    }
    const FileFormat format = formatForSaving(order.path);
    if (format == FileFormat::Unknown) // saveDocument's error says which endings there are
        return failed(saveDocument(*order.painting, order.extras, order.path).error());
    DocumentExtras extras = order.extras;
    if (format == FileFormat::Suffuse && order.painting->segmentCount() <= mostPreviewed)
        extras.preview = previewPng(order.painting);
    const Painting painting = withRelativeLinks(*order.painting, QFileInfo(outcome.path).path());
    extras.history = order.history ? writeHistory(*order.history, painting) : QByteArray();
    const QByteArray bytes = writeDocument(painting, extras, format);
    if (isOther()) // looked at once more, since drawing and packing took their time
        return outcome;
    outcome.hash = QCryptographicHash::hash(bytes, QCryptographicHash::Sha256);
    // A version is kept as a backup when another one takes its place. Equal bytes are written all the same: the user
    // may save once more because a message said that the folder could not be synced.
    const Result<void> kept = there == outcome.hash ? Result<void>() : keepBackups(order.path, order.backups);
    if (const Result<void> written = writeFileAtomically(order.path, bytes); !written)
        return failed(written.error());
    outcome.message = kept.error();
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
        const bool replaces = !m_orders.empty() && m_orders.back().order.path == order.path &&
                              m_orders.back().order.isCopy == order.isCopy;
        const bool knowsAll = m_open == 0;
        if (replaces)
            m_orders.pop_back();
        else
            ++m_open;
        m_orders.push_back({std::move(order), knowsAll});
    }
    m_wake.notify_one();
}

void Saver::run()
{
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_wake.wait(lock, [this] { return m_stop || !m_orders.empty(); });
        if (m_orders.empty())
            return;
        auto [order, knowsAll] = std::move(m_orders.front());
        m_orders.pop_front();
        lock.unlock();
        QList<QByteArray> &states = m_states[order.path];
        if (knowsAll)
            states.clear();
        if (!order.expected.isEmpty() && states.contains(order.expected) && states.back() != order.expected) {
            order.isThere = false; // This was said of the earlier one.
            order.expected = states.back();
        }
        if (states.isEmpty())
            states.push_back(order.expected);
        const SaveOutcome outcome = carryOut(order);
        if (outcome.isSaved())
            states.push_back(outcome.hash);
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

#pragma once

#include "model/journal/journal_file.h"
#include "model/journal/journal_format.h"

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace suffuse {

/// Keeps one document's journal on a thread of its own: the caller hands over a snapshot and goes on. What lies between
/// two snapshots is found, written and synced there; a snapshot that has not been looked at is superseded by a newer
/// one.
class JournalWriter {
public:
    /// Both are called on the writer's thread.
    struct Reports {
        std::function<void(quint64 serial)> written;        ///< that snapshot and all before it are on disk
        std::function<void(const QString &message)> failed; ///< the first time only
    };

    JournalWriter(QString folder, Reports reports);
    ~JournalWriter(); ///< does what is left; the journal stays unless `remove` was called

    /// Another document. An empty, unmodified one gets a file with its first edit. `replaced`: its journal of an
    /// earlier run, which goes when the new one is on disk.
    void begin(JournalHead head, PaintingPtr painting, bool modified, std::shared_ptr<JournalFile> replaced = {});
    /// Returns the snapshot's number, from 1 on.
    quint64 record(PaintingPtr painting, bool modified);
    /// It was saved under this name. `modified`: it has been edited since.
    void saved(JournalHead head, bool modified);
    /// The document goes in peace: nothing is to be recovered.
    void remove();
    /// Waits until all is done.
    void flush();

private:
    enum class Task { Begin, Record, Saved, Remove };
    struct Order {
        Task task = Task::Record;
        JournalHead head;
        PaintingPtr painting;
        bool modified = false;
        std::shared_ptr<JournalFile> replaced;
        quint64 serial = 0;
        qint64 now = 0;
    };

    void add(Order order);
    void run();
    Result<void> carryOut(Order &order);
    Result<void> begin(Order &order);
    Result<void> record(const Order &order);
    Result<void> append(const QByteArray &bytes);
    /// A file of its own for the whole painting; takes the place of the one before.
    Result<void> startFile(const PaintingPtr &painting, bool modified, qint64 now);
    bool isTooLarge(const Painting &painting) const;
    QString freeName() const;

    // Writer thread only.
    const QString m_folder;
    const Reports m_reports;
    JournalHead m_head;
    JournalEncoder m_encoder;
    std::unique_ptr<JournalFile> m_file;
    std::shared_ptr<JournalFile> m_replaced;
    qint64 m_startBytes = 0; ///< of the file, when it was begun
    bool m_complained = false;

    std::mutex m_mutex;
    std::condition_variable m_wake, m_idle;
    std::deque<Order> m_orders;
    std::vector<PaintingPtr> m_superseded; ///< to be freed by the writer
    quint64 m_serial = 0;
    bool m_busy = false;
    bool m_stop = false;
    std::thread m_thread;
};

} // namespace suffuse

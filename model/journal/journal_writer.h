#pragma once

#include "model/journal/journal_file.h"
#include "model/journal/journal_format.h"

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace suffuse {

/// Keeps the journal of one document on a thread of its own. The caller hands over a snapshot and goes on; what lies
/// between two snapshots is found, written and synced on that thread. A snapshot that has not been looked at is
/// superseded by a newer one.
class JournalWriter {
public:
    /// Both functions are called on the writer's thread.
    struct Reports {
        std::function<void(quint64 serial)> written;        ///< that snapshot and all before it are on disk
        std::function<void(const QString &message)> failed; ///< called only the first time
    };

    JournalWriter(QString folder, Reports reports);
    ~JournalWriter(); ///< Finishes what is left to do. The journal stays unless `remove` was called.

    /// Begins the journal of another document. An empty, unmodified document gets a file with its first edit.
    /// `replaced` is the document's journal of an earlier run, which is removed when the new one is on disk.
    void begin(JournalHead head, PaintingPtr painting, bool modified, std::shared_ptr<JournalFile> replaced = {});
    /// Records a snapshot. Returns its number, from 1 on.
    quint64 record(PaintingPtr painting, bool modified);
    /// Records that the document was saved under this name. `modified` says whether it has been edited since.
    void saved(JournalHead head, bool modified);
    /// Removes the journal, since the document was closed in the regular way and nothing is to be recovered.
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
    /// Begins a new file with the whole painting, which replaces the file before.
    Result<void> startFile(const PaintingPtr &painting, bool modified, qint64 now);
    bool isTooLarge(const Painting &painting) const;
    QString freeName() const;

    // What follows is used only on the writer's thread.
    const QString m_folder;
    const Reports m_reports;
    JournalHead m_head;
    JournalEncoder m_encoder;
    std::unique_ptr<JournalFile> m_file;
    std::shared_ptr<JournalFile> m_replaced;
    qint64 m_startBytes = 0; ///< the size of the file when it was begun
    bool m_complained = false;

    std::mutex m_mutex;
    std::condition_variable m_wake, m_idle;
    std::deque<Order> m_orders;
    std::vector<PaintingPtr> m_superseded; ///< paintings that the writer's thread frees
    quint64 m_serial = 0;
    bool m_busy = false;
    bool m_stop = false;
    std::thread m_thread;
};

} // namespace suffuse

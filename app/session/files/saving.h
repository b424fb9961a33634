#pragma once

#include "model/formats/files.h"
#include "model/formats/suffuse/suffuse_history.h"

#include <QObject>

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>

namespace suffuse {

/// What is to be written, and where.
struct SaveOrder {
    PaintingPtr painting;
    DocumentExtras extras;
    QString path;
    QByteArray expected;                     ///< SHA-256 of the file that may be replaced; empty: any
    int backups = 0;                         ///< earlier versions that are kept
    std::optional<UndoHistory> history = {}; ///< goes into the file, too
    bool isThere = false;                    ///< a file as `expected` holds all of this: nothing is written then
    bool isCopy = false;                     ///< the document goes on living in its own file
    quint64 serial = 0;                      ///< comes back with the outcome
};

/// How it went.
struct SaveOutcome {
    enum class Kind { Saved, Failed, ChangedOutside };
    Kind kind = Kind::Saved;
    QString path;    ///< absolute
    QString message; ///< what went wrong; with Saved, what went wrong beside it
    QByteArray hash; ///< SHA-256 of the file as it is now, Saved and ChangedOutside
    qint64 bytes = 0;
    qint64 historyBytes = 0;  ///< of them
    bool withHistory = false; ///< as it was ordered
    bool wasThere = false;    ///< nothing was written: the file holds all of it already
    bool isCopy = false;      ///< as it was ordered
    quint64 serial = 0;       ///< of the order

    bool isSaved() const { return kind == Kind::Saved; }
};

/// Writes snapshots on a thread of its own, in turn. One that has not begun gives way to a newer one for the same file.
/// When it is destroyed, what was ordered is written first.
class Saver : public QObject {
    Q_OBJECT

public:
    explicit Saver(QObject *parent = nullptr);
    ~Saver() override;

    void save(SaveOrder order);
    /// Until the outcome of the last order has been told.
    bool isBusy() const { return m_open > 0; }

signals:
    /// On the thread that ordered; orders that gave way are not told of.
    void finished(const suffuse::SaveOutcome &outcome);

private:
    void run();

    int m_open = 0; ///< the owner's thread only: orders without an outcome
    std::mutex m_mutex;
    std::condition_variable m_wake;
    std::deque<SaveOrder> m_orders;
    bool m_stop = false;
    std::thread m_thread;
};

/// Writes it here and now, a preview with it. Any thread.
SaveOutcome carryOut(const SaveOrder &order);

} // namespace suffuse

#pragma once

#include "model/formats/files.h"
#include "model/formats/suffuse/suffuse_history.h"

#include <QObject>

#include <condition_variable>
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

    bool isSaved() const { return kind == Kind::Saved; }
};

/// Writes snapshots on a thread of its own. One that has not begun gives way to a newer one. When it is destroyed, what
/// was ordered is written first.
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
    std::optional<SaveOrder> m_order;
    bool m_stop = false;
    std::thread m_thread;
};

/// Writes it here and now, a preview with it. Any thread.
SaveOutcome carryOut(const SaveOrder &order);

} // namespace suffuse

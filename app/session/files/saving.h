#pragma once

#include "model/formats/files.h"
#include "model/formats/suffuse/suffuse_history.h"

#include <QObject>

#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

namespace suffuse {

/// An order to write a painting: what, and where.
struct SaveOrder {
    PaintingPtr painting;
    DocumentExtras extras;
    QString path;
    QByteArray expected;                     ///< SHA-256 of the file that may be replaced; empty: any
    int backups = 0;                         ///< how many earlier versions are kept
    std::optional<UndoHistory> history = {}; ///< undo steps that go into the file, too
    bool isThere = false; ///< the expected file holds all of this already, so nothing is written if it is there
    bool isCopy = false;  ///< the document goes on living in its own file
    quint64 serial = 0;   ///< number of the order, which comes back with the outcome
};

/// How saving went.
struct SaveOutcome {
    enum class Kind { Saved, Failed, ChangedOutside };
    Kind kind = Kind::Saved;
    QString path;    ///< absolute
    QString message; ///< what went wrong; with Saved, what went wrong beside the painting
    QByteArray hash; ///< SHA-256 of the file as it is now, with Saved and ChangedOutside
    qint64 bytes = 0;
    qint64 historyBytes = 0;  ///< how many of the bytes the undo steps take
    bool withHistory = false; ///< as it was ordered
    bool wasThere = false;    ///< nothing was written, since the file held all of it already
    bool isCopy = false;      ///< as it was ordered
    quint64 serial = 0;       ///< of the order

    bool isSaved() const { return kind == Kind::Saved; }
};

/// Writes snapshots on a thread of its own, one after the other. A snapshot whose turn has not come gives way to a
/// newer one for the same file. The destructor first writes all that was ordered.
class Saver : public QObject {
    Q_OBJECT

public:
    explicit Saver(QObject *parent = nullptr);
    ~Saver() override;

    void save(SaveOrder order);
    /// True until the outcome of the last order has been told.
    bool isBusy() const { return m_open > 0; }

signals:
    /// Emitted on the thread that ordered. Orders that gave way have no outcome.
    void finished(const suffuse::SaveOutcome &outcome);

private:
    void run();

    struct Waiting {
        SaveOrder order;
        bool knowsAll = true; ///< whether the outcomes of all earlier orders had been told when it was given
    };

    int m_open = 0; ///< orders without an outcome; used on the owner's thread only
    std::mutex m_mutex;
    std::condition_variable m_wake;
    std::deque<Waiting> m_orders;
    /// Hashes of what each file has been since its outcomes were last told: an order that expects an earlier one does
    /// not know yet what was written since, which is not another program's. Used on the thread only.
    std::map<QString, QList<QByteArray>> m_states;
    bool m_stop = false;
    std::thread m_thread;
};

/// Carries out an order here and now, and writes a preview with it. Any thread.
SaveOutcome carryOut(const SaveOrder &order);

} // namespace suffuse

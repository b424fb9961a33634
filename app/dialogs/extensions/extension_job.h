#pragma once

#include "app/extensions/extension_run.h"

#include <QObject>

#include <thread>

namespace suffuse {

/// Runs the program of an extension on a thread of its own.
class ExtensionJob : public QObject {
    Q_OBJECT

public:
    explicit ExtensionJob(QObject *parent = nullptr);
    ~ExtensionJob() override; ///< cancels and waits

    /// Not while it is running.
    void start(const ExtensionOrder &order);
    void cancel() { m_cancel = true; }
    bool isRunning() const { return m_isRunning; }
    const ExtensionOrder &order() const { return m_order; }

signals:
    /// `share` of the work is done, from 0 to 1; `what` is done now, which may be empty.
    void progressed(double share, const QString &what);
    void finished(const suffuse::ExtensionOutcome &outcome);

private:
    ExtensionOrder m_order;
    bool m_isRunning = false;
    std::atomic<bool> m_cancel = false;
    std::jthread m_thread;
};

} // namespace suffuse

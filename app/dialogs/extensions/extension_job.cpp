#include "app/dialogs/extensions/extension_job.h"

#include <new>

namespace suffuse {

ExtensionJob::ExtensionJob(QObject *parent) : QObject(parent) {}

ExtensionJob::~ExtensionJob()
{
    m_cancel = true;
}

void ExtensionJob::start(const ExtensionOrder &order)
{
    Q_ASSERT(!m_isRunning);
    m_order = order;
    m_cancel = false;
    m_isRunning = true;
    m_thread = std::jthread([this] {
        auto outcome = std::make_shared<ExtensionOutcome>();
        try {
            *outcome = runExtension(m_order, m_cancel, [this](double share, const QString &what) {
                QMetaObject::invokeMethod(
                    this, [this, share, what] { emit progressed(share, what); }, Qt::QueuedConnection);
            });
        } catch (const std::bad_alloc &) {
            outcome->error = ExtensionMessages::tr("The result does not fit into memory.");
        }
        QMetaObject::invokeMethod(
            this,
            [this, outcome] {
                m_isRunning = false;
                emit finished(*outcome);
            },
            Qt::QueuedConnection);
    });
}

} // namespace suffuse

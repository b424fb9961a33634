#include "app/window/files/running_program.h"

#include "app/window/main_window.h"

#include <QApplication>
#include <QDBusConnection>
#include <QDBusConnectionInterface>
#include <QDBusMessage>
#include <QFileInfo>
#include <QTimer>
#include <QUrl>

#include <utility>

namespace suffuse {

namespace {

const QString busName = QStringLiteral("org.suffuse.Suffuse");
const QString busPath = QStringLiteral("/org/suffuse/Suffuse");
const QString busInterface = QStringLiteral("org.freedesktop.Application");
const QString newPaintingAction = QStringLiteral("NewPainting");
/// A program that has not answered then is not waited for.
constexpr int answerMs = 5'000;
/// So often it is looked whether a dialog is gone.
constexpr int againMs = 100;

QDBusMessage callFor(const StartRequest &request)
{
    const auto call = [](const char *method) {
        QDBusMessage message = QDBusMessage::createMethodCall(busName, busPath, busInterface, QLatin1String(method));
        message.setAutoStartService(false);
        return message;
    };
    if (request.newPainting)
        return call("ActivateAction") << newPaintingAction << QVariantList() << QVariantMap();
    if (request.files.isEmpty())
        return call("Activate") << QVariantMap();
    QStringList uris; // The other program may have another current folder.
    for (const QString &file : request.files)
        uris << QUrl::fromLocalFile(QFileInfo(file).absoluteFilePath()).toString(QUrl::FullyEncoded);
    return call("Open") << uris << QVariantMap();
}

/// The window that a request is about: the active one, else the one that was made last.
MainWindow *frontWindow()
{
    if (auto *active = qobject_cast<MainWindow *>(QApplication::activeWindow()))
        return active;
    MainWindow *last = nullptr;
    for (QWidget *widget : QApplication::topLevelWidgets())
        if (auto *window = qobject_cast<MainWindow *>(widget); window && window->isVisible())
            last = window;
    return last;
}

void raise(QWidget &window)
{
    window.setWindowState(window.windowState() & ~Qt::WindowMinimized);
    window.raise();
    window.activateWindow();
}

/// Whether a window that came now would come between a person and what the person is doing.
bool isInHand()
{
    return QApplication::activeModalWidget() || QApplication::activePopupWidget() ||
           QApplication::mouseButtons() != Qt::NoButton;
}

} // namespace

bool handOver(const StartRequest &request)
{
    // A connection of its own, which goes with the application object that asks.
    const QString name = QStringLiteral("handing over");
    bool isTaken = false;
    {
        const QDBusConnection bus = QDBusConnection::connectToBus(QDBusConnection::SessionBus, name);
        isTaken = bus.isConnected() && bus.interface()->isServiceRegistered(busName) &&
                  bus.call(callFor(request), QDBus::Block, answerMs).type() == QDBusMessage::ReplyMessage;
    }
    QDBusConnection::disconnectFromBus(name);
    return isTaken;
}

RunningProgram::RunningProgram(std::function<MainWindow *()> makeWindow, QObject *parent)
    : QObject(parent), m_makeWindow(std::move(makeWindow))
{}

RunningProgram::~RunningProgram()
{
    if (m_hasName)
        QDBusConnection::sessionBus().unregisterService(busName);
}

bool RunningProgram::begin()
{
    QDBusConnection bus = QDBusConnection::sessionBus();
    // The object first: calls wait for the name, not for the object.
    m_hasName = bus.isConnected() && bus.registerObject(busPath, this, QDBusConnection::ExportScriptableSlots) &&
                bus.registerService(busName);
    return m_hasName;
}

void RunningProgram::Activate(const QVariantMap & /*platformData*/)
{
    take({});
}

void RunningProgram::Open(const QStringList &uris, const QVariantMap & /*platformData*/)
{
    StartRequest request;
    for (const QString &uri : uris)
        if (const QString path = QUrl(uri).toLocalFile(); !path.isEmpty())
            request.files << path;
    take(std::move(request));
}

void RunningProgram::ActivateAction(const QString &action, const QVariantList & /*parameter*/,
                                    const QVariantMap & /*platformData*/)
{
    StartRequest request;
    request.newPainting = action == newPaintingAction;
    take(std::move(request));
}

/// Afterwards: who asked need not wait until files are read.
void RunningProgram::take(StartRequest request)
{
    m_waiting << std::move(request);
    QTimer::singleShot(0, this, &RunningProgram::carryOutWaiting);
}

void RunningProgram::carryOutWaiting()
{
    if (isInHand()) {
        QTimer::singleShot(againMs, this, &RunningProgram::carryOutWaiting);
        return;
    }
    while (!m_waiting.isEmpty() && !isInHand())
        carryOut(m_waiting.takeFirst());
    if (!m_waiting.isEmpty()) // A message about the first ones is open.
        QTimer::singleShot(againMs, this, &RunningProgram::carryOutWaiting);
}

void RunningProgram::carryOut(const StartRequest &request)
{
    MainWindow *window = request.newPainting ? nullptr : frontWindow();
    if (!window)
        window = m_makeWindow();
    for (const QString &file : request.files)
        if (MainWindow *opened = window->openFile(file))
            window = opened;
    raise(*window);
}

} // namespace suffuse

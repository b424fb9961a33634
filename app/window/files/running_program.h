// The program as others on the session bus see it: a second start opens its files in the one that runs already.
#pragma once

#include <QObject>
#include <QStringList>
#include <QVariantMap>

#include <functional>

namespace suffuse {

class MainWindow;

/// What a start of the program asks for.
struct StartRequest {
    QStringList files;        ///< paths
    bool newPainting = false; ///< a window with a new painting, whatever is open
};

/// Gives a request to the program that runs in this session already, and returns whether it has taken it. False where
/// none runs, where there is no session bus, and where it does not answer: then this program does it itself.
bool handOver(const StartRequest &request);

/// Takes requests by the interface org.freedesktop.Application, by which desktops start programs, too. A request waits
/// while a dialog asks something or a button is held, since windows must not come between.
class RunningProgram : public QObject {
    Q_OBJECT
    Q_CLASSINFO("D-Bus Interface", "org.freedesktop.Application")

public:
    /// `makeWindow` makes and shows a window with a new painting.
    explicit RunningProgram(std::function<MainWindow *()> makeWindow, QObject *parent = nullptr);
    ~RunningProgram() override;

    /// Takes the program's name on the session bus. False if another program has it, or if there is no bus: then nobody
    /// finds this one, and all else works.
    bool begin();

    /// Does what is asked for, at once: files in windows, a new painting, or the last window raised.
    void carryOut(const StartRequest &request);

public slots: // named as the interface names them
    Q_SCRIPTABLE void Activate(const QVariantMap &platformData);
    Q_SCRIPTABLE void Open(const QStringList &uris, const QVariantMap &platformData);
    Q_SCRIPTABLE void ActivateAction(const QString &action, const QVariantList &parameter,
                                     const QVariantMap &platformData);

private:
    void take(StartRequest request);
    void carryOutWaiting();

    std::function<MainWindow *()> m_makeWindow;
    QList<StartRequest> m_waiting;
    bool m_hasName = false;
};

} // namespace suffuse

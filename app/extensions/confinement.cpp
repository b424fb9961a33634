#include "app/extensions/confinement.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>

#include <algorithm>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace suffuse {

namespace {

constexpr int tryMs = 10'000;

/// Bubblewrap's arguments before the command.
QStringList wrapArguments(const WorkFolders *folders, bool network)
{
    QStringList arguments{"--ro-bind",
                          "/",
                          "/",
                          "--dev",
                          "/dev",
                          "--proc",
                          "/proc",
                          "--die-with-parent",
                          "--new-session",
                          "--unshare-pid",
                          "--unshare-ipc"};
    QStringList hidden; // Sockets in the file system lead out, too: the bus, the display, services of the system.
    if (network)
        hidden << "/run/user"
               << "/run/dbus"
               << "/run/systemd";
    else
        hidden << "/run";
    hidden << "/tmp/.X11-unix"
           << "/tmp/.ICE-unix";
    hidden.removeIf([](const QString &path) { return !QFileInfo(path).isDir() || QFileInfo(path).isSymLink(); });
    for (const QString &path : hidden)
        arguments << "--tmpfs" << path;
    if (folders) {
        for (const QString &path : folders->read)
            arguments << "--ro-bind" << path << path;
        arguments << "--bind" << folders->write << folders->write << "--chdir" << folders->write;
    }
    for (const QString &path : hidden)
        arguments << "--remount-ro" << path;
    arguments << "--remount-ro"
              << "/dev";
    if (!network)
        arguments << "--unshare-net";
    return arguments << "--";
}

Confinement tried()
{
    Confinement found;
    const QString program = QStandardPaths::findExecutable(QStringLiteral("bwrap"));
    if (program.isEmpty()) {
        found.why = ExtensionMessages::tr("Programs are limited in time, memory and what they write, but not confined: "
                                          "install bubblewrap, and they have no network and can write nowhere else.");
        return found;
    }
    QProcess process;
    process.start(program, wrapArguments(nullptr, false) << QStringLiteral("true"));
    if (process.waitForFinished(tryMs) && process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0) {
        found.bubblewrap = program;
        found.why = ExtensionMessages::tr("Programs are confined by bubblewrap: they have no network, unless they say "
                                          "that they need it, and can write in a temporary folder only.");
        return found;
    }
    found.why = ExtensionMessages::tr("Programs are limited in time, memory and what they write, but not confined: "
                                      "bubblewrap is installed, and does not work here (%1).")
                    .arg(QString::fromLocal8Bit(process.readAllStandardError()).trimmed().section('\n', 0, 0));
    return found;
}

QByteArray procFile(int process, const char *name)
{
    QFile file(QStringLiteral("/proc/%1/%2").arg(process).arg(QLatin1String(name)));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

const Confinement &confinement()
{
    static const Confinement found = tried();
    return found;
}

QStringList confined(const QStringList &command, const WorkFolders &folders, bool network)
{
    const QString &program = confinement().bubblewrap;
    return program.isEmpty() ? command : QStringList(program) + wrapArguments(&folders, network) + command;
}

std::function<void()> limitsModifier(const ExtensionLimits &limits)
{
    const auto memory = rlim_t(limits.memory * megabyte), written = rlim_t(limits.written * megabyte);
    return [memory, written] {
        setpgid(0, 0);
        prctl(PR_SET_PDEATHSIG, SIGKILL); // It does not outlive us.
        const rlimit data{memory, memory}, file{written, written}, none{0, 0}, files{1024, 1024};
        setrlimit(RLIMIT_DATA, &data);
        setrlimit(RLIMIT_FSIZE, &file);
        setrlimit(RLIMIT_CORE, &none);
        setrlimit(RLIMIT_NOFILE, &files);
    };
}

std::vector<int> ProcessTree::processes() const
{
    std::vector<int> found;
    const QByteArray marked = '\0' + m_mark + '\0';
    for (const QString &name : QDir(QStringLiteral("/proc")).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        bool isProcess = false;
        const int process = name.toInt(&isProcess);
        if (isProcess && process != getpid() && ('\0' + procFile(process, "environ") + '\0').contains(marked))
            found.push_back(process);
    }
    return found;
}

ProcessTree::Use ProcessTree::use() const
{
    Use all;
    const qint64 page = sysconf(_SC_PAGESIZE);
    for (const int process : processes()) {
        all.memory += procFile(process, "statm").split(' ').value(1).toLongLong() * page;
        for (const QByteArray &line : procFile(process, "io").split('\n'))
            if (line.startsWith("write_bytes: "))
                all.written += line.mid(13).toLongLong();
    }
    return all;
}

void ProcessTree::end(qint64 leader) const
{
    if (leader > 0) {
        kill(pid_t(-leader), SIGKILL);
        kill(pid_t(leader), SIGKILL);
    }
    // Whoever is started while the others are ended is there the next time.
    for (int round = 0; round < 20; ++round) {
        const std::vector<int> left = processes();
        const bool none = std::ranges::none_of(left, [](int process) { return kill(process, SIGKILL) == 0; });
        if (none)
            return;
        usleep(2000);
    }
}

qint64 bytesWithin(const QString &folder, qint64 enough)
{
    constexpr qint64 block = 4096;
    qint64 bytes = 0;
    for (QDirIterator it(folder, QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot,
                         QDirIterator::Subdirectories);
         it.hasNext() && bytes <= enough;) {
        it.next();
        const QFileInfo file = it.fileInfo();
        bytes += std::max(block, file.isFile() && !file.isSymLink() ? file.size() : 0);
    }
    return bytes;
}

} // namespace suffuse

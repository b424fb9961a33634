#include "app/extensions/found_extensions.h"

#include "app/extensions/manifest.h"

#include <QCollator>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>

#include <algorithm>
#include <mutex>
#include <set>

namespace suffuse {

namespace {

constexpr qint64 largestManifest = 1 << 20;
constexpr int mostExtensions = 1000;
constexpr int answerMs = 20'000;

FoundExtension readFolder(const QString &folder, bool isOwn)
{
    FoundExtension found;
    found.folder = folder;
    found.isOwn = isOwn;
    const QString path = QDir(folder).filePath(manifestName);
    QFile file(path);
    if (!QFileInfo(path).isFile() || file.size() > largestManifest || !file.open(QIODevice::ReadOnly)) {
        found.problem = ExtensionMessages::tr("%1: cannot be read, or is larger than 1 MB").arg(path);
        return found;
    }
    Result<Extension> extension = readManifest(file.readAll(), path);
    if (extension)
        found.extension = std::move(*extension);
    else
        found.problem = extension.error();
    return found;
}

/// The folder with `import suffuse` of a build, or of an installation elsewhere; empty: there is none.
QString pythonModuleFolder()
{
    for (const char *folder : {"../python", "../lib/python3/dist-packages"}) {
        const QDir dir(QCoreApplication::applicationDirPath() + '/' + QLatin1String(folder));
        if (dir.exists(QStringLiteral("suffuse/__init__.py")))
            return QDir::cleanPath(dir.absolutePath());
    }
    return {};
}

/// What Python does not find of some modules. Nothing is imported but the packages around them.
QStringList missingModules(const QString &python, const QStringList &modules)
{
    static std::mutex mutex;
    static std::set<QStringList> whole; // What was found once stays where it is.
    const std::lock_guard lock(mutex);
    if (whole.contains(modules))
        return {};
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    addPythonPlaces(environment);
    process.setProcessEnvironment(environment);
    process.start(python, QStringList{QStringLiteral("-B"), QStringLiteral("-c"),
                                      QStringLiteral("import importlib.util as u, sys\n"
                                                     "print(*[m for m in sys.argv[1:] if u.find_spec(m) is None])")} +
                              modules);
    if (!process.waitForFinished(answerMs) || process.exitCode() != 0)
        return modules;
    const QStringList missing =
        QString::fromUtf8(process.readAllStandardOutput()).split(QChar(' '), Qt::SkipEmptyParts);
    QStringList trimmed;
    for (const QString &module : missing)
        if (!module.trimmed().isEmpty())
            trimmed << module.trimmed();
    if (trimmed.isEmpty())
        whole.insert(modules);
    return trimmed;
}

} // namespace

QString ownExtensionsFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
           QStringLiteral("/suffuse/extensions");
}

QString shippedExtensionsFolder()
{
    for (const char *folder : {"../share/suffuse/extensions", "../../packaging/extensions"}) {
        const QDir dir(QCoreApplication::applicationDirPath() + '/' + QLatin1String(folder));
        if (dir.exists())
            return QDir::cleanPath(dir.absolutePath());
    }
    return {};
}

std::vector<FoundExtension> findExtensions(const QString &language)
{
    return findExtensions({shippedExtensionsFolder(), ownExtensionsFolder()}, language);
}

std::vector<FoundExtension> findExtensions(const QStringList &folders, const QString &language)
{
    std::vector<FoundExtension> all;
    for (const QString &place : folders) {
        const bool isOwn = place == folders.last();
        if (place.isEmpty())
            continue;
        for (const QFileInfo &folder : QDir(place).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name)) {
            if (!QFileInfo::exists(folder.filePath() + '/' + manifestName) || all.size() >= mostExtensions)
                continue;
            FoundExtension found = readFolder(folder.absoluteFilePath(), isOwn);
            const auto same = std::ranges::find_if(all, [&](const FoundExtension &other) {
                return other.extension && found.extension && other.extension->id == found.extension->id;
            });
            if (same != all.end() && same->isOwn == isOwn) {
                found.problem = ExtensionMessages::tr("%1: %2 has the id “%3”, too; give it another one")
                                    .arg(found.folder, same->folder, found.extension->id);
                found.extension.reset();
            } else if (same != all.end()) {
                all.erase(same);
            }
            all.push_back(std::move(found));
        }
    }
    const QCollator collator;
    std::ranges::stable_sort(all, [&](const FoundExtension &a, const FoundExtension &b) {
        const auto nameOf = [&](const FoundExtension &f) {
            return f.extension ? f.extension->name.in(language) : QFileInfo(f.folder).fileName();
        };
        return collator.compare(nameOf(a), nameOf(b)) < 0;
    });
    return all;
}

QString python3()
{
    const QString debian = QStringLiteral("/usr/bin/python3");
    return QFileInfo(debian).isExecutable() ? debian : QStandardPaths::findExecutable(QStringLiteral("python3"));
}

void addPythonPlaces(QProcessEnvironment &environment)
{
    const QProcessEnvironment ours = QProcessEnvironment::systemEnvironment();
    const QString path = QStringLiteral("PYTHONPATH"), own = QStringLiteral("PYTHONUSERBASE");
    QStringList folders{pythonModuleFolder(), ours.value(path)};
    folders.removeAll(QString());
    if (!folders.isEmpty())
        environment.insert(path, folders.join(':'));
    environment.insert(own, ours.value(own, QDir::homePath() + QStringLiteral("/.local")));
}

QStringList commandOf(const Extension &extension)
{
    QStringList command;
    for (QString part : extension.program)
        command
            << part.replace(QLatin1String("{python3}"), python3()).replace(QLatin1String("{folder}"), extension.folder);
    if (!command.first().contains('/'))
        if (const QString program = QStandardPaths::findExecutable(command.first()); !program.isEmpty())
            command.first() = program;
    return command;
}

QString problemOfNeeds(const Extension &extension)
{
    const bool isPython = extension.program.first() == QLatin1String("{python3}");
    if (isPython && python3().isEmpty())
        return ExtensionMessages::tr("Python 3 is missing. Install python3.");
    const QString program = commandOf(extension).first();
    if (!QFileInfo(program).isExecutable())
        return ExtensionMessages::tr("The program %1 is missing, or cannot be started. Install it.").arg(program);
    if (extension.pythonModules.isEmpty())
        return {};
    const QString python = isPython ? program : python3();
    if (python.isEmpty())
        return ExtensionMessages::tr("Python 3 is missing. Install python3.");
    const QStringList missing = missingModules(python, extension.pythonModules);
    if (missing.isEmpty())
        return {};
    return ExtensionMessages::tr(
               "%1 does not find the Python modules %2. Install them by packages such as python3-suffuse and "
               "python3-numpy, or by pip as docs/python.md says.")
        .arg(python, missing.join(QStringLiteral(", ")));
}

} // namespace suffuse

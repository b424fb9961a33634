// The store of the settings: where it lies, and how a start survives a damaged one.
#include "app/session/settings/settings.h"
#include "model/environment.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLockFile>
#include <QTemporaryDir>

#include <memory>

namespace suffuse::settings {

namespace {

constexpr qint64 largestStore = qint64(4) << 20;
constexpr int startsForgiven = 2;
/// The number of starts that failed in a row is kept beside the settings, not in them.
constexpr char startsEnding[] = ".starts";
constexpr char damagedEnding[] = ".damaged";
constexpr char listsEnding[] = ".lists";
constexpr int lockMs = 1'000;

std::unique_ptr<QTemporaryDir> &forgotten()
{
    static std::unique_ptr<QTemporaryDir> folder;
    return folder;
}

/// SUFFUSE_SETTINGS.
QString givenPath()
{
    return QString::fromStdString(environment::value(environment::Variable::Settings));
}

QString storePath()
{
    if (forgotten())
        return forgotten()->filePath(QStringLiteral("suffuse.ini"));
    if (const QString given = givenPath(); !given.isEmpty())
        return given;
    return QSettings(QSettings::IniFormat, QSettings::UserScope, "suffuse", "suffuse").fileName();
}

/// Puts a file aside. Returns its new path, or an empty string. Only files are moved: a device may stand in their
/// place.
QString putAside(const QString &path)
{
    if (!QFileInfo(path).isFile())
        return {};
    const QString place = path + QLatin1String(damagedEnding);
    QFile::remove(place);
    return QFile::rename(path, place) ? place : QString();
}

/// Whether Suffuse can have written this. Reading a pipe would wait, and a huge file would take long. "@Variant" makes
/// Qt build any type from the bytes that follow, and Suffuse never writes it.
bool mayBeRead(const QString &path)
{
    const QFileInfo info(path);
    if (!info.exists())
        return true;
    QFile file(path);
    if (!info.isFile() || info.size() > largestStore)
        return false;
    if (!file.open(QIODevice::ReadOnly))
        return true; // Qt cannot read it either
    const QByteArray bytes = file.readAll();
    return !bytes.contains("@Variant(") && !bytes.contains("@DateTime(");
}

int failedStarts(const QString &path)
{
    QFile file(path + QLatin1String(startsEnding));
    return QFileInfo(file).isFile() && file.open(QIODevice::ReadOnly) ? file.read(8).trimmed().toInt() : 0;
}

} // namespace

QSettings &store()
{
    const auto given = [&folder = forgotten()] { // the folder must outlive the settings that are written to it
        return folder ? folder->path() : givenPath();
    };
    static std::unique_ptr<QSettings> settings;
    static QString opened;
    if (settings && given() == opened)
        return *settings;
    if (const QString path = storePath(); !mayBeRead(path) && putAside(path).isEmpty())
        forgetEverything();
    opened = given();
    settings = std::make_unique<QSettings>(storePath(), QSettings::IniFormat);
    return *settings;
}

void updateList(const QString &key, const std::function<QStringList(const QStringList &stored)> &change,
                const QStringList &usual)
{
    QSettings &s = store();
    // Qt's own lock covers reading and writing, but not the time between them.
    QLockFile lock(storePath() + QLatin1String(listsEnding));
    lock.tryLock(lockMs); // if the lock cannot be had, an entry may be lost, but the program does not wait
    s.sync();
    s.setValue(key, change(s.value(key, usual).toStringList()));
    s.sync();
}

void forgetEverything()
{
    forgotten() = std::make_unique<QTemporaryDir>();
}

QString beginStart()
{
    const QString path = storePath();
    const int failed = failedStarts(path);
    QString place;
    if (failed >= startsForgiven && QFileInfo::exists(path))
        place = putAside(path);
    QFile file(path + QLatin1String(startsEnding));
    QDir().mkpath(QFileInfo(path).absolutePath());
    if ((!file.exists() || QFileInfo(file).isFile()) && file.open(QIODevice::WriteOnly))
        file.write(QByteArray::number(place.isEmpty() ? failed + 1 : 1));
    return place;
}

void startSucceeded()
{
    QFile::remove(storePath() + QLatin1String(startsEnding));
}

} // namespace suffuse::settings

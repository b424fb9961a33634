#include "model/journal/recovery.h"

#include "model/environment.h"
#include "model/formats/messages.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>

namespace suffuse {

namespace {

constexpr int unreadableDays = 30;
constexpr int unwantedDays = 90;
constexpr int unfinishedDays = 1;

QFileInfoList filesIn(const QString &folder, const char *ending)
{
    return QDir(folder).entryInfoList({QLatin1Char('*') + QLatin1String(ending)}, QDir::Files | QDir::Hidden);
}

QString idOf(const QString &path)
{
    return QFileInfo(path).completeBaseName();
}

} // namespace

QString journalFolder()
{
    using environment::Variable;
    if (const QString given = QString::fromStdString(environment::value(Variable::Journals)); !given.isEmpty())
        return QDir(given).absolutePath();
#ifdef Q_OS_LINUX
    const QString state = QString::fromStdString(environment::value(Variable::StateHome));
    const QString base = QDir::isAbsolutePath(state) ? state : QDir::homePath() + QLatin1String("/.local/state");
#else
    const QString base = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
#endif
    return base + QLatin1String("/suffuse/journals");
}

QString LostDocument::id() const
{
    return idOf(file->path());
}

Journals findJournals(const QString &folder)
{
    Journals found;
    for (const QFileInfo &info : filesIn(folder, journalEnding)) {
        const QString path = info.absoluteFilePath();
        OtherJournal other{idOf(path), {}, info.lastModified(), JournalFile::openAbandoned(path)};
        if (!other.file) {
            found.inUse.push_back(std::move(other));
            continue;
        }
        Result<JournalContent> content = readJournal(other.file->readAll(), path);
        if (!content) {
            other.reason = content.error();
            found.unreadable.push_back(std::move(other));
        } else if (!content->modified) {
            found.saved.push_back(std::move(other));
        } else {
            found.lost.push_back({std::move(other.file), std::move(*content)});
        }
    }
    std::stable_sort(found.lost.begin(), found.lost.end(), [](const LostDocument &a, const LostDocument &b) {
        return a.content.lastChange > b.content.lastChange;
    });
    return found;
}

void tidyJournals(Journals &journals, const QString &folder, const QDateTime &now)
{
    for (const OtherJournal &journal : journals.saved)
        journal.file->remove();
    journals.saved.clear();
    std::erase_if(journals.unreadable, [&](const OtherJournal &journal) {
        const bool old = journal.lastChange.daysTo(now) > unreadableDays;
        if (old)
            journal.file->remove();
        return old;
    });
    std::erase_if(journals.lost, [&](const LostDocument &document) {
        const bool old = document.lastChange().daysTo(now) > unwantedDays;
        if (old)
            document.file->remove();
        return old;
    });
    for (const QFileInfo &info : filesIn(folder, unfinishedEnding))
        if (info.lastModified().daysTo(now) > unfinishedDays)
            if (const auto file = JournalFile::openAbandoned(info.absoluteFilePath()))
                file->remove();
}

} // namespace suffuse

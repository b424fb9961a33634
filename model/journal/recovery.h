// What is left of documents whose program ended without closing them.
#pragma once

#include "model/journal/journal_file.h"
#include "model/journal/journal_format.h"

#include <QDateTime>

namespace suffuse {

inline constexpr char journalEnding[] = ".journal";
/// Behind it while a journal is begun; what ends so was never in use.
inline constexpr char unfinishedEnding[] = ".new";

/// The folder of journals: what the environment variable SUFFUSE_JOURNALS names, else one of the user's state.
QString journalFolder();

/// A document that can be recovered. Nobody else is offered it while this lives.
struct LostDocument {
    std::shared_ptr<JournalFile> file;
    JournalContent content;

    /// Name of the journal, for the command line.
    QString id() const;
    QDateTime lastChange() const { return QDateTime::fromMSecsSinceEpoch(content.lastChange); }
    /// "flowers.suffuse", or "Untitled"
    const QString &name() const { return content.head.name; }
};

/// A journal without anything to offer.
struct OtherJournal {
    QString id;
    QString reason; ///< why it cannot be read; empty where it can
    QDateTime lastChange;
    std::shared_ptr<JournalFile> file; ///< null where a program is writing it
};

struct Journals {
    std::vector<LostDocument> lost;  ///< the newest first
    std::vector<OtherJournal> saved; ///< their documents hold all that was done
    std::vector<OtherJournal> unreadable;
    std::vector<OtherJournal> inUse;
};
/// Reads the journals of a folder. Alters nothing.
Journals findJournals(const QString &folder);

/// Removes what is of no use any more: journals of documents that were saved, unreadable ones after a month, ones that
/// nobody wanted to recover for a quarter of a year, unfinished ones.
void tidyJournals(Journals &journals, const QString &folder, const QDateTime &now);

} // namespace suffuse

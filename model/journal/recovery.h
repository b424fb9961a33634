// Finds the documents whose program ended without closing them.
#pragma once

#include "model/journal/journal_file.h"
#include "model/journal/journal_format.h"

#include <QDateTime>

namespace suffuse {

inline constexpr char journalEnding[] = ".journal";
/// The ending of a journal that is being begun. A file with this ending was never in use.
inline constexpr char unfinishedEnding[] = ".new";

/// The folder of journals: the one that the environment variable SUFFUSE_JOURNALS names, else one in the user's state
/// folder.
QString journalFolder();

/// A document that can be recovered. While this object lives, nobody else is offered the document.
struct LostDocument {
    std::shared_ptr<JournalFile> file;
    JournalContent content;

    /// The name of the journal, for the command line.
    QString id() const;
    QDateTime lastChange() const { return QDateTime::fromMSecsSinceEpoch(content.lastChange); }
    /// A name such as "flowers.suffuse"; empty: it has none.
    const QString &name() const { return content.head.name; }
};

/// A journal that has nothing to offer.
struct OtherJournal {
    QString id;
    QString reason; ///< why it cannot be read; empty if it can
    QDateTime lastChange;
    std::shared_ptr<JournalFile> file; ///< null if a program is writing it
};

struct Journals {
    std::vector<LostDocument> lost;  ///< the newest first
    std::vector<OtherJournal> saved; ///< their documents' files have all that was done
    std::vector<OtherJournal> unreadable;
    std::vector<OtherJournal> inUse;
};
/// Reads the journals of a folder. It changes nothing.
Journals findJournals(const QString &folder);

/// Removes what is no longer of use: journals of documents that were saved, unreadable ones after a month, those that
/// nobody wanted to recover for three months, and unfinished ones.
void tidyJournals(Journals &journals, const QString &folder, const QDateTime &now);

} // namespace suffuse

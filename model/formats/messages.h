// What all readers and writers of files share: the context of translations, and how messages name values.
#pragma once

#include "model/result.h"

#include <QByteArray>
#include <QCoreApplication>
#include <QStringList>

#include <string_view>
#include <vector>

namespace suffuse {

/// The context of translations for all messages about files.
struct FileMessages {
    Q_DECLARE_TR_FUNCTIONS(suffuse::Files)
};

/// A path as the user gave it; "standard input" for "-".
QString shownName(const QString &path);
/// A piece of a file for a message: at most 40 characters, with control characters replaced.
QString excerpt(std::string_view text);

/// An error as "NAME: WHAT", the form of every message about a file's content.
inline Error fileError(const QString &fileName, const QString &what)
{
    return Error{shownName(fileName) + QStringLiteral(": ") + what};
}

/// How much of one kind was left out. The sentence is like "3 fills, 2 gradients were left out.", about the kinds whose
/// number is above 0; it is empty if there are none.
struct LeftOut {
    int count = 0;
    QString what; ///< the words for it, with the number
};
QString leftOutSentence(const std::vector<LeftOut> &kinds);
/// Joins the sentences that are not empty, one after the other.
QString joinedSentences(const QStringList &sentences);

/// The largest file that is read or written, bytes.
inline constexpr qint64 largestFile = qint64(2) << 30;
/// The largest image inside a painting, bytes.
inline constexpr qint64 largestImage = qint64(64) << 20;

} // namespace suffuse

// What every reader and writer of files shares: the translation context and how messages name values.
#pragma once

#include "model/result.h"

#include <QByteArray>
#include <QCoreApplication>

#include <string_view>
#include <vector>

namespace suffuse {

/// Translation context of all messages about files.
struct FileMessages {
    Q_DECLARE_TR_FUNCTIONS(suffuse::Files)
};

/// A path as the user gave it; "standard input" for "-".
QString shownName(const QString &path);
/// A piece of a file for a message: at most 40 characters, control characters replaced.
QString excerpt(std::string_view text);

/// "NAME: WHAT", the form of every message about a file's content.
inline Error fileError(const QString &fileName, const QString &what)
{
    return Error{shownName(fileName) + QStringLiteral(": ") + what};
}

/// "3 fills, 2 gradients were left out.", of the kinds whose number is above 0; empty where there are none.
struct LeftOut {
    int count = 0;
    QString what; ///< with the number
};
QString leftOutSentence(const std::vector<LeftOut> &kinds);

/// Largest file that is read or written, bytes.
inline constexpr qint64 largestFile = qint64(2) << 30;
/// Largest image inside a painting, bytes.
inline constexpr qint64 largestImage = qint64(64) << 20;

} // namespace suffuse

// The programs that the harness tries, and what they say.
#pragma once

#include "tests/trials.h"

#include <QByteArray>
#include <QString>

namespace suffuse {

/// Where the victim and the library of faults are: where they were built, or what SUFFUSE_HARNESS names.
inline QString harnessFile(const char *name)
{
    return qEnvironmentVariable("SUFFUSE_HARNESS", QStringLiteral(SUFFUSE_HARNESS_DIR)) + QLatin1Char('/') +
           QLatin1String(name);
}
inline QString victim()
{
    return harnessFile("suffuse_victim");
}

/// Number and rest of the last line that starts with a word; 0 where there is none.
struct Said {
    int number = 0;
    QByteArray rest;
};
inline Said lastSaid(const QByteArray &lines, const QByteArray &word)
{
    Said said;
    for (const QByteArray &line : lines.split('\n')) {
        const QList<QByteArray> words = line.split(' ');
        if (words.size() >= 2 && words[0] == word)
            said = {words[1].toInt(), words.mid(2).join(' ')};
    }
    return said;
}

} // namespace suffuse

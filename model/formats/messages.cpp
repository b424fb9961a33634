#include "model/formats/messages.h"

#include <QStringList>

#include <algorithm>

namespace suffuse {

QString shownName(const QString &path)
{
    return path == QLatin1String("-") ? FileMessages::tr("standard input") : path;
}

QString excerpt(std::string_view text)
{
    constexpr std::size_t most = 40;
    const bool cut = text.size() > most;
    QString shown = QString::fromUtf8(text.data(), qsizetype(std::min(text.size(), most)));
    for (QChar &c : shown) {
        if (c.category() == QChar::Other_Control)
            c = QChar(0xfffd);
    }
    return cut ? shown + QChar(0x2026) : shown;
}

QString leftOutSentence(const std::vector<LeftOut> &kinds)
{
    QStringList named;
    int count = 0;
    for (const LeftOut &kind : kinds) {
        if (kind.count <= 0)
            continue;
        named << kind.what;
        count = std::min(count, 1'000'000'000) + std::min(kind.count, 1'000'000'000);
    }
    if (named.isEmpty())
        return {};
    //: %1: a list such as "3 fills, 2 gradients"; the number is that of all things in it.
    return FileMessages::tr("%1 were left out.", nullptr, count).arg(named.join(FileMessages::tr(", ", "list")));
}

QString joinedSentences(const QStringList &sentences)
{
    QStringList said = sentences;
    said.removeAll(QString());
    return said.join(' ');
}

} // namespace suffuse

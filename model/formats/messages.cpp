#include "model/formats/messages.h"

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

} // namespace suffuse

#include "app/widgets/look/elided_sentences.h"

#include <QFontMetrics>

namespace suffuse {

namespace {

constexpr QChar fullStop(u'.'), wideStop(u'。');

/// Whether a sentence ends with this character. A point in a number or a key ends none.
bool endsSentence(const QString &text, qsizetype at)
{
    return text[at] == wideStop || (text[at] == fullStop && at + 1 < text.size() && text[at + 1].isSpace());
}

} // namespace

QString elidedSentences(const QString &text, const QFontMetrics &metrics, int room)
{
    if (metrics.horizontalAdvance(text) <= room)
        return text;
    for (qsizetype end = text.size() - 1; end > 0; --end) {
        if (!endsSentence(text, end - 1))
            continue;
        const QString line = text.first(end) + (text[end - 1] == wideStop ? QString() : QStringLiteral(" ")) + u'…';
        const int width = metrics.horizontalAdvance(line);
        if (width <= room && width >= room / 2)
            return line;
    }
    return metrics.elidedText(text, Qt::ElideRight, room);
}

} // namespace suffuse

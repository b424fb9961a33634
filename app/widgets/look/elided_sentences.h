#pragma once

#include <QString>

class QFontMetrics;

namespace suffuse {

/// As many whole sentences of a text as a line has room for, and "…" behind them where some are missing. Where that
/// would leave half of the line empty, the text is cut off where the room ends.
QString elidedSentences(const QString &text, const QFontMetrics &metrics, int room);

} // namespace suffuse

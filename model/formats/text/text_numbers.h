// Numbers as the text form prints them: the fewest digits that read back to the same value.
#pragma once

#include "model/painting/segment.h"

#include <QByteArray>

namespace suffuse {

void appendNumber(QByteArray &out, float value);
void appendNumber(QByteArray &out, double value);
void appendNumber(QByteArray &out, std::uint64_t value);
/// Appends seconds as an exact decimal: 16000 µs is 0.016.
void appendSeconds(QByteArray &out, Microseconds value);
/// Appends a JSON string in quotes.
void appendString(QByteArray &out, const QString &text);

} // namespace suffuse

#include "model/formats/text/text_numbers.h"

#include <QString>

#include <charconv>
#include <cmath>
#include <cstdio>

namespace suffuse {

namespace {

template <typename Number>
void appendShortest(QByteArray &out, Number value)
{
    char buffer[64];
    // to_chars prefers 1e+06 to 1000000; whole numbers of a readable length are printed in full.
    const bool whole = std::abs(value) < Number(1e9) && std::trunc(value) == value;
    const auto result = whole ? std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed)
                              : std::to_chars(buffer, buffer + sizeof buffer, value);
    out.append(buffer, result.ptr - buffer);
}

} // namespace

void appendNumber(QByteArray &out, float value)
{
    appendShortest(out, value);
}

void appendNumber(QByteArray &out, double value)
{
    appendShortest(out, value);
}

void appendNumber(QByteArray &out, std::uint64_t value)
{
    char buffer[24];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
    out.append(buffer, result.ptr - buffer);
}

void appendSeconds(QByteArray &out, Microseconds value)
{
    const std::uint64_t size = value < 0 ? 0 - std::uint64_t(value) : std::uint64_t(value);
    if (value < 0)
        out.append('-');
    appendNumber(out, size / 1'000'000);
    std::uint64_t fraction = size % 1'000'000;
    if (fraction == 0)
        return;
    char digits[7] = {'.', '0', '0', '0', '0', '0', '0'};
    for (int k = 6; k >= 1; --k, fraction /= 10)
        digits[k] = char('0' + fraction % 10);
    int length = 7;
    while (digits[length - 1] == '0')
        --length;
    out.append(digits, length);
}

void appendString(QByteArray &out, const QString &text)
{
    out.append('"');
    for (const char c : text.toUtf8()) {
        if (c == '"' || c == '\\') {
            out.append('\\').append(c);
        } else if (c == '\n') {
            out.append("\\n");
        } else if (static_cast<unsigned char>(c) < 0x20) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
            out.append(escape);
        } else {
            out.append(c);
        }
    }
    out.append('"');
}

} // namespace suffuse

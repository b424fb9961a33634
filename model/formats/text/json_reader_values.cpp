// Strings, numbers and the other values.
#include "model/formats/text/json_reader.h"

#include "model/formats/messages.h"

#include <QStringDecoder>

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

namespace suffuse {

namespace {

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// Of a valid JSON number that no double or float can hold: is it too large (rather than too small)?
bool isTooLarge(std::string_view token)
{
    const std::size_t e = token.find_first_of("eE");
    long long exponent = 0;
    if (e != token.npos) {
        std::size_t from = e + 1;
        if (token[from] == '+')
            ++from;
        const auto [end, code] = std::from_chars(token.data() + from, token.data() + token.size(), exponent);
        if (code != std::errc())
            return token[from] != '-';
    }
    // Power of ten of the first digit that is not 0.
    const std::string_view digits = token.substr(0, e);
    const std::size_t point = std::min(digits.find('.'), digits.size());
    const std::size_t first = digits.find_first_of("123456789");
    if (first == digits.npos)
        return false;
    const long long power = first < point ? (long long)(point - first) - 1 : (long long)point - (long long)first;
    return power + exponent > 0;
}

} // namespace

bool JsonReader::readHex(std::uint32_t &unit)
{
    unit = 0;
    if (m_end - m_at < 4)
        return false;
    const auto [end, code] = std::from_chars(m_at, m_at + 4, unit, 16);
    if (code != std::errc() || end != m_at + 4)
        return false;
    m_at = end;
    return true;
}

bool JsonReader::readEscape(std::string &text)
{
    static constexpr std::string_view letters = "\"\\/bfnrt", meanings = "\"\\/\b\f\n\r\t";
    const char c = m_at < m_end ? *m_at++ : '\0';
    if (const std::size_t k = letters.find(c); k != letters.npos) {
        text += meanings[k];
        return true;
    }
    std::uint32_t unit = 0, low = 0;
    bool good = c == 'u' && readHex(unit);
    if (good && unit >= 0xd800 && unit < 0xe000) {
        good = unit < 0xdc00 && m_end - m_at >= 6 && m_at[0] == '\\' && m_at[1] == 'u';
        m_at += good ? 2 : 0;
        good = good && readHex(low) && low >= 0xdc00 && low < 0xe000;
        unit = 0x10000 + ((unit & 0x3ff) << 10) + (low & 0x3ff);
    }
    if (!good) {
        failSyntax(FileMessages::tr("a string has a wrong escape “\\%1”").arg(QLatin1Char(c)));
        return false;
    }
    if (unit < 0x80) {
        text += char(unit);
    } else if (unit < 0x800) {
        text += {char(0xc0 | (unit >> 6)), char(0x80 | (unit & 0x3f))};
    } else if (unit < 0x10000) {
        text += {char(0xe0 | (unit >> 12)), char(0x80 | ((unit >> 6) & 0x3f)), char(0x80 | (unit & 0x3f))};
    } else {
        text += {char(0xf0 | (unit >> 18)), char(0x80 | ((unit >> 12) & 0x3f)), char(0x80 | ((unit >> 6) & 0x3f)),
                 char(0x80 | (unit & 0x3f))};
    }
    return true;
}

bool JsonReader::readText(std::string &text)
{
    text.clear();
    ++m_at; // the quote
    for (;;) {
        const char *from = m_at;
        while (m_at < m_end && *m_at != '"' && *m_at != '\\' && static_cast<unsigned char>(*m_at) >= 0x20)
            ++m_at;
        text.append(from, m_at);
        if (m_at >= m_end) {
            failSyntax(FileMessages::tr("the file ends inside a string; it is probably cut off"));
            return false;
        }
        if (*m_at == '"') {
            ++m_at;
            return true;
        }
        if (*m_at != '\\') {
            failSyntax(FileMessages::tr("a string has a control character; write it as an escape such as \\n"));
            return false;
        }
        ++m_at;
        if (!readEscape(text))
            return false;
    }
}

bool JsonReader::numberToken(std::string_view &token)
{
    if (!ok())
        return false;
    skipSpace();
    const char *p = m_at;
    const auto digits = [&] {
        const char *from = p;
        while (p < m_end && isDigit(*p))
            ++p;
        return p > from;
    };
    p += p < m_end && *p == '-';
    const char *whole = p;
    bool good = digits() && (*whole != '0' || p == whole + 1);
    if (good && p < m_end && *p == '.') {
        ++p;
        good = digits();
    }
    if (good && p < m_end && (*p == 'e' || *p == 'E')) {
        ++p;
        p += p < m_end && (*p == '+' || *p == '-');
        good = digits();
    }
    if (!good || (p < m_end && !std::strchr(" \t\r\n,]}", *p))) {
        failType(FileMessages::tr("a number"));
        return false;
    }
    token = {m_at, std::size_t(p - m_at)};
    m_at = p;
    return true;
}

template <typename Number>
void JsonReader::readFloating(Number &value)
{
    std::string_view token;
    if (!numberToken(token))
        return;
    const auto [end, code] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (code == std::errc())
        return;
    if (isTooLarge(token))
        fail(FileMessages::tr("%1 is too large; the largest number is %2")
                 .arg(excerpt(token))
                 .arg(double(std::numeric_limits<Number>::max()), 0, 'g', 4));
    value = token.front() == '-' ? Number(-0.0) : Number(0);
}

void JsonReader::read(float &value)
{
    readFloating(value);
}

void JsonReader::read(double &value)
{
    readFloating(value);
}

void JsonReader::read(std::uint64_t &value)
{
    std::string_view token;
    if (!numberToken(token))
        return;
    const auto [end, code] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (code != std::errc() || end != token.data() + token.size())
        fail(FileMessages::tr("%1 is not a whole number from 0 to 2^64 − 1").arg(excerpt(token)));
}

void JsonReader::readSeconds(Microseconds &value)
{
    std::string_view token;
    if (!numberToken(token))
        return;
    double seconds = 0;
    const auto [end, code] = std::from_chars(token.data(), token.data() + token.size(), seconds);
    if (code != std::errc() ? isTooLarge(token) : std::abs(seconds) > 1e12) {
        fail(FileMessages::tr("%1 s is not in [-1e12, 1e12]").arg(excerpt(token)));
        return;
    }
    // Whole microseconds are read as integers: a double has no room for them beyond 285 years.
    const std::size_t point = std::min(token.find('.'), token.size());
    if (token.find_first_of("eE") == token.npos && token.size() <= point + 7) {
        std::string digits(token.substr(0, point));
        if (point < token.size())
            digits += token.substr(point + 1);
        digits.append(6 - (point < token.size() ? token.size() - point - 1 : 0), '0');
        std::from_chars(digits.data(), digits.data() + digits.size(), value);
        return;
    }
    value = std::llround(seconds * 1e6);
}

void JsonReader::read(bool &value)
{
    if (!ok())
        return;
    skipSpace();
    const std::string_view token = valueToken();
    if (token != "true" && token != "false") {
        failType(FileMessages::tr("true or false"));
        return;
    }
    value = token == "true";
    m_at += token.size();
}

bool JsonReader::skipNull()
{
    if (!ok())
        return false;
    skipSpace();
    if (valueToken() != "null")
        return false;
    m_at += 4;
    return true;
}

void JsonReader::read(QString &value)
{
    if (!ok())
        return;
    skipSpace();
    if (m_at >= m_end || *m_at != '"') {
        failType(FileMessages::tr("a string in quotes"));
        return;
    }
    if (!readText(m_text))
        return;
    QStringDecoder decoder(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    value = decoder(QByteArrayView(m_text.data(), qsizetype(m_text.size())));
    if (decoder.hasError())
        fail(FileMessages::tr("is not UTF-8; save the file in that encoding"));
}

} // namespace suffuse

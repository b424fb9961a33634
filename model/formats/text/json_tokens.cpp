#include "model/formats/text/json_tokens.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace suffuse::json {

namespace {

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// Reads the four digits of a UTF-16 unit.
bool readHex(const char *&at, const char *end, std::uint32_t &unit)
{
    unit = 0;
    if (end - at < 4)
        return false;
    const auto [last, code] = std::from_chars(at, at + 4, unit, 16);
    if (code != std::errc() || last != at + 4)
        return false;
    at = last;
    return true;
}

bool readEscape(const char *&at, const char *end, std::string &text, char &escape)
{
    static constexpr std::string_view letters = "\"\\/bfnrt", meanings = "\"\\/\b\f\n\r\t";
    const char c = escape = at < end ? *at++ : '\0';
    if (const std::size_t k = letters.find(c); k != letters.npos) {
        text += meanings[k];
        return true;
    }
    std::uint32_t unit = 0, low = 0;
    bool good = c == 'u' && readHex(at, end, unit);
    if (good && unit >= 0xd800 && unit < 0xe000) {
        good = unit < 0xdc00 && end - at >= 6 && at[0] == '\\' && at[1] == 'u';
        at += good ? 2 : 0;
        good = good && readHex(at, end, low) && low >= 0xdc00 && low < 0xe000;
        unit = 0x10000 + ((unit & 0x3ff) << 10) + (low & 0x3ff);
    }
    if (!good)
        return false;
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

} // namespace

std::string_view valueAt(const char *at, const char *limit)
{
    const char *end = at;
    if (end < limit && *end == '"') {
        for (++end; end < limit && *end != '"' && end - at < 60; ++end)
            end += *end == '\\' && end + 1 < limit;
        end = std::min(end + 1, limit);
    } else if (end < limit && (*end == '{' || *end == '[')) {
        return *end == '{' ? "{…}" : "[…]";
    } else {
        while (end < limit && end - at < 60 && !std::strchr(" \t\r\n,]}:", *end))
            ++end;
        if (end == at && end < limit)
            ++end;
    }
    return {at, std::size_t(end - at)};
}

std::string_view numberAt(const char *at, const char *end)
{
    const char *p = at;
    const auto digits = [&] {
        const char *from = p;
        while (p < end && isDigit(*p))
            ++p;
        return p > from;
    };
    p += p < end && *p == '-';
    const char *whole = p;
    bool good = digits() && (*whole != '0' || p == whole + 1);
    if (good && p < end && *p == '.') {
        ++p;
        good = digits();
    }
    if (good && p < end && (*p == 'e' || *p == 'E')) {
        ++p;
        p += p < end && (*p == '+' || *p == '-');
        good = digits();
    }
    const bool ends = p == end || std::strchr(" \t\r\n,]}", *p);
    return good && ends ? std::string_view(at, std::size_t(p - at)) : std::string_view();
}

bool isTooLarge(std::string_view number)
{
    const std::size_t e = number.find_first_of("eE");
    long long exponent = 0;
    if (e != number.npos) {
        std::size_t from = e + 1;
        if (number[from] == '+')
            ++from;
        const auto [end, code] = std::from_chars(number.data() + from, number.data() + number.size(), exponent);
        if (code != std::errc())
            return number[from] != '-';
    }
    // This is the power of ten of the first digit that is not 0.
    const std::string_view digits = number.substr(0, e);
    const std::size_t point = std::min(digits.find('.'), digits.size());
    const std::size_t first = digits.find_first_of("123456789");
    if (first == digits.npos)
        return false;
    const long long power = first < point ? (long long)(point - first) - 1 : (long long)point - (long long)first;
    return power + exponent > 0;
}

std::optional<Microseconds> secondsOf(std::string_view number)
{
    double seconds = 0;
    const auto [end, code] = std::from_chars(number.data(), number.data() + number.size(), seconds);
    if (code != std::errc() ? isTooLarge(number) : std::abs(seconds) > 1e12)
        return {};
    Microseconds value = 0;
    // Whole microseconds are read as integers, since a double has too few digits for them beyond 285 years.
    const std::size_t point = std::min(number.find('.'), number.size());
    if (number.find_first_of("eE") == number.npos && number.size() <= point + 7) {
        std::string digits(number.substr(0, point));
        if (point < number.size())
            digits += number.substr(point + 1);
        digits.append(6 - (point < number.size() ? number.size() - point - 1 : 0), '0');
        std::from_chars(digits.data(), digits.data() + digits.size(), value);
        return value;
    }
    return std::llround(seconds * 1e6);
}

StringEnd readString(const char *&at, const char *end, std::string &text, char &escape)
{
    text.clear();
    for (;;) {
        const char *from = at;
        while (at < end && *at != '"' && *at != '\\' && static_cast<unsigned char>(*at) >= 0x20)
            ++at;
        text.append(from, at);
        if (at >= end)
            return StringEnd::EndOfFile;
        if (*at == '"') {
            ++at;
            return StringEnd::Quote;
        }
        if (*at != '\\')
            return StringEnd::ControlCharacter;
        ++at;
        if (!readEscape(at, end, text, escape))
            return StringEnd::WrongEscape;
    }
}

} // namespace suffuse::json

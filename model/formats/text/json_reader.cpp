#include "model/formats/text/json_reader.h"

#include "model/formats/messages.h"
#include "model/formats/text/json_tokens.h"

#include <QStringDecoder>

#include <charconv>
#include <limits>

namespace suffuse {

JsonReader::JsonReader(const QByteArray &bytes, const QString &fileName)
    : m_begin(bytes.constData()), m_at(m_begin), m_end(m_begin + bytes.size()), m_fileName(fileName)
{
    if (bytes.startsWith("\xef\xbb\xbf"))
        m_at += 3;
}

void JsonReader::skipSpace()
{
    while (m_at < m_end && (*m_at == ' ' || *m_at == '\n' || *m_at == '\r' || *m_at == '\t'))
        ++m_at;
}

bool JsonReader::isObjectNext()
{
    skipSpace();
    return ok() && m_at < m_end && *m_at == '{';
}

bool JsonReader::open(char bracket)
{
    if (!ok())
        return false;
    skipSpace();
    if (m_at < m_end && *m_at == bracket) {
        ++m_at;
        return true;
    }
    failType(bracket == '{' ? FileMessages::tr("an object {…}") : FileMessages::tr("a list […]"));
    return false;
}

bool JsonReader::nextItem(char closing, bool first)
{
    if (!ok())
        return false;
    skipSpace();
    if (m_at < m_end && *m_at == closing) {
        ++m_at;
        return false;
    }
    if (first && m_at < m_end)
        return true;
    if (m_at < m_end && *m_at == ',') {
        ++m_at;
        skipSpace();
        if (m_at < m_end && *m_at != closing)
            return true;
    }
    if (m_at >= m_end)
        failSyntax(
            FileMessages::tr("the file ends here, “%1” is missing; it is probably cut off").arg(QLatin1Char(closing)));
    else
        failSyntax(
            FileMessages::tr("expected “,” or “%1” before “%2”").arg(QLatin1Char(closing)).arg(excerpt(valueToken())));
    return false;
}

int JsonReader::memberName(std::span<const std::string_view> names, std::uint32_t found)
{
    if (*m_at != '"') {
        failSyntax(FileMessages::tr("expected a member's name in quotes before “%1”").arg(excerpt(valueToken())));
        return -1;
    }
    if (!readText(m_text))
        return -1;
    skipSpace();
    if (m_at >= m_end || *m_at != ':') {
        failSyntax(FileMessages::tr("expected “:” after “%1”").arg(excerpt(m_text)));
        return -1;
    }
    ++m_at;
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (names[k] != m_text)
            continue;
        if (found & (1u << k)) {
            failMember(names[k], FileMessages::tr("is given twice; keep one of them"));
            return -1;
        }
        return int(k);
    }
    const std::string name = m_text;
    failMember(name, FileMessages::tr("is not a member of this format; correct or remove it"));
    return -1;
}

std::string_view JsonReader::valueToken() const
{
    return json::valueAt(m_at, m_end);
}

void JsonReader::failType(const QString &wanted)
{
    skipSpace();
    if (m_at >= m_end)
        failSyntax(FileMessages::tr("the file ends here; it is probably cut off"));
    else if (*m_at == ',' || *m_at == '}' || *m_at == ']' || *m_at == ':')
        failSyntax(FileMessages::tr("expected %1 before “%2”").arg(wanted, QString(QLatin1Char(*m_at))));
    else
        fail(FileMessages::tr("%1 is not %2").arg(excerpt(valueToken()), wanted));
}

void JsonReader::failCount(std::size_t count, std::size_t wanted)
{
    fail(FileMessages::tr("has %1 numbers instead of %2").arg(count).arg(wanted));
}

void JsonReader::finish()
{
    skipSpace();
    if (ok() && m_at < m_end)
        failSyntax(
            FileMessages::tr("“%1” follows after the end of the painting; remove it").arg(excerpt(valueToken())));
}

QString JsonReader::pathText() const
{
    QString path;
    for (const Step &step : m_path) {
        if (step.name.empty())
            path += QStringLiteral("[%1]").arg(step.index);
        else
            path += (path.isEmpty() ? QString() : QStringLiteral(".")) + excerpt(step.name);
    }
    return path;
}

void JsonReader::fail(const QString &what)
{
    if (!ok())
        return;
    const QString path = pathText();
    m_error =
        shownName(m_fileName) + QStringLiteral(": ") + (path.isEmpty() ? what : path + QStringLiteral(": ") + what);
}

void JsonReader::failMember(std::string_view member, const QString &what)
{
    m_path.push_back({member, 0});
    fail(what);
    m_path.pop_back();
}

void JsonReader::failSyntax(const QString &what)
{
    if (!ok())
        return;
    qint64 line = 1;
    const char *lineStart = m_begin;
    for (const char *p = m_begin; p < m_at; ++p) {
        if (*p == '\n') {
            ++line;
            lineStart = p + 1;
        }
    }
    const qint64 column = QString::fromUtf8(lineStart, m_at - lineStart).size() + 1;
    m_error = shownName(m_fileName) + QStringLiteral(": ") +
              FileMessages::tr("line %1, column %2: %3").arg(line).arg(column).arg(what);
}

bool JsonReader::readText(std::string &text)
{
    ++m_at; // behind the quote
    char escape = 0;
    switch (json::readString(m_at, m_end, text, escape)) {
    case json::StringEnd::EndOfFile:
        failSyntax(FileMessages::tr("the file ends inside a string; it is probably cut off"));
        return false;
    case json::StringEnd::ControlCharacter:
        failSyntax(FileMessages::tr("a string has a control character; write it as an escape such as \\n"));
        return false;
    case json::StringEnd::WrongEscape:
        failSyntax(FileMessages::tr("a string has a wrong escape “\\%1”").arg(QLatin1Char(escape)));
        return false;
    case json::StringEnd::Quote:
        break;
    }
    return true;
}

bool JsonReader::numberToken(std::string_view &token)
{
    if (!ok())
        return false;
    skipSpace();
    token = json::numberAt(m_at, m_end);
    if (token.empty()) {
        failType(FileMessages::tr("a number"));
        return false;
    }
    m_at += token.size();
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
    if (json::isTooLarge(token))
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
    if (const std::optional<Microseconds> seconds = json::secondsOf(token))
        value = *seconds;
    else
        fail(FileMessages::tr("%1 s is not in [-1e12, 1e12]").arg(excerpt(token)));
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

#include "model/formats/text/json_reader.h"

#include "model/formats/messages.h"

#include <algorithm>
#include <cstring>

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
    const char *end = m_at;
    if (end < m_end && *end == '"') {
        for (++end; end < m_end && *end != '"' && end - m_at < 60; ++end)
            end += *end == '\\' && end + 1 < m_end;
        end = std::min(end + 1, m_end);
    } else if (end < m_end && (*end == '{' || *end == '[')) {
        return *end == '{' ? "{…}" : "[…]";
    } else {
        while (end < m_end && end - m_at < 60 && !std::strchr(" \t\r\n,]}:", *end))
            ++end;
        if (end == m_at && end < m_end)
            ++end;
    }
    return {m_at, std::size_t(end - m_at)};
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

} // namespace suffuse

#include "app/cli/options.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonDocument>
#include <QLocale>
#include <QTextStream>

#include <cmath>
#include <cstdio>

namespace suffuse::cli {

namespace {

/// Stands before a negative number while QCommandLineParser looks at it.
const QChar guard(0x200B);

} // namespace

CommandLine::CommandLine(const QString &command, const QString &description, const QStringList &positional)
    : m_command(command), m_most(int(positional.size()))
{
    m_parser.setApplicationDescription(description);
    m_parser.addPositionalArgument(command, QCoreApplication::translate("Cli", "The command."), command);
    for (const QString &name : positional)
        m_parser.addPositionalArgument(name, {}, name);
    m_parser.addOption(
        {{QStringLiteral("h"), QStringLiteral("help")}, QCoreApplication::translate("Cli", "Shows this help.")});
}

void CommandLine::add(const QStringList &names, const QString &description, const QString &value)
{
    m_parser.addOption(QCommandLineOption(names, description, value));
    m_options += names;
    if (!value.isEmpty())
        for (const QString &name : names)
            m_valueOptions.append((name.size() == 1 ? QStringLiteral("-") : QStringLiteral("--")) + name);
}

QStringList CommandLine::withProtectedNumbers(const QStringList &arguments) const
{
    QStringList out;
    bool isValue = false;
    for (const QString &a : arguments) {
        const bool isNumber = a.size() > 1 && a.startsWith(QLatin1Char('-')) && toNumber(a);
        out.append(isNumber && !isValue ? guard + a : a);
        isValue = !isValue && m_valueOptions.contains(a);
    }
    return out;
}

std::optional<int> CommandLine::parse(const QStringList &arguments, int required)
{
    const bool understood = m_parser.parse(withProtectedNumbers(arguments));
    if (m_parser.isSet(QStringLiteral("help")))
        return print(m_parser.helpText());
    if (!understood)
        return failUsage(m_command, m_parser.errorText());
    m_positional = m_parser.positionalArguments().mid(1);
    for (QString &a : m_positional)
        if (a.startsWith(guard))
            a.remove(0, 1);
    const int least = required < 0 ? m_most : required;
    if (m_positional.size() < least)
        return failUsage(m_command, QCoreApplication::translate("Cli", "too few arguments"));
    if (m_positional.size() > m_most)
        return failUsage(m_command,
                         QCoreApplication::translate("Cli", "one argument too many: %1").arg(m_positional.at(m_most)));
    return {};
}

void warn(const QString &message)
{
    QTextStream(stderr) << "suffuse-cli: " << message << Qt::endl;
}

int fail(const QString &message, ExitCode code)
{
    warn(message);
    return code;
}

int failUsage(const QString &command, const QString &message)
{
    const QString said = message.endsWith(QLatin1Char('.')) ? message.chopped(1) : message;
    return fail(QCoreApplication::translate("Cli", "%1: %2. See suffuse-cli %1 --help.").arg(command, said), WrongUsage);
}

int print(const QString &text)
{
    QFile out;
    if (!out.open(stdout, QIODevice::WriteOnly))
        return Failed;
    const QByteArray bytes = text.toUtf8();
    if (out.write(bytes) != bytes.size() || !out.flush() || std::fflush(stdout) != 0)
        return fail(QCoreApplication::translate("Cli", "standard output cannot be written: %1").arg(out.errorString()));
    return Done;
}

int printJson(const QJsonObject &object)
{
    return print(QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Indented)));
}

std::optional<double> toNumber(const QString &text)
{
    bool ok = false;
    const double v = QLocale::c().toDouble(text.trimmed(), &ok);
    if (!ok || !std::isfinite(v))
        return {};
    return v;
}

} // namespace suffuse::cli

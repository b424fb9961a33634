#include "app/cli/options.h"

#include "model/formats/files.h"
#include "render/image_io/file_replacement.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonDocument>
#include <QLocale>
#include <QSet>
#include <QTextStream>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>

#include <unistd.h>

namespace suffuse::cli {

namespace {

/// Stands before a negative number while QCommandLineParser looks at it.
const QChar guard(0x200B);

QString withDashes(const QString &name)
{
    return (name.size() == 1 ? QStringLiteral("-") : QStringLiteral("--")) + name;
}

/// What an argument is, by its name in the syntax.
QString meaningOfArgument(const QString &argument)
{
    if (argument == QLatin1String("IN"))
        return QCoreApplication::translate("Cli", "The painting, recording or drawing to read; -: standard input.");
    if (argument == QLatin1String("PICTURE"))
        return QCoreApplication::translate("Cli", "The picture to read: PNG, JPEG, TIFF, EXR, WebP or diffusion curves (XML); -: "
                                                  "standard input.");
    if (argument == QLatin1String("OUT"))
        return QCoreApplication::translate("Cli", "The file to write: .suffuse or .json; -: standard output.");
    if (argument == QLatin1String("FILE"))
        return QCoreApplication::translate("Cli", "The painting, recording or drawing to read.");
    if (argument == QLatin1String("PNG"))
        return QCoreApplication::translate("Cli", "The PNG file to write; -: standard output.");
    if (argument == QLatin1String("SIDE"))
        return QCoreApplication::translate("Cli", "So many pixels a side at most, 1 to 1024.");
    if (argument == QLatin1String("A"))
        return QCoreApplication::translate("Cli", "The painting before; -: standard input.");
    if (argument == QLatin1String("B"))
        return QCoreApplication::translate("Cli", "The painting after; -: standard input.");
    if (argument == QLatin1String("X"))
        return QCoreApplication::translate("Cli", "How far right of the canvas' left edge, in canvas units.");
    if (argument == QLatin1String("Y"))
        return QCoreApplication::translate("Cli", "How far below the canvas' upper edge, in canvas units.");
    if (argument == QLatin1String("ID"))
        return QCoreApplication::translate("Cli", "Which one, as the list names it.");
    if (argument == QLatin1String("EXTENSION"))
        return QCoreApplication::translate("Cli", "Its id, as extension list names it, or the path of its folder.");
    if (argument == QLatin1String("FOLDER"))
        return QCoreApplication::translate("Cli", "The folder of the farm, which all machines share.");
    return {};
}

} // namespace

CommandLine::CommandLine(const QString &command, const QString &description, const QStringList &positional)
    : m_command(command), m_syntax(positional)
{
    m_parser.setApplicationDescription(description);
    for (const QString &name : positional)
        m_parser.addPositionalArgument(name, meaningOfArgument(name));
    m_parser.addOption(
        {{QStringLiteral("h"), QStringLiteral("help")}, QCoreApplication::translate("Cli", "Shows this help.")});
}

void CommandLine::add(const QStringList &names, const QString &description, const QString &value)
{
    m_parser.addOption(QCommandLineOption(names, description, value));
    for (const QString &name : names) {
        m_options.insert(name, names.front());
        if (!value.isEmpty())
            m_valueOptions.append(withDashes(name));
    }
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

QString CommandLine::repeatedOption() const
{
    QSet<QString> given;
    for (const QString &name : m_parser.optionNames()) {
        const QString option = m_options.value(name);
        if (given.contains(option) && !m_repeatable.contains(option))
            return withDashes(name);
        given.insert(option);
    }
    return {};
}

QString CommandLine::help(int required) const
{
    QString usage = QCoreApplication::translate("Cli", "Usage: suffuse-cli %1 [options]").arg(m_command);
    for (int k = 0; k < int(m_syntax.size()); ++k)
        usage += (k < required ? QStringLiteral(" %1") : QStringLiteral(" [%1]")).arg(m_syntax.at(k)) +
                 (k == 0 && m_isSeveral ? QStringLiteral("…") : QString());
    const QString text = m_parser.helpText(); // its first line puts the options before the command
    return usage + text.mid(text.indexOf('\n'));
}

std::optional<int> CommandLine::parse(const QStringList &arguments, int required)
{
    const bool understood = m_parser.parse(withProtectedNumbers(arguments));
    if (m_parser.isSet(QStringLiteral("help")))
        return print(help(required < 0 ? int(m_syntax.size()) : required));
    if (!understood)
        return failUsage(m_command, m_parser.errorText());
    if (const QString option = repeatedOption(); !option.isEmpty())
        return failUsage(m_command, QCoreApplication::translate("Cli", "%1 is given twice; give it once").arg(option));
    m_positional = m_parser.positionalArguments().mid(1);
    for (QString &a : m_positional)
        if (a.startsWith(guard))
            a.remove(0, 1);
    if (m_positional.size() < (required < 0 ? m_syntax.size() : required))
        return failUsage(m_command, QCoreApplication::translate("Cli", "too few arguments"));
    if (m_positional.size() > m_syntax.size() && !m_isSeveral)
        return failUsage(
            m_command,
            QCoreApplication::translate("Cli", "one argument too many: %1").arg(m_positional.at(m_syntax.size())));
    return {};
}

Result<Painting> paintingOf(const QString &path, double *resolution)
{
    QString leftOut;
    Result<Painting> painting = loadPainting(path, nullptr, &leftOut, resolution);
    if (painting && !leftOut.isEmpty())
        warn(QStringLiteral("%1: %2").arg(path, leftOut));
    return painting;
}

bool isSameFile(const QString &in, const QString &out)
{
    const QString file = in == QLatin1String("-") ? QString() : QFileInfo(in).canonicalFilePath();
    return !file.isEmpty() && file == QFileInfo(out).canonicalFilePath();
}

QString inputWouldBeLost(const QString &out)
{
    return QCoreApplication::translate("Cli", "%1: is IN itself, which would be lost; give OUT another name").arg(out);
}

QString problemOfPictureFile(const QString &out)
{
    if (out == QLatin1String("-"))
        return {};
    FileReplacement file(out); // which leaves nothing behind
    const Result<void> opened = file.open();
    return opened ? QString() : opened.error();
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
    return fail(QCoreApplication::translate("Cli", "%1: %2. See suffuse-cli %1 --help.").arg(command, said),
                WrongUsage);
}

int print(const QString &text)
{
    return printBytes(text.toUtf8());
}

int printBytes(const QByteArray &bytes)
{
    for (qsizetype at = 0; at < bytes.size();) {
        const ssize_t written = ::write(STDOUT_FILENO, bytes.constData() + at, std::size_t(bytes.size() - at));
        if (written >= 0) {
            at += written;
        } else if (errno == EPIPE) {
            std::signal(SIGPIPE, SIG_DFL);
            std::raise(SIGPIPE);
        } else if (errno != EINTR || interrupted()) {
            return fail(QCoreApplication::translate("Cli", "standard output cannot be written: %1")
                            .arg(QString::fromLocal8Bit(std::strerror(errno))));
        }
    }
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

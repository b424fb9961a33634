#include "app/cli/fitting/fit_options.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

#include <array>
#include <cmath>
#include <cstdio>

namespace suffuse::cli {

Result<double> numberOf(const CommandLine &line, const QString &option, double usual, const NumberRange &range)
{
    if (!line.isSet(option))
        return usual;
    const std::optional<double> value = toNumber(line.value(option));
    if (!value || *value < range.least || *value > range.greatest || (range.isWhole && *value != std::floor(*value)))
        return Error{(range.isWhole ? QCoreApplication::translate("Cli", "--%1 %2: give a whole number from %3 to %4")
                                    : QCoreApplication::translate("Cli", "--%1 %2: give a number from %3 to %4"))
                         .arg(option, line.value(option))
                         .arg(range.least, 0, 'g', 12)
                         .arg(range.greatest, 0, 'g', 12)};
    return *value;
}

Result<StyleKind> styleOf(const CommandLine &line)
{
    const QString name = line.isSet("style") ? line.value("style") : QStringLiteral("feathering");
    constexpr std::array names = {std::pair("feathering", StyleKind::Feathering),
                                  std::pair("uniform", StyleKind::Uniform), std::pair("edge", StyleKind::Edge)};
    for (const auto &[known, kind] : names)
        if (name == QLatin1String(known))
            return kind;
    return Error{QCoreApplication::translate("Cli", "--style %1: give feathering, uniform or edge").arg(name)};
}

Result<QByteArray> inputBytes(const QString &path)
{
    QFile file(path);
    const bool isOpen =
        path == QLatin1String("-") ? file.open(stdin, QIODevice::ReadOnly) : file.open(QIODevice::ReadOnly);
    if (!isOpen)
        return Error{QStringLiteral("%1: %2").arg(path, file.errorString())};
    return file.readAll();
}

QString problemOfOut(const QString &out)
{
    const QFileInfo file(out), folder(file.absolutePath());
    if (!folder.isDir())
        return QCoreApplication::translate("Cli", "%1: there is no folder %2").arg(out, folder.filePath());
    if (!folder.isWritable() || file.isDir())
        return QCoreApplication::translate("Cli", "%1: cannot be written").arg(out);
    return {};
}

} // namespace suffuse::cli

#include "model/formats/brushes/gimp_palette.h"

#include "model/formats/messages.h"
#include "model/painting/ryb.h"

#include <QStringDecoder>

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse {

namespace {

constexpr qsizetype largestPalette = 1 << 20;
constexpr std::size_t mostColours = 10'000;
constexpr QLatin1String signature("GIMP Palette");
constexpr QLatin1String nameless("Untitled"); ///< the name that GIMP gives to a colour without a name

/// Decodes UTF-8, or Latin-1 from older programs.
QString decoded(const QByteArray &bytes)
{
    QStringDecoder utf8(QStringDecoder::Utf8);
    const QString text = utf8(bytes);
    return utf8.hasError() ? QString::fromLatin1(bytes) : text;
}

/// Takes the numbers of "R G B NAME" off the front of `rest`. Returns an empty text, or what is wrong.
QString takeChannels(QStringView &rest, std::array<int, 3> &channels)
{
    for (int &channel : channels) {
        rest = rest.trimmed();
        qsizetype length = 0;
        while (length < rest.size() && !rest[length].isSpace())
            ++length;
        bool ok = false;
        channel = rest.left(length).toInt(&ok);
        if (!ok || channel < 0 || channel > 255)
            return length == 0 ? FileMessages::tr("a colour has three numbers: red, green, blue")
                               : FileMessages::tr("“%1” is not a number from 0 to 255")
                                     .arg(excerpt(rest.left(length).toUtf8().toStdString()));
        rest = rest.mid(length);
    }
    return {};
}

QString oneLine(const QString &text)
{
    return text.simplified();
}

} // namespace

Result<GimpPalette> readGimpPalette(const QByteArray &bytes, const QString &fileName)
{
    if (bytes.size() > largestPalette)
        return fileError(fileName, FileMessages::tr("is larger than 1 MiB; a palette is not"));
    const QString text = decoded(bytes);
    GimpPalette palette;
    int number = 0;
    for (QStringView line : QStringView(text).split(u'\n')) {
        ++number;
        line = line.trimmed();
        const auto wrong = [&](const QString &what) {
            return fileError(fileName, FileMessages::tr("line %1: %2").arg(number).arg(what));
        };
        if (number == 1) {
            if (line != signature)
                return wrong(FileMessages::tr("“GIMP Palette” is missing: this is no GIMP palette"));
        } else if (line.startsWith(u"Name:") && palette.swatches.empty()) {
            palette.name = line.mid(5).trimmed().toString();
        } else if (!line.isEmpty() && !line.startsWith(u'#') && !line.startsWith(u"Columns:")) {
            std::array<int, 3> rgb{};
            if (const QString problem = takeChannels(line, rgb); !problem.isEmpty())
                return wrong(problem);
            if (palette.swatches.size() == mostColours)
                return wrong(FileMessages::tr("there are more than %1 colours").arg(mostColours));
            const QString name = line.trimmed().toString();
            palette.swatches.push_back(
                {name == nameless ? QString() : name, rybFromSrgb(rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0)});
        }
    }
    return palette;
}

QByteArray writeGimpPalette(const GimpPalette &palette)
{
    QString out = QStringLiteral("GIMP Palette\nName: %1\nColumns: 0\n#\n").arg(oneLine(palette.name));
    for (const Swatch &swatch : palette.swatches) {
        for (const double channel : srgbFromRyb(swatch.colour))
            out += QStringLiteral("%1 ").arg(std::lround(255 * std::clamp(channel, 0.0, 1.0)), 3);
        const QString name = oneLine(swatch.name);
        out.back() = u'\t';
        out += (name.isEmpty() ? QString(nameless) : name) + u'\n';
    }
    return out.toUtf8();
}

} // namespace suffuse

#include "app/session/colour_convert.h"

#include "model/formats/svg/css/css_colours.h"
#include "model/painting/ryb.h"

#include <QMimeData>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <array>

namespace suffuse {

namespace {
const QString colourMime = QStringLiteral("application/x-suffuse-colour");
} // namespace

QColor toOpaqueScreen(const Colour &colour)
{
    const auto rgb = srgbFromRyb(colour);
    return QColor::fromRgbF(float(std::clamp(rgb[0], 0.0, 1.0)), float(std::clamp(rgb[1], 0.0, 1.0)),
                            float(std::clamp(rgb[2], 0.0, 1.0)));
}

QColor toScreen(const Colour &colour)
{
    QColor screen = toOpaqueScreen(colour);
    screen.setAlphaF(colour.opacity);
    return screen;
}

Colour fromScreen(const QColor &colour)
{
    // The 8-bit channels are taken from the integers, so that hex fields come back as they were typed.
    Colour result = rybFromSrgb(colour.red() / 255.0, colour.green() / 255.0, colour.blue() / 255.0);
    result.opacity = float(colour.alpha() / 255.0);
    return result;
}

std::optional<Colour> typedColour(const QString &text)
{
    static const QRegularExpression form("^#?([0-9A-Fa-f]{3}|[0-9A-Fa-f]{6})$");
    const QRegularExpressionMatch match = form.match(text.trimmed());
    if (match.hasMatch())
        return fromScreen(QColor("#" + match.captured(1)));
    const auto css = text.contains('#') ? std::nullopt : cssColour(text.trimmed());
    if (!css || (*css)[3] == 0) // "transparent" names no colour
        return {};
    return fromScreen(QColor::fromRgbF(float((*css)[0]), float((*css)[1]), float((*css)[2])));
}

QString textOf(const Colour &colour)
{
    const auto text = [](float channel) { return QString::number(double(channel), 'g', 9); };
    return QStringList{text(colour.red), text(colour.yellow), text(colour.blue), text(colour.opacity)}.join(' ');
}

std::optional<Colour> colourOfText(const QString &text)
{
    const QStringList parts = text.split(' ');
    std::array<float, 4> channels{};
    if (parts.size() != qsizetype(channels.size()))
        return {};
    for (std::size_t i = 0; i < channels.size(); ++i) {
        bool ok = false;
        channels[i] = parts[qsizetype(i)].toFloat(&ok);
        if (!ok || !(channels[i] >= 0 && channels[i] <= 1))
            return {};
    }
    return Colour{channels[0], channels[1], channels[2], channels[3]};
}

QMimeData *dragDataOf(const Colour &colour)
{
    auto *data = new QMimeData;
    data->setColorData(toScreen(colour));
    data->setData(colourMime, textOf(colour).toLatin1());
    return data;
}

std::optional<Colour> colourOf(const QMimeData &data)
{
    if (const auto colour = colourOfText(QString::fromLatin1(data.data(colourMime))))
        return colour;
    return data.hasColor() ? std::optional(fromScreen(data.colorData().value<QColor>())) : std::nullopt;
}

} // namespace suffuse

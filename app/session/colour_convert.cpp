#include "app/session/colour_convert.h"

#include "model/painting/ryb.h"

#include <QMimeData>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>

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

Colour pureHue(double hue)
{
    const double h = 6 * (hue - std::floor(hue));
    const auto channel = [h](double centre) {
        double d = std::abs(h - centre);
        d = std::min(d, 6 - d);
        return float(std::clamp(2 - d, 0.0, 1.0));
    };
    return {channel(0), channel(2), channel(4), 1};
}

HueShares toShares(const Colour &colour, double hueOfGrey)
{
    const double r = colour.red, y = colour.yellow, b = colour.blue;
    const double high = std::max({r, y, b}), low = std::min({r, y, b});
    HueShares shares{hueOfGrey, high - low, low};
    if (shares.chroma < 1e-6)
        return shares;
    double h = 0;
    if (high == r)
        h = (y - b) / shares.chroma;
    else if (high == y)
        h = 2 + (b - r) / shares.chroma;
    else
        h = 4 + (r - y) / shares.chroma;
    shares.hue = h < 0 ? h / 6 + 1 : h / 6;
    return shares;
}

Colour fromShares(const HueShares &shares, float opacity)
{
    const Colour pure = pureHue(shares.hue);
    const auto channel = [&shares](float p) { return float(std::clamp(shares.chroma * p + shares.black, 0.0, 1.0)); };
    return {channel(pure.red), channel(pure.yellow), channel(pure.blue), opacity};
}

} // namespace suffuse

#include "app/session/colour/colour_words.h"

#include "app/session/colour_convert.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace suffuse {

namespace {

/// The names of the hues up to an angle of the colour circle: dark, as it is, and light.
struct Hue {
    int until; ///< degrees
    std::array<const char *, 3> words;
};

// Angles are those of red, green and blue light (HSV). Names stand whole in the table, since languages join them in their own ways.
constexpr Hue hues[] = {
    {12, {QT_TRANSLATE_NOOP("ColourWords", "dark red"), QT_TRANSLATE_NOOP("ColourWords", "red"),
          QT_TRANSLATE_NOOP("ColourWords", "light red")}},
    {42, {QT_TRANSLATE_NOOP("ColourWords", "brown"), QT_TRANSLATE_NOOP("ColourWords", "orange"),
          QT_TRANSLATE_NOOP("ColourWords", "light orange")}},
    {68, {QT_TRANSLATE_NOOP("ColourWords", "olive"), QT_TRANSLATE_NOOP("ColourWords", "yellow"),
          QT_TRANSLATE_NOOP("ColourWords", "light yellow")}},
    {90, {QT_TRANSLATE_NOOP("ColourWords", "dark yellow-green"), QT_TRANSLATE_NOOP("ColourWords", "yellow-green"),
          QT_TRANSLATE_NOOP("ColourWords", "light yellow-green")}},
    {158, {QT_TRANSLATE_NOOP("ColourWords", "dark green"), QT_TRANSLATE_NOOP("ColourWords", "green"),
           QT_TRANSLATE_NOOP("ColourWords", "light green")}},
    {195, {QT_TRANSLATE_NOOP("ColourWords", "dark turquoise"), QT_TRANSLATE_NOOP("ColourWords", "turquoise"),
           QT_TRANSLATE_NOOP("ColourWords", "light turquoise")}},
    {250, {QT_TRANSLATE_NOOP("ColourWords", "dark blue"), QT_TRANSLATE_NOOP("ColourWords", "blue"),
           QT_TRANSLATE_NOOP("ColourWords", "light blue")}},
    {292, {QT_TRANSLATE_NOOP("ColourWords", "dark violet"), QT_TRANSLATE_NOOP("ColourWords", "violet"),
           QT_TRANSLATE_NOOP("ColourWords", "light violet")}},
    {345, {QT_TRANSLATE_NOOP("ColourWords", "dark magenta"), QT_TRANSLATE_NOOP("ColourWords", "magenta"),
           QT_TRANSLATE_NOOP("ColourWords", "pink")}},
    {360, {QT_TRANSLATE_NOOP("ColourWords", "dark red"), QT_TRANSLATE_NOOP("ColourWords", "red"),
           QT_TRANSLATE_NOOP("ColourWords", "pink")}},
};

constexpr std::array<const char *, 5> greys{
    QT_TRANSLATE_NOOP("ColourWords", "black"), QT_TRANSLATE_NOOP("ColourWords", "dark grey"),
    QT_TRANSLATE_NOOP("ColourWords", "grey"), QT_TRANSLATE_NOOP("ColourWords", "light grey"),
    QT_TRANSLATE_NOOP("ColourWords", "white")};

const char *greyOf(double lightness)
{
    constexpr std::array<double, 4> borders{0.12, 0.36, 0.64, 0.93};
    return greys[std::size_t(std::ranges::upper_bound(borders, lightness) - borders.begin())];
}

} // namespace

QString wordOf(const Colour &colour)
{
    const QColor screen = toOpaqueScreen(colour);
    const double most = std::max({screen.redF(), screen.greenF(), screen.blueF()});
    const double least = std::min({screen.redF(), screen.greenF(), screen.blueF()});
    const double lightness = (most + least) / 2, chroma = most - least;
    const char *word = nullptr;
    constexpr double paleChroma = 0.11; // below it the hue is hardly seen
    if (chroma < paleChroma) {
        word = greyOf(lightness);
    } else {
        const int angle = std::max(0, screen.hsvHue());
        const auto *hue = std::ranges::find_if(hues, [angle](const Hue &h) { return angle < h.until; });
        // Yellow is light by itself, and blue is dark; so it is the strongest channel and the weakest that count.
        const bool isDark = most < 0.62, isLight = !isDark && least > 0.62;
        word = hue->words[isDark ? 0 : isLight ? 2 : 1];
    }
    return QCoreApplication::translate("ColourWords", word);
}

} // namespace suffuse

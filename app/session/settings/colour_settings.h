// What the program remembers of colour profiles.
#pragma once

#include "render/image_io/colour_conversion.h"

#include <QString>

namespace suffuse {

/// Whose profile tells what the screen makes of its numbers.
enum class ScreenProfile { System, None, File };

/// How the canvas shows colours.
struct ColourSettings {
    ScreenProfile screen = ScreenProfile::System;
    QString screenFile;  ///< the profile, where the choice is a file
    bool proofs = false; ///< whether the canvas shows what is left of the colours on another device
    bool marksGamut = false;
    QString proofFile; ///< that device's profile
    RenderingIntent intent = RenderingIntent::RelativeColorimetric;
    bool blackPoints = true;

    friend bool operator==(const ColourSettings &, const ColourSettings &) = default;
};

/// The conversion to a screen with this profile (empty: sRGB). Fails, with the file's name, if a profile cannot be
/// used.
Result<ColourConversion> screenConversion(const ColourSettings &settings, const QByteArray &systemProfile);

/// What the profile in a file is called; the file's name where it has no name or cannot be read.
QString titleOfProfileAt(const QString &path);

namespace settings {

ColourSettings colours();
void setColours(const ColourSettings &colours);

} // namespace settings

} // namespace suffuse

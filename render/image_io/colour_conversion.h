// Colours of one ICC profile as colours of another one, by the image module, which knows lcms2.
#pragma once

#include "model/result.h"
#include "render/image_io/module/api.h"

#include <QByteArray>
#include <QString>

#include <memory>

namespace suffuse {

/// The largest profile that is read, bytes. Those of presses with many tables have some megabytes.
inline constexpr qint64 largestProfile = qint64(16) << 20;

/// What a profile calls itself; empty if it has no name. Fails if these are no profile, or one for other colours than
/// RGB, grey or CMYK.
Result<QString> nameOfProfile(const QByteArray &profile);
/// What a profile is called, for people: its own name, or `otherwise` where it has none or is none.
QString titleOfProfile(const QByteArray &profile, const QString &otherwise);
/// Reads a profile's file. Fails, with the file's name, if it cannot be read, is too large, or is no profile.
Result<QByteArray> readProfile(const QString &path);

/// How colours that a profile has not become colours that it has (ICC.1, "rendering intents").
enum class RenderingIntent { Perceptual, RelativeColorimetric, Saturation, AbsoluteColorimetric };

/// From which profile to which one. An empty profile is sRGB, which is what Suffuse's pictures are in.
struct ColourProfiles {
    QByteArray from;
    QByteArray to;
    QByteArray proof; ///< the profile of a press or a screen whose colours are to be seen; empty: none
    RenderingIntent intent = RenderingIntent::RelativeColorimetric;
    bool blackPoints = true; ///< whether the darkest colour of one becomes the darkest of the other
    bool marksGamut = false; ///< whether the channels of what `proof` cannot show become -1

    bool operator==(const ColourProfiles &) const = default;
};

/// A conversion that is ready. Copies share it; it may be applied on several threads at once.
class ColourConversion {
public:
    /// Changes nothing.
    ColourConversion() = default;
    /// Fails if a profile is damaged, or is for colours that are not RGB (`from` may be for grey, `proof` for
    /// anything).
    static Result<ColourConversion> between(const ColourProfiles &profiles);

    /// Whether no channel changes by more than half of a 255th. Then `apply` leaves every bit as it is, so that a
    /// picture whose profile is sRGB is what it would be without.
    bool changesNothing() const { return !m_conversion; }
    /// Whether `from` is for grey: only the first channel counts.
    bool isFromGrey() const { return m_isGrey; }
    /// Converts pixels of four floats in place. Values may leave [0, 1]; alpha stays.
    void apply(float *rgba, std::size_t pixels) const;

private:
    std::shared_ptr<void> m_conversion;
    ImageModuleColoursApplyFunction m_apply = nullptr;
    bool m_isGrey = false;
};

} // namespace suffuse

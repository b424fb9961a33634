// How numbers are shown and typed. Whoever shows a number asks here, so that it reads alike wherever it stands.
#pragma once

#include <QString>

namespace suffuse {

/// From values to what is shown and back: shown = value · factor + offset, with the unit behind it. A factor below 0
/// turns the sense around.
struct Display {
    QString unit = {}; ///< " s", " %"; translated
    double factor = 1;
    double offset = 0;
    int decimals = -1; ///< at most so many; −1: some four digits in all

    double toShown(double value) const { return value * factor + offset; }
    double toValue(double shown) const { return (shown - offset) / factor + 0.0; } // + 0.0: a zero has no sign
    bool isReversed() const { return factor < 0; }
    /// "43.3", in the language's digits.
    QString number(double value) const;
    /// "43.3 %"
    QString text(double value) const { return number(value) + unit; }
};

/// Units as they stand behind a number, translated: of the canvas' lengths, of time and of diffusion.
QString canvasUnit();
QString secondsUnit();
QString diffusionUnit();

/// Lengths of the canvas, in units.
Display lengthDisplay();
Display timeDisplay();      ///< of seconds
Display diffusionDisplay(); ///< of units² a second
Display angleDisplay();     ///< of radians, in degrees
Display shareDisplay();     ///< of [0, 1], in per cent with at most one decimal
/// Of ω, which hides the paper: the amount of grain, 1 − ω, in per cent. 0 % is smooth, 100 % shows all of the grain.
Display grainDisplay();
/// Of differences of ω, as amounts of grain.
Display grainDifferenceDisplay();
Display screenDisplay(); ///< lengths of the screen, in logical pixels

} // namespace suffuse

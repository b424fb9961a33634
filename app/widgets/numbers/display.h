// How numbers are shown and typed. Everything that shows a number asks here, so that it reads alike wherever it stands.
#pragma once

#include <QString>

namespace suffuse {

/// Converts values to shown numbers and back: shown = value · factor + offset, with the unit behind it. A factor below
/// 0 turns the sense around.
struct Display {
    QString unit = {}; ///< " s", " %"; translated
    double factor = 1;
    double offset = 0;
    int decimals = -1; ///< at most so many decimals; −1: some four digits in all
    /// Of lengths, how many canvas units an inch has, so that millimetres and inches can be typed; 0: it is not known.
    double resolution = 0;
    bool isLength = false; ///< a length of the canvas: fields show it in the unit of their window (LengthUnits)
    double step = 1;       ///< what a step of 1 is, in values

    double toShown(double value) const { return value * factor + offset; }
    double toValue(double shown) const { return (shown - offset) / factor + 0.0; } // + 0.0: a zero has no sign
    bool isReversed() const { return factor < 0; }
    /// "43.3", in the language's digits.
    QString number(double value) const;
    /// "43.3 %", for reading alone: the digits of large numbers are grouped, as in "879,364 u".
    QString text(double value) const;
};

/// Units as they stand behind a number, translated: those of the canvas' lengths, of time and of diffusion.
QString canvasUnit();
QString millimetreUnit();
QString inchUnit();
QString secondsUnit();
QString diffusionUnit();

/// Displays lengths of the canvas: in units or, in a field, as its window does.
Display lengthDisplay();
Display timeDisplay();      ///< a time in seconds
Display diffusionDisplay(); ///< D in units² a second
Display angleDisplay();     ///< an angle in radians, shown in degrees
Display shareDisplay();     ///< a share in [0, 1], shown in per cent with at most one decimal
/// Displays ω, which hides the paper, as the amount of grain, 1 − ω, in per cent. 0 % is smooth, 100 % shows all of the
/// grain.
Display grainDisplay();
/// Displays differences of ω as differences of the amount of grain.
Display grainDifferenceDisplay();
Display screenDisplay(); ///< a length on the screen, in logical pixels

} // namespace suffuse

// Sheets to begin with: of screens, of paper, and with a ground of their own.
#pragma once

#include "model/painting/painting.h"

#include <QSizeF>
#include <QString>

#include <vector>

namespace suffuse {

constexpr double inch = 25.4;           ///< mm
constexpr double usualResolution = 150; ///< of paper, pixels an inch

struct SheetPreset {
    QString section; ///< the heading that it stands below, translated
    QString name;    ///< translated
    QString size;    ///< in pixels, or in millimetres and inches
    Canvas canvas;   ///< of paper at the usual resolution
    QSizeF paper;    ///< mm; empty: it has no size on paper
    bool hasGround = false; ///< background and grain belong to it

    /// The sides in units, where an inch of paper has so many pixels. A unit is a pixel.
    QSizeF sides(double resolution) const;
};

/// A side of a sheet of paper in whole units.
double unitsOf(double millimetres, double resolution);

/// All sheets that are offered, section by section, wherever somebody asks for a new painting.
std::vector<SheetPreset> sheetPresets();

} // namespace suffuse

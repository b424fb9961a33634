// Sheets to begin with: of screens, of paper, and with a ground of their own.
#pragma once

#include "model/painting/painting.h"
#include "model/painting/resolution.h"

#include <QSizeF>
#include <QString>

#include <vector>

namespace suffuse {

/// What a new painting begins with.
struct NewSheet {
    Canvas canvas;
    double resolution = 0; ///< canvas units an inch of paper; 0: it has no size on paper
};

struct SheetPreset {
    QString section;        ///< the heading that it stands below, translated
    QString name;           ///< translated
    QString size;           ///< in pixels, or in millimetres and inches
    Canvas canvas;          ///< of paper at the usual resolution
    QSizeF paper;           ///< mm; empty: it has no size on paper
    bool hasGround = false; ///< background and grain belong to it

    /// The sides in units, where an inch of paper has so many pixels. A unit is a pixel.
    QSizeF sides(double resolution) const;
    /// As it is offered: what has a size on paper has the usual resolution.
    NewSheet sheet() const { return {canvas, paper.isEmpty() ? 0 : usualResolution}; }
};

/// A side of a sheet of paper in whole units.
double unitsOf(double millimetres, double resolution);

/// What paper of a name, as PPD files have it, is called: "Letter". Names that are the same everywhere, as "A4", stay.
QString paperTitle(const QString &name);

/// All sheets that are offered, section by section, wherever somebody asks for a new painting.
std::vector<SheetPreset> sheetPresets();

} // namespace suffuse

// Sheets to begin with: of screens, of paper, and with a ground of their own.
#pragma once

#include "model/painting/painting.h"

#include <QString>

#include <vector>

namespace suffuse {

struct SheetPreset {
    QString section; ///< the heading that it stands below, translated
    QString name;    ///< translated
    QString size;    ///< in pixels, or in millimetres and inches
    Canvas canvas;
};

/// All of them, section by section. Paper has 150 pixels an inch; screens have a pixel a unit.
std::vector<SheetPreset> sheetPresets();

} // namespace suffuse

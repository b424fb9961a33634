// How a painting is put on paper, as its file keeps it.
#pragma once

#include "model/geometry/geometry.h"
#include "model/painting/segment.h"

#include <QString>

#include <array>

namespace suffuse {

/// A page, and what of a painting is printed on it. This is no part of the picture.
struct PrintSetup {
    enum class Size { FitPage, Actual, Scaled };
    enum class Area { Canvas, Painted, Selected, Shown, Numbers };
    enum class Moment { Dried, Now, Time };

    static constexpr double mostMargin = 1000; ///< mm
    static constexpr double leastScale = 1, mostScale = 10'000;
    static constexpr int leastDpi = 36, mostDpi = 4800;

    /// As paper, one as large as the painting's own sheet. It lies as that does.
    static constexpr char ownSheet[] = "Sheet";

    QString paper = QStringLiteral("A4"); ///< a name of paper as PPD files have it, "A4", "Letter", or `ownSheet`
    bool landscape = false;
    std::array<double, 4> margins = {10, 10, 10, 10}; ///< mm: left, top, right, bottom, of the paper as it lies
    Size size = Size::FitPage;
    double scale = 100; ///< per cent of the actual size, where that is asked for
    Area area = Area::Canvas;
    Rect numbers = {}; ///< canvas units, where the area is given by numbers
    Moment moment = Moment::Dried;
    Microseconds time = 0;  ///< where the moment is one
    bool background = true; ///< or else the paint lies on the paper as it is
    int dpi = 0;            ///< dots an inch; 0: as fine as the printer prints

    bool isOnOwnSheet() const { return paper == QLatin1String(ownSheet); }
    friend bool operator==(const PrintSetup &, const PrintSetup &) = default;
};

} // namespace suffuse

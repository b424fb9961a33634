// How the letters of SVG texts look, and how they stand to each other.
#pragma once

#include "model/formats/svg/svg_length.h"
#include "model/painting/text.h"

#include <QMap>
#include <QString>
#include <QStringList>

namespace suffuse {

/// Properties of an element by their names, as written in CSS.
using SvgProperties = QMap<QString, QString>;

/// Calls `use` with the value of a property that is given.
template <class Use>
void svgTake(const SvgProperties &all, const char *name, Use use)
{
    const auto it = all.constFind(QLatin1String(name));
    if (it != all.constEnd() && *it != QLatin1String("inherit"))
        use(*it);
}

/// The properties of texts; lengths are user units.
struct SvgFont {
    QStringList families; ///< the first that is installed counts
    float weight = 400;
    bool italic = false;
    double stretch = 100; ///< per cent of the usual width: below, a narrower family of the same name counts
    bool hasSmallCaps = false;
    double letterSpacing = 0, wordSpacing = 0; ///< added behind each letter, and behind each space
    TextAlignment anchor = TextAlignment::Start;
    bool isRightToLeft = false; ///< on which side a text starts
    bool isVertical = false;
    bool keepsSpace = false;       ///< whether several spaces are several spaces
    double raised = 0;             ///< by baseline-shift, upwards
    QString baseline, ownBaseline; ///< dominant-baseline, and what is said of this element alone
    bool isUnderlined = false, isOverlined = false, isStruck = false;

    static SvgFont of(const SvgProperties &all, const SvgFont &parent, const SvgUnits &units);
};

/// The size of a font, of which per cents and em are shares of the one around it.
double svgFontSize(const QString &text, const SvgUnits &around);
/// What `font: italic bold 12px/1.5 Georgia, serif` says in one, as single properties; none where it makes no sense.
SvgProperties svgFontShorthand(const QString &text);

} // namespace suffuse

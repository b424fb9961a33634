#include "app/panels/inspector/figures/figure_warnings.h"

#include "model/paint/style_function.h"

#include <QCoreApplication>
#include <QLocale>

namespace suffuse {

namespace {

/// If the ratio ξ1/ξ2 is smaller than this, the uniform style covers noticeably (5 %) where there is hardly any paint.
constexpr double clearestEdge = 3;
/// With less coverage than this nobody sees the paint inside a dark rim.
constexpr double bareInside = 0.02;

struct WarningText {
    Q_DECLARE_TR_FUNCTIONS(FigureWarnings)
};

QString seconds(double value)
{
    return QLocale().toString(value, 'g', 3);
}

void addFading(QStringList &warnings, const Extent &fading, const Extent &shrinking, std::size_t all)
{
    if (fading.count == all)
        //: %1: seconds after it was painted
        warnings
            << WarningText::tr(
                   "Fades away at %1 s: nothing of it is seen after that. More φ, or less D or drying time, keeps it.")
                   .arg(seconds(fading.most));
    else if (fading.count > 0)
        warnings << WarningText::tr("Parts fade away, the first at %1 s. More φ, or less D or drying time, keeps them.")
                        .arg(seconds(fading.least));
    else if (shrinking.count > 0)
        warnings << WarningText::tr("Widest at %1 s; from then on it grows narrower while it spreads.")
                        .arg(seconds(shrinking.least));
}

void addStyle(QStringList &warnings, const Style &style)
{
    const double xi1 = style.xi[0], xi2 = style.xi[1];
    if (style.kind == StyleKind::Uniform && xi1 < clearestEdge * xi2)
        warnings << WarningText::tr(
                        "ξ2 too large for ξ1: the stroke has no clear edge and tints as far as its paint reaches. "
                        "Up to %1 is clear.")
                        .arg(QLocale().toString(xi1 / clearestEdge, 'g', 2));
    if (hasRim(style.kind) && leastInsideRim(style) < bareInside)
        warnings << WarningText::tr("ξ2 too large for ξ1: the paint inside the dark rim vanishes.");
}

} // namespace

QStringList figureWarnings(const FiguresSummary &figures)
{
    QStringList warnings;
    if (figures.isErasure()) { // What is said of paint means nothing for what takes it away.
        if (figures.withoutEffect == figures.erasing)
            warnings << WarningText::tr("Strength 0: nothing is taken away.");
        return warnings;
    }
    if (figures.isFillAlone())
        return warnings; // Nothing is wrong with an outline that lays no paint.
    if (figures.withoutPaint == figures.segments)
        warnings << WarningText::tr("Density 0: there is no paint.");
    else if (figures.transparent == figures.segments)
        warnings << WarningText::tr("Opacity 0 %: nothing of it is seen.");
    else
        addFading(warnings, figures.fading, figures.shrinking, figures.segments);
    for (const Style &style : figures.styles) {
        if (warnings.size() > 3)
            break;
        addStyle(warnings, style);
    }
    warnings.removeDuplicates();
    return warnings;
}

} // namespace suffuse

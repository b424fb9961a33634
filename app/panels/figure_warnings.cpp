#include "app/panels/figure_warnings.h"

#include "app/panels/density_function.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <numbers>

namespace suffuse {

namespace {

/// Below this ratio ξ1/ξ2 the uniform style covers noticeably (5 %) where there is hardly any paint.
constexpr double clearestEdge = 3;
/// Coverage inside a dark rim that nobody sees.
constexpr double bareInside = 0.02;

struct Text {
    Q_DECLARE_TR_FUNCTIONS(FigureWarnings)
};

QString seconds(double value)
{
    return QLocale().toString(value, 'g', 3);
}

/// An age and how many segments it is that of.
struct Ages {
    double least = 0, most = 0;
    std::size_t count = 0;
    void add(double age)
    {
        least = count ? std::min(least, age) : age;
        most = std::max(most, age);
        ++count;
    }
};

void addFading(QStringList &warnings, const Ages &fading, const Ages &shrinking, std::size_t all)
{
    if (fading.count == all)
        //: %1: seconds after it was painted
        warnings
            << Text::tr(
                   "Dries out at %1 s: nothing of it is seen after that. More φ, or less D or drying time, keeps it.")
                   .arg(seconds(fading.most));
    else if (fading.count > 0)
        warnings << Text::tr("Parts dry out, the first at %1 s. More φ, or less D or drying time, keeps them.")
                        .arg(seconds(fading.least));
    else if (shrinking.count > 0)
        warnings << Text::tr("Widest at %1 s; from then on it grows narrower while it spreads.")
                        .arg(seconds(shrinking.least));
}

void addStyle(QStringList &warnings, const Style &style)
{
    const double xi1 = style.xi[0], xi2 = style.xi[1], xi3 = style.xi[2];
    if (style.kind == StyleKind::Uniform && xi1 < clearestEdge * xi2)
        warnings << Text::tr("ξ2 too large for ξ1: the stroke has no clear edge and tints as far as its paint reaches. "
                             "Up to %1 is clear.")
                        .arg(QLocale().toString(xi1 / clearestEdge, 'g', 2));
    if (style.kind == StyleKind::Edge && xi3 * (1 - std::pow(xi2 / xi1, 6) / 4) < bareInside)
        warnings << Text::tr("ξ2 too large for ξ1: the paint inside the dark rim vanishes.");
}

} // namespace

QStringList figureWarnings(const Inspected &inspected)
{
    QStringList warnings;
    Ages fading, shrinking;
    std::size_t transparent = 0, withoutPaint = 0;
    for (const InspectedSegment &s : inspected.segments) {
        const Segment &segment = *s.segment;
        transparent += segment.colour.opacity == 0;
        withoutPaint += segment.density == 0;
        const double fades = fadingAge(curveDiffusion(segment).across, double(segment.density), visibleCut(s.style()));
        if (fades < double(segment.maxAge) && segment.density > 0)
            fading.add(fades);
        else if (fades / std::numbers::e < double(segment.maxAge) && segment.density > 0)
            shrinking.add(fades / std::numbers::e);
    }
    const std::size_t all = inspected.segments.size();
    if (withoutPaint == all)
        warnings << Text::tr("Density 0: there is no paint.");
    else if (transparent == all)
        warnings << Text::tr("Opacity 0 %: nothing of it is seen.");
    else
        addFading(warnings, fading, shrinking, all);
    for (const InspectedSegment &s : inspected.segments) {
        if (warnings.size() > 3)
            break;
        if (&s == &inspected.segments.front() || !(s.style() == (&s - 1)->style()))
            addStyle(warnings, s.style());
    }
    warnings.removeDuplicates();
    return warnings;
}

} // namespace suffuse

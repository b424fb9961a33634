#include "app/panels/inspector/figures/figures_summary.h"

#include "model/paint/derived_figures.h"

#include <algorithm>
#include <numbers>

namespace suffuse {

void Extent::add(const Extent &other)
{
    if (other.count == 0)
        return;
    least = count ? std::min(least, other.least) : other.least;
    most = count ? std::max(most, other.most) : other.most;
    count += other.count;
}

void FiguresSummary::add(const InspectedSegment &inspected)
{
    const Segment &segment = *inspected.segment;
    const Style &style = inspected.style();
    const DerivedFigures figures = derivedFigures(segment, style);
    if (segment.takesPaint()) {
        ++erasing;
        withoutEffect += segment.density == 0;
        reach.add(figures.spread);
        if (segment.fade)
            share.add(takenShare(segment));
        else
            taken.add(figures.peak);
        return;
    }
    ++segments;
    transparent += segment.colour.opacity == 0;
    withoutPaint += segment.density == 0;
    aroundFills += segment.density == 0 && inspected.stroke->fill;
    spread.add(figures.spread);
    along.add(figures.along);
    peak.add(figures.peak);
    halfWidth.add(figures.halfWidth);
    uneven = uneven || !segment.isIsotropic();
    if (figures.driesOut)
        driesOut.add(*figures.driesOut);
    const double fades = fadingAge(curveDiffusion(segment).across, double(segment.density), visibleCut(style));
    if (fades < double(segment.maxAge) && segment.density > 0)
        fading.add(fades);
    else if (fades / std::numbers::e < double(segment.maxAge) && segment.density > 0)
        shrinking.add(fades / std::numbers::e);
    if (styles.empty() || !(styles.back() == style))
        styles.push_back(style);
}

void FiguresSummary::add(const FiguresSummary &other)
{
    segments += other.segments;
    transparent += other.transparent;
    withoutPaint += other.withoutPaint;
    aroundFills += other.aroundFills;
    spread.add(other.spread);
    along.add(other.along);
    peak.add(other.peak);
    halfWidth.add(other.halfWidth);
    driesOut.add(other.driesOut);
    fading.add(other.fading);
    shrinking.add(other.shrinking);
    uneven = uneven || other.uneven;
    erasing += other.erasing;
    withoutEffect += other.withoutEffect;
    reach.add(other.reach);
    taken.add(other.taken);
    share.add(other.share);
    for (const Style &style : other.styles)
        if (styles.empty() || !(styles.back() == style))
            styles.push_back(style);
}

FiguresSummary FiguresKeeper::summaryOf(const Inspected &inspected)
{
    FiguresSummary all;
    const std::vector<InspectedSegment> &segments = inspected.segments;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < segments.size();) {
        const Stroke *stroke = segments[i].stroke;
        const std::size_t end = i + stroke->segments.size();
        const bool isWhole = end <= segments.size() && segments[end - 1].stroke == stroke;
        if (!isWhole) {
            all.add(segments[i++]);
            continue;
        }
        if (kept == m_kept.size())
            m_kept.emplace_back();
        Kept &one = m_kept[kept++];
        if (one.stroke != stroke) {
            one = {stroke, {}};
            for (std::size_t k = i; k < end; ++k)
                one.figures.add(segments[k]);
        }
        all.add(one.figures);
        i = end;
    }
    m_kept.resize(kept);
    m_painting = inspected.painting;
    return all;
}

} // namespace suffuse

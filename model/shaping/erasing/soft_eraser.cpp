#include "model/shaping/erasing/soft_eraser.h"

#include "model/paint/half_width.h"
#include "model/paint/point_density.h"
#include "model/painting/influence.h"
#include "model/shaping/curves/split.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

/// A segment that takes paint spreads so short a time that it is done before the paint around it is dry.
constexpr float takingAge = 0.1f;
/// Paint that is lifted is looked for up to so many radii from the path. What fades has no edge, and is laid where it
/// takes more than this share.
constexpr double soughtRadii = 0.95, leastShare = 1.0 / 64;
/// The points at which it is looked for lie so many radii apart.
constexpr double spacingRadii = 1.0 / 3;
constexpr double ln2 = std::numbers::ln2, lnUnseen = 11 * ln2; ///< e^−lnUnseen = 1/2048
/// What has been taken counts for what comes so many spreads later along the path: before, it is the same stroke of
/// the hand.
constexpr double sameStroke = 3;
/// For what fades that is so from fewer spreads on: what lies farther back on a straight line is ½ erfc(2) of its peak,
/// 1/400. Less than a share of the peak does not count, so that a line that does not come by again takes one share.
constexpr double sameFade = 2, leastTaken = 1.0 / 50;
constexpr double mostPathParts = 64; // of a segment

/// Its density is that of a peak of 1, and its granulation the share of the strength.
Brush pathBrush(const SoftTip &tip)
{
    Brush brush;
    brush.maxAge = takingAge;
    brush.setSpread(tip.spread());
    brush.peak = 1;
    brush.granulation = 1;
    brush.dynamics = {{BrushQuantity::Granulation, BrushInput::Pressure, {{{0, 0}, {1, 1}}}}};
    brush.interval = 2 * samplingInterval; // it need not be as fine as a drawing
    return brush;
}

} // namespace

double SoftTip::spread() const
{
    if (way == SoftWay::Lift)
        return softness * radius;
    // Half is left at the radius where peak · e^−(radius/s)² = ln 2. The greatest peak depends on s itself, and reaches
    // that at the spread 2/(1 + ln(lnUnseen/ln 2)) radii.
    const double peak = -std::log1p(-strength);
    double widest = greatestSoftness;
    if (peak > ln2)
        widest = std::max(1 / std::sqrt(std::log(peak / ln2)), 2 / (1 + std::log(lnUnseen / ln2)));
    return std::min(softness, widest) * radius;
}

double fadingPeak(double share, const SoftTip &tip)
{
    const double within = std::max(0.0, tip.radius / tip.spread() - 1); // in spreads
    return std::min(-std::log1p(-share), lnUnseen * std::exp(within * within));
}

double liftingPeak(double excess, double share, const SoftTip &tip)
{
    const double ends = std::max(0.0, 2 * share - 1) / tip.softness; // in spreads
    return excess * std::min(1.0, 2 * share) * std::exp(ends * ends);
}

SoftEraser::SoftEraser(const SoftTip &tip, const std::vector<StrokePtr> &strokes, Microseconds T, const Washes &washes)
    : m_tip(tip), m_sought(soughtRadii * tip.radius), m_time(T), m_builder(pathBrush(tip), 0), m_strokes(strokes)
{
    if (tip.way == SoftWay::Lift)
        return;
    m_sought = tip.spread() * std::sqrt(std::max(0.0, std::log(fadingPeak(tip.strength, tip) / leastShare)));
    for (const auto &[group, wash] : washes)
        m_washes.emplace(group, wash->id);
}

void SoftEraser::add(const PenSample &sample)
{
    if (m_targets.empty()) {
        for (const StrokePtr &stroke : m_strokes) {
            const auto wash = m_washes.find(stroke->group);
            const bool isOne = !stroke->fill && wash != m_washes.end();
            m_targets.push_back({PaintSamples(stroke, m_time, sample.position, spacingRadii * m_tip.radius),
                                 influenceOf(*stroke, m_time).united(influenceOf(*stroke, stroke->driesAt())),
                                 isOne ? wash->second : 0,
                                 {},
                                 0});
        }
        m_strokes.clear();
    }
    m_builder.add(sample);
    follow();
}

void SoftEraser::finish()
{
    m_builder.finish();
    follow();
}

void SoftEraser::follow()
{
    const StrokePtr path = m_builder.stroke();
    if (!path)
        return;
    const int frozen = m_builder.frozenSegments();
    const std::size_t before = m_frozenParts;
    m_parts.resize(before);
    for (int k = m_frozenSegments; k < int(path->segments.size()); ++k) {
        addParts(*path, path->segments[std::size_t(k)]);
        if (k < frozen)
            m_frozenParts = m_parts.size();
    }
    m_frozenSegments = std::max(m_frozenSegments, frozen);
    for (SoughtStroke &target : m_targets)
        seek(target, before);
}

/// Appends the segment in parts.
void SoftEraser::addParts(const Stroke &path, const Segment &segment)
{
    const Cubic curve = path.cubicOf(segment);
    const double arc = arcLength(curve), begin = m_parts.empty() ? 0 : m_parts.back().to;
    const int count = int(std::clamp(std::ceil(arc / m_tip.radius), 1.0, mostPathParts));
    for (int i = 0; i < count; ++i) {
        const double from = double(i) / count, to = double(i + 1) / count;
        PathPart part;
        part.curve = partOf(curve, from, to);
        part.density = double(segment.density);
        part.share = m_tip.strength * double(segment.granulation);
        part.born = segment.born;
        part.reach = part.curve.controlBox().grown(std::max(m_sought, m_tip.radius));
        part.from = begin + from * arc;
        part.to = begin + to * arc;
        part.peak = m_tip.way == SoftWay::Fade ? peakLeft(part) : 0;
        m_parts.push_back(part);
    }
}

double SoftEraser::peakLeft(const PathPart &part) const
{
    const double peak = fadingPeak(part.share, m_tip), spread = m_tip.spread();
    const Point middle = part.curve.at(0.5);
    double taken = 0;
    for (const PathPart &before : m_parts) {
        if (before.to > part.from - sameFade * spread)
            break;
        const Segment segment = segmentOf(before, before.peak, middle);
        if (before.peak > 0 && reaches(segment, spread, {}))
            taken += segmentDensity(segment, spread, {}, CurveDetail::Rough);
    }
    return taken < leastTaken * peak ? peak : std::max(0.0, peak - taken);
}

/// Looks for a stroke's paint under the parts from `from` on. What was found there before was provisional.
void SoftEraser::seek(SoughtStroke &target, std::size_t from)
{
    std::erase_if(target.hits, [from](const FoundPaint &hit) { return hit.part >= from; });
    for (std::size_t i = from; i < m_parts.size(); ++i) {
        const PathPart &part = m_parts[i];
        const bool takes = m_tip.way == SoftWay::Fade ? part.peak > leastShare : part.share > 0;
        if (!takes || !target.reach.intersects(part.reach))
            continue;
        while (m_tip.way == SoftWay::Lift && i < m_frozenParts && target.taken < target.hits.size() &&
               m_parts[target.hits[target.taken].part].to < part.from - sameStroke * m_tip.spread())
            target.samples.take(taking(target.hits[target.taken++], target.samples.stroke()->origin));
        if (const double excess = target.samples.excessWithin(part.curve.at(0.5), m_sought); excess > 0)
            target.hits.push_back({i, excess});
    }
}

Segment SoftEraser::segmentOf(const PathPart &part, double peak, Point origin) const
{
    Segment segment;
    for (std::size_t i = 0; i < 4; ++i)
        segment.bezier[i] = toOffset(part.curve.p[i], origin);
    const double spread = m_tip.spread();
    segment.diffusion = float(spread * spread / (4 * double(takingAge)));
    segment.maxAge = takingAge;
    segment.density = float(std::min(1e12, part.density * peak));
    segment.born = part.born;
    (m_tip.way == SoftWay::Fade ? segment.fade : segment.lift) = true;
    return segment;
}

Segment SoftEraser::taking(const FoundPaint &hit, Point origin) const
{
    const PathPart &part = m_parts[hit.part];
    const bool fades = m_tip.way == SoftWay::Fade;
    return segmentOf(part, fades ? part.peak : liftingPeak(hit.excess, part.share, m_tip), origin);
}

std::vector<SoftEraser::FoundPaint> SoftEraser::hitsOf(const SoughtStroke &target) const
{
    if (target.wash == 0)
        return target.hits;
    const SoughtStroke *first = nullptr;
    std::vector<FoundPaint> all;
    for (const SoughtStroke &member : m_targets) {
        if (member.wash != target.wash || member.hits.empty())
            continue;
        if (!first || member.hits.front().part < first->hits.front().part)
            first = &member;
        all.insert(all.end(), member.hits.begin(), member.hits.end());
    }
    if (first != &target)
        return {};
    std::ranges::stable_sort(all, {}, &FoundPaint::part);
    const auto isSame = [](const FoundPaint &a, const FoundPaint &b) { return a.part == b.part; };
    all.erase(std::unique(all.begin(), all.end(), isSame), all.end());
    return all;
}

std::set<StrokeId> SoftEraser::touched() const
{
    std::set<StrokeId> ids;
    for (const SoughtStroke &target : m_targets)
        if (!hitsOf(target).empty())
            ids.insert(target.samples.stroke()->id);
    return ids;
}

Stroke SoftEraser::erased(const Stroke &stroke) const
{
    Stroke result = stroke;
    const auto target = std::ranges::find_if(
        m_targets, [&stroke](const SoughtStroke &t) { return t.samples.stroke()->id == stroke.id; });
    if (target == m_targets.end())
        return result;
    bool goesOn = false;
    std::size_t next = 0;
    for (const FoundPaint &hit : hitsOf(*target)) {
        Segment segment = taking(hit, stroke.origin);
        goesOn = goesOn && hit.part == next;
        next = hit.part + 1;
        if (isPoint(segment)) // as small as float32 can tell, so that what follows begins at the same place
            continue;
        segment.start = !std::exchange(goesOn, true);
        result.segments.push_back(std::move(segment));
    }
    return result;
}

} // namespace suffuse

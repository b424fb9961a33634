#include "undo/area_edits.h"

#include "model/area/outline.h"
#include "model/area/pen_outline.h"
#include "model/paint/half_width.h"
#include "model/painting/editable.h"
#include "model/painting/validate.h"
#include "model/restyling/appearance.h"
#include "model/shaping/curves/chain_strokes.h"
#include "undo/edits.h"
#include "undo/fill_edits.h"

#include <algorithm>

namespace suffuse {

namespace {

/// About a second. It is spent before outlines are drawn in part only (model/area/crossings.cpp).
constexpr std::uint64_t mostSteps = 300'000'000;

/// What becomes of an edit while strokes are replaced: the painting's order, and what is selected then.
class Replacing {
public:
    explicit Replacing(Document &document) : m_document(document) {}

    /// Puts strokes into the place of one, which keeps its id if the first of them has it; the others get new ones.
    void replace(StrokeId id, std::vector<Stroke> strokes) { m_places.emplace(id, std::move(strokes)); }

    Edit edit()
    {
        Edit edit;
        edit.order.emplace();
        edit.selection.emplace();
        for (const StrokePtr &stroke : m_document.painting()->strokes) {
            const auto place = m_places.find(stroke->id);
            if (place == m_places.end()) {
                edit.order->push_back(stroke->id);
                continue;
            }
            if (place->second.empty())
                edit.strokes.emplace(stroke->id, nullptr);
            for (std::size_t i = 0; i < place->second.size(); ++i) {
                Stroke &part = place->second[i];
                part.id = i == 0 ? stroke->id : m_document.takeStrokeId();
                edit.order->push_back(part.id);
                edit.selection->strokes.insert(part.id);
                edit.strokes.emplace(part.id, std::make_shared<const Stroke>(std::move(part)));
            }
        }
        return edit;
    }

private:
    Document &m_document;
    std::map<StrokeId, std::vector<Stroke>> m_places;
};

Edit refused(AreaProblem why, AreaProblem *problem)
{
    if (problem)
        *problem = why;
    return {};
}

/// The part of a line that is as wide to the eye, and how wide.
struct LineOfWidth {
    double half = 0;
    PenLine line;
};

/// The lines of what a stroke lays, offsets from its origin, as far as they are seen when they are dry.
std::vector<LineOfWidth> seenLines(const Stroke &stroke)
{
    constexpr double alike = 0.01; // of the width
    std::vector<LineOfWidth> lines;
    for (const Chain &chain : chainsOf(stroke)) {
        bool goesOn = false;
        const std::size_t before = lines.size();
        for (int k = chain.first; k <= chain.last; ++k) {
            const Segment &segment = stroke.segments[std::size_t(k)];
            const Cubic curve = offsetsOf(segment);
            const double age = segment.age(segment.driesAt()), cut = visibleCut(stroke.styleOf(segment));
            const double half =
                segment.takesPaint() || !(cut > 0)
                    ? 0
                    : halfWidth(diffusionAcross(segment, tangentAt(curve, 0.5)), double(segment.density), age, cut);
            if (!(half > 0)) {
                goesOn = false;
                continue;
            }
            if (!goesOn || std::abs(half - lines.back().half) > alike * half)
                lines.push_back({half, {}});
            lines.back().line.curves.push_back(curve);
            goesOn = true;
        }
        if (lines.size() == before + 1) {
            std::vector<Cubic> &curves = lines.back().line.curves;
            lines.back().line.isClosed = curves.front().p[0] == curves.back().p[3];
        }
    }
    return lines;
}

/// The area of what is seen of a stroke's lines, and their mean half-width.
std::optional<Area> areaOfLines(const Stroke &stroke, double &half, AreaEffort &effort)
{
    constexpr double exactness = 0.01; // of the width
    std::vector<std::vector<Cubic>> loops;
    double lengths = 0;
    half = 0;
    for (const LineOfWidth &each : seenLines(stroke)) {
        Pen pen;
        pen.width = 2 * each.half;
        pen.cap = LineCap::Round;
        pen.join = LineJoin::Round;
        double length = 0;
        for (const Cubic &curve : each.line.curves)
            length += polygonLength(curve);
        lengths += length;
        half += length * each.half;
        for (std::vector<Cubic> &loop : penOutline({each.line}, pen, exactness * each.half, &effort))
            loops.push_back(std::move(loop));
    }
    half = lengths > 0 ? half / lengths : 0;
    return certainArea(loops, FillRule::NonZero, &effort);
}

/// The fill that looks as lines do in their middle: crisp, since their outlines are where their paint ends.
Fill fillOfLines(const Stroke &stroke)
{
    Stroke alone = stroke;
    alone.fill = {};
    const Appearance paint = appearanceOf(alone);
    Fill fill = usualFill(alone);
    fill.diffusion = 0;
    fill.density = std::max(fill.density, float(peakDensity(paint.density, spreadAt(paint.diffusion, paint.maxAge))));
    fill.granulation = float(paint.granulation);
    fill.maxAge = float(paint.maxAge);
    fill.colour = {float(paint.colour[0]), float(paint.colour[1]), float(paint.colour[2]), float(paint.colour[3])};
    return fill;
}

void layNoPaint(Stroke &stroke)
{
    for (Segment &segment : stroke.segments)
        if (!segment.takesPaint())
            segment.density = 0;
}

} // namespace

std::vector<StrokePtr> selectedAreas(const Document &document)
{
    const Painting &painting = *document.painting();
    const std::set<StrokeId> &selected = document.selection().strokes;
    std::vector<StrokePtr> areas;
    if (selected.empty())
        return areas;
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (stroke->fill && selected.contains(stroke->id) && isEditable(*stroke))
            areas.push_back(stroke);
    return areas;
}

bool hasSelectedAreas(const Document &document, int least)
{
    const Painting &painting = *document.painting();
    const std::set<StrokeId> &selected = document.selection().strokes;
    int count = 0;
    if (int(selected.size()) < least)
        return false;
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (stroke->fill && selected.contains(stroke->id) && isEditable(*stroke) && ++count == least)
            return true;
    return false;
}

Edit combineAreas(Document &document, AreaSet how, AreaProblem *problem)
{
    if (problem)
        *problem = AreaProblem::None;
    const std::vector<StrokePtr> strokes = selectedAreas(document);
    if (strokes.size() < 2)
        return refused(AreaProblem::TooFew, problem);
    AreaEffort effort(mostSteps);
    const std::optional<std::vector<Area>> areas = areasOf(strokes, &effort);
    const std::optional<std::vector<Area>> set = areas ? setOf(*areas, how, &effort) : std::nullopt;
    if (!set || effort.isSpent())
        return refused(effort.isSpent() ? AreaProblem::TooMuch : AreaProblem::Uncertain, problem);
    Stroke lowest = *strokes.front();
    const bool addsPaint = how == AreaSet::Union || how == AreaSet::Exclusion;
    for (auto other = strokes.begin() + 1; addsPaint && other != strokes.end(); ++other)
        if (!appendLifts(lowest, **other))
            return refused(AreaProblem::Empty, problem);
    std::vector<Stroke> results;
    for (const Area &area : *set) {
        std::optional<Stroke> stroke = withArea(lowest, area, strokes);
        if (!stroke)
            continue;
        if (how != AreaSet::Division) {
            results.push_back(std::move(*stroke));
            continue;
        }
        for (Stroke &part : strokesOfChains(*stroke))
            results.push_back(std::move(part));
    }
    if (results.empty())
        return refused(AreaProblem::Empty, problem);
    Replacing replacing(document);
    replacing.replace(lowest.id, std::move(results));
    for (auto other = strokes.begin() + 1; other != strokes.end(); ++other)
        replacing.replace((*other)->id, {});
    return replacing.edit();
}

Edit offsetAreas(const Document &document, double by, AreaProblem *problem)
{
    if (problem)
        *problem = AreaProblem::None;
    const std::vector<StrokePtr> strokes = selectedAreas(document);
    if (strokes.empty())
        return refused(AreaProblem::TooFew, problem);
    Pen pen;
    pen.width = 2 * std::abs(by);
    AreaEffort effort(mostSteps);
    Edit edit;
    for (const StrokePtr &stroke : strokes) {
        const std::optional<std::vector<Area>> area = areasOf({stroke}, &effort);
        std::vector<PenLine> lines;
        for (const std::vector<Cubic> &loop : area ? area->front().loops : std::vector<std::vector<Cubic>>()) {
            lines.emplace_back().curves = loop;
            lines.back().isClosed = true;
        }
        const std::optional<Area> border =
            certainArea(penOutline(lines, pen, 0.002 * pen.width, &effort), FillRule::NonZero, &effort);
        const std::optional<std::vector<Area>> moved =
            area && border ? setOf({area->front(), *border}, by > 0 ? AreaSet::Union : AreaSet::Difference, &effort)
                           : std::nullopt;
        if (!moved || effort.isSpent())
            return refused(effort.isSpent() ? AreaProblem::TooMuch : AreaProblem::Uncertain, problem);
        std::optional<Stroke> result = moved->empty() ? std::nullopt : withArea(*stroke, moved->front());
        if (!result)
            return refused(AreaProblem::Empty, problem);
        edit.strokes.emplace(stroke->id, std::make_shared<const Stroke>(std::move(*result)));
    }
    Selection whole{document.selection().strokes, {}}; // The segments are others.
    if (whole != document.selection())
        edit.selection = std::move(whole);
    return edit;
}

Edit linesToAreas(Document &document, AreaProblem *problem)
{
    constexpr double step = 0.12, exactness = 0.04; // of the half-width
    if (problem)
        *problem = AreaProblem::None;
    const PaintingPtr painting = document.painting();
    AreaEffort effort(mostSteps);
    Replacing replacing(document);
    bool any = false;
    const Editable isEditable(painting->groups);
    for (const StrokePtr &stroke : painting->strokes) {
        if (!document.selection().strokes.contains(stroke->id) || !isEditable(*stroke))
            continue;
        double half = 0;
        const std::optional<Area> area = areaOfLines(*stroke, half, effort);
        if (!area || effort.isSpent())
            return refused(effort.isSpent() ? AreaProblem::TooMuch : AreaProblem::Uncertain, problem);
        if (area->isEmpty())
            continue;
        Stroke line = *stroke;
        line.fill = fillOfLines(*stroke);
        layNoPaint(line);
        const std::optional<Stroke> filled = withArea(line, drawnAnew(*area, step * half, exactness * half));
        if (!filled)
            return refused(AreaProblem::Empty, problem);
        std::vector<Stroke> strokes;
        if (stroke->fill) {
            strokes.push_back(*stroke);
            layNoPaint(strokes.back());
        }
        strokes.push_back(*filled);
        replacing.replace(stroke->id, std::move(strokes));
        any = true;
    }
    return any ? replacing.edit() : refused(AreaProblem::TooFew, problem);
}

} // namespace suffuse

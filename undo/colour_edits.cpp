#include "undo/colour_edits.h"

#include "model/colour/colour_shift.h"
#include "model/painting/editable.h"
#include "model/painting/validate.h"
#include "undo/swatch_edits.h"

namespace suffuse {

namespace {

/// The stroke that is in the document with the colours that the map makes of those of the part. Null where it has them,
/// and where it is another stroke by now.
StrokePtr recoloured(const Stroke &now, const ColourPart &part, const ColourMap &map)
{
    const std::vector<Segment> &before = part.stroke->segments;
    if (now.segments.size() != before.size())
        return nullptr;
    std::shared_ptr<Stroke> result;
    for (std::size_t k = 0; k < before.size(); ++k) {
        if (!part.has(k))
            continue;
        const Colour colour = map(before[k].colour);
        if (colour == now.segments[k].colour || !problemOf(colour).isEmpty())
            continue;
        if (!result)
            result = std::make_shared<Stroke>(now);
        result->segments[k].colour = colour;
    }
    if (!now.fill || !part.stroke->fill)
        return result;
    Fill fill = *now.fill;
    const Fill &then = *part.stroke->fill;
    if (part.fill)
        fill.colour = map(then.colour);
    if (part.gradient && fill.gradient && then.gradient)
        fill.gradient->colour = map(then.gradient->colour);
    if (fill == *now.fill || !problemOf(fill.colour).isEmpty() ||
        (fill.gradient && !problemOf(fill.gradient->colour).isEmpty()))
        return result;
    if (!result)
        result = std::make_shared<Stroke>(now);
    result->fill = fill;
    return result;
}

Edit recolourAll(const Document &document, const ColourParts &parts, const ColourMap &map, bool lockedToo)
{
    Edit edit;
    const Painting &painting = *document.painting();
    std::map<StrokeId, const ColourPart *> partOf;
    for (const ColourPart &part : parts)
        partOf.emplace(part.stroke->id, &part);
    const Locks isLocked(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        const auto at = partOf.find(stroke->id);
        if (at == partOf.end() || (!lockedToo && isLocked(*stroke)))
            continue;
        if (StrokePtr result = recoloured(*stroke, *at->second, map))
            edit.strokes.emplace(stroke->id, std::move(result));
    }
    return edit;
}

} // namespace

Edit recolour(const Document &document, const ColourParts &parts, const ColourMap &map)
{
    return recolourAll(document, parts, map, false);
}

Edit changeSwatch(const Document &document, std::size_t swatch, const Colour &to, const ColourParts &users)
{
    std::vector<Swatch> swatches = document.painting()->swatches;
    if (swatch >= swatches.size() || !problemOf(to).isEmpty())
        return {};
    swatches[swatch].colour = to;
    Edit edit = recolourAll(
        document, users, [&](const Colour &colour) { return withOpacity(to, colour.opacity); }, true);
    edit.swatches = setSwatches(document, swatches).swatches;
    return edit;
}

ColourParts usersOf(const Painting &painting, std::size_t swatch)
{
    if (swatch >= painting.swatches.size() || !painting.swatches[swatch].linked)
        return {};
    return partsOfColour(painting, painting.swatches[swatch].colour);
}

} // namespace suffuse

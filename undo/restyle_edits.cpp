#include "undo/restyle_edits.h"

#include "undo/run_edits.h"

#include <map>

namespace suffuse {

Edit applyBrush(const Document &document, const Brush &brush, BrushPart part, const BrushNamed &brushNamed)
{
    const Painting &painting = *document.painting();
    const Selection &selection = document.selection();
    std::map<QString, Restyle> byBrush;
    for (const StrokePtr &stroke : painting.strokes) {
        if (!selection.strokes.contains(stroke->id))
            continue;
        Restyle &how =
            byBrush.try_emplace(stroke->brush, Restyle{brush, part, brushNamed(stroke->brush), {}}).first->second;
        how.strongest.take(*stroke, how.painted);
    }
    return reshapeSelection(document, painting, selection,
                            [&](const Stroke &stroke, const std::vector<bool> &chosen, std::vector<int> *sources) {
                                return restyled(stroke, byBrush.at(stroke.brush), chosen, sources);
                            });
}

Edit applyAppearance(const Document &document, const Painting &before, const Selection &selection,
                     const Appearance &appearance, Variation variation)
{
    return reshapeSelection(document, before, selection,
                            [&](const Stroke &stroke, const std::vector<bool> &chosen, std::vector<int> *) {
                                return withAppearance(stroke, appearance, variation, chosen);
                            });
}

Edit varySelection(const Document &document, const Painting &before, const Selection &selection,
                   const VaryAmounts &amounts)
{
    return reshapeSelection(document, before, selection,
                            [&](const Stroke &stroke, const std::vector<bool> &chosen, std::vector<int> *) {
                                return varied(stroke, amounts, chosen);
                            });
}

} // namespace suffuse

#include "model/document/edit.h"

namespace suffuse {

std::vector<StrokeId> orderWanted(const Edit &edit, const std::vector<StrokeId> &before)
{
    if (edit.order)
        return *edit.order;
    if (!edit.places)
        return before;
    return reordered(before, *edit.places, [&](StrokeId id) {
        const auto it = edit.strokes.find(id);
        return it != edit.strokes.end() && !it->second;
    });
}

} // namespace suffuse

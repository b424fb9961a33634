#include "undo/swatch_edits.h"

namespace suffuse {

Edit setSwatches(const Document &document, const std::vector<Swatch> &swatches)
{
    Edit edit;
    if (swatches != document.painting()->swatches)
        edit.swatches = swatches;
    return edit;
}

} // namespace suffuse

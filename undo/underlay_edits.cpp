#include "undo/underlay_edits.h"

#include "model/painting/validate.h"

namespace suffuse {

Edit setUnderlay(const Document &document, std::optional<Underlay> underlay)
{
    const std::shared_ptr<const Underlay> &now = document.painting()->underlay;
    const bool same = underlay && now ? *underlay == *now : bool(underlay) == bool(now);
    Edit edit;
    if (same || (underlay && !problemOf(*underlay).isEmpty()))
        return edit;
    edit.underlay = underlay ? std::make_shared<const Underlay>(std::move(*underlay)) : nullptr;
    return edit;
}

Edit changeUnderlay(const Document &document, const std::function<void(Underlay &)> &change)
{
    if (!document.painting()->underlay)
        return {};
    Underlay underlay = *document.painting()->underlay;
    change(underlay);
    return setUnderlay(document, std::move(underlay));
}

Rect fitted(double width, double height, const Rect &around)
{
    const double scale = std::min(around.width() / width, around.height() / height);
    const Point centre = around.centre();
    return Rect::of(centre.x - 0.5 * scale * width, centre.y - 0.5 * scale * height, scale * width, scale * height);
}

} // namespace suffuse

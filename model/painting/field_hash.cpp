#include "model/painting/field_hash.h"

namespace suffuse {

QByteArray hashOf(const Painting &painting)
{
    FieldHash out;
    out.put(painting.canvas);
    out.put(std::uint64_t(painting.strokes.size()));
    for (const StrokePtr &s : painting.strokes)
        out.put(*s);
    out.put(painting.groups);
    out.put(painting.swatches);
    out.put(bool(painting.underlay));
    if (painting.underlay)
        out.put(*painting.underlay);
    return out.result();
}

} // namespace suffuse

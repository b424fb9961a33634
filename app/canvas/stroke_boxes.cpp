#include "app/canvas/stroke_boxes.h"

#include "model/transform.h"

namespace suffuse {

bool StrokeBoxes::follow(const StrokeList &strokes)
{
    return m_boxes.follow(strokes, controlBox);
}

} // namespace suffuse

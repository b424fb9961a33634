#include "app/session/selecting/stroke_boxes.h"

#include "model/shaping/transform.h"

namespace suffuse {

bool StrokeBoxes::follow(const StrokeList &strokes)
{
    return m_boxes.follow(strokes, controlBox);
}

} // namespace suffuse

#include "app/canvas/input/pointer_event.h"

#include <QWidget>

namespace suffuse {

Point devicePixels(const QWidget &widget, const QPointF &logical)
{
    const double dpr = widget.devicePixelRatioF();
    return {logical.x() * dpr, logical.y() * dpr};
}

} // namespace suffuse

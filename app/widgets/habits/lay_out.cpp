#include "app/widgets/habits/lay_out.h"

#include <QCoreApplication>
#include <QEvent>
#include <QPointer>
#include <QWidget>

namespace suffuse {

void layOutNow(QWidget &widget)
{
    // What lies within others comes first, since it asks these for room.
    QList<QPointer<QWidget>> widgets{&widget};
    for (QWidget *child : widget.findChildren<QWidget *>())
        widgets << child;
    for (auto it = widgets.rbegin(); it != widgets.rend(); ++it)
        if (*it)
            QCoreApplication::sendPostedEvents(*it, QEvent::LayoutRequest);
}

} // namespace suffuse

// Names for screen readers where Qt has none.
#pragma once

class QWidget;

namespace suffuse {

/// Lets drop-downs be called by what they are about and what is chosen in them, "Speed, 2×" for example. On Linux Qt calls
/// them by the choice alone, and readers learn the rest only where a label belongs to them. May be called again.
void installSpokenNames();

/// Names what Qt makes by itself: the list that drops down, and the arrow behind which a tool bar hides what has no room.
/// Lists are described by their tool tips.
/// Call it as soon as the widget is about to be seen.
void nameOwnWidgetOfQt(QWidget &widget);

} // namespace suffuse

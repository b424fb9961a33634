// Changes of what a row of the strokes dock has of its own: name, eye and lock.
#pragma once

#include "model/painting/painting.h"

#include <QString>

#include <functional>

namespace suffuse {

class Editor;

/// One undo step with the text; none where nothing changes.
void changeStroke(Editor &editor, StrokeId id, const std::function<void(Stroke &)> &change, const QString &text);
void changeGroup(Editor &editor, GroupId id, const std::function<void(Group &)> &change, const QString &text);

} // namespace suffuse

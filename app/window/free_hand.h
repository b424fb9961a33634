#pragma once

#include <functional>

class QObject;

namespace suffuse {

class CanvasWidget;

/// Calls a function when nothing is in hand: at once or, while a tool is at work on the canvas or a value is being
/// dragged, when that has ended. What moves the canvas below the pointer uses it, since a stroke that is being painted
/// would jump. The function is not called after `context` is destroyed.
void whenHandIsFree(CanvasWidget &canvas, QObject &context, const std::function<void()> &function);

} // namespace suffuse

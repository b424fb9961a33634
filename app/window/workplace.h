// What the parts of a window work on.
#pragma once

class QMainWindow;

namespace suffuse {

class CanvasWidget;
class Commands;
struct OpenPainting;

/// One window, its painting, the canvas that shows it, and the table to which the parts add the rows of what they do.
struct Workplace {
    QMainWindow &window;
    OpenPainting &open;
    CanvasWidget &canvas;
    Commands &commands;
};

} // namespace suffuse

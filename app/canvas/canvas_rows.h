// The rows of the table that move the view, or ask the tool in use.
#pragma once

namespace suffuse {

class CanvasWidget;
class Commands;

/// Adds the rows, and updates the table when the canvas changes. The canvas must outlive the table.
void addCanvasRows(Commands &table, CanvasWidget &canvas);

} // namespace suffuse

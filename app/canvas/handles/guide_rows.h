#pragma once

namespace suffuse {

class CanvasWidget;
class Commands;

/// Adds the rows of the table about rulers and guides. The canvas must outlive the table.
void addGuideRows(Commands &table, CanvasWidget &canvas);

} // namespace suffuse

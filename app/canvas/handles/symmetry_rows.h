#pragma once

namespace suffuse {

class CanvasWidget;
class Commands;

/// Adds the rows of the table that switch the symmetry on and set it. The canvas must outlive the table.
void addSymmetryRows(Commands &table, CanvasWidget &canvas);

} // namespace suffuse

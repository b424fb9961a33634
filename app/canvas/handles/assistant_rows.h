#pragma once

namespace suffuse {

class CanvasWidget;
class Commands;

/// Adds the rows of the table about assistants. The canvas must outlive the table.
void addAssistantRows(Commands &table, CanvasWidget &canvas);

} // namespace suffuse

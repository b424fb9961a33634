// The rows of the table that need neither canvas nor window: what they do is done by the session.
#pragma once

#include "app/session/commands/commands.h"
#include "app/session/open_painting.h"

namespace suffuse {

/// All of them; the table follows the painting from then on. The painting must outlive the table.
void addSessionRows(Commands &table, OpenPainting &open);

void addEditRows(Commands &table, OpenPainting &open);
void addObjectRows(Commands &table, OpenPainting &open);
void addLayerRows(Commands &table, OpenPainting &open);
void addAreaRows(Commands &table, OpenPainting &open);
void addReshapeRows(Commands &table, OpenPainting &open);
void addRestyleRows(Commands &table, OpenPainting &open);
void addColourRows(Commands &table, OpenPainting &open);
void addAlignRows(Commands &table, OpenPainting &open);
void addTimeRows(Commands &table, OpenPainting &open);
void addBrushRows(Commands &table, OpenPainting &open);

/// A brush was chosen, to paint with it: takes the Brush, unless the tool in use paints as well.
void takeToPaint(const Commands &table, Editor &editor);

/// Something is selected.
CommandRow::Condition anySelected(Editor &editor);
/// The painting has a stroke.
CommandRow::Condition anyStrokes(Editor &editor);

} // namespace suffuse

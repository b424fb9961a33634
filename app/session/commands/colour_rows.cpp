// The row that gives paint the colours of the palette.
#include "app/session/commands/session_rows.h"

#include "app/session/colour/recolouring.h"

namespace suffuse {

void addColourRows(Commands &table, OpenPainting &open)
{
    Editor &editor = open.editor;
    table
        .add(Command::MapToSwatches, "mapToSwatches", Commands::tr("Map Colours to S&watches"), "", {},
             Commands::tr("Give what is selected, or else all of the painting, the swatches that look nearest"))
        .when([strokes = anyStrokes(editor), &editor, whyNot = Commands::tr("The painting has no swatches.")] {
            return editor.unsettled().painting()->swatches.empty() ? Usability(false, whyNot) : strokes();
        })
        .runs([&table, &editor] {
            if (const QString why = mapToSwatches(editor); !why.isEmpty())
                emit table.said(why, 5000);
        });
}

} // namespace suffuse

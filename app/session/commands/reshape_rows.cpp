// Rows that reshape the selected strokes by the amounts that were used last.
#include "app/session/commands/reshaping.h"
#include "app/session/commands/session_rows.h"

namespace suffuse {

void addReshapeRows(Commands &table, OpenPainting &open)
{
    using enum Command;
    Editor &editor = open.editor;
    const auto add = [&](Command command, const char *id, const QString &text, const char *icon, const QString &keys,
                         const QString &tip, Reshaping what, bool inverse = false) {
        table.add(command, QString::fromLatin1(id), text, icon, {QKeySequence(keys)}, tip)
            .when(anySelected(editor))
            .runs([&table, &editor, what, inverse] {
                ReshapeAmounts amounts = ReshapeAmounts::stored();
                if ((amounts.width < 1) != inverse)
                    amounts.width = 1 / amounts.width;
                if (const QString why = reshapeSelected(editor, what, amounts); !why.isEmpty())
                    emit table.said(why, 5000);
            });
    };
    add(SmoothStrokes, "smoothStrokes", Commands::tr("&Smooth"), "smooth", Commands::tr("Ctrl+Shift+L"),
        Commands::tr("Smooth the curves of the selected strokes; each time more"), Reshaping::Smooth);
    add(StraightenStrokes, "straighten", Commands::tr("S&traighten"), "straighten", Commands::tr("Ctrl+Alt+L"),
        Commands::tr("Move the selected strokes towards straight lines; each time more"), Reshaping::Straighten);
    add(GrowPaint, "growPaint", Commands::tr("&Grow Paint"), "grow", Commands::tr("Ctrl+)"),
        Commands::tr("Make the paint of the selected strokes wider"), Reshaping::Width);
    add(ShrinkPaint, "shrinkPaint", Commands::tr("S&hrink Paint"), "shrink", Commands::tr("Ctrl+("),
        Commands::tr("Make the paint of the selected strokes narrower"), Reshaping::Width, true);
}

} // namespace suffuse

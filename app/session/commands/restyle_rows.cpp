// Rows that put a brush, or the appearance of another stroke, on the selection.
#include "app/session/commands/restyling.h"
#include "app/session/commands/session_rows.h"

namespace suffuse {

void addRestyleRows(Commands &table, OpenPainting &open)
{
    using enum Command;
    Editor &editor = open.editor;
    const auto say = [&table](const QString &why) {
        if (!why.isEmpty())
            emit table.said(why, 5000);
    };
    const auto apply = [&](Command command, const char *id, const QString &text, const QList<QKeySequence> &keys,
                           const QString &tip, BrushPart part) {
        table.add(command, QString::fromLatin1(id), text, part == BrushPart::Whole ? "brush" : "", keys, tip)
            .when(anySelected(editor))
            .runs([&editor, part, say] { say(commands::applyBrushInHand(editor, part)); });
    };
    apply(ApplyBrush, "applyBrush", Commands::tr("&Whole Brush"), {QKeySequence(Commands::tr("Ctrl+B"))},
          Commands::tr("Put the brush in hand on the selected strokes; they remember the pen's pressure"),
          BrushPart::Whole);
    apply(ApplyBrushForm, "applyBrushForm", Commands::tr("&Form Only"), {},
          Commands::tr("Width, density, tapering and tip of the brush in hand"), BrushPart::Form);
    apply(ApplyBrushColour, "applyBrushColour", Commands::tr("&Colour Only"), {},
          Commands::tr("Colour and opacity of the brush in hand"), BrushPart::Colour);
    apply(ApplyBrushTexture, "applyBrushTexture", Commands::tr("&Texture Only"), {},
          Commands::tr("Style, mixing, grain and drying time of the brush in hand"), BrushPart::Texture);
    table
        .add(CopyAppearance, "copyAppearance", Commands::tr("C&opy Appearance"), "",
             {QKeySequence(Commands::tr("Ctrl+Shift+C"))},
             Commands::tr("Copy style, mixing, values and colour of the stroke that was selected last"))
        .when(anySelected(editor))
        .runs([&open] { commands::copyAppearance(open.editor, open.selectionOrder.last()); });
    const auto paste = [&](Command command, const char *id, const QString &text, const QList<QKeySequence> &keys,
                           const QString &tip, Variation variation) {
        table.add(command, QString::fromLatin1(id), text, "", keys, tip)
            .when([selected = anySelected(editor), whyNot = Commands::tr("Copy an appearance first.")] {
                return commands::copiedAppearance() ? selected() : Usability(false, whyNot);
            })
            .runs([&editor, variation, say] { say(commands::pasteAppearance(editor, variation)); });
    };
    paste(PasteAppearance, "pasteAppearance", Commands::tr("Paste Appeara&nce"),
          {QKeySequence(Commands::tr("Ctrl+Shift+V"))},
          Commands::tr("Put it on the selected strokes; what varies along them goes on varying"), Variation::Kept);
    paste(PasteAppearanceEvenly, "pasteAppearanceEvenly", Commands::tr("Paste Appearance Evenl&y"), {},
          Commands::tr("Put it on the selected strokes, with the same values all along"), Variation::Levelled);
}

} // namespace suffuse

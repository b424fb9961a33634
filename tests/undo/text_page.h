// A page on which texts are typed, as the program does it.
#pragma once

#include "tests/undo/steps.h"
#include "undo/lettering/text_layout.h"
#include "undo/text_edits.h"
#include "undo/text_links.h"

#include <QUndoStack>

namespace suffuse {

/// A document in which texts are set as the program does it.
struct TextPage {
    Document document;
    QUndoStack stack;
    TextLayout layout;

    TextPage() { document.reset(std::make_shared<const Painting>()); }
    const Painting &painting() const { return *document.painting(); }
    GroupId put(const Text &text)
    {
        const GroupId group = document.takeGroupId();
        const LaidText after = layout.lay(text);
        push(setText(document, group, text, nullptr, after, change({})));
        return group;
    }
    void set(GroupId group, const Text &text, std::optional<qsizetype> at = {})
    {
        const LaidText before = layout.lay(*textOf(painting(), group)), after = layout.lay(text);
        push(setText(document, group, text, &before, after, change(at)));
    }
    void retype(GroupId group, const QString &string, std::optional<qsizetype> at = {})
    {
        Text text = *textOf(painting(), group);
        text.string = string;
        set(group, text, at);
    }
    void push(Edit edit)
    {
        completeTexts(painting(), edit, [this](const Text &text) { return layout.lay(text); });
        if (!edit.isEmpty())
            pushStep(stack, document, std::move(edit));
    }
    TextChange change(std::optional<qsizetype> at)
    {
        Brush brush;
        brush.colour = {0.5f, 0.25f, 0, 1};
        return {at, letterWith(brush, 100, ++born), true};
    }
    QString names() const
    {
        QString all;
        for (const StrokePtr &stroke : painting().strokes)
            all += stroke->name;
        return all;
    }
    StrokePtr letter(int index) const { return painting().strokes[std::size_t(index)]; }
    void select(int index) { document.setSelection({{letter(index)->id}, {}}); }
    void recolour(int index, const Colour &colour)
    {
        push(changeStrokes(document, {letter(index)->id}, [&](Stroke &stroke) {
            Fill fill = *stroke.fill;
            fill.colour = colour;
            stroke.fill = fill;
        }));
    }

    Microseconds born = 0;
};

inline Text typedText(const QString &string)
{
    Text text;
    text.string = string;
    text.family = QStringLiteral("DejaVu Sans");
    text.size = 100;
    text.place = Affine::translation({50, 200});
    return text;
}

} // namespace suffuse

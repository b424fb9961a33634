// A window in which a text is typed.
#pragma once

#include "app/session/settings/settings.h"
#include "app/tools/text/text_row.h"
#include "app/tools/text/text_tool.h"
#include "tests/app/selecting.h"
#include "undo/text_edits.h"

#include <QTest>

namespace suffuse {

/// A window with the Text tool in hand.
struct Typing : Selecting {
    explicit Typing(StrokeList strokes = {}) : Selecting(std::move(strokes))
    {
        use(Command::Text);
        canvas().setFocus();
        editor().setColour({0.25f, 0.5f, 0, 1});
    }
    TextTool &tool() { return *static_cast<TextTool *>(canvas().tool()); }
    void type(const QString &keys) { QTest::keyClicks(&canvas(), keys); }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&canvas(), key, modifiers); }
    QString names()
    {
        QString all;
        for (const StrokePtr &stroke : painting().strokes)
            all += stroke->name;
        return all;
    }
    QString string()
    {
        for (const Group &group : painting().groups)
            if (group.text)
                return group.text->string;
        return {};
    }
    GroupId group() { return painting().groups.empty() ? 0 : painting().groups.back().id; }
    StrokePtr letter(int index) { return painting().strokes[std::size_t(index)]; }
    Point inkOf(int index) { return curveBox(*letter(index)).centre(); }
    /// The middle of the caret before a character of the text in hand, or of the first one that there is.
    Point placeOf(qsizetype position)
    {
        const SharedText text = textOf(painting(), group());
        const CaretLine caret = TextLayout().lay(*text).caretAt(position);
        return text->place(0.5 * (caret[0] + caret[1]));
    }
    void write(const QString &keys, Point where = {200, 300})
    {
        click(where);
        type(keys);
        key(Qt::Key_Escape);
        editor().clock().setTime(painting().end()); // paint that is not there yet is not clicked
        // The next click is no second one of a double click.
        QTest::qWait(QApplication::doubleClickInterval() + 20);
    }
    void doubleClick(Point where)
    {
        click(where);
        const QPointF at = this->at(where);
        send(QEvent::MouseButtonDblClick, at, {});
        send(QEvent::MouseButtonRelease, at, {});
    }
    QWidget &row() { return *window.findChild<TextRow *>(); }
};

inline const Colour red{1, 0.2f, 0, 1};

inline void recolour(Typing &s, int letter)
{
    const StrokeId id = s.letter(letter)->id;
    s.editor().push(changeStrokes(s.editor().document(), {id},
                                  [](Stroke &stroke) {
                                      Fill fill = *stroke.fill;
                                      fill.colour = red;
                                      stroke.fill = fill;
                                  }),
                    "red");
}

} // namespace suffuse

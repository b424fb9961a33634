// The text that is being typed.
#pragma once

#include "app/session/gesture.h"
#include "undo/lettering/text_layout.h"

#include <QObject>

#include <functional>
#include <optional>

namespace suffuse {

struct Change;
class Editor;

/// A text in hand: what is typed shows as paint at once, and is one undo step when it is left. Until then its own steps
/// can be taken back one by one. It follows whatever else happens to its group: it is another text where something else
/// has changed it, and is left where the group is gone.
class TextEntry : public QObject {
    Q_OBJECT

public:
    explicit TextEntry(Editor &editor, QObject *parent = nullptr);

    bool isOpen() const { return m_isOpen; }
    /// Begins a text of which nothing is there yet, with the values of `text`.
    void begin(const Text &text);
    /// Takes a text into the hand, which must be one and visible; not one that is locked. The caret stands at its end.
    void open(GroupId group);
    /// What was typed is a step, and is typed on: before saving, for example. What was taken back is a step that can be
    /// redone. What an input method has not decided is left out.
    void settle();
    /// Leaves the text: what was typed is a step, and its letters are selected. What an input method has not decided is
    /// left out.
    void finish();
    /// Puts back what was typed since the text was taken into the hand, and leaves it.
    void giveUp();

    /// What is shown: with what an input method composes.
    const Text &text() const { return m_shown; }
    const LaidText &laid() const { return m_laid; }
    GroupId group() const { return m_group; }
    /// The place of the caret in what is shown, and the other end of what is selected.
    qsizetype caret() const { return m_preedit.isEmpty() ? m_caret : m_caret + m_preeditCaret; }
    qsizetype anchor() const { return m_preedit.isEmpty() ? m_anchor : caret(); }
    bool hasSelection() const { return m_preedit.isEmpty() && m_caret != m_anchor; }
    QString selectedString() const;
    /// From where to where an input method composes.
    std::pair<qsizetype, qsizetype> composed() const { return {m_caret, m_caret + m_preedit.size()}; }
    /// The strokes of the selected letters.
    std::set<StrokeId> selectedLetters();

    void moveTo(qsizetype position, bool selects);
    void select(qsizetype from, qsizetype to);
    /// Puts characters in place of what is selected.
    void type(const QString &characters);
    /// Deletes what is selected, or else what lies between the caret and a place.
    void eraseTo(qsizetype position);
    /// Changes size, font and the like; the string stays. Steps of one field follow each other as one.
    void change(const std::function<void(Text &)> &how);
    /// What an input method composes at the caret, with the place of its caret in it.
    void compose(const QString &preedit, qsizetype caret);
    /// What an input method has decided: it goes in place of `length` characters at `start` from the caret.
    void decide(const QString &characters, qsizetype start, qsizetype length);

    /// Whether something was typed that can be taken back by itself.
    bool hasTyped() const;
    bool canTypeAgain() const { return !m_future.empty(); }
    /// Returns false where nothing typed is left to take back; what was taken back before is a step then, which the
    /// undo stack can redo after whatever it undoes next.
    bool takeBack();
    bool typeAgain();

    /// New letters take the colour of the brush instead of that of their neighbours, until the caret is moved.
    void useBrush() { m_usesBrush = true; }

signals:
    void changed(); ///< what is shown, or where the caret is
    void opened();
    void closed();
    /// The font is not there: what is typed now is ignored, once, and the next time another font stands in.
    void fontMissing(const QString &family);
    void locked(); ///< the text that should be opened is locked, or something in it is

private:
    struct State {
        Text text;
        qsizetype caret = 0, anchor = 0;
        PaintingPtr painting; ///< that shows it, so that the very strokes come back; null: not known
    };
    /// What was there before the text had no letter left, which is no group then.
    struct Emptied {
        PaintingPtr painting;
        Text text;
    };
    enum class Kind { None, Typed, Erased, Changed };

    /// Notes where it was, so that the next change can be taken back; changes of one kind follow each other as one
    /// step.
    void note(Kind kind, bool goesOn);
    void replace(qsizetype from, qsizetype to, const QString &characters, Kind kind);
    State state() const { return {m_text, m_caret, m_anchor, m_plain}; }
    void show(std::optional<qsizetype> at);
    void put(Edit edit, Text shown);
    void bringBack();
    void restore(const State &state);
    void keepForRedo();
    void follow(const Change &change);
    void close();
    bool refusesForFont();

    Editor &m_editor;
    TextLayout m_layout;
    Gesture m_gesture;
    bool m_isOpen = false;
    bool m_shows = false; ///< it is changing the document itself
    GroupId m_group = 0;
    Text m_text;         ///< as typed
    Text m_shown;        ///< with what is composed
    PaintingPtr m_plain; ///< the painting as it shows m_text; null: not known
    LaidText m_laid;     ///< of m_shown
    QString m_preedit;
    qsizetype m_preeditCaret = 0;
    qsizetype m_caret = 0, m_anchor = 0; ///< in m_text
    std::vector<State> m_past, m_future;
    std::optional<Emptied> m_emptied;
    Kind m_last = Kind::None;
    bool m_usesBrush = false;
    bool m_wasWarned = false; ///< that the font is missing
    bool m_isOld = false;     ///< it was there before it was taken into the hand
    bool m_isThere = false;   ///< the painting has its group
};

} // namespace suffuse

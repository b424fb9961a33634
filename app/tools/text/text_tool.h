#pragma once

#include "app/session/lettering/text_entry.h"
#include "app/tools/canvas_tool.h"
#include "app/tools/text/text_keys.h"
#include "app/tools/text/text_values.h"

#include <QBasicTimer>

namespace suffuse {

/// Types texts, whose letters are strokes with the paint of the brush. A click begins a text, or puts the caret into
/// one. What is typed shows as paint at once, and is one undo step when it is left: by Esc, a click elsewhere or
/// another tool. While a text is in hand, all keys that type or move a caret are the tool's.
class TextTool : public CanvasTool {
    Q_OBJECT

public:
    explicit TextTool(CanvasWidget &canvas, QObject *parent = nullptr);

    QString hint() const override;
    QCursor cursor() const override { return Qt::IBeamCursor; }
    QWidget *options() override { return m_values.options(); }
    ColourTarget::ToolUse colourUse() const override { return ColourTarget::ToolUse::Paints; }
    bool showsOutlines() const override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    bool isBusy() const override { return m_isPressed || m_entry.hasTyped(); }
    void cancel() override;
    void settle() override;
    void settleWritten() override { settle(); } // it leaves the caret where it is
    bool takesText() const override { return m_entry.isOpen(); }
    bool keyPress(QKeyEvent *event) override;
    bool wantsKey(const QKeyEvent &event) const override;
    void inputMethod(QInputMethodEvent &event) override;
    QVariant inputMethodQuery(Qt::InputMethodQuery query) const override;
    bool takeBack() override { return m_entry.takeBack(); }
    bool deleteSelected() override;
    bool selectAll() override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

    /// Takes a text into the hand, with the caret at a place.
    void edit(GroupId text, Point point);
    TextEntry &entry() { return m_entry; }
    /// Does what a key does in the text in hand, for commands. Returns false if none is in hand.
    bool takesKey(Qt::Key key, Qt::KeyboardModifiers modifiers);

protected:
    void timerEvent(QTimerEvent *event) override;

private:
    void beginByKey();
    qsizetype placeAt(Point point) const;
    bool isOver(Point point) const;
    GroupId textAt(const PointerEvent &event) const;
    void changed();
    void say(const QString &text);
    void restartBlinking();
    QRectF seenCaret() const;
    void followCaret();

    TextEntry m_entry;
    TextValues m_values;
    TextKeys m_keys;
    mutable TextLayout m_layout; ///< for texts that are not in hand
    bool m_isPressed = false;
    bool m_isOn = true; ///< the caret, as it blinks
    bool m_choosesWords = false;
    qsizetype m_wordFrom = 0, m_wordTo = 0;   ///< the word where a drag by words began
    std::pair<QString, qsizetype> m_followed; ///< the text and the caret in it that the view has followed
    QBasicTimer m_blinking;
    QRectF m_caret;              ///< device pixels, where it was drawn last; empty: more than a caret was
    mutable SharedText m_framed; ///< the text of which m_frame is the box
    mutable Rect m_frame;
    QString m_said;
};

} // namespace suffuse

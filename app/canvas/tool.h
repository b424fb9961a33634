// What stands between the pointer and the document: a tool.
#pragma once

#include "app/canvas/input/pointer_event.h"
#include "app/session/colour/colour_target.h"
#include "model/painting/selection.h"
#include "render/view.h"

#include <QCursor>
#include <QObject>
#include <QVariant>

#include <optional>

class QInputMethodEvent;
class QKeyEvent;
class QPainter;
class QWidget;

namespace suffuse {

/// What the canvas knows of a tool. The tool sees press, moves and release of the main button, and the hovering in
/// between. It changes the document through the editor, and draws only on the overlay.
class Tool : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// One line for the status bar, translated.
    virtual QString hint() const = 0;
    virtual QCursor cursor() const { return Qt::ArrowCursor; }
    /// The widget for the row over the canvas while the tool is in use; null if there is none. It is always the same
    /// one, and belongs to the row from then on.
    virtual QWidget *options() { return nullptr; }

    virtual void press(const PointerEvent &event) = 0;
    virtual void move(const PointerEvent &event) = 0;
    virtual void release(const PointerEvent &event) = 0;
    virtual void hover(const PointerEvent &) {}
    virtual void leave() {}
    /// Whether a drag may change strokes that are not selected.
    virtual bool changesAnything() const { return false; }
    /// Whether lines are drawn through selected strokes while the tool is in use.
    virtual bool showsOutlines() const { return true; }
    /// Whether selected strokes have dashed lines along what takes paint away while it is in use.
    virtual bool showsErasures() const { return false; }
    /// Whether a press at a pixel moves a guide of the canvas that runs there, since the tool has nothing to do with it.
    virtual bool leavesToGuides(Point /*pixel*/) const { return false; }
    /// Whose colour the colour dock is to show while the tool is in use.
    virtual ColourTarget::ToolUse colourUse() const { return ColourTarget::ToolUse::Refines; }
    /// Whether a press has come and no release yet.
    virtual bool isBusy() const = 0;
    /// Gives up what is in hand, as if it had not begun.
    virtual void cancel() = 0;
    /// Finishes what is in hand between two presses, as far as it is something, before another tool is taken.
    virtual void settle() {}
    /// Makes a step of what the painting has of it already, such as typed letters, and goes on with it, before the
    /// painting is written. What is drawn and not in the painting yet stays in hand.
    virtual void settleWritten() {}
    /// Changes the size by so many steps, for a command. A tool without a size does nothing.
    virtual void stepSize(int /*steps*/) {}
    virtual void stepOpacity(int /*steps*/) {}
    /// Takes a turn of the wheel while the tool is pressed, in notches away from the hand. Returns true if the tool has
    /// used it.
    virtual bool wheel(double /*notches*/) { return false; }
    /// Takes a key. Returns true if the tool has used it.
    virtual bool keyPress(QKeyEvent *) { return false; }
    /// Whether the key means the tool, even where it is the shortcut of a command.
    virtual bool wantsKey(const QKeyEvent &) const { return false; }
    /// Whether what is typed goes into a text: keys mean the tool before they mean the canvas or a command, and input
    /// methods work.
    virtual bool takesText() const { return false; }
    virtual void inputMethod(QInputMethodEvent &) {}
    virtual QVariant inputMethodQuery(Qt::InputMethodQuery) const { return {}; }
    /// Takes back the last step of what is in hand, for the command Undo. Returns false if there is none.
    virtual bool takeBack() { return false; }
    /// Whether the tool itself has chosen something, besides strokes, that the command Delete means.
    virtual bool hasChosen() const { return false; }
    /// Deletes what the tool itself has selected (nodes), for the command Delete. Returns false if that is nothing.
    virtual bool deleteSelected() { return false; }
    /// Selects all that the tool itself selects (nodes), for the command Select All. Returns false if it selects
    /// nothing.
    virtual bool selectAll() { return false; }
    /// The box of what the tool itself has selected (nodes), canvas units; empty if that is nothing.
    virtual Rect chosenBox() const { return {}; }
    /// Draws over the picture, in device pixels.
    virtual void paint(QPainter &, const View &, double /*dpr*/) const {}
    /// How far from the control points of the selected strokes `paint` may draw at the moment, in device pixels. No
    /// value means that it may draw anywhere.
    virtual std::optional<double> paintMargin() const { return {}; }

signals:
    /// Emitted when `hint` returns another line than before.
    void hintChanged();
    /// Emitted when `isBusy` and `cursor` may be other ones without an event or a command: what was worked on aside is
    /// done.
    void asideChanged();
    /// Emitted when `takesText` or what input methods ask for has changed.
    void typingChanged();
    /// A text is to be typed in, with the caret at the pointer.
    void textAsked(const suffuse::PointerEvent &event, suffuse::GroupId text);
    /// The values of a segment that is selected, or of its stroke, are to be shown and changed where the pointer is.
    void valuesAsked(const suffuse::PointerEvent &event, const suffuse::SegmentRef &segment);
};

} // namespace suffuse

// What happens between pointer and document.
#pragma once

#include "app/canvas/input/pointer_event.h"
#include "render/view.h"

#include <QCursor>
#include <QObject>

#include <optional>

class QKeyEvent;
class QPainter;
class QWidget;

namespace suffuse {

/// What the canvas knows of a tool: it sees press, moves, release of the main button, and hovering in between; it
/// changes the document through the editor and draws only on the overlay.
class Tool : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// One line for the status bar, translated.
    virtual QString hint() const = 0;
    virtual QCursor cursor() const { return Qt::ArrowCursor; }
    /// What stands in the row over the canvas while the tool is in use, always the same widget; null: nothing. The row
    /// owns it from then on.
    virtual QWidget *options() { return nullptr; }

    virtual void press(const PointerEvent &event) = 0;
    virtual void move(const PointerEvent &event) = 0;
    virtual void release(const PointerEvent &event) = 0;
    virtual void hover(const PointerEvent &) {}
    virtual void leave() {}
    /// A drag may change strokes that are not selected.
    virtual bool changesAnything() const { return false; }
    /// Whether selected strokes have their lines while it is in use.
    virtual bool showsOutlines() const { return true; }
    /// True between press and release.
    virtual bool isBusy() const = 0;
    /// Gives up what is in hand, as if it had not begun.
    virtual void cancel() = 0;
    /// The commands for size and opacity, by so many steps; nothing for a tool that has none.
    virtual void stepSize(int /*steps*/) {}
    virtual void stepOpacity(int /*steps*/) {}
    /// True if the key was used.
    virtual bool keyPress(QKeyEvent *) { return false; }
    /// True if the key means the tool, even where it is a command's shortcut.
    virtual bool wantsKey(const QKeyEvent &) const { return false; }
    /// The command Delete: true if the tool deleted something of its own (nodes).
    virtual bool deleteSelected() { return false; }
    /// The command Select All: true if the tool selected something of its own (nodes).
    virtual bool selectAll() { return false; }
    /// Draws over the picture, in device pixels.
    virtual void paint(QPainter &, const View &, double /*dpr*/) const {}
    /// Device pixels around the control points of the selected strokes that `paint` keeps to now; none: it may paint
    /// anywhere.
    virtual std::optional<double> paintMargin() const { return {}; }

signals:
    /// What hint() says is another line now.
    void hintChanged();
};

} // namespace suffuse

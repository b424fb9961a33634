#pragma once

#include <QObject>

#include <functional>

class QKeyEvent;
class QWidget;

namespace suffuse {

/// For a widget on which something is dragged from press to release. A dialog or a menu that opens meanwhile takes the
/// mouse, and the release never comes: the widget then gets a release where the pointer was last. It also gets one when
/// the pointer moves on without a button. Until the release Tab does not take the keyboard elsewhere.
void endDragsWhenCovered(QWidget &dragged);

/// Ends what is dragged on such widgets in a panel, in the same way: after a command that selects something else, since
/// a drag is about what was selected at the press.
void endDragsIn(const QWidget &panel);

/// Whether a key gives a drag up: Esc, Delete or undo, as on the canvas.
bool givesUpDrag(const QKeyEvent &key);

/// While it lives, and a QDrag goes on, the keys that give a drag up do so: to be made before `QDrag::exec`, which
/// takes all keys and has no use for any but Esc.
class KeysEndDrag : public QObject {
    Q_OBJECT

public:
    KeysEndDrag(); ///< it ends QDrag's
    explicit KeysEndDrag(std::function<void()> end);

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    std::function<void()> m_end;
};

} // namespace suffuse

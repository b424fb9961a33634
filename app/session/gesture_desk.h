// Where the one gesture lies that is open.
#pragma once

#include "app/session/floating_view.h"
#include "model/document/document.h"

#include <functional>
#include <memory>

namespace suffuse {

class GestureState;
class GestureSteps;

/// Exchanges what a gesture shows with the document, and decides it when somebody else needs the document: whatever is
/// begun commits what is open; an exchange that comes from elsewhere, a step of the undo stack, has it given up before,
/// since it leads from a state without it.
class GestureDesk : public QObject {
    Q_OBJECT

public:
    /// What a gesture needs of the editor.
    struct Host {
        std::function<Edit(Edit)> place;                            ///< an edit, where it belongs in time
        std::function<void(Edit back, const QString &name)> commit; ///< what was done becomes a step
    };

    GestureDesk(Document &document, Host host);

    std::unique_ptr<GestureState> begin(const QString &name, GestureSteps *steps = nullptr);
    const GestureState *open() const { return m_open; }
    /// The hand of what is open does not rest.
    bool isMoving() const { return m_open && !m_rests; }
    /// The way back from what is shown and in no step yet; null: nothing is.
    const Edit *undecided() const;
    /// Of what is open, if anything is: see Gesture.
    void settle();
    void rest();
    void commit();

    void setFloatingView(FloatingView *view) { m_view = view; }
    FloatingView *floatingView() const { return m_view; }

    // For the gestures themselves.
    const Document &document() const { return m_document; }
    /// It is the one that is open, and moves.
    void take(GestureState &gesture);
    /// Exchanges an edit that it shows, at its place in time.
    void show(Edit &edit);
    void rest(GestureState &gesture);
    void commit(GestureState &gesture);
    void giveUp(GestureState &gesture);

signals:
    void openChanged(bool open);
    void movingEnded();
    void undecidedChanged(); ///< there is something undecided, or nothing any more
    /// What is shown is to be kept in case of a crash, or is not there any more though it was told so.
    void restTold();

private:
    void exchange(Edit &edit);
    bool close();

    Document &m_document;
    Host m_host;
    FloatingView *m_view = nullptr;
    GestureState *m_open = nullptr;
    bool m_rests = false;
    bool m_told = false;      ///< `restTold`, of what is open
    bool m_exchanges = false; ///< for a gesture
};

} // namespace suffuse

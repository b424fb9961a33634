#include "app/session/gesture_desk.h"

#include "app/session/gesture_state.h"
#include "undo/history/back_edit.h"

#include <QScopedValueRollback>

namespace suffuse {

GestureDesk::GestureDesk(Document &document, Host host) : m_document(document), m_host(std::move(host))
{
    connect(&document, &Document::aboutToExchange, this, [this] {
        if (m_open && !m_exchanges)
            giveUp(*m_open);
    });
    connect(&document, &Document::changed, this, [this](const Change &change) {
        if (!change.reset || !m_open)
            return;
        m_open->forget();
        (void)close();
    });
}

std::unique_ptr<GestureState> GestureDesk::begin(const QString &name, GestureSteps *steps)
{
    auto gesture = std::make_unique<GestureState>(*this, name, steps);
    take(*gesture);
    m_rests = true; // until it shows something: no frame comes of a press alone, and none would tell that it rests
    return gesture;
}

void GestureDesk::take(GestureState &gesture)
{
    m_rests = m_rests && m_open != &gesture;
    if (m_open == &gesture)
        return;
    commit();
    m_open = &gesture;
    m_rests = false;
    emit openChanged(true);
}

void GestureDesk::show(Edit &edit)
{
    edit = m_host.place(std::move(edit));
    exchange(edit);
}

void GestureDesk::exchange(Edit &edit)
{
    const QScopedValueRollback exchanges(m_exchanges, true);
    m_document.exchange(edit);
}

const Edit *GestureDesk::undecided() const
{
    return m_open ? m_open->back() : nullptr;
}

void GestureDesk::settle()
{
    if (m_open)
        m_open->settle();
}

void GestureDesk::rest()
{
    if (m_open)
        rest(*m_open);
}

void GestureDesk::rest(GestureState &gesture)
{
    if (m_open != &gesture || m_rests)
        return;
    gesture.settle();
    if (gesture.back() && changesNothing(*gesture.back(), *m_document.painting())) {
        (void)gesture.takeBack(); // It is back where it began, so there is nothing to decide.
        emit undecidedChanged();
    }
    gesture.liftAnew();
    m_rests = true;
    m_told = m_told || gesture.back();
    emit movingEnded();
    if (m_told)
        emit restTold();
}

void GestureDesk::commit()
{
    if (m_open)
        commit(*m_open);
}

void GestureDesk::commit(GestureState &gesture)
{
    if (m_open != &gesture)
        return;
    const QString name = gesture.name();
    std::optional<Edit> back = gesture.takeBack();
    const bool told = close();
    if (back && !changesNothing(*back, *m_document.painting()))
        m_host.commit(std::move(*back), name);
    else if (told)
        emit restTold();
    emit undecidedChanged();
}

void GestureDesk::giveUp(GestureState &gesture)
{
    if (m_open != &gesture)
        return;
    std::optional<Edit> back = gesture.takeUndo();
    const bool told = close(); // whoever hears of the exchange may begin another one
    if (back)
        exchange(*back);
    if (told)
        emit restTold();
    emit undecidedChanged();
}

/// Returns whether `restTold` has told of it.
bool GestureDesk::close()
{
    m_open = nullptr;
    m_rests = false;
    emit openChanged(false);
    if (m_view)
        m_view->endLift();
    emit movingEnded();
    return std::exchange(m_told, false);
}

} // namespace suffuse

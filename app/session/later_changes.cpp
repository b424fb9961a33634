#include "app/session/later_changes.h"

#include <QCoreApplication>
#include <QEvent>

#include <algorithm>

namespace suffuse {

namespace {

constexpr int patienceMs = 100; ///< where nothing is painted: a window that is covered
/// While strokes change again and again, panels follow so often, and for at most about a fifth of the time.
constexpr qint64 leastRestMs = 50, mostRestMs = 150, restShare = 4;

void add(Change &to, const Change &change)
{
    to.strokes.insert(to.strokes.end(), change.strokes.begin(), change.strokes.end());
    std::sort(to.strokes.begin(), to.strokes.end());
    to.strokes.erase(std::unique(to.strokes.begin(), to.strokes.end()), to.strokes.end());
    to.order = to.order || change.order;
    to.canvas = to.canvas || change.canvas;
    to.selection = to.selection || change.selection;
    to.draft = to.draft || change.draft;
    to.reset = to.reset || change.reset;
}

/// Something is being done that may ask what stands in a panel.
bool actsOnPanels(QEvent::Type type)
{
    switch (type) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::TabletPress:
    case QEvent::TouchBegin:
    case QEvent::Wheel:
    case QEvent::KeyPress:
    case QEvent::ShortcutOverride:
    case QEvent::InputMethod:
    case QEvent::DragEnter:
    case QEvent::Drop:
        return true;
    default:
        return false;
    }
}

} // namespace

LaterChanges::LaterChanges(Document &document, QObject *parent) : QObject(parent)
{
    m_clock.start();
    m_due.setSingleShot(true);
    connect(&m_due, &QTimer::timeout, this, &LaterChanges::flush);
    connect(&document, &Document::changed, this, &LaterChanges::take);
}

void LaterChanges::take(const Change &change)
{
    if (m_waits && m_waits(change)) {
        if (!m_waiting) {
            m_waiting.emplace();
            m_due.start(patienceMs);
            qApp->installEventFilter(this);
        }
        add(*m_waiting, change);
        return;
    }
    if (m_waiting) { // one with what waited: the states in between are gone
        add(*m_waiting, change);
        flush();
    } else {
        emit changed(change);
    }
}

void LaterChanges::painted()
{
    if (m_waiting)
        m_due.start(int(std::max<qint64>(0, m_restsUntil - m_clock.elapsed())));
}

void LaterChanges::flush()
{
    if (!m_waiting)
        return;
    m_due.stop();
    qApp->removeEventFilter(this);
    const Change change = *std::exchange(m_waiting, std::nullopt);
    const qint64 start = m_clock.elapsed();
    emit changed(change);
    const qint64 end = m_clock.elapsed();
    if (!change.strokes.empty())
        m_restsUntil = end + std::clamp(restShare * (end - start), leastRestMs, mostRestMs);
}

bool LaterChanges::eventFilter(QObject *watched, QEvent *event)
{
    if (actsOnPanels(event->type()))
        flush();
    return QObject::eventFilter(watched, event);
}

} // namespace suffuse

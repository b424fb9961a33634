#include "app/session/later_changes.h"

#include <QScopedValueRollback>

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
    to.texts = to.texts || change.texts;
    to.selection = to.selection || change.selection;
    to.draft = to.draft || change.draft;
    to.reset = to.reset || change.reset;
}

} // namespace

LaterChanges::LaterChanges(Document &document, QObject *parent) : QObject(parent)
{
    m_clock.start();
    m_due.setSingleShot(true);
    connect(&m_due, &QTimer::timeout, this, &LaterChanges::flush);
    connect(&document, &Document::changed, this, &LaterChanges::take);
}

bool LaterChanges::waits(const Change &change) const
{
    if (!m_canvasShown || change.canvas || change.draft || change.reset || (change.order && !m_gestureOpen))
        return false;
    return change.selection || change.texts || !change.strokes.empty();
}

void LaterChanges::take(const Change &change)
{
    if (waits(change)) {
        if (!m_waiting) {
            m_waiting.emplace();
            m_due.start(patienceMs);
        }
        add(*m_waiting, change);
        return;
    }
    if (m_waiting) { // one with what waited: the states in between are gone
        add(*m_waiting, change);
        flush();
    } else {
        tell(change);
    }
}

void LaterChanges::tell(const Change &change)
{
    const QScopedValueRollback telling(m_telling, true);
    emit changed(change);
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
    const Change change = *std::exchange(m_waiting, std::nullopt);
    const qint64 start = m_clock.elapsed();
    tell(change);
    const qint64 end = m_clock.elapsed();
    if (!change.strokes.empty())
        m_restsUntil = end + std::clamp(restShare * (end - start), leastRestMs, mostRestMs);
}

} // namespace suffuse

#include "app/canvas/overlay/canvas_note.h"

#include "app/canvas/overlay/overlay.h"

#include <QPainter>

#include <utility>

namespace suffuse {

CanvasNote::CanvasNote()
{
    m_timer.setSingleShot(true);
    m_timer.setInterval(shownMs);
    connect(&m_timer, &QTimer::timeout, this, [this] { show({}); });
}

void CanvasNote::show(const QString &text)
{
    if (text.isEmpty())
        m_timer.stop();
    else
        m_timer.start();
    if (std::exchange(m_text, text) != text)
        emit changed();
}

void CanvasNote::paint(QPainter &painter, const View &view, double dpr) const
{
    if (m_text.isEmpty())
        return;
    constexpr double fromEdge = 12; // logical pixels
    const double y = fromEdge * dpr;
    paintPlate(painter, m_text, {view.width / 2.0, y}, view.width - 2 * y, dpr);
}

} // namespace suffuse

#include "app/panels/timeline/timeline_view.h"

#include "app/session/editor.h"
#include "app/session/playback.h"

#include <QGestureEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QNativeGestureEvent>
#include <QPinchGesture>
#include <QScrollBar>
#include <QToolTip>
#include <QWheelEvent>

#include <cmath>
#include <tuple>
#include <utility>

namespace suffuse {

namespace {

constexpr double endMargin = 12;             ///< pixels at both ends when all is shown
constexpr double finest = 20;                ///< microseconds a pixel
constexpr double mostPixels = 1e9;           ///< of the whole length, so that scroll bars can count them
constexpr Microseconds shortest = 1'000'000; ///< of what is shown of an empty painting
constexpr int lanesLaterMs = 60;

/// Time ahead of what is painted.
Microseconds roomFor(const TimeSpan &span)
{
    return (span.end - span.begin) / 16;
}

} // namespace

TimelineView::TimelineView(Editor &editor, Playback &playback, QWidget *parent)
    : QAbstractScrollArea(parent), m_editor(editor), m_playback(playback)
{
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::StrongFocus);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // nothing moves while one zooms
    setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    setAccessibleName(tr("Timeline"));
    viewport()->setMouseTracking(true);
    viewport()->grabGesture(Qt::PinchGesture);
    setMinimumHeight(rulerHeight() + 40);
    m_later.setSingleShot(true);
    m_later.setInterval(lanesLaterMs);
    connect(&m_later, &QTimer::timeout, this, &TimelineView::refresh);
    connect(&editor.document(), &Document::changed, this, [this](const Change &change) {
        documentChanged(!change.strokes.empty() || change.order || change.canvas, change.selection, change.reset);
        if (change.draft)
            draftChanged();
    });
    connect(&editor.clock(), &PaintingClock::timeChanged, this, &TimelineView::timeChanged);
    connect(&editor.clock(), &PaintingClock::pastChanged, viewport(), qOverload<>(&QWidget::update));
}

int TimelineView::rulerHeight() const
{
    return fontMetrics().height() + 10;
}

void TimelineView::documentChanged(bool painting, bool selection, bool reset)
{
    if (reset) {
        m_drag = Drag::None;
        m_before.reset();
        m_fitted = true;
        m_room = 0;
    }
    m_stale = m_stale || painting || reset;
    m_looksStale = m_looksStale || selection || reset || m_before;
    if (!isVisible() || !(painting || selection || reset))
        return;
    if (m_drag != Drag::None || reset)
        refresh();
    else if (!m_later.isActive())
        m_later.start();
}

void TimelineView::draftChanged()
{
    m_draftStale = true;
    if (isVisible() && !m_later.isActive())
        m_later.start();
}

void TimelineView::catchUp()
{
    if (m_stale)
        refresh();
}

void TimelineView::refresh()
{
    const auto seen = [this] { return std::tuple(m_from, m_scale, verticalScrollBar()->value()); };
    const auto before = seen();
    bool differs = std::exchange(m_looksStale, false);
    // While bars are dragged the lanes stay: what is dragged is painted over them.
    if (m_stale && !m_before) {
        differs = m_bars.setPainting(m_editor.document().painting()) || differs;
        m_stale = false;
    }
    updateScrollBars();
    if (std::exchange(m_draftStale, false))
        updateDraft();
    if (differs || seen() != before)
        viewport()->update();
}

void TimelineView::updateDraft()
{
    QRect now;
    if (const std::optional<TimelineBar> draft = draftBar())
        now =
            QRectF(QPointF(xOf(draft->begin), laneTop(draft->lane)), QPointF(xOf(draft->end), laneTop(draft->lane + 1)))
                .toAlignedRect()
                .adjusted(-4, -1, 4, 1);
    viewport()->update(std::exchange(m_draftRect, now).united(now));
}

void TimelineView::showEvent(QShowEvent *event)
{
    QAbstractScrollArea::showEvent(event);
    m_looksStale = true;
    refresh();
}

void TimelineView::resizeEvent(QResizeEvent *event)
{
    QAbstractScrollArea::resizeEvent(event);
    updateScrollBars();
}

TimeSpan TimelineView::shownSpan() const
{
    TimeSpan span = m_bars.span();
    span.begin = std::min<Microseconds>(span.begin, 0);
    span.end = std::max({span.end, m_editor.clock().shown(), span.begin + shortest});
    if (m_room < span.end + 2 * roomFor(span)) // else undone since
        span.end = std::max(span.end, m_room);
    return span;
}

void TimelineView::updateScrollBars()
{
    const TimeSpan span = shownSpan();
    const double length = double(span.end - span.begin), width = viewport()->width();
    if (m_fitted) {
        m_scale = std::max(length / std::max(width - 2 * endMargin, 1.0), finest);
        m_from = span.begin - Microseconds(endMargin * m_scale);
    }
    m_scale = std::max(m_scale, length / mostPixels);
    const double before = endMargin + double(m_from - span.begin) / m_scale; // pixels left of the view
    const int range = int(std::max(0.0, std::ceil(length / m_scale + 2 * endMargin - width)));
    m_scrolling = true;
    horizontalScrollBar()->setRange(0, range);
    horizontalScrollBar()->setPageStep(int(width));
    horizontalScrollBar()->setSingleStep(40);
    horizontalScrollBar()->setValue(int(std::lround(before)));
    const int rows = int(laneTop(m_bars.laneCount()) - laneTop(0)) + 8;
    verticalScrollBar()->setRange(0, std::max(0, rows - (viewport()->height() - rulerHeight())));
    verticalScrollBar()->setPageStep(viewport()->height() - rulerHeight());
    verticalScrollBar()->setSingleStep(int(laneTop(1) - laneTop(0)));
    m_scrolling = false;
}

void TimelineView::scrollContentsBy(int dx, int)
{
    if (m_scrolling)
        return;
    if (dx != 0) {
        const double pixels = horizontalScrollBar()->value() - endMargin;
        m_from = shownSpan().begin + Microseconds(std::llround(pixels * m_scale));
        m_fitted = false;
    }
    viewport()->update();
}

void TimelineView::fit()
{
    m_fitted = true;
    m_room = 0;
    m_looksStale = true;
    refresh();
}

void TimelineView::zoomBy(double factor)
{
    const double head = xOf(m_editor.clock().shown());
    zoomAt(head >= 0 && head < viewport()->width() ? head : viewport()->width() / 2.0, factor);
}

void TimelineView::zoomAt(double x, double factor)
{
    const TimeSpan span = shownSpan();
    const double widest = double(span.end - span.begin) / std::max(viewport()->width() - 2 * endMargin, 1.0);
    const Microseconds fixed = timeAt(x);
    const double scale = std::clamp(m_scale / factor, finest, std::max(widest, finest));
    m_fitted = scale >= widest;
    m_scale = scale;
    // Neither end comes further in than its margin.
    const Microseconds edge = Microseconds(endMargin * scale);
    const Microseconds last = span.end + edge - Microseconds(viewport()->width() * scale);
    m_from = std::max(span.begin - edge, std::min(fixed - Microseconds(std::llround(x * scale)), last));
    m_looksStale = true;
    refresh();
}

void TimelineView::pinch(QGestureEvent &event)
{
    const auto *gesture = static_cast<QPinchGesture *>(event.gesture(Qt::PinchGesture));
    if (gesture && gesture->changeFlags() & QPinchGesture::ScaleFactorChanged)
        zoomAt(viewport()->mapFromGlobal(gesture->centerPoint()).x(), gesture->scaleFactor());
}

void TimelineView::wheelEvent(QWheelEvent *event)
{
    event->accept();
    constexpr double zoomPerNotch = 1.25, notch = 120;
    const QPoint angle = event->angleDelta();
    const int turned = angle.y() != 0 ? angle.y() : angle.x();
    if (event->modifiers() & Qt::ControlModifier) {
        zoomAt(event->position().x(), std::pow(zoomPerNotch, turned / notch));
    } else {
        const bool across = event->modifiers() & Qt::ShiftModifier || angle.y() == 0;
        QScrollBar *bar = across ? horizontalScrollBar() : verticalScrollBar();
        bar->setValue(bar->value() - (event->pixelDelta().isNull() ? int(turned / notch * 3 * bar->singleStep())
                                      : across                     ? event->pixelDelta().x()
                                                                   : event->pixelDelta().y()));
    }
}

bool TimelineView::viewportEvent(QEvent *event)
{
    if (event->type() == QEvent::Gesture)
        pinch(static_cast<QGestureEvent &>(*event));
    else if (event->type() == QEvent::NativeGesture) {
        const auto &gesture = static_cast<QNativeGestureEvent &>(*event);
        if (gesture.gestureType() == Qt::ZoomNativeGesture)
            zoomAt(gesture.position().x(), 1 + gesture.value());
    } else if (event->type() == QEvent::Leave) {
        unsetCursor();
    } else if (event->type() == QEvent::ToolTip) {
        const auto &help = static_cast<QHelpEvent &>(*event);
        catchUp();
        QToolTip::showText(help.globalPos(), m_drag == Drag::None ? toolTipAt(help.pos()) : QString(), viewport());
        return true;
    }
    return QAbstractScrollArea::viewportEvent(event);
}

void TimelineView::timeChanged()
{
    if (!isVisible())
        return;
    const Microseconds time = m_editor.clock().shown();
    if (const TimeSpan span = shownSpan(); span.end == time) {
        if (m_fitted && time > m_bars.span().end) {
            m_room = time + roomFor(span);
            viewport()->update();
        }
        updateScrollBars();
    }
    // A page on, where it is played out of the view.
    const double x = xOf(time);
    if (m_playback.isPlaying() && !m_fitted && (x < 0 || x > viewport()->width())) {
        m_from = time - Microseconds(endMargin * m_scale);
        updateScrollBars();
        viewport()->update();
    }
    const auto strip = [this](Microseconds t) {
        const double at = std::clamp(xOf(t), -100.0, viewport()->width() + 100.0);
        return QRect(int(at) - 8, 0, 17, viewport()->height());
    };
    for (const Microseconds head : {std::exchange(m_head, time), time}) {
        viewport()->update(strip(head));
        viewport()->update(headArea(head));
    }
}

void TimelineView::keyPressEvent(QKeyEvent *event)
{
    constexpr Microseconds frame = 40'000, second = 1'000'000;
    const Microseconds step = event->modifiers() & Qt::ShiftModifier ? second : frame;
    switch (event->key()) {
    case Qt::Key_Left:
        m_playback.seek(std::max(m_editor.clock().shown() - step, m_playback.begin()));
        break;
    case Qt::Key_Right:
        m_playback.seek(m_editor.clock().shown() + step);
        break;
    case Qt::Key_Home:
        m_playback.seek(m_playback.begin());
        break;
    case Qt::Key_End:
        m_playback.seek(m_playback.end());
        break;
    case Qt::Key_Space:
        m_playback.toggle();
        break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoomBy(1.25);
        break;
    case Qt::Key_Minus:
        zoomBy(0.8);
        break;
    case Qt::Key_0:
        fit();
        break;
    case Qt::Key_Escape:
        if (m_drag != Drag::None) {
            giveUp();
            break;
        }
        [[fallthrough]];
    default:
        QAbstractScrollArea::keyPressEvent(event);
    }
}

bool TimelineView::event(QEvent *event)
{
    if (event->type() != QEvent::ShortcutOverride)
        return QAbstractScrollArea::event(event);
    auto *key = static_cast<QKeyEvent *>(event);
    if (m_drag != Drag::None && key->matches(QKeySequence::Undo)) { // as on the canvas: it gives up the drag
        giveUp();
        key->accept();
    }
    // The canvas' commands have some of these keys.
    constexpr int own[] = {Qt::Key_Left, Qt::Key_Right, Qt::Key_Home,  Qt::Key_End, Qt::Key_Space,
                           Qt::Key_Plus, Qt::Key_Minus, Qt::Key_Equal, Qt::Key_0};
    const bool plain = !(key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier));
    const bool giveUpKey = key->key() == Qt::Key_Escape && m_drag != Drag::None;
    if (giveUpKey || (plain && std::ranges::find(own, key->key()) != std::end(own)))
        key->accept();
    return key->isAccepted() || QAbstractScrollArea::event(event);
}

} // namespace suffuse

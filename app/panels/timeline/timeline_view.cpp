#include "app/panels/timeline/timeline_view.h"

#include "app/panels/timeline/timeline_picture.h"
#include "app/session/editor.h"
#include "app/session/playback.h"
#include "app/widgets/habits/held_button.h"
#include "app/widgets/look/theme.h"

#include <QContextMenuEvent>
#include <QGestureEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPainter>
#include <QPinchGesture>
#include <QScrollBar>
#include <QToolTip>
#include <QWheelEvent>

#include <cmath>
#include <tuple>
#include <utility>

namespace suffuse {

namespace {

constexpr int lanesLaterMs = 60;

} // namespace

TimelineView::TimelineView(Editor &editor, Playback &playback, QWidget *parent)
    : QAbstractScrollArea(parent), m_editor(editor), m_playback(playback),
      m_pointer(editor, playback, m_bars, *viewport())
{
    setFrameShape(QFrame::NoFrame);
    endDragsWhenCovered(*viewport());
    setFocusPolicy(Qt::StrongFocus);
    // The bar is always shown, so that nothing moves when one zooms.
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    setAccessibleName(tr("Timeline"));
    setAccessibleDescription(tr("A bar for each stroke, from when it was painted until it is dry."));
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
    connect(&m_pointer, &TimelinePointer::dragged, this, &TimelineView::dragged);
    connect(&m_pointer, &TimelinePointer::panned, this, &TimelineView::pan);
    connect(&m_pointer, &TimelinePointer::retimingEnded, this, [this](bool isKept) {
        m_stale = true;
        refresh();
        if (isKept) // else the bars are where they were, and so is the view
            revealSelected();
    });
    connect(&editor.clock(), &PaintingClock::timeChanged, this, &TimelineView::timeChanged);
    connect(&editor.clock(), &PaintingClock::pastChanged, viewport(), qOverload<>(&QWidget::update));
}

TimelineAxes TimelineView::axes() const
{
    return {m_shown.from(), m_shown.scale(), rulerHeight(), verticalScrollBar()->value()};
}

int TimelineView::rulerHeight() const
{
    return fontMetrics().height() + 10;
}

void TimelineView::documentChanged(bool painting, bool selection, bool reset)
{
    if (reset) {
        m_pointer.forget();
        m_shown.fit();
    }
    m_stale = m_stale || painting || reset;
    m_looksStale = m_looksStale || selection || reset || m_pointer.isRetiming();
    if (!isVisible() || !(painting || selection || reset))
        return;
    if (m_pointer.isBusy() || reset)
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
    const auto seen = [this] { return std::tuple(m_shown.from(), m_shown.scale(), verticalScrollBar()->value()); };
    const auto before = seen();
    bool differs = std::exchange(m_looksStale, false);
    // While bars are dragged the lanes stay, and what is dragged is painted over them.
    if (m_stale && !m_pointer.isRetiming()) {
        differs = m_bars.setPainting(m_editor.unsettled().painting()) || differs;
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
    const TimelineAxes axes = this->axes();
    if (const std::optional<TimelineBar> draft = draftBar(m_bars, m_editor.unsettled()))
        now = QRectF(QPointF(axes.xOf(draft->begin), axes.laneTop(draft->lane)),
                     QPointF(axes.xOf(draft->end), axes.laneTop(draft->lane + 1)))
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
    return m_shown.spanOf(m_bars.span(), m_editor.clock().shown());
}

void TimelineView::updateScrollBars()
{
    const TimeSpan span = shownSpan();
    const int width = viewport()->width();
    m_shown.follow(span, width);
    const double before = m_shown.pixelsBefore(span);
    m_scrolling = true;
    horizontalScrollBar()->setRange(0, int(m_shown.pixelsBeyond(span, width)));
    horizontalScrollBar()->setPageStep(width);
    horizontalScrollBar()->setSingleStep(40);
    horizontalScrollBar()->setValue(int(std::lround(before)));
    const TimelineAxes axes = this->axes();
    const int rows = int(axes.laneTop(m_bars.laneCount()) - axes.laneTop(0)) + 8;
    verticalScrollBar()->setRange(0, std::max(0, rows - (viewport()->height() - rulerHeight())));
    verticalScrollBar()->setPageStep(viewport()->height() - rulerHeight());
    verticalScrollBar()->setSingleStep(int(axes.laneTop(1) - axes.laneTop(0)));
    m_scrolling = false;
}

/// Bars that were dragged may have another lane, since there was no room in theirs.
void TimelineView::revealSelected()
{
    const std::set<StrokeId> &selected = m_editor.document().selection().strokes;
    const TimelineAxes axes = this->axes();
    std::optional<int> hidden;
    for (std::size_t i = 0; i < m_bars.size(); ++i) {
        if (!selected.contains(m_bars[i].stroke))
            continue;
        const int lane = m_bars[i].lane;
        if (axes.laneTop(lane) >= axes.rulerHeight && axes.laneTop(lane + 1) <= viewport()->height())
            return;
        hidden = std::min(lane, hidden.value_or(lane));
    }
    if (!hidden)
        return;
    const double above = axes.rulerHeight - axes.laneTop(*hidden),
                 below = axes.laneTop(*hidden + 1) + 4 - viewport()->height();
    verticalScrollBar()->setValue(axes.scrolled + int(std::ceil(below > 0 ? below : -above)));
}

void TimelineView::scrollContentsBy(int dx, int)
{
    if (m_scrolling)
        return;
    if (dx != 0)
        m_shown.scrollTo(horizontalScrollBar()->value(), shownSpan());
    viewport()->update();
}

void TimelineView::pan(QPointF by)
{
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() - int(by.x()));
    verticalScrollBar()->setValue(verticalScrollBar()->value() - int(by.y()));
}

void TimelineView::fit()
{
    m_shown.fit();
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
    m_shown.zoomAt(x, factor, shownSpan(), viewport()->width());
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
        QToolTip::showText(help.globalPos(), m_pointer.isBusy() ? QString() : m_pointer.toolTipAt(help.pos(), axes()),
                           viewport());
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
        if (m_shown.isFitted() && time > m_bars.span().end) {
            m_shown.makeRoomAfter(time, span);
            viewport()->update();
        }
        updateScrollBars();
    }
    // When playing leaves the view, the view goes a page on.
    const double x = xOf(time);
    if (m_playback.isPlaying() && !m_shown.isFitted() && (x < 0 || x > viewport()->width())) {
        m_shown.turnPageTo(time);
        updateScrollBars();
        viewport()->update();
    }
    const auto strip = [this](Microseconds t) {
        const double at = std::clamp(xOf(t), -100.0, viewport()->width() + 100.0);
        return QRect(int(at) - 8, 0, 17, viewport()->height());
    };
    for (const Microseconds head : {std::exchange(m_head, time), time}) {
        viewport()->update(strip(head));
        viewport()->update(TimelinePicture::headArea(axes(), head, viewport()->width()));
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
    case Qt::Key_Delete:
        if (m_pointer.isBusy()) {
            m_pointer.giveUp();
            break;
        }
        [[fallthrough]];
    default:
        QAbstractScrollArea::keyPressEvent(event);
    }
}

bool TimelineView::event(QEvent *event)
{
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut)
        viewport()->update();
    if (event->type() != QEvent::ShortcutOverride)
        return QAbstractScrollArea::event(event);
    auto *key = static_cast<QKeyEvent *>(event);
    if (m_pointer.isBusy() && key->key() != Qt::Key_Escape && givesUpDrag(*key)) {
        m_pointer.giveUp();
        key->accept();
    }
    // Some of these keys are also keys of the canvas' commands.
    constexpr int own[] = {Qt::Key_Left, Qt::Key_Right, Qt::Key_Home,  Qt::Key_End, Qt::Key_Space,
                           Qt::Key_Plus, Qt::Key_Minus, Qt::Key_Equal, Qt::Key_0};
    const bool plain = !(key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier));
    const bool giveUpKey = key->key() == Qt::Key_Escape && m_pointer.isBusy();
    if (giveUpKey || (plain && std::ranges::find(own, key->key()) != std::end(own)))
        key->accept();
    return key->isAccepted() || QAbstractScrollArea::event(event);
}

QRectF TimelineView::drawnRect(StrokeId id)
{
    catchUp();
    const TimelineAxes axes = this->axes();
    for (std::size_t i = 0; i < m_bars.size(); ++i)
        if (const TimelineBar &bar = m_bars[i]; bar.stroke == id)
            return {QPointF(axes.xOf(bar.begin), axes.laneTop(bar.lane)),
                    QPointF(axes.xOf(bar.drawn), axes.laneTop(bar.lane) + TimelineAxes::laneHeight)};
    return {};
}

void TimelineView::paintEvent(QPaintEvent *event)
{
    QPainter painter(viewport());
    const TimelinePicture picture(*viewport(), m_editor.unsettled(), m_editor.clock(), m_bars, axes());
    picture.paint(painter, event->rect(), m_pointer.retimed(), m_pointer.band());
    if (hasFocus()) {
        constexpr int width = 2;
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(focusFrame(), width, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
        painter.drawRect(viewport()->rect().adjusted(width / 2, width / 2, -width / 2, -width / 2));
    }
}

void TimelineView::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton && !m_pointer.isBusy())
        catchUp();
    m_pointer.press(*event, axes());
}

void TimelineView::mouseMoveEvent(QMouseEvent *event)
{
    m_pointer.move(*event, axes());
}

void TimelineView::mouseReleaseEvent(QMouseEvent *event)
{
    if (m_pointer.release(*event))
        m_pointer.hover(event->position(), axes());
}

void TimelineView::mouseDoubleClickEvent(QMouseEvent *event)
{
    catchUp();
    m_pointer.doubleClick(*event, axes());
}

void TimelineView::contextMenuEvent(QContextMenuEvent *event)
{
    if (m_pointer.isBusy())
        return;
    catchUp();
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    const bool onBar =
        byKey ? !m_editor.document().selection().isEmpty() : m_pointer.selectForMenu(event->pos(), axes());
    emit menuWanted(event->globalPos(), onBar);
}

} // namespace suffuse

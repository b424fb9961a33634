#pragma once

#include "app/panels/timeline/shown_time.h"
#include "app/panels/timeline/timeline_pointer.h"

#include <QAbstractScrollArea>
#include <QTimer>

#include <optional>

class QGestureEvent;

namespace suffuse {

class Editor;
class Playback;

/// The painting in time: a ruler with the playhead, and a bar per stroke that can be selected, moved and stretched.
class TimelineView : public QAbstractScrollArea {
    Q_OBJECT

public:
    TimelineView(Editor &editor, Playback &playback, QWidget *parent = nullptr);

    /// Shows all of the time; stays so when the painting grows.
    void fit();
    void zoomBy(double factor);
    /// Pixels of the viewport, and back.
    double xOf(Microseconds time) const { return axes().xOf(time); }
    Microseconds timeAt(double x) const { return axes().timeAt(x); }
    /// Where a stroke's bar is in the viewport; its drawn part alone.
    QRectF drawnRect(StrokeId stroke);
    int rulerHeight() const;

    QSize sizeHint() const override { return {640, 150}; }

signals:
    /// What is being dragged, in words; empty: nothing.
    void dragged(const QString &what);
    /// The menu of what is selected; of the timeline itself where `onBar` is false.
    void menuWanted(QPoint globalPosition, bool onBar);

protected:
    bool viewportEvent(QEvent *event) override;
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void scrollContentsBy(int dx, int dy) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    TimelineAxes axes() const;
    void refresh();
    /// Brings the bars up to date now, where they wait for a pause.
    void catchUp();
    void documentChanged(bool painting, bool selection, bool reset);
    void draftChanged();
    void timeChanged();
    void updateScrollBars();
    void updateDraft();
    void zoomAt(double x, double factor);
    void pinch(QGestureEvent &event);
    TimeSpan shownSpan() const;
    void pan(QPointF by);

    Editor &m_editor;
    Playback &m_playback;
    TimelineBars m_bars;
    TimelinePointer m_pointer;
    bool m_stale = true;
    bool m_looksStale = true; ///< the selection is another one, or what is dragged
    QTimer m_later;           ///< edits that follow each other fast are followed now and then: frames go first
    ShownTime m_shown;
    bool m_scrolling = false; ///< the scroll bars are being set
    Microseconds m_head = 0;  ///< where the playhead is painted
    bool m_draftStale = false;
    QRect m_draftRect; ///< where the stroke in hand is painted
};

} // namespace suffuse

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

/// Shows the painting in time: a ruler with the playhead, and for each stroke a bar that can be selected, moved and
/// stretched.
class TimelineView : public QAbstractScrollArea {
    Q_OBJECT

public:
    TimelineView(Editor &editor, Playback &playback, QWidget *parent = nullptr);

    /// Shows all of the time, also when the painting grows.
    void fit();
    /// Zooms in by a factor around the playhead or the middle.
    void zoomBy(double factor);
    /// The place of a moment in pixels of the viewport, and the moment at a place.
    double xOf(Microseconds time) const { return axes().xOf(time); }
    Microseconds timeAt(double x) const { return axes().timeAt(x); }
    /// The rectangle of a stroke's bar in the viewport: the part in which it was drawn.
    QRectF drawnRect(StrokeId stroke);
    int rulerHeight() const;

    QSize sizeHint() const override { return {640, 150}; }

signals:
    /// What is being dragged, in words; empty if nothing is.
    void dragged(const QString &what);
    /// A menu is wanted: that of the selection or, where `onBar` is false, of the Timeline itself.
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
    /// Brings the bars up to date now, if they wait for a pause.
    void catchUp();
    void documentChanged(bool painting, bool selection, bool reset);
    void draftChanged();
    void timeChanged();
    void updateScrollBars();
    void revealSelected();
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
    bool m_looksStale = true; ///< whether the selection, or what is dragged, has changed since the last painting
    /// Edits that follow each other fast are followed only now and then, so that frames come first.
    QTimer m_later;
    ShownTime m_shown;
    bool m_scrolling = false; ///< whether the scroll bars are being set
    Microseconds m_head = 0;  ///< the moment at which the playhead is painted
    bool m_draftStale = false;
    QRect m_draftRect; ///< the rectangle in which the stroke in hand is painted
};

} // namespace suffuse

#pragma once

#include "app/panels/timeline/timeline_bars.h"
#include "model/painting/selection.h"
#include "undo/edit_command.h"

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
    double xOf(Microseconds time) const { return double(time - m_from) / m_scale; }
    Microseconds timeAt(double x) const { return m_from + Microseconds(std::llround(x * m_scale)); }
    /// Where a stroke's bar is in the viewport; its drawn part alone.
    QRectF drawnRect(StrokeId stroke);
    int rulerHeight() const;
    /// Where a label of this width begins: right of its tick, or where it leaves the view or the playhead's head would
    /// cover it, left of it, or beside the playhead. Logical pixels.
    static double labelLeft(double tick, double width, double head, double view);

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
    enum class Part { None, Ruler, Body, Begin, End };
    enum class Drag { None, Scrub, Press, Band, Shift, StretchBegin, StretchEnd, EaseBegin, EaseEnd, Pan };
    /// What is under the pointer.
    struct Hit {
        Part part = Part::None;
        std::size_t bar = 0;
    };

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
    double laneTop(int lane) const;
    Hit hitAt(QPointF at) const;
    bool isRetimable(std::size_t bar) const;
    void updateCursor(QPointF at);
    QString toolTipAt(QPointF at) const;

    void selectPressed(const Hit &hit, Qt::KeyboardModifiers modifiers);
    void beginRetiming();
    void retimeTo(QPointF at);
    /// What the drag makes of the painting before, and what it is called.
    std::pair<Edit, QString> stretched(Microseconds by) const;
    std::pair<Edit, QString> easedBy(Microseconds by) const;
    QString retimingText() const;
    void endRetiming();
    void giveUp();
    void selectBand();

    void paintRuler(QPainter &painter, const QRect &area) const;
    /// Where labels of the ruler make way for a playhead.
    QRect headArea(Microseconds time) const;
    void paintLanes(QPainter &painter, const QRect &area) const;
    void paintBar(QPainter &painter, const TimelineBar &bar, const Stroke &stroke) const;
    /// The bar of the stroke in hand; none: nothing is painted at the moment.
    std::optional<TimelineBar> draftBar() const;
    void paintSelectedRuns(QPainter &painter, const Stroke &stroke, const QRectF &rect) const;
    void paintPlayhead(QPainter &painter) const;

    Editor &m_editor;
    Playback &m_playback;
    TimelineBars m_bars;
    bool m_stale = true;
    bool m_looksStale = true; ///< the selection is another one, or what is dragged
    QTimer m_later;           ///< edits that follow each other fast are followed now and then: frames go first
    bool m_fitted = true;
    bool m_scrolling = false; ///< the scroll bars are being set
    Microseconds m_from = 0;  ///< at the left edge
    double m_scale = 10'000;  ///< microseconds a pixel
    Microseconds m_head = 0;  ///< where the playhead is painted
    Microseconds m_room = 0;  ///< shown up to here, so that not every moment moves all bars
    bool m_draftStale = false;
    QRect m_draftRect; ///< where the stroke in hand is painted

    Drag m_drag = Drag::None;
    QPointF m_pressed, m_pointer;
    Qt::KeyboardModifiers m_pressedWith;
    Hit m_hit;
    Selection m_selectionBefore; ///< at the press
    PaintingPtr m_before;        ///< at the press of a drag that retimes
    TimeSpan m_drawnBefore;
    EditRun m_run = 0;
};

} // namespace suffuse

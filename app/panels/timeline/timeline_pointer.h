// The mouse on the Timeline: it moves the playhead, selects and retimes.
#pragma once

#include "app/panels/timeline/retiming.h"
#include "app/panels/timeline/timeline_axes.h"

#include <QObject>
#include <QPointF>

#include <optional>

class QMouseEvent;
class QWidget;

namespace suffuse {

class Playback;

/// Knows what the mouse holds from press to release, and what is below the pointer. While something is held, the bars
/// must stay those of the press.
class TimelinePointer : public QObject {
    Q_OBJECT

public:
    TimelinePointer(Editor &editor, Playback &playback, const TimelineBars &bars, QWidget &viewport)
        : m_editor(editor), m_playback(playback), m_bars(bars), m_viewport(viewport)
    {}

    bool isBusy() const { return m_drag != Drag::None; }
    bool isRetiming() const { return m_retiming.has_value(); }
    /// The strokes that are being retimed; null if none are.
    const std::set<StrokeId> *retimed() const { return m_retiming ? &m_retiming->strokes() : nullptr; }
    /// The rectangle that is drawn around strokes to select them; no value if there is none.
    std::optional<QRectF> band() const;

    void press(const QMouseEvent &event, const TimelineAxes &axes);
    void move(const QMouseEvent &event, const TimelineAxes &axes);
    /// Returns true if nothing is held any more.
    bool release(const QMouseEvent &event);
    /// To be called when the pointer moves over the bars and holds nothing.
    void hover(QPointF at, const TimelineAxes &axes);
    /// Selects the segment under the pointer. Elsewhere it acts like a press.
    void doubleClick(const QMouseEvent &event, const TimelineAxes &axes);
    /// Selects what is at a place where a menu is wanted. Returns false if there is no bar.
    bool selectForMenu(QPointF at, const TimelineAxes &axes);
    /// Gives the drag up, as if it had not begun.
    void giveUp();
    /// To be called when there is another painting. What is held is given up.
    void forget();

    /// What is below the pointer, in words.
    QString toolTipAt(QPointF at, const TimelineAxes &axes) const;

signals:
    /// What is being dragged, in words; empty if nothing is.
    void dragged(const QString &what);
    /// The view is to be scrolled by so many logical pixels.
    void panned(QPointF by);
    /// Retiming is over, so lanes may change.
    void retimingEnded(bool isKept);

private:
    enum class Part { None, Ruler, Body, Begin, End };
    enum class Drag { None, Scrub, Press, Band, Retime, Pan };
    /// What is under the pointer.
    struct Hit {
        Part part = Part::None;
        std::size_t bar = 0;
        bool isOnBar() const { return part != Part::None && part != Part::Ruler; }
    };

    Hit hitAt(QPointF at, const TimelineAxes &axes) const;
    void selectPressed(const Hit &hit, Qt::KeyboardModifiers modifiers);
    void selectBand(const TimelineAxes &axes);
    void scrubTo(double x, const TimelineAxes &axes);
    void beginRetiming(const TimelineAxes &axes);
    void retimeTo(QPointF at, const TimelineAxes &axes);
    void endRetiming(bool isKept);

    Editor &m_editor;
    Playback &m_playback;
    const TimelineBars &m_bars;
    QWidget &m_viewport;
    Drag m_drag = Drag::None;
    QPointF m_pressed, m_pointer;
    Qt::KeyboardModifiers m_pressedWith;
    Hit m_hit;
    Selection m_selectionBefore;   ///< the selection at the press
    Microseconds m_timeBefore = 0; ///< the moment that was looked at then
    std::optional<Retiming> m_retiming;
};

} // namespace suffuse

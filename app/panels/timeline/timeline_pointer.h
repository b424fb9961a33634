// The mouse on the timeline: the playhead, selecting, retiming.
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

/// What is held of the timeline from press to release, and what is below the pointer. The bars that it is called with
/// stay those of the press while something is held.
class TimelinePointer : public QObject {
    Q_OBJECT

public:
    TimelinePointer(Editor &editor, Playback &playback, const TimelineBars &bars, QWidget &viewport)
        : m_editor(editor), m_playback(playback), m_bars(bars), m_viewport(viewport)
    {}

    bool isBusy() const { return m_drag != Drag::None; }
    bool isRetiming() const { return m_retiming.has_value(); }
    /// Of a retiming; null: there is none.
    const std::set<StrokeId> *retimed() const { return m_retiming ? &m_retiming->strokes() : nullptr; }
    /// While a band is drawn around strokes.
    std::optional<QRectF> band() const;

    void press(const QMouseEvent &event, const TimelineAxes &axes);
    void move(const QMouseEvent &event, const TimelineAxes &axes);
    /// True if nothing is held any more.
    bool release(const QMouseEvent &event);
    /// The pointer goes over the bars, and holds nothing.
    void hover(QPointF at, const TimelineAxes &axes);
    /// Selects the segment under the pointer; elsewhere it is a press.
    void doubleClick(const QMouseEvent &event, const TimelineAxes &axes);
    /// A menu is wanted at a place: selects what is there. False if there is no bar.
    bool selectForMenu(QPointF at, const TimelineAxes &axes);
    /// As if the drag had not begun.
    void giveUp();
    /// Another painting is there: nothing is held any more, and what was is given up.
    void forget();

    /// What is below the pointer, in words.
    QString toolTipAt(QPointF at, const TimelineAxes &axes) const;

signals:
    /// What is being dragged, in words; empty: nothing.
    void dragged(const QString &what);
    /// The view is to be scrolled by so many pixels.
    void panned(QPointF by);
    /// Retiming is over: lanes may be other ones.
    void retimingEnded();

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
    void endRetiming();

    Editor &m_editor;
    Playback &m_playback;
    const TimelineBars &m_bars;
    QWidget &m_viewport;
    Drag m_drag = Drag::None;
    QPointF m_pressed, m_pointer;
    Qt::KeyboardModifiers m_pressedWith;
    Hit m_hit;
    Selection m_selectionBefore; ///< at the press
    std::optional<Retiming> m_retiming;
};

} // namespace suffuse

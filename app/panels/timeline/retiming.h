// A drag on the timeline that retimes what is selected.
#pragma once

#include "app/panels/timeline/timeline_bars.h"
#include "app/session/gesture.h"
#include "model/painting/selection.h"

#include <QCoreApplication>

namespace suffuse {

class Editor;

/// Moves the selected strokes in time, stretches what they were drawn in, or makes their begin or end slower: one undo
/// step, each state computed from the painting as it was before.
class Retiming {
    Q_DECLARE_TR_FUNCTIONS(Retiming)

public:
    enum class Kind { Shift, StretchBegin, StretchEnd, EaseBegin, EaseEnd };

    /// `held`: the bar that is dragged. None if all that is selected is locked.
    static std::optional<Retiming> begin(Editor &editor, Kind kind, const TimelineBar &held);

    /// So much from where the drag began. Returns what that makes of the strokes, in words.
    QString moveBy(Microseconds by);
    /// The strokes are where they were.
    void giveUp() { m_gesture.giveUp(); }
    /// They stay where they are: a step.
    void commit() { m_gesture.commit(); }
    const std::set<StrokeId> &strokes() const { return m_selection.strokes; }

private:
    Retiming(Editor &editor, Kind kind, const TimelineBar &held);
    std::pair<Edit, QString> shifted(Microseconds by) const;
    std::pair<Edit, QString> stretched(Microseconds by) const;
    std::pair<Edit, QString> eased(Microseconds by) const;
    bool eases() const { return m_kind == Kind::EaseBegin || m_kind == Kind::EaseEnd; }

    Kind m_kind;
    TimelineBar m_held;
    PaintingPtr m_before;
    Selection m_selection;
    TimeSpan m_drawn; ///< before
    Gesture m_gesture;
};

} // namespace suffuse

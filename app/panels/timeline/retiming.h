// A drag on the Timeline that changes when the selected strokes are painted.
#pragma once

#include "app/panels/timeline/timeline_bars.h"
#include "app/session/gesture.h"
#include "model/painting/selection.h"

#include <QCoreApplication>

namespace suffuse {

class Editor;

/// Moves the selected strokes in time, stretches the time in which they were drawn, or makes their begin or end slower.
/// The drag is one undo step, and each state of it is computed from the painting before the drag.
class Retiming {
    Q_DECLARE_TR_FUNCTIONS(Retiming)

public:
    enum class Kind { Shift, StretchBegin, StretchEnd, EaseBegin, EaseEnd };

    /// Begins a drag of the bar `held`. Returns nothing if all that is selected is locked.
    static std::optional<Retiming> begin(Editor &editor, Kind kind, const TimelineBar &held);

    /// Shows the strokes when the drag has gone so far from its begin. Returns in words what that makes of them.
    QString moveBy(Microseconds by);
    /// Gives the drag up: the strokes are where they were.
    void giveUp() { m_gesture.giveUp(); }
    /// Ends the drag, and makes a step of it.
    void commit() { m_gesture.commit(); }
    const std::set<StrokeId> &strokes() const { return m_selection.strokes; }

private:
    Retiming(Editor &editor, Kind kind, const TimelineBar &held);
    std::pair<Edit, QString> shifted(Microseconds by) const;
    std::pair<Edit, QString> stretched(Microseconds by) const;
    std::pair<Edit, QString> eased(Microseconds by) const;
    QString withErasures(const QString &words) const;
    bool eases() const { return m_kind == Kind::EaseBegin || m_kind == Kind::EaseEnd; }

    Kind m_kind;
    TimelineBar m_held;
    PaintingPtr m_before;
    Selection m_selection;
    TimeSpan m_drawn;             ///< the time in which the strokes were drawn, before the drag
    bool m_movesErasures = false; ///< what takes paint away goes along when the selection moves
    bool m_hasErasures = false;   ///< paint is selected, and something takes some of it away
    Gesture m_gesture;
};

} // namespace suffuse

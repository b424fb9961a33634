// Which strokes the eraser may touch, and why it leaves others alone.
#pragma once

#include "model/document/document.h"

namespace suffuse {

/// Where nothing is selected, `Selected` is all strokes. The group is that in which selected strokes stand, or else the
/// stroke under the pointer; what stands in no group counts as one.
enum class EraserScope { Selected, Group, All };

/// What keeps the eraser off a stroke.
enum class Spared { Nothing, Locked, NotSelected, OtherGroup };

/// Tells for a press at a point which strokes the eraser may touch.
class EraserReach {
public:
    EraserReach() = default;
    /// `tolerance`: canvas units around the point in which hairlines are found.
    EraserReach(const Document &document, Microseconds T, EraserScope scope, Point point, double tolerance);

    /// Of a visible stroke that is begun.
    Spared spares(const Painting &painting, const Stroke &stroke) const;
    /// The visible strokes that are begun by T and that it does not spare.
    std::vector<StrokePtr> strokesOf(const Painting &painting, Microseconds T) const;

private:
    EraserScope m_scope = EraserScope::All;
    std::set<StrokeId> m_selected; ///< of Selected
    std::set<GroupId> m_groups;    ///< of Group; 0: what stands in none
};

/// All visible strokes that are begun by T.
std::vector<StrokePtr> visibleStrokes(const Painting &painting, Microseconds T);

} // namespace suffuse

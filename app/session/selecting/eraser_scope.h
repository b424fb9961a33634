// Which strokes the eraser may touch, and why it leaves others alone.
#pragma once

#include "model/document/document.h"
#include "model/painting/editable.h"

namespace suffuse {

class CurrentLayer;

/// Where nothing is selected, `Selected` is all strokes. The group is that in which selected strokes stand, or else the
/// current layer or, where there is none, the group of the stroke under the pointer; what stands in no group counts as
/// one.
enum class EraserScope { Selected, Group, All };

/// What keeps the eraser off a stroke.
enum class Spared { Nothing, OtherLayer, Locked, NotSelected, OtherGroup };

/// Tells for a press at a point which strokes the eraser may touch.
class EraserReach {
public:
    EraserReach() = default;
    /// `layer` is the current one, and knows what tools reach. `tolerance`: canvas units around the point in which
    /// hairlines are found.
    EraserReach(const Document &document, const CurrentLayer &layer, Microseconds T, EraserScope scope, Point point,
                double tolerance);

    /// Of a visible stroke that is begun.
    Spared spares(const Stroke &stroke) const;
    /// The visible strokes that are begun by T and that it does not spare.
    std::vector<StrokePtr> strokesOf(const Painting &painting, Microseconds T) const;

private:
    EraserScope m_scope = EraserScope::All;
    Locks m_isLocked; ///< No group changes while it is erased.
    bool m_isOnly = false;
    std::unordered_set<GroupId> m_layer;  ///< all that is reached, where that is a layer only
    std::set<StrokeId> m_selected;        ///< of Selected
    std::unordered_set<GroupId> m_groups; ///< of Group, with those within them; 0: what stands in none
};

/// All visible strokes that are begun by T.
std::vector<StrokePtr> visibleStrokes(const Painting &painting, Microseconds T);

} // namespace suffuse

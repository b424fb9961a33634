// Which layer was painted on, for undo and redo.
#pragma once

#include "undo/layers/painted_layer.h"

#include <map>
#include <optional>
#include <utility>

namespace suffuse {

/// Remembers of undo steps, by their numbers, which layer there was before and after them.
class LayerSteps {
public:
    /// A step was done; the ones that could be redone in its place are gone.
    void add(int step, const PaintedLayer &before, const PaintedLayer &after);
    /// The layer became another one by the step itself, which was known for none or for this one.
    void note(int step, const PaintedLayer &before, const PaintedLayer &after);
    /// The layer before a step, if it made another one of it.
    const PaintedLayer *before(int step) const;
    /// The layer when steps have been undone or redone: `from` and `to` tell how many are done. Where another layer was
    /// chosen since a step, that stays. Nothing, if the layer is the same one.
    std::optional<PaintedLayer> walked(const PaintedLayer &layer, int from, int to) const;
    /// The layer that there was when the painting came to be as it is after such a walk; nothing, if it is not known.
    std::optional<GroupId> known(int from, int to) const;
    void clear() { m_steps.clear(), m_known.clear(); }

private:
    struct Step {
        PaintedLayer before, after;
    };
    std::map<int, Step> m_steps; ///< those that made another one of the layer
    std::map<int, std::pair<GroupId, GroupId>> m_known;
};

} // namespace suffuse

// The strokes of a wash are drawn as one (docs/solver.md, "Washes").
#pragma once

#include "model/painting/painting.h"

#include <unordered_map>
#include <vector>

namespace suffuse {

/// Makes one stroke of the strokes of each wash. What is made stays the same object as long as the strokes do, so that
/// snapshots can be compared.
class Washes {
public:
    /// The painting as it is drawn. In place of a wash's visible strokes it has one, in the order where the first of them
    /// was; groups within the wash are not put by themselves. Filled strokes are drawn each by itself, with the wash's
    /// style and mixing. Masks within the wash are no part of it. A painting without a wash is returned as it is.
    PaintingPtr drawn(const PaintingPtr &painting);

private:
    struct United {
        Wash wash;
        std::vector<StrokePtr> members;
        StrokePtr stroke;
    };
    /// One stroke of these; that of the last call, if they are the same.
    const StrokePtr &unite(std::unordered_map<StrokeId, United> &now, std::vector<StrokePtr> members, GroupId group,
                           const Wash &wash);

    std::unordered_map<StrokeId, United> m_united; ///< by the ids of their first strokes
};

} // namespace suffuse

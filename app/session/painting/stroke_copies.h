// The copies of a stroke that come with it where one paints in a symmetry.
#pragma once

#include "model/geometry/symmetry.h"
#include "model/painting/stroke.h"

namespace suffuse {

class Document;

/// The one place where a stroke that is painted becomes several. Each copy is a stroke as any other, with values and
/// times of its own, so that whatever is done with strokes is done with it.
class StrokeCopies {
public:
    /// Begins with a new stroke: it takes an id for each copy that the symmetry makes.
    void begin(Document &document, const Symmetry &symmetry);
    /// The next stroke comes alone.
    void clear();

    /// The copies of a stroke as it is now, without itself. One that cannot be (beyond all numbers) is left out, and so
    /// are all of a null one.
    std::vector<StrokePtr> of(const StrokePtr &stroke);
    /// The stroke and its copies.
    std::vector<StrokePtr> with(const StrokePtr &stroke);

private:
    struct Copy {
        StrokeId id = 0;
        Affine map;
        StrokePtr last; ///< of `m_last`; null: there was none
    };
    /// How many segments are still those of the stroke that was mapped last, and need not be mapped again: of a stroke
    /// that is being drawn only the tail changes.
    std::size_t unchanged(const Stroke &stroke) const;

    std::vector<Copy> m_copies;
    StrokePtr m_last; ///< the stroke that was mapped last
};

} // namespace suffuse

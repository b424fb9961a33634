// What the window "Along the Stroke" has made of strokes, and with which curves.
#pragma once

#include "app/panels/inspector/along/along_curve.h"

#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace suffuse {

using CurvesSet = std::map<Quantity, CurveAlong>;

/// The runs that the window is about, and the curves that are set along them. They make the strokes that it shows.
struct AlongState {
    std::shared_ptr<const StrokeRuns> runs;    ///< as they were before the curves; never null
    std::shared_ptr<const StrokeRuns> refined; ///< with shorter segments; null until a curve varies
    CurvesSet set;

    /// The runs that the curves belong on: those with shorter segments where something varies. It may make these.
    const StrokeRuns &runsToSet();
};

/// The states that the window has shown, for as long as a step or the document has their strokes. Undo and redo bring
/// back the very same strokes, so the window finds what it had set there, and how they were before it.
class AlongStates {
public:
    /// The state is what the painting shows.
    void note(const Painting &painting, const AlongState &state);
    /// The state that shows the painting's strokes with these runs selected; null: they are not of the window's making.
    const AlongState *find(const Painting &painting, const StrokeRuns &selected) const;
    /// The painting's strokes that are of the window's making, as they were when it came to them first.
    StrokeRuns starts(const Painting &painting) const;

private:
    using WeakStroke = std::weak_ptr<const Stroke>;
    struct Known {
        std::map<StrokeId, WeakStroke> strokes;
        AlongState state; ///< with the runs of which the segments are those of the strokes
    };

    std::vector<Known> m_known;
    /// Of each stroke that was shown, how it was before.
    std::map<WeakStroke, std::shared_ptr<const StrokeRun>, std::owner_less<>> m_starts;
};

} // namespace suffuse

// Finds the strokes under the pointer by their visible paint, not by the thin curve.
#pragma once

#include "model/paint/seen_paint.h"
#include "model/painting/editable.h"
#include "model/painting/selection.h"
#include "render/view.h"

#include <optional>
#include <vector>

namespace suffuse {

/// Which strokes of a painting can be selected at T: those that are visible, unlocked and begun.
class Selectable {
public:
    Selectable(const Painting &painting, Microseconds T) : m_isEditable(painting.groups), m_time(T) {}

    bool operator()(const Stroke &stroke) const { return stroke.born() <= m_time && m_isEditable(stroke); }

private:
    Editable m_isEditable;
    Microseconds m_time;
};

/// The topmost visible, unlocked stroke that paints at the point or, for hairlines, within `tolerance` canvas units of
/// it; `segment` is the one with the largest share of the density there.
std::optional<SegmentRef> pickTopmost(const Painting &painting, Microseconds T, Point point, double tolerance);

/// The stroke that people would say they have clicked: the topmost one, but a faint halo of it gives way to paint below
/// that is seen more.
std::optional<SegmentRef> pickSeen(const Painting &painting, Microseconds T, Point point, double tolerance);

/// The same for one stroke alone, whatever lies above it.
std::optional<SegmentRef> pickOn(const Painting &painting, StrokeId stroke, Microseconds T, Point point,
                                 double tolerance);

/// All visible, unlocked strokes that paint at the point, from top to bottom. Where no stroke paints there, those
/// within `tolerance`.
std::vector<SegmentRef> pickAll(const Painting &painting, Microseconds T, Point point, double tolerance);

/// The strokes that a click on one stroke selects: those of its outermost group that can be selected, or the stroke
/// alone. Where only what is in a group is reached, `outer`, the outermost one within that counts.
std::set<StrokeId> withGroup(const Painting &painting, StrokeId stroke, GroupId outer = 0);

/// The visible, unlocked strokes, begun by T, whose curves lie wholly within a rectangle of the view's pixels.
std::set<StrokeId> strokesWithin(const Painting &painting, Microseconds T, const View &view, const Rect &pixels);
/// The same within a closed polygon in canvas units (even-odd rule).
std::set<StrokeId> strokesWithin(const Painting &painting, Microseconds T, const std::vector<Point> &polygon);
/// Goes along a path and collects the visible, unlocked strokes, begun by T, that paint somewhere on it (or within
/// `tolerance` of it); canvas units. Each step looks only at strokes that are not touched yet.
class PathTouch {
public:
    PathTouch(PaintingPtr painting, Microseconds T, double tolerance, Point start);
    void goOn(Point to);
    const std::set<StrokeId> &touched() const { return m_touched; }

private:
    struct Candidate {
        StrokePtr stroke;
        Rect around; ///< the stroke paints nowhere outside of this
        bool hairline = false;
    };
    void touchAt(const std::vector<Point> &points);
    bool touches(const Candidate &candidate, Point p) const;

    PaintingPtr m_painting;
    Microseconds m_time;
    double m_tolerance;
    Point m_last;
    std::vector<Candidate> m_left;
    std::set<StrokeId> m_touched;
};
/// The segments of visible, unlocked strokes, begun by T, whose curves' middles lie within a rectangle of the view's
/// pixels.
std::set<SegmentRef> segmentsWithin(const Painting &painting, Microseconds T, const View &view, const Rect &pixels);
/// All strokes that can be selected at T.
std::set<StrokeId> selectableStrokes(const Painting &painting, Microseconds T);

} // namespace suffuse

// What lies under the pointer: by visible paint, not by a thin curve.
#pragma once

#include "model/painting/painting.h"
#include "model/painting/selection.h"
#include "render/view.h"

#include <optional>
#include <vector>

namespace suffuse {

/// A stroke whose opacity w at a point is less than this is not seen there.
inline constexpr double visibleOpacity = 0.02;

/// The topmost visible, unlocked stroke that paints at the point or, for hairlines, within `tolerance` canvas units of
/// it; `segment` is the one with the largest share of the density there.
std::optional<SegmentRef> pickTopmost(const Painting &painting, Microseconds T, Point point, double tolerance);

/// The same for one stroke alone, whatever lies above it.
std::optional<SegmentRef> pickOn(const Painting &painting, StrokeId stroke, Microseconds T, Point point,
                                 double tolerance);

/// All visible, unlocked strokes that paint at the point, from top to bottom; where none does, those within
/// `tolerance`.
std::vector<SegmentRef> pickAll(const Painting &painting, Microseconds T, Point point, double tolerance);

/// The strokes that a click on one means: those of its outermost group that can be selected, or itself alone.
std::set<StrokeId> withGroup(const Painting &painting, StrokeId stroke);

/// The visible, unlocked strokes, begun by T, whose curves lie wholly within a rectangle of the view's pixels.
std::set<StrokeId> strokesWithin(const Painting &painting, Microseconds T, const View &view, const Rect &pixels);
/// The same within a closed polygon, canvas units; even-odd.
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
        Rect around; ///< nothing of it is found outside
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
/// All visible, unlocked strokes that are begun by T.
std::set<StrokeId> selectableStrokes(const Painting &painting, Microseconds T);

} // namespace suffuse

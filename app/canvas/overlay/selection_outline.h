#pragma once

#include "app/canvas/overlay/overlay.h"
#include "app/canvas/overlay/thin_outline.h"
#include "app/session/selecting/stroke_boxes.h"

#include <QtGlobal>

#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

namespace suffuse {

/// Draws thin two-tone lines through the selected strokes, fainter where they lie close, so that the paint below is
/// seen. Selected segments stand out, and have dots at their nodes.
/// What was computed for a stroke in a view is kept.
/// Where there is more to draw than lines could show, lines are not smoothed. They are thinned out, are fainter the
/// denser they lie, and are kept as a picture; heavy lines through selected segments are a picture of their own. While
/// a few hundred segments move, their lines are not smoothed either. A few changing strokes among many are drawn apart,
/// over the picture of the others.
class SelectionOutline {
public:
    SelectionOutline() = default;
    Q_DISABLE_COPY_MOVE(SelectionOutline) // The thin lines refer to the member beside them.

    void paint(QPainter &painter, const View &view, const Painting &painting, const Selection &selection,
               const OverlayColours &colours, double dpr, bool moving = false);
    /// Whether the last picture was thinned out.
    bool isThin() const { return m_thin; }
    /// The box of the selected strokes' control points, canvas units.
    Rect boxOf(const Painting &painting, const Selection &selection);
    /// The box that `selectionBox` gives for the selection, canvas units.
    Rect curveBoxOf(const Painting &painting, const Selection &selection);

private:
    struct Line {
        StrokePtr stroke;
        std::set<int> chosen;     ///< the segments that are selected
        QPainterPath path;        ///< through the other segments
        QPainterPath segments;    ///< through the selected segments
        std::vector<Point> nodes; ///< the nodes of the selected segments, device pixels
        double weight = 1;        ///< a factor of the path's opacity
    };

    void locate(const Painting &painting, const Selection &selection);
    bool follow(const View &view, const Painting &painting, bool moving);
    bool followApart(const StrokeList &strokes, const std::vector<std::size_t> &changed);
    void gather(const View &view, const Painting &painting, double dpr);
    std::set<int> chosenOf(StrokeId id) const;
    const Line &lineOf(const OutlinedStroke &shown);
    void weigh(double dpr);
    void paintFine(QPainter &painter, const OverlayColours &colours, double dpr) const;

    StrokeBoxes m_boxes;
    Selection m_selection;             ///< the selection whose places are known
    std::vector<std::size_t> m_places; ///< the places of its strokes in the order
    bool m_weighed = false;            ///< whether the lines' weights are those of what is shown
    bool m_stale = true;               ///< whether other strokes are selected than were gathered

    StrokeList m_strokes; ///< the strokes of the painting that was shown
    OutlinedStrokes m_shown;
    ThinOutline m_thinLines{m_shown};
    std::unordered_map<StrokeId, Line> m_lines;
    std::size_t m_segments = 0; ///< the number of their segments
    bool m_thin = false;
};

} // namespace suffuse

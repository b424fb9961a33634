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

/// Thin two-tone lines through the selected strokes; selected segments stand out, with dots at their nodes. What was
/// computed for a stroke in a view is kept. Where there is more to draw than lines could show, they are not smoothed,
/// thinned out, the fainter the denser they lie, and kept as a picture; plain, too, of a few hundred segments while
/// they move. Selected segments stand out there as well: heavy lines in a picture of their own. A few strokes that change
/// among many are drawn apart, over the picture of the others.
class SelectionOutline {
public:
    SelectionOutline() = default;
    Q_DISABLE_COPY_MOVE(SelectionOutline) // the thin lines are those of the member beside them

    void paint(QPainter &painter, const View &view, const Painting &painting, const Selection &selection,
               const OverlayColours &colours, double dpr, bool moving = false);
    /// Whether the last picture was thinned out.
    bool isThin() const { return m_thin; }
    /// The box of the selected strokes' control points, canvas units.
    Rect boxOf(const Painting &painting, const Selection &selection);
    /// The same as `selectionBox`.
    Rect curveBoxOf(const Painting &painting, const Selection &selection);

private:
    struct Line {
        StrokePtr stroke;
        std::set<int> chosen;     ///< segments
        QPainterPath path;        ///< of the others
        QPainterPath segments;    ///< of the chosen ones
        std::vector<Point> nodes; ///< of these, device pixels
    };

    void locate(const Painting &painting, const Selection &selection);
    bool follow(const View &view, const Painting &painting, bool moving);
    bool followApart(const StrokeList &strokes, const std::vector<std::size_t> &changed);
    void gather(const View &view, const Painting &painting);
    std::set<int> chosenOf(StrokeId id) const;
    const Line &lineOf(const OutlinedStroke &shown);
    void paintFine(QPainter &painter, const OverlayColours &colours, double dpr) const;

    StrokeBoxes m_boxes;
    Selection m_selection;             ///< that was located
    std::vector<std::size_t> m_places; ///< of its strokes in the order
    bool m_stale = true;               ///< others are selected than were gathered

    StrokeList m_strokes; ///< of the painting that was shown
    OutlinedStrokes m_shown;
    ThinOutline m_thinLines{m_shown};
    std::unordered_map<StrokeId, Line> m_lines;
    std::size_t m_segments = 0; ///< of these
    bool m_thin = false;
};

} // namespace suffuse

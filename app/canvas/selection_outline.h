#pragma once

#include "app/canvas/overlay.h"
#include "app/canvas/pixel_mask.h"
#include "app/canvas/stroke_boxes.h"

#include <unordered_map>

namespace suffuse {

/// Thin two-tone lines through the selected strokes; selected segments stand out, with dots at their nodes. What was
/// computed for a stroke in a view is kept. Where there is more to draw than lines could show, they are plain, thinned
/// out and kept as a picture; plain, too, of a few hundred segments while they move. A few strokes that change among
/// many are drawn apart, over the picture of the others.
class SelectionOutline {
public:
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

    /// A selected stroke in the view.
    struct Shown {
        std::size_t place = 0; ///< in the order
        StrokePtr stroke;
        std::set<int> chosen; ///< segments
        bool apart = false;   ///< it is in no picture
    };

    void locate(const Painting &painting, const Selection &selection);
    bool follow(const View &view, const Painting &painting, bool moving);
    bool followApart(const StrokeList &strokes, const std::vector<std::size_t> &changed);
    void gather(const View &view, const Painting &painting);
    std::set<int> chosenOf(StrokeId id) const;
    const Line &lineOf(const Shown &shown);
    void paintFine(QPainter &painter, const OverlayColours &colours, double dpr) const;
    void paintQuick(QPainter &painter, const View &view, const QColor &colour, double dpr, bool apart) const;
    double lengthOfLines() const;
    void drawThin(double dpr, bool moving);
    void paintThin(QPainter &painter, const View &view, double dpr, const QColor &colour, bool moving);

    StrokeBoxes m_boxes;
    Selection m_selection;             ///< that was located
    std::vector<std::size_t> m_places; ///< of its strokes in the order
    bool m_stale = true;               ///< others are selected than were gathered

    View m_view;
    StrokeList m_strokes;       ///< of the painting that was shown
    std::vector<Shown> m_shown; ///< bottom to top
    Rect m_shownBox;            ///< of their control points, canvas units
    std::unordered_map<StrokeId, Line> m_lines;
    std::size_t m_segments = 0; ///< of these
    bool m_thin = false;
    PixelMask m_mask; ///< of thin lines, larger than the view, with the same middle; kept, since a new one is slow
    QRect m_inked;    ///< where lines may be
    bool m_drawn = false;
    bool m_rough = false; ///< drawn with fewer lines, since they moved
};

} // namespace suffuse

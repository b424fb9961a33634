#pragma once

#include "app/canvas/overlay.h"
#include "app/canvas/pixel_mask.h"
#include "app/session/selecting/stroke_boxes.h"

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

    /// Pixels of thin lines around the view, so that it can be moved without drawing them anew.
    static constexpr int thinMargin = 160;
    /// By how many pixels a picture of one view lies off in another that differs from it in its centre alone, if it does.
    static std::optional<Point> shiftBetween(const View &from, const View &to);

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
    void weigh();
    void paintChosen(QPainter &painter, const QColor &colour, double dpr, Point shift);
    View thinView() const;
    QRect inkedBy(const Rect &box) const;
    void mendThin(const std::vector<Shown> &before);
    static std::vector<const Stroke *> differingStrokes(const std::vector<Shown> &before,
                                                        const std::vector<Shown> &after);
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
    bool m_rough = false; ///< drawn with fewer lines, or in parts, since they moved
    double m_spacing = 0; ///< pixels between the points of its lines
    double m_weight = 1;  ///< of its lines' opacity
    PixelMask m_chosenMask; ///< the same of the chosen segments, in any mode but the fine one
    bool m_chosenDrawn = false;
};

} // namespace suffuse

#pragma once

#include "app/canvas/overlay.h"

#include <QImage>

#include <unordered_map>

namespace suffuse {

/// Thin two-tone lines through the selected strokes; selected segments stand out, with dots at their nodes. What was
/// computed for a stroke in a view is kept. Where there is more to draw than lines could show, they are plain, thinned
/// out and kept as a picture; plain, too, of a few hundred segments while they move.
class SelectionOutline {
public:
    void paint(QPainter &painter, const View &view, const Painting &painting, const Selection &selection,
               const OverlayColours &colours, double dpr, bool moving = false);
    /// Whether the last picture was thinned out.
    bool isThin() const { return m_thin; }

private:
    struct Line {
        StrokePtr stroke;
        std::set<int> chosen;     ///< segments
        QPainterPath path;        ///< of the others
        QPainterPath segments;    ///< of the chosen ones
        std::vector<Point> nodes; ///< of these, device pixels
    };

    bool isUnchanged(const View &view, const Painting &painting, const Selection &selection) const;
    void gather(const View &view, const Painting &painting, const Selection &selection);
    const Line &lineOf(const StrokePtr &stroke, std::set<int> chosen);
    void paintFine(QPainter &painter, const OverlayColours &colours, double dpr) const;
    void paintQuick(QPainter &painter, const QColor &colour, double dpr) const;
    void drawThin(const QColor &colour, double dpr, bool moving);
    void paintThin(QPainter &painter, const View &view, double dpr, const QColor &colour, bool moving);

    View m_view;
    StrokeList m_strokes; ///< of the painting that was shown
    Selection m_selection;
    std::vector<std::pair<StrokePtr, std::set<int>>> m_shown; ///< selected strokes in the view, with chosen segments
    std::unordered_map<StrokeId, Line> m_lines;
    std::size_t m_segments = 0; ///< of these
    bool m_thin = false;
    QColor m_thinColour;
    QImage m_picture; ///< of thin lines, larger than the view, with the same middle
    bool m_drawn = false;
    bool m_rough = false; ///< drawn with fewer lines, since they moved
};

} // namespace suffuse

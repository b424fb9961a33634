// The picture of thin lines through many strokes, and through selected segments among them.
#pragma once

#include "app/canvas/overlay/pixel_mask.h"
#include "app/session/selecting/stroke_boxes.h"
#include "render/view.h"

#include <QColor>
#include <QRect>

#include <optional>
#include <set>
#include <vector>

class QPainter;

namespace suffuse {

/// A selected stroke in the view.
struct OutlinedStroke {
    std::size_t place = 0; ///< in the order
    StrokePtr stroke;
    std::set<int> chosen; ///< segments
    bool apart = false;   ///< it is in no picture
};

/// What there is to outline in a view.
struct OutlinedStrokes {
    View view;
    std::vector<OutlinedStroke> strokes; ///< bottom to top
    Rect box;                            ///< of their control points, canvas units
    bool anyChosen = false;              ///< segments are selected, be they in the view or not
};

/// By how many pixels a picture of one view lies off in another that differs from it in its centre alone, if it does.
std::optional<Point> shiftBetween(const View &from, const View &to);

/// Lines of one pixel through the strokes that are apart, or those that are not, drawn where they are now.
void paintQuickLines(QPainter &painter, const View &view, const std::vector<OutlinedStroke> &strokes, bool apart,
                     const QColor &colour, double dpr);

/// Keeps a picture of lines that are not smoothed, thinned out, the fainter the denser they lie; heavy lines through
/// selected segments are a picture of their own.
class ThinOutline {
public:
    /// Pixels of thin lines around the view, so that it can be moved without drawing them anew.
    static constexpr int margin = 160;

    explicit ThinOutline(const OutlinedStrokes &of) : m_of(of) {}

    bool isDrawn() const { return m_drawn; }
    /// The lines, or those through selected segments, are to be drawn anew.
    void forgetLines() { m_drawn = false; }
    void forgetChosen() { m_chosenDrawn = false; }
    /// Draws thin lines anew where what was shown before and what is shown now differ, if that is by few strokes.
    void mend(const std::vector<OutlinedStroke> &before, const StrokeBoxes &boxes);

    void paint(QPainter &painter, const View &view, double dpr, const QColor &colour, bool moving);
    /// Over all the others, where these are no fine lines; `shift`: of the view since strokes were gathered.
    void paintChosen(QPainter &painter, const QColor &colour, double dpr, Point shift);

private:
    double lengthOfLines() const;
    void draw(double dpr, bool moving);
    void weigh();
    View around() const;
    QRect inkedBy(const Rect &box) const;

    const OutlinedStrokes &m_of;
    PixelMask m_mask; ///< of thin lines, larger than the view, with the same middle; kept, since a new one is slow
    QRect m_inked;    ///< where lines may be
    bool m_drawn = false;
    bool m_rough = false;   ///< drawn with fewer lines, or in parts, since they moved
    double m_spacing = 0;   ///< pixels between the points of its lines
    double m_weight = 1;    ///< of its lines' opacity
    PixelMask m_chosenMask; ///< the same of the chosen segments, in any mode but the fine one
    bool m_chosenDrawn = false;
};

} // namespace suffuse

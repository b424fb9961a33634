// A picture of thin lines through many strokes, and of heavy ones through selected segments among them.
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

/// A selected stroke that the view shows.
struct OutlinedStroke {
    std::size_t place = 0; ///< its place in the order
    StrokePtr stroke;
    std::set<int> chosen; ///< the segments that are selected
    bool apart = false;   ///< whether it is drawn apart, and is in no picture
};

/// What a view shows that is to be outlined.
struct OutlinedStrokes {
    View view;
    std::vector<OutlinedStroke> strokes; ///< bottom to top
    Rect box;                            ///< around their control points, canvas units
    bool anyChosen = false;              ///< whether segments are selected, in the view or beside it
};

/// How far the picture of one view lies off in another one, in pixels. It has no value where the views differ in more
/// than their centres.
std::optional<Point> shiftBetween(const View &from, const View &to);

/// Draws lines of one pixel where strokes are now, through either those that are drawn apart or the others.
void paintQuickLines(QPainter &painter, const View &view, const std::vector<OutlinedStroke> &strokes, bool apart,
                     const QColor &colour, double dpr);

/// Keeps a picture of lines that are not smoothed. They are thinned out, and are fainter the denser they lie. Heavy
/// lines through selected segments are a picture of their own.
class ThinOutline {
public:
    /// Thin lines are drawn so many pixels beyond the view, so that it can be moved without drawing them anew.
    static constexpr int margin = 160;

    explicit ThinOutline(const OutlinedStrokes &of) : m_of(of) {}

    bool isDrawn() const { return m_drawn; }
    /// Has the lines, or the heavy ones through selected segments, drawn anew.
    void forgetLines() { m_drawn = false; }
    void forgetChosen() { m_chosenDrawn = false; }
    /// Draws thin lines anew where what was shown before and what is shown now differ, if few strokes do.
    void mend(const std::vector<OutlinedStroke> &before, const StrokeBoxes &boxes);

    void paint(QPainter &painter, const View &view, double dpr, const QColor &colour, bool moving);
    /// Paints the selected segments over all lines, where these are not smooth. `shift` is how far the view has moved
    /// since strokes were gathered.
    void paintChosen(QPainter &painter, const QColor &colour, double dpr, Point shift);

private:
    double lengthOfLines() const;
    void draw(double dpr, bool moving);
    void weigh();
    View around() const;
    QRect inkedBy(const Rect &box) const;

    const OutlinedStrokes &m_of;
    /// The mask of thin lines is larger than the view and has the same centre. It is kept, since making a new one takes
    /// long.
    PixelMask m_mask;
    QRect m_inked;    ///< where in the mask there may be lines
    bool m_drawn = false;
    bool m_rough = false;   ///< whether it was drawn with fewer lines, or only in parts, since the strokes moved
    double m_spacing = 0;   ///< pixels between the points of its lines
    double m_weight = 1;    ///< a factor of its lines' opacity
    PixelMask m_chosenMask; ///< the mask of the selected segments, wherever lines are not smooth
    bool m_chosenDrawn = false;
};

} // namespace suffuse

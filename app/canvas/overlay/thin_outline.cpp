#include "app/canvas/overlay/thin_outline.h"

#include "app/canvas/overlay/thin_lines.h"
#include "model/shaping/transform.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

/// A thin picture has about so many lines at most, and at least one for each stroke.
constexpr double thinLines = 20'000, movingLines = 7'000;
/// The opacity of lines that lie apart and of their rims, and the factor to which both fall where lines would hide the
/// picture.
constexpr double thinOpacity = 0.85, rimOpacity = 0.6, leastWeight = 0.3;
/// Lines become fainter where they fill a larger share than this of the pixels of their box.
constexpr double denseLines = 0.06;
/// A factor of the opacity of strokes where segments are selected, so that these stand out.
constexpr double quietWeight = 0.6;
constexpr double chosenRim = 0.75;
constexpr double leastSpacing = 5; ///< logical pixels between the points of a thin line
/// Up to so many strokes that are new, gone or changed are drawn anew without the rest of a thin picture.
constexpr std::size_t mendedStrokes = 256;

/// The box of the view's pixels that a box of the canvas takes.
Rect pixelBox(const View &view, const Rect &box)
{
    Rect pixels;
    for (const Point corner : {Point{box.left, box.top}, Point{box.right, box.top}, Point{box.right, box.bottom},
                               Point{box.left, box.bottom}})
        pixels.include(view.toPixels(corner));
    return pixels;
}

/// The strokes of either list that are not in the other one, bottom to top; where the lists have little in common,
/// others as well. A stroke that is drawn apart in the first list counts as different.
std::vector<const Stroke *> differingStrokes(const std::vector<OutlinedStroke> &before,
                                             const std::vector<OutlinedStroke> &after)
{
    constexpr std::size_t near = 8; // how many places ahead are compared
    std::vector<const Stroke *> differing;
    std::size_t i = 0;
    const auto goes = [&] { differing.push_back(before[i++].stroke.get()); };
    for (const OutlinedStroke &shown : after) {
        std::size_t known = i;
        while (known < std::min(i + near, before.size()) && before[known].stroke != shown.stroke)
            ++known;
        if (known < std::min(i + near, before.size())) {
            while (i < known)
                goes();
            if (before[i].apart)
                goes();
            else
                ++i;
        } else {
            differing.push_back(shown.stroke.get());
            if (i < before.size() && before[i].stroke->id == shown.stroke->id)
                goes();
        }
        if (differing.size() > mendedStrokes)
            return differing;
    }
    while (i < before.size())
        goes();
    return differing;
}

} // namespace

std::optional<Point> shiftBetween(const View &from, const View &to)
{
    View alike = from;
    alike.centre = to.centre;
    if (!(alike == to))
        return {};
    return to.toPixels(from.centre) - Point{0.5 * to.width, 0.5 * to.height};
}

void paintQuickLines(QPainter &painter, const View &view, const std::vector<OutlinedStroke> &strokes, bool apart,
                     const QColor &colour, double dpr)
{
    ListPen pen;
    for (const OutlinedStroke &shown : strokes)
        if (shown.apart == apart)
            drawStroke(pen, *shown.stroke, PixelMap(view, shown.stroke->origin), view.scale, leastSpacing * dpr);
    painter.setPen(QPen(colour, 0)); // The lines are one device pixel wide and not smoothed.
    painter.drawLines(pen.lines);
}

/// The length of all lines together in pixels, estimated from some of the strokes.
double ThinOutline::lengthOfLines() const
{
    constexpr std::size_t most = 64; // how many strokes are measured
    const std::size_t step = m_of.strokes.size() / most + 1;
    double sum = 0;
    for (std::size_t i = 0; i < m_of.strokes.size(); i += step)
        for (const Segment &segment : m_of.strokes[i].stroke->segments)
            sum += polygonLength(segment);
    return sum * double(step) * m_of.view.scale;
}

void ThinOutline::draw(double dpr, bool moving)
{
    m_drawn = true;
    m_chosenDrawn = false;
    m_rough = moving;
    const View wide = around();
    m_inked = inkedBy(m_of.box);
    m_mask.clear(wide.width, wide.height);
    weigh();
    m_spacing = std::max(leastSpacing * dpr, lengthOfLines() / (moving ? movingLines : thinLines));
    ThinPen pen(m_mask, {0, 0, wide.width, wide.height});
    for (const OutlinedStroke &shown : m_of.strokes)
        if (!shown.apart)
            drawStroke(pen, *shown.stroke, PixelMap(wide, shown.stroke->origin), m_of.view.scale, m_spacing);
}

/// Makes lines that lie close together fainter, since they must not hide the paint.
void ThinOutline::weigh()
{
    const double area = m_of.box.width() * m_of.box.height() * m_of.view.scale * m_of.view.scale;
    m_weight = std::clamp(denseLines * area / std::max(lengthOfLines(), 1.0), leastWeight, 1.0);
    if (m_of.anyChosen)
        m_weight *= quietWeight;
}

/// The view that the mask shows.
View ThinOutline::around() const
{
    View wide = m_of.view; // It has the same centre.
    wide.width += 2 * margin;
    wide.height += 2 * margin;
    return wide;
}

/// The pixels of the mask where lines in a box of the canvas may be.
QRect ThinOutline::inkedBy(const Rect &box) const
{
    const View wide = around();
    const Rect pixels = pixelBox(wide, box).grown(2);
    // At deep zoom the box may be too large for whole numbers.
    const QRectF inView = QRectF(0, 0, wide.width, wide.height);
    return (inView & QRectF(QPointF(pixels.left, pixels.top), QPointF(pixels.right, pixels.bottom))).toAlignedRect();
}

/// Draws thin lines anew where what was shown before and what is shown now differ, if few strokes do.
void ThinOutline::mend(const std::vector<OutlinedStroke> &before, const StrokeBoxes &boxes)
{
    const std::vector<const Stroke *> differing = differingStrokes(before, m_of.strokes);
    if (differing.size() > mendedStrokes)
        return;
    m_drawn = m_rough = true;
    weigh();
    m_inked = inkedBy(m_of.box);
    Rect box; // One box serves all, since most often the strokes stand together.
    for (const Stroke *stroke : differing)
        box = box.united(controlBox(*stroke));
    const QRect part = inkedBy(box);
    if (part.isEmpty())
        return;
    m_mask.clear(part);
    const View wide = around();
    Rect reach;
    for (const QPoint corner : {part.topLeft(), part.topRight(), part.bottomLeft(), part.bottomRight()})
        reach.include(wide.toCanvas({double(corner.x()), double(corner.y())}));
    reach = reach.grown(2 / wide.scale);
    ThinPen pen(m_mask, part);
    for (const OutlinedStroke &shown : m_of.strokes)
        if (boxes[shown.place].intersects(reach))
            drawStroke(pen, *shown.stroke, PixelMap(wide, shown.stroke->origin), m_of.view.scale, m_spacing);
}

void ThinOutline::paint(QPainter &painter, const View &view, double dpr, const QColor &colour, bool moving)
{
    if (!m_drawn || (m_rough && !moving))
        draw(dpr, moving);
    const Point shift = *shiftBetween(m_of.view, view);
    const QPoint corner(int(std::round(shift.x)) - margin, int(std::round(shift.y)) - margin);
    QColor veiled = colour, rim = Qt::white; // The paint below must still be seen.
    veiled.setAlphaF(float(thinOpacity * m_weight));
    rim.setAlphaF(float(rimOpacity * std::pow(m_weight, 1.5))); // The rim is wider, so it fades faster.
    m_mask.paint(painter, corner, m_inked, {{rim, 1}, {veiled, 0}});
    paintQuickLines(painter, view, m_of.strokes, true, colour, dpr);
    paintChosen(painter, colour, dpr, shift);
}

/// Draws the selected segments over all lines, where these are not smooth. `shift` is how far the view has moved since
/// strokes were gathered.
void ThinOutline::paintChosen(QPainter &painter, const QColor &colour, double dpr, Point shift)
{
    if (!m_of.anyChosen)
        return;
    const View wide = around();
    if (!std::exchange(m_chosenDrawn, true)) {
        m_chosenMask.clear(wide.width, wide.height);
        ThinPen pen(m_chosenMask, {0, 0, wide.width, wide.height});
        for (const OutlinedStroke &shown : m_of.strokes)
            if (!shown.chosen.empty())
                drawChosen(pen, *shown.stroke, shown.chosen, PixelMap(wide, shown.stroke->origin), m_of.view.scale,
                           leastSpacing * dpr);
    }
    const int core = std::max(1, int(std::lround(dpr)));
    QColor rim = Qt::white;
    rim.setAlphaF(float(chosenRim));
    const QPoint corner(int(std::round(shift.x)) - margin, int(std::round(shift.y)) - margin);
    m_chosenMask.paint(painter, corner, {0, 0, wide.width, wide.height}, {{rim, 2 * core}, {colour, core}});
}

} // namespace suffuse

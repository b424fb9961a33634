// The handles around a selection: where they stand, and which map a drag of one means.
#pragma once

#include "app/canvas/overlay/overlay.h"
#include "model/shaping/transform.h"

#include <optional>
#include <vector>

namespace suffuse {

/// A handle at a corner or in the middle of a side, as in Inkscape, with x and y in {−1, 0, 1}; or the centre.
struct TransformHandle {
    enum class Kind { Scale, Rotate, Skew, Centre };
    Kind kind = Kind::Scale;
    int x = 0;
    int y = 0;
    friend bool operator==(const TransformHandle &, const TransformHandle &) = default;
};

/// A box with its handles. The handles keep their size on the screen and stand a little outside of the box. The box
/// lies along the axes of the canvas, so in a turned or mirrored view it is turned and mirrored, too.
class TransformHandles {
public:
    enum class Mode { Scale, Turn };

    Mode mode() const { return m_mode; }
    void setMode(Mode mode) { m_mode = mode; }
    const Rect &box() const { return m_box; }
    /// Puts the handles around another box. The centre keeps its place relative to the box.
    void setBox(const Rect &box);
    /// The point about which strokes are turned, and about which they are scaled with Shift (canvas units).
    Point centre() const;
    void setCentre(Point centre);
    void resetCentre() { m_centre = {0.5, 0.5}; }

    /// The handles of the mode. A side that is too short has no handle in its middle.
    std::vector<TransformHandle> handles(const View &view, double dpr) const;
    /// Where a handle stands on the screen, device pixels.
    Point place(const TransformHandle &handle, const View &view, double dpr) const;
    /// The handle at a device pixel, if there is one.
    std::optional<TransformHandle> at(Point pixel, const View &view, double dpr) const;
    /// The point of the box that the handle stands for, canvas units.
    Point anchor(const TransformHandle &handle) const;

    /// The map that a move of the pointer from one point to another (canvas units) means. Shift scales about the centre
    /// and turns about the opposite corner; Ctrl keeps proportions or takes steps of 15°. When the pointer passes the
    /// fixed point, strokes are mirrored, each axis by itself, as in Inkscape. Where no map can be told, it is the
    /// identity.
    Affine map(const TransformHandle &handle, Point from, Point to, Qt::KeyboardModifiers modifiers) const;

    void paint(QPainter &painter, const View &view, double dpr, const QColor &accent,
               const std::optional<TransformHandle> &hovered) const;

private:
    void paintHandle(QPainter &painter, const TransformHandle &handle, const View &view, double dpr,
                     const QColor &fill) const;
    Affine scaling(const TransformHandle &handle, Point by, Qt::KeyboardModifiers modifiers) const;
    Affine rotation(const TransformHandle &handle, Point from, Point to, Qt::KeyboardModifiers modifiers) const;
    Affine skewing(const TransformHandle &handle, Point by, Qt::KeyboardModifiers modifiers) const;
    Point fixedPoint(const TransformHandle &handle, bool atCentre) const;

    Mode m_mode = Mode::Scale;
    Rect m_box;
    Point m_centre{0.5, 0.5}; ///< as shares of the box, 0 … 1
};

} // namespace suffuse

// The handles around a selection: where they stand, and which map dragging one means.
#pragma once

#include "app/canvas/overlay/overlay.h"
#include "model/shaping/transform.h"

#include <optional>
#include <vector>

namespace suffuse {

/// A handle at a corner or the middle of a side, as Inkscape's: x, y in {−1, 0, 1}; or the centre.
struct TransformHandle {
    enum class Kind { Scale, Rotate, Skew, Centre };
    Kind kind = Kind::Scale;
    int x = 0;
    int y = 0;
    friend bool operator==(const TransformHandle &, const TransformHandle &) = default;
};

/// A box with its handles. They keep their size on screen and stand a little outside of it, along its own sides in
/// turned and mirrored views.
class TransformHandles {
public:
    enum class Mode { Scale, Turn };

    Mode mode() const { return m_mode; }
    void setMode(Mode mode) { m_mode = mode; }
    const Rect &box() const { return m_box; }
    /// The centre stays where it was in the box.
    void setBox(const Rect &box);
    /// What turns turn about and Shift scales about.
    Point centre() const;
    void setCentre(Point centre);
    void resetCentre() { m_centre = {0.5, 0.5}; }

    /// Those of the mode; sides too short for a handle in the middle have none.
    std::vector<TransformHandle> handles(const View &view, double dpr) const;
    /// Device pixels.
    Point place(const TransformHandle &handle, const View &view, double dpr) const;
    std::optional<TransformHandle> at(Point pixel, const View &view, double dpr) const;
    /// The point of the box that the handle stands for, canvas units.
    Point anchor(const TransformHandle &handle) const;

    /// What moving the pointer means: Shift scales about the centre and turns about the opposite corner, Ctrl keeps
    /// proportions or goes in steps of 15°. Past the fixed point scaling mirrors, each axis by itself, as in Inkscape.
    /// The identity where that cannot be told.
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
    Point m_centre{0.5, 0.5}; ///< within the box: 0 … 1
};

} // namespace suffuse

#pragma once

#include "app/tools/shapes/drawing_tool.h"
#include "model/shaping/nodes/node_path.h"
#include "model/shaping/nodes/reshape.h"

#include <optional>

namespace suffuse {

/// Draws an outline node by node: a click sets a corner, a drag a smooth node with its handles. A press on the first
/// node closes the outline; Return or a double click ends it open. It begins anew, or goes on from an end of a selected
/// stroke, whose values it then takes. Between the presses the outline is in hand: it shows as paint, and is no undo
/// step yet.
class PenTool : public DrawingTool {
    Q_OBJECT

public:
    explicit PenTool(CanvasWidget &canvas, QObject *parent = nullptr);

    QString hint() const override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    void hover(const PointerEvent &event) override;
    void leave() override;
    void settle() override { finish(false); }
    /// The last node.
    bool takeBack() override;
    /// Return ends the outline open, Backspace takes back the last node, and a key that redoes brings it back.
    bool keyPress(QKeyEvent *event) override;
    bool wantsKey(const QKeyEvent &event) const override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

protected:
    void show() override;
    void forget() override;

private:
    void setFirst(const PointerEvent &event);
    bool isNear(Point place, Point pixel) const;
    /// Whether a press there closes the outline.
    bool closesAt(Point pixel) const;
    void dragHandle(const PointerEvent &event);
    void takeBackNode();
    void bringBackNode();
    void finish(bool isClosed);
    StrokePtr strokeInHand(bool isClosed) const;

    std::vector<PathNode> m_nodes;
    std::vector<PathNode> m_takenBack; ///< since the last node was set; the last one comes back first
    std::optional<NodeRef> m_extended; ///< the end of the stroke with which the outline goes on
    bool m_isPressed = false;
    bool m_isClosing = false; ///< the press is on the first node
    Point m_pressPixel;
    std::optional<Point> m_next;      ///< where the next node would be, canvas units
    std::optional<NodeRef> m_nearEnd; ///< the end under the pointer with which the outline could go on
};

} // namespace suffuse

#pragma once

#include "app/tools/shapes/drawing_tool.h"
#include "model/shaping/nodes/node_path.h"
#include "model/shaping/nodes/reshape.h"

#include <optional>

namespace suffuse {

class NextNodeFields;

/// Draws an outline node by node: a click sets a corner, a drag a smooth node with its handles. A press on the first
/// node closes the outline; Return or a double click ends it open. The row takes the next node by numbers. It begins
/// anew, or goes on from an end of a selected stroke, whose values it then takes. Between the presses the outline is in
/// hand: it shows as paint, and is no undo step yet.
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
    /// Return sets the node that is typed in the row, else it ends the outline open, or closes it with Shift; Backspace
    /// takes back the last node, and a key that redoes brings it back.
    bool keyPress(QKeyEvent *event) override;
    bool wantsKey(const QKeyEvent &event) const override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

protected:
    void addFields(QHBoxLayout &row) override;
    void show() override;
    void forget() override;

private:
    void setFirst(const PointerEvent &event);
    /// Whether the row says, at least in part, where the next node is.
    bool isTyped() const;
    /// Where the next node would be, for what is typed and where the pointer is.
    Point placeFor(Point pointed) const;
    std::optional<Point> lastPlace() const;
    /// The same for where the pointer was last seen; none if neither that nor the row says anything.
    std::optional<Point> nextPlace() const;
    bool isFirstNode(Point place) const;
    bool canClose() const { return m_nodes.size() > 1 && !m_extended; }
    void setTyped();
    void showNumbers();
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
    Point m_handleShift;              ///< from the pointer to the handle: a node that was typed is not where it is
    std::optional<Point> m_pointed;   ///< where the pointer would set the next node, canvas units
    std::optional<NodeRef> m_nearEnd; ///< the end under the pointer with which the outline could go on
    QPointer<NextNodeFields> m_fields;
};

} // namespace suffuse

#pragma once

#include "app/session/selecting/snapping.h"
#include "app/tools/canvas_tool.h"
#include "model/shaping/node_path.h"
#include "model/shaping/reshape.h"
#include "model/shaping/shapes.h"

#include <QPointer>

#include <optional>

namespace suffuse {

/// Draws an outline node by node: a click sets a corner, a drag a smooth node with its handles. A press on the first
/// node closes the outline; Return or a double click ends it open. It begins anew, or goes on from an end of a selected
/// stroke, whose values it then takes. Between the presses the outline is in hand: it shows as paint, and is no undo
/// step yet.
class PenTool : public CanvasTool {
    Q_OBJECT

public:
    explicit PenTool(CanvasWidget &canvas, QObject *parent = nullptr);

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    QWidget *options() override;
    ColourTarget::ToolUse colourUse() const override { return ColourTarget::ToolUse::Paints; }
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    void hover(const PointerEvent &event) override;
    void leave() override;
    bool isBusy() const override { return !m_nodes.empty(); }
    void cancel() override;
    void settle() override { finish(false); }
    /// Return ends the outline open, Backspace takes back the last node.
    bool keyPress(QKeyEvent *event) override;
    bool wantsKey(const QKeyEvent &event) const override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

    /// What of the outlines is painted from now on; it is remembered in the settings.
    void setPaint(ShapePaint paint);

private:
    void begin(const PointerEvent &event);
    /// Where a node is set or a handle is dragged to.
    Point placeOf(const PointerEvent &event, Point from) const;
    bool isNear(Point place, Point pixel) const;
    /// Whether a press there closes the outline.
    bool closesAt(Point pixel) const;
    void dragHandle(const PointerEvent &event);
    void takeBackNode();
    void show();
    void finish(bool isClosed);
    StrokePtr strokeInHand(bool isClosed) const;

    ShapePaint m_paint;
    std::vector<PathNode> m_nodes;
    std::optional<NodeRef> m_extended; ///< the end of the stroke with which the outline goes on
    bool m_isPressed = false;
    bool m_isClosing = false; ///< the press is on the first node
    StrokeId m_id = 0;
    Microseconds m_born = 0;
    Point m_pressPixel;
    std::optional<Point> m_next;      ///< where the next node would be, canvas units
    std::optional<NodeRef> m_nearEnd; ///< the end under the pointer with which the outline could go on
    Snapping m_snapping;
    QPointer<QWidget> m_options;
};

} // namespace suffuse

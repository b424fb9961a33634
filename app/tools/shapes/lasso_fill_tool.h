#pragma once

#include "app/session/selecting/snapping.h"
#include "app/tools/canvas_tool.h"
#include "model/shaping/shapes.h"

#include <QPointer>

#include <optional>

namespace suffuse {

/// Paints what is drawn around. A drag is closed by a straight line when it ends, and becomes a filled stroke. Clicks
/// set corners between straight lines, and with Alt the end of a drag is such a corner; a press on the first point, a
/// double click or Return closes what is in hand then.
class LassoFillTool : public CanvasTool {
    Q_OBJECT

public:
    explicit LassoFillTool(CanvasWidget &canvas, QObject *parent = nullptr);

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    QWidget *options() override;
    ColourTarget::ToolUse colourUse() const override { return ColourTarget::ToolUse::Paints; }
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    void hover(const PointerEvent &event) override;
    void leave() override;
    bool isBusy() const override { return !m_parts.empty(); }
    void cancel() override;
    void settle() override { finish(); }
    bool keyPress(QKeyEvent *event) override;
    bool wantsKey(const QKeyEvent &event) const override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

    void setPaint(ShapePaint paint);

private:
    using Part = std::vector<Point>; ///< what was drawn between a press and its release, canvas units

    bool closesAt(Point pixel) const;
    bool isClick(const Part &part) const;
    void add(const PointerEvent &event);
    void show();
    void finish();
    /// The closed outline of what is in hand, smooth within each part.
    std::vector<Cubic> outline() const;

    ShapePaint m_paint;
    std::vector<Part> m_parts;
    bool m_isPressed = false;
    StrokeId m_id = 0;
    Microseconds m_born = 0;
    std::optional<Point> m_next; ///< where the next straight line would lead
    Snapping m_snapping;
    QPointer<QWidget> m_options;
};

} // namespace suffuse

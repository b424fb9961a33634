#pragma once

#include "app/tools/eyedropper_tool.h"
#include "app/tools/tool.h"
#include "model/brush.h"
#include "model/reshape.h"
#include "model/stroke_builder.h"

#include <memory>

namespace suffuse {

/// Paints: the stroke in hand is the document's draft, and becomes one undo step when the pen lifts. With Shift from an
/// end of a selected stroke it goes on with that stroke, with the values at that end; with Ctrl or Alt it picks
/// colours.
class BrushTool : public Tool {
    Q_OBJECT

public:
    explicit BrushTool(CanvasWidget &canvas, QObject *parent = nullptr);
    ~BrushTool() override;

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    void hover(const PointerEvent &event) override;
    void leave() override;
    bool isBusy() const override { return m_builder || m_picker.isActive(); }
    void cancel() override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

private:
    void add(const PointerEvent &event);
    void pushStroke(const StrokePtr &stroke);
    /// The end node of a selected stroke that is near enough to go on from.
    std::optional<NodeRef> endAt(Point pixel) const;
    void showOutlineAt(Point pixel);
    QRectF outlineBox() const;

    std::unique_ptr<StrokeBuilder> m_builder;
    Microseconds m_lastTime = 0;
    std::optional<NodeRef> m_extended; ///< the end that the stroke in hand goes on from
    std::optional<NodeRef> m_nearEnd;  ///< under the pointer
    ColourPicker m_picker;
    bool m_hovering = false;
    Point m_pixel; ///< where the outline is
};

/// Half-width of the visible paint of a long straight line at full pressure and age: where its profile
/// pk·e^(−v²/s²) falls to the density at which the style is half opaque (edge darkening: where it ends). 0 if it never
/// gets there. Canvas units.
double halfWidthOf(const Brush &brush);

} // namespace suffuse

#pragma once

#include "app/session/painting/stabiliser.h"
#include "app/tools/brush/brush_sizing.h"
#include "app/tools/brush/eyedropper_tool.h"
#include "app/tools/canvas_tool.h"
#include "model/brush/brush.h"
#include "model/brush/stroke_builder.h"
#include "model/shaping/reshape.h"

#include <QPointer>

#include <memory>

namespace suffuse {

/// Paints: the stroke in hand is the document's draft, and becomes one undo step when the pen lifts. With Shift from an
/// end of a selected stroke it goes on with that stroke, with the values at that end; from elsewhere Shift changes the
/// brush's size across and its opacity upwards; with Ctrl or Alt it picks colours.
class BrushTool : public CanvasTool {
    Q_OBJECT

public:
    explicit BrushTool(CanvasWidget &canvas, QObject *parent = nullptr);
    ~BrushTool() override;

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    QWidget *options() override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    void hover(const PointerEvent &event) override;
    void leave() override;
    /// None: what is painted is to be seen.
    bool showsOutlines() const override { return false; }
    bool isBusy() const override { return m_builder || m_sizing.isActive() || m_picker.isActive(); }
    void cancel() override;
    void stepSize(int steps) override { m_sizing.stepSize(steps); }
    void stepOpacity(int steps) override { m_sizing.stepOpacity(steps); }
    void paint(QPainter &painter, const View &view, double dpr) const override;

    /// What the canvas says about the brush at the moment; empty: nothing.
    const QString &note() const { return m_sizing.note(); }

private:
    void add(const PointerEvent &event);
    PenSample sampleOf(const PointerEvent &event) const;
    void paintString(QPainter &painter, const View &view, double dpr) const;
    void paintOutline(QPainter &painter, const View &view, double dpr) const;
    void paintNote(QPainter &painter, double dpr) const;
    void pushStroke(const StrokePtr &stroke);
    /// Says so where nothing of a new stroke can be seen, until something else is done.
    void tellIfUnseen(const Stroke &stroke);
    void say(const QString &text);
    /// The end node of a selected stroke that is near enough to go on from.
    std::optional<NodeRef> endAt(Point pixel) const;
    void showOutlineAt(Point pixel);
    QRectF outlineBox() const;

    std::unique_ptr<StrokeBuilder> m_builder;
    PenStabiliser m_stabiliser;
    BrushSizing m_sizing;
    Microseconds m_lastTime = 0;
    std::optional<NodeRef> m_extended; ///< the end that the stroke in hand goes on from
    std::optional<NodeRef> m_nearEnd;  ///< under the pointer
    ColourPicker m_picker;
    QString m_said; ///< about the last stroke; empty: nothing
    bool m_hovering = false;
    Point m_pixel; ///< where the outline is
    QPointer<QWidget> m_options;
};

} // namespace suffuse

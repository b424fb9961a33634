#pragma once

#include "app/session/painting/assisted_pen.h"
#include "app/session/painting/stabiliser.h"
#include "app/session/painting/stroke_copies.h"
#include "app/tools/brush/brush_sizing.h"
#include "app/tools/brush/eyedropper_tool.h"
#include "app/tools/canvas_tool.h"
#include "model/brush/brush.h"
#include "model/brush/brush_dynamics.h"
#include "model/brush/stroke_builder.h"
#include "model/shaping/nodes/reshape.h"

#include <QPointer>

#include <memory>

namespace suffuse {

/// Paints. The stroke in hand is the document's draft, and becomes one undo step when the pen lifts. A drag with Shift
/// that begins at an end of a selected stroke continues that stroke with the values at that end; one that begins
/// elsewhere changes the brush's size across and its opacity upwards. With Ctrl or Alt the tool picks colours.
class BrushTool : public CanvasTool {
    Q_OBJECT

public:
    explicit BrushTool(CanvasWidget &canvas, QObject *parent = nullptr);
    ~BrushTool() override;

    QString hint() const override;
    ColourTarget::ToolUse colourUse() const override { return ColourTarget::ToolUse::Paints; }
    QCursor cursor() const override { return Qt::CrossCursor; }
    QWidget *options() override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    void hover(const PointerEvent &event) override;
    void leave() override;
    /// Outlines are hidden, so that what is painted is seen.
    bool showsOutlines() const override { return false; }
    bool isBusy() const override { return m_builder || m_sizing.isActive() || m_picker.isActive(); }
    void cancel() override;
    void stepSize(int steps) override { m_sizing.stepSize(steps); }
    void stepOpacity(int steps) override { m_sizing.stepOpacity(steps); }
    void paint(QPainter &painter, const View &view, double dpr) const override;

    /// What stands beside the pointer about the brush at the moment; empty where nothing does.
    const QString &note() const { return m_sizing.note(); }
    /// The radius of the circle at the pointer, canvas units: half of what is painted in a long line. A mouse presses fully
    /// and is moved as hands usually move it; for a pen it is that of full pressure, which is the most that it paints. `dpr`
    /// is that of the canvas.
    double circle(const View &view, double dpr) const;

private:
    /// Decides with the first sample what assistants the new stroke may follow.
    void beginAssisted();
    void add(const PointerEvent &event);
    void build(const std::vector<PenSample> &samples);
    void showDraft();
    PenSample sampleOf(const PointerEvent &event) const;
    void paintString(QPainter &painter, const View &view, double dpr) const;
    void paintOutline(QPainter &painter, const View &view, double dpr) const;
    void paintNote(QPainter &painter, double dpr) const;
    void pushStroke(const StrokePtr &stroke);
    /// Says it where nothing of a new stroke can be seen, and, until a stroke was ever selected, how that is done;
    /// until something else is done.
    void tellAbout(const Stroke &stroke);
    void showOutlineAt(const PointerEvent &event);
    std::optional<PenState> usualPen(const View &view, double dpr) const;
    QRectF outlineBox() const;

    std::unique_ptr<StrokeBuilder> m_builder;
    StrokeCopies m_copies; ///< of the stroke in hand
    PenStabiliser m_stabiliser;
    AssistedPen m_assisted; ///< behind the stabiliser, whose string would cut corners
    BrushSizing m_sizing;
    Microseconds m_lastTime = 0;
    std::optional<NodeRef> m_extended; ///< the end that the stroke in hand continues
    std::optional<NodeRef> m_nearEnd;  ///< the end under the pointer that could be continued
    ColourPicker m_picker;
    bool m_hovering = false;
    Point m_pixel; ///< where the outline of the brush is
    PointerDevice m_device = PointerDevice::Mouse; ///< that is there
    QPointer<QWidget> m_options;
};

} // namespace suffuse

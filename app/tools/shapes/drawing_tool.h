// What the tools that draw shapes, outlines and lassos have in common.
#pragma once

#include "app/session/painting/stroke_copies.h"
#include "app/session/selecting/snapping.h"
#include "app/tools/canvas_tool.h"
#include "app/tools/shapes/shape_paint.h"

#include <QPointer>

class QHBoxLayout;

namespace suffuse {

/// Paints a new stroke with the brush in hand: its outline, what is within it, or both. Until it is finished the stroke
/// is in hand: it shows as paint, and is no undo step.
class DrawingTool : public CanvasTool {
    Q_OBJECT

public:
    QCursor cursor() const override { return Qt::CrossCursor; }
    QWidget *options() override;
    ColourTarget::ToolUse colourUse() const override { return ColourTarget::ToolUse::Paints; }
    bool isBusy() const override { return m_id != 0; }
    void cancel() override;

    /// What of the shape is painted from now on, and of that in hand; it is remembered in the settings.
    void setPaint(ShapePaint paint);

protected:
    /// `name` is that of its settings.
    DrawingTool(CanvasWidget &canvas, const QString &name, QObject *parent);

    /// Fills the row over the canvas: here with what is painted.
    virtual void addFields(QHBoxLayout &row);
    /// Shows what is in hand as it is now.
    virtual void show() = 0;
    /// Forgets what is in hand; called when it is finished or given up, and when nothing of it can come back any more.
    virtual void forget() = 0;

    /// Whether one may be begun; the canvas says why not.
    bool mayBegin();
    /// Takes a new stroke in hand, which was begun at `born`.
    void begin(Microseconds born);
    /// The same by the pointer; time stands still until it is finished.
    void begin(const PointerEvent &event);
    /// The same by keys alone.
    void beginWithoutPointer(Microseconds born);
    /// Takes in hand again what was given up last, as long as nothing else has happened since.
    void resume();
    /// Where the pointer is, or what it snaps to.
    Point snapped(const PointerEvent &event) const;
    /// As `snapped`, and with Shift in a direction of steps of 15° from a point.
    Point placeOf(const PointerEvent &event, Point from) const;
    /// The stroke in hand along curves; null where nothing can be painted.
    StrokePtr painted(const std::vector<Cubic> &curves) const;
    /// Shows a stroke as what is in hand, with the copies that the symmetry makes of it or alone.
    void showDraft(const StrokePtr &stroke, bool alone = false);
    /// Adds a stroke and its copies, selected, as a step of this name.
    void push(const StrokePtr &stroke, const QString &name);
    /// The same, but where the stroke is null, the status bar says that there is no area.
    void addOrSay(const StrokePtr &stroke, const QString &name);

    StrokeId m_id = 0; ///< of the stroke in hand; 0: none
    Microseconds m_born = 0;
    QPointer<QWidget> m_options;

private:
    QString m_name;
    ShapePaint m_paint;
    Snapping m_snapping;
    StrokeCopies m_copies; ///< of the stroke in hand
};

} // namespace suffuse

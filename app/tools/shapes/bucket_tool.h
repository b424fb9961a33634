#pragma once

#include "app/session/painting/paint_region.h"
#include "app/tools/canvas_tool.h"

#include <QPointer>

namespace suffuse {

/// Fills the region that is bounded by the paint that is seen around a click, as a filled stroke with the values of the
/// brush in hand. It lies over or under all other strokes, and what bounded it is forgotten.
class BucketTool : public CanvasTool {
    Q_OBJECT

public:
    explicit BucketTool(CanvasWidget &canvas, QObject *parent = nullptr);

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    QWidget *options() override;
    ColourTarget::ToolUse colourUse() const override { return ColourTarget::ToolUse::Paints; }
    bool showsOutlines() const override { return false; }
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &) override {}
    void release(const PointerEvent &event) override;
    bool isBusy() const override { return m_isPressed; }
    void cancel() override;

    const RegionWish &wish() const { return m_wish; }
    /// What is filled from now on, and whether below all strokes; both are remembered in the settings.
    void setWish(const RegionWish &wish, bool isUnder);

private:
    void fill(const PointerEvent &event);

    RegionWish m_wish;
    bool m_isUnder = false;
    bool m_isPressed = false;
    QPointer<QWidget> m_options;
};

} // namespace suffuse

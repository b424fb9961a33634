#pragma once

#include "app/tools/canvas_tool.h"
#include "app/tools/shapes/bucket_job.h"

#include <QPointer>

#include <deque>

namespace suffuse {

/// Fills the region that is bounded by the paint that is seen around a click, as a filled stroke with the values of the
/// brush in hand. It lies over or under all other strokes, and what bounded it is forgotten. The region is found aside
/// from the window. Clicks that come meanwhile wait, and each fills the picture that those before it have left. They
/// are in hand until then: Esc gives all of them up, and undo the last one. What is found in a painting that has
/// changed since is dropped.
class BucketTool : public CanvasTool {
    Q_OBJECT

public:
    explicit BucketTool(CanvasWidget &canvas, QObject *parent = nullptr);

    QString hint() const override;
    QCursor cursor() const override { return m_job.isRunning() ? Qt::BusyCursor : Qt::CrossCursor; }
    QWidget *options() override;
    ColourTarget::ToolUse colourUse() const override { return ColourTarget::ToolUse::Paints; }
    bool showsOutlines() const override { return false; }
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &) override {}
    void release(const PointerEvent &event) override;
    bool isBusy() const override { return m_isPressed || m_job.isRunning(); }
    void cancel() override;
    /// The last click that is not filled yet.
    bool takeBack() override;

    const RegionWish &wish() const { return m_wish; }
    /// What is filled from now on, and whether below all strokes; both are remembered in the settings.
    void setWish(const RegionWish &wish, bool isUnder);

private:
    void startNext();
    void take(const BucketOrder &order, const StrokePtr &stroke);

    RegionWish m_wish;
    bool m_isUnder = false;
    bool m_isPressed = false;
    QPointer<QWidget> m_options;
    std::deque<BucketOrder> m_waiting; ///< clicks, each without a painting until it is its turn
    BucketJob m_job;
};

} // namespace suffuse

// The work of a click of the bucket, aside from the window.
#pragma once

#include "app/session/painting/paint_region.h"
#include "model/brush/brush.h"

#include <QObject>
#include <QThreadPool>

#include <memory>

namespace suffuse {

/// What is to be filled, and with what.
struct BucketOrder {
    PaintingPtr painting;
    PaintingPtr bounds;    ///< what of it bounds the region
    Microseconds time = 0; ///< whose picture is looked at, and when the fill is born
    Point at;              ///< canvas units
    RegionWish wish;
    double scale = 1;     ///< as that of `paintRegion`
    bool isUnder = false; ///< below all strokes
    Brush brush;
    StrokeId id = 0;
};

/// The filled stroke of an order; null where there is nothing to fill, or once `cancel` is set. Any thread.
StrokePtr bucketFill(const BucketOrder &order, const std::atomic<bool> &cancel);

/// Works on one order at a time on a thread of its own. What is cancelled is never heard of again.
class BucketJob : public QObject {
    Q_OBJECT

public:
    explicit BucketJob(QObject *parent = nullptr);
    ~BucketJob() override; ///< cancels and waits

    void start(const BucketOrder &order);
    void cancel();
    bool isRunning() const { return m_cancel != nullptr; }

signals:
    /// Emitted on the caller's thread, from its event loop.
    void done(const suffuse::BucketOrder &order, const suffuse::StrokePtr &stroke);

private:
    std::shared_ptr<std::atomic<bool>> m_cancel; ///< of the order that is worked on; null: none is
    QThreadPool m_thread;
};

} // namespace suffuse

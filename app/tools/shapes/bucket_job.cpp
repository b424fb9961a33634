#include "app/tools/shapes/bucket_job.h"

#include "app/tools/shapes/shape_paint.h"
#include "model/shaping/area_strokes.h"

namespace suffuse {

StrokePtr bucketFill(const BucketOrder &order, const std::atomic<bool> &cancel)
{
    Area area{paintRegion(order.bounds, order.time, order.at, order.wish, order.scale, &cancel)};
    if (area.loops.empty())
        return nullptr;
    const StrokePtr first = paintedAlong(area.loops.front(), order.brush, order.id, order.time, ShapePaint::Fill);
    if (!first || cancel)
        return nullptr;
    for (std::vector<Cubic> &loop : area.loops)
        for (Cubic &curve : loop)
            for (Point &p : curve.p)
                p = p - first->origin;
    std::optional<Stroke> stroke = withArea(*first, area);
    return stroke ? std::make_shared<const Stroke>(std::move(*stroke)) : nullptr;
}

BucketJob::BucketJob(QObject *parent) : QObject(parent)
{
    m_thread.setMaxThreadCount(1);
}

BucketJob::~BucketJob()
{
    cancel();
    m_thread.waitForDone();
}

void BucketJob::start(const BucketOrder &order)
{
    Q_ASSERT(!isRunning());
    m_cancel = std::make_shared<std::atomic<bool>>(false);
    m_thread.start([this, order, cancel = m_cancel] {
        const StrokePtr stroke = bucketFill(order, *cancel);
        const auto tell = [this, order, stroke, cancel] {
            if (*cancel)
                return;
            m_cancel.reset();
            emit done(order, stroke);
        };
        QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
    });
}

void BucketJob::cancel()
{
    if (m_cancel)
        *m_cancel = true;
    m_cancel.reset();
}

} // namespace suffuse

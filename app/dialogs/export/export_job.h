#pragma once

#include "model/result.h"
#include "render/image_io/image_io.h"
#include "render/renderer.h"

#include <QObject>

#include <thread>

namespace suffuse {

/// An order: what is to be exported, and where.
struct ExportOrder {
    QString path;
    PaintingPtr painting;
    Microseconds time = 0;
    Rect area; ///< canvas units
    int width = 0;
    int height = 0;
    bool transparent = false;
    ImageOptions image;
    int threads = 0; ///< 0: all cores
};

/// Renders and writes a picture, or the layers of an OpenRaster file, on a thread of its own. If it is cancelled or
/// fails, it leaves the target as it was.
class ExportJob : public QObject {
    Q_OBJECT

public:
    explicit ExportJob(QObject *parent = nullptr);
    ~ExportJob() override; ///< cancels and waits

    /// Starts an order; only one runs at a time.
    void start(const ExportOrder &order);
    void cancel() { m_cancel = true; }
    bool isRunning() const { return m_running; }
    /// The target of the order that was started last.
    const QString &path() const { return m_path; }

signals:
    void progressed(int perMille);
    /// Emitted on the caller's thread. `error` is empty after success and after a cancel.
    void finished(bool written, const QString &error);

private:
    void run(const ExportOrder &order);
    Result<void> work(const ExportOrder &order);
    Result<void> workOnLayers(const ExportOrder &order, Renderer &renderer);
    void show(int perMille);

    QString m_path;
    std::atomic<bool> m_cancel = false;
    bool m_running = false;
    std::jthread m_thread;
};

} // namespace suffuse

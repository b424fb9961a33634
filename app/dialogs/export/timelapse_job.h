#pragma once

#include "model/document/timelapse.h"
#include "render/film/film_writer.h"

#include <QObject>

#include <thread>

namespace suffuse {

/// An order: what is to be filmed, and how.
struct TimelapseOrder {
    FilmOptions film;  ///< its path, frames a second, size, image and loops
    double idle = 0.5; ///< seconds that are kept of each pause
    PaintingPtr painting;
    Rect area;       ///< canvas units
    int threads = 0; ///< 0: all cores
};

/// Draws and writes a film on a thread of its own. If it is cancelled or fails, it leaves the target as it was.
class TimelapseJob : public QObject {
    Q_OBJECT

public:
    explicit TimelapseJob(QObject *parent = nullptr);
    ~TimelapseJob() override; ///< cancels and waits

    /// Starts an order; only one runs at a time.
    void start(const TimelapseOrder &order);
    void cancel() { m_cancel = true; }
    bool isRunning() const { return m_running; }

signals:
    void progressed(int frames);
    /// Emitted on the caller's thread. `error` is empty after success and after a cancel.
    void finished(bool written, const QString &error);

private:
    /// Returns an empty string, or why there is no film.
    Result<void> film(TimelapseOrder order);

    std::atomic<bool> m_cancel = false;
    bool m_running = false;
    std::jthread m_thread;
};

} // namespace suffuse

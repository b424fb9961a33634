#pragma once

#include "app/panels/strokes/thumbnails/thumbnail_renderer.h"

#include <QCache>
#include <QImage>
#include <QObject>
#include <QThreadPool>

#include <map>
#include <memory>

namespace suffuse {

/// Small pictures of dry strokes, drawn by the real renderer. A picture is made when a row that shows it is first
/// painted, on a thread of its own, and the newest wish comes first.
class StrokeThumbnails : public QObject {
    Q_OBJECT

public:
    explicit StrokeThumbnails(QObject *parent = nullptr);
    ~StrokeThumbnails() override;

    /// The picture of a stroke in this state, or the last one that is known; null if there is none yet. A picture that
    /// is missing is asked for, unless `quiet`.
    QImage of(const StrokePtr &stroke, double ratio, bool quiet);

    /// Whether all pictures that were asked for are there.
    bool isIdle() const { return !m_running && m_wanted.empty(); }

signals:
    /// Emitted when the picture of a stroke is there.
    void ready(suffuse::StrokeId stroke);

private:
    struct Entry {
        StrokePtr stroke; ///< the state that the picture shows
        QImage image;
    };

    void startNext();
    void take(const StrokePtr &stroke, const QImage &image);

    QCache<StrokeId, Entry> m_known{4096};
    std::vector<std::pair<StrokePtr, double>> m_wanted; ///< the newest wish last
    StrokePtr m_running;
    std::shared_ptr<ThumbnailRenderer> m_renderer;
    QThreadPool m_thread;
};

} // namespace suffuse

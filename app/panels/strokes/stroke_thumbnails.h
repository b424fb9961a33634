#pragma once

#include "model/painting/painting.h"

#include <QCache>
#include <QImage>
#include <QObject>
#include <QThreadPool>

#include <map>
#include <memory>

namespace suffuse {

class Renderer;

/// Small pictures of strokes, dry, by the real renderer: made when a row that shows one is first painted, on a thread
/// of its own, the newest wish first.
class StrokeThumbnails : public QObject {
    Q_OBJECT

public:
    static constexpr QSize size{32, 20}; ///< logical pixels

    explicit StrokeThumbnails(QObject *parent = nullptr);
    ~StrokeThumbnails() override;

    /// The picture of this state of the stroke, or of the last one known; null where there is none yet. Asks for it
    /// unless `quiet`.
    QImage of(const StrokePtr &stroke, double ratio, bool quiet);

    /// All pictures that were asked for are there.
    bool isIdle() const { return !m_running && m_wanted.empty(); }

signals:
    void ready(suffuse::StrokeId stroke);

private:
    struct Entry {
        StrokePtr stroke; ///< what the picture is of
        QImage image;
    };
    class Maker;

    void startNext();
    void take(const StrokePtr &stroke, const QImage &image);

    QCache<StrokeId, Entry> m_known{4096};
    std::vector<std::pair<StrokePtr, double>> m_wanted; ///< the newest last
    StrokePtr m_running;
    std::shared_ptr<Maker> m_maker;
    QThreadPool m_thread;
};

} // namespace suffuse

#pragma once

#include "app/panels/strokes/strokes_tree.h"

#include <QCache>
#include <QImage>
#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <atomic>
#include <memory>

namespace suffuse {

class ThumbnailRenderer;

/// Small pictures of groups, each as if it were alone. They may take long, so they are drawn while nothing else goes
/// on: on a thread that others go before, when nothing has been asked for a while, and not during a gesture. The newest
/// wish comes first.
class GroupThumbnails : public QObject {
    Q_OBJECT

public:
    explicit GroupThumbnails(const StrokesTree &tree, QObject *parent = nullptr);
    ~GroupThumbnails() override;

    /// The picture of a group, or the last one that is known where it was in another state; null if there is none yet.
    /// A picture that is missing is asked for, unless `quiet`: then a gesture goes on, and what is being drawn is given
    /// up.
    QImage of(const StrokesTree::Node &group, double ratio, bool quiet);

    /// Whether all pictures that were asked for are there.
    bool isIdle() const { return m_running.group == 0 && m_wanted.empty(); }

signals:
    /// Emitted when the picture of a group is there.
    void ready(suffuse::GroupId group);

private:
    /// What a picture shows: the group in a state, which a number tells from others.
    struct Wish {
        GroupId group = 0;
        std::size_t state = 0;
        double ratio = 1;
        friend bool operator==(const Wish &, const Wish &) = default;
    };
    struct Entry {
        Wish shown;
        QImage image;
        std::size_t state = 0;
        int seen = 0; ///< when that was found
    };

    std::size_t stateOf(const StrokesTree::Node &group) const;
    void ask(const Wish &wish);
    void startNext();
    void take(const Wish &wish, const QImage &image);

    const StrokesTree &m_tree;
    PaintingPtr m_seenIn; ///< the painting in which states were looked for last
    int m_seen = 0;       ///< counts those
    QCache<GroupId, Entry> m_known{512};
    std::vector<Wish> m_wanted; ///< the newest wish last
    Wish m_running;
    std::shared_ptr<std::atomic<bool>> m_cancel;
    std::shared_ptr<ThumbnailRenderer> m_renderer;
    QTimer m_idle;
    QThreadPool m_thread;
};

} // namespace suffuse

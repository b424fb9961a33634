// The strokes of a painting that is being edited, prepared for a view: each snapshot costs what differs from the last
// one.
#pragma once

#include "render/nodes/frozen_nodes.h"
#include "render/scene/scene.h"
#include "render/threads/parallel.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace suffuse {

using SceneStrokePtr = std::shared_ptr<const SceneStroke>;

/// How a scene differs from the one before.
struct SceneChange {
    struct Replaced {
        std::size_t index = 0;
        SceneStrokePtr before;
    };
    /// Strokes that were prepared anew, by ascending index, where all else stayed.
    std::vector<Replaced> replaced;
    /// Strokes came, went or moved: `before` are all that were there, `places` says where among them each one stood.
    bool reordered = false;
    std::vector<SceneStrokePtr> before;
    std::vector<std::size_t> places;
    static constexpr std::size_t nowhere = std::size_t(-1);
};

/// Strokes of equal id, time, view and values keep what was prepared for them, and so do their nodes over changes of
/// the view within an octave.
class LiveScene {
public:
    /// `cull`: false, and every stroke seems to reach and show everywhere, for tests.
    explicit LiveScene(bool cull = true) : m_cull(cull) {}

    /// Brings the scene up to date with the request. What is told of the change is of use where the view is the same.
    SceneChange update(const RenderRequest &request, Threads threads);

    /// Visible strokes from bottom to top.
    const std::vector<SceneStrokePtr> &strokes() const { return m_strokes; }
    /// Their bounds, side by side.
    const std::vector<PixelRect> &bounds() const { return m_bounds; }
    std::size_t nodeCount() const { return m_nodeCount; }

private:
    /// A stroke to prepare anew, and whether its nodes still hold.
    struct Stale {
        std::size_t index = 0;
        bool nodesHold = false;
    };
    /// Takes the painting's strokes over in place and returns where they differ; false where strokes came, went or
    /// moved.
    bool replace(const RenderRequest &request, std::vector<Stale> &stale);
    /// Brings the strokes into the painting's order, keeping what is known of each; returns SceneChange::places.
    std::vector<std::size_t> align(const Painting &painting);
    std::vector<std::size_t> placesOf(const std::vector<StrokePtr> &strokes) const;
    std::vector<Stale> staleAfterAlign(const RenderRequest &request) const;
    void addWet(Microseconds time, std::vector<Stale> &stale) const;
    /// A stroke as it is once it has dried, where that is known: scrubbing comes back to it.
    SceneStrokePtr dryOf(std::size_t i, const View &view) const;
    void prepare(const std::vector<Stale> &stale, const RenderRequest &request, Threads threads);
    bool sameAge(std::size_t i, Microseconds time) const
    {
        return time == m_time || (m_driesAt[i] <= m_time && m_driesAt[i] <= time);
    }

    bool m_cull;
    View m_view;
    Microseconds m_time = 0;
    StrokeList m_seen;                     ///< the painting's, visible or not
    std::vector<Group> m_groups;           ///< the painting's
    std::vector<std::int64_t> m_place;     ///< of each of m_seen among the visible ones, −1 where it is not
    std::vector<StrokePtr> m_sources;      ///< the visible ones
    std::vector<SceneStrokePtr> m_strokes; ///< the same, prepared; null where that was never done
    std::vector<Microseconds> m_driesAt;   ///< the same
    std::vector<PixelRect> m_bounds;       ///< the same
    std::size_t m_nodeCount = 0;
    std::unordered_map<StrokeId, FrozenNodes> m_frozen; ///< of strokes that were wet in the last update
};

} // namespace suffuse

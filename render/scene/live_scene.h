// The strokes of a painting that is being edited, prepared for a view. Each snapshot costs only what differs from the
// last one.
#pragma once

#include "render/composition/composition.h"
#include "render/composition/washes.h"
#include "render/nodes/bulk_nodes.h"
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
    /// The strokes that were prepared anew, by ascending index, if nothing else changed.
    std::vector<Replaced> replaced;
    /// Whether strokes were added, removed or moved, or groups differ. Then `before` has all strokes that existed, and
    /// `places` says where among them each stroke was.
    bool reordered = false;
    std::vector<SceneStrokePtr> before;
    std::vector<std::size_t> places;
    Composition composed; ///< as it was before
    static constexpr std::size_t nowhere = std::size_t(-1);
};

/// Strokes of equal id, time, place in the grid and values keep what was prepared for them. Their nodes also stay when
/// the view changes within an octave.
class LiveScene {
public:
    /// With `cull` false, every stroke seems to reach and show everywhere, for tests. `bulk`, if there is one, builds
    /// nodes where many are missing; the nodes are the same.
    explicit LiveScene(bool cull = true, BulkNodeBuilder *bulk = nullptr) : m_cull(cull), m_bulk(bulk) {}

    /// Brings the scene up to date with the request, whose view lies in `grid`. The returned change is useful only if
    /// the place in the grid is the same. Strokes whose boundaries were not found when `stop` became true are not seen;
    /// they are prepared anew in the next update.
    SceneChange update(const RenderRequest &request, const PictureGrid &grid, Threads threads,
                       const std::atomic<bool> *stop = nullptr);

    /// The visible strokes from bottom to top.
    const std::vector<SceneStrokePtr> &strokes() const { return m_strokes; }
    /// The bounds of these strokes, in the same order.
    const std::vector<PixelRect> &bounds() const { return m_bounds; }
    std::size_t nodeCount() const { return m_nodeCount; }
    /// The layers of these strokes.
    const Composition &composition() const { return m_composition; }

private:
    /// A stroke to be prepared anew, and whether its nodes are still valid.
    struct Stale {
        std::size_t index = 0;
        bool nodesHold = false;
    };
    /// Takes over the painting's strokes in place, and lists where they differ. Returns false if strokes were added,
    /// removed or moved.
    bool replace(const Painting &painting, Microseconds time, std::vector<Stale> &stale);
    /// Whether the painting differs from the last one in nothing but the opacities and modes of groups.
    bool isPutAnew(const Painting &painting) const;
    /// Brings the strokes into the painting's order, and keeps what is known of each. Returns SceneChange::places.
    std::vector<std::size_t> align(const Painting &painting);
    std::vector<std::size_t> placesOf(const std::vector<StrokePtr> &strokes) const;
    std::vector<Stale> staleAfterAlign(Microseconds time, const PictureGrid &grid) const;
    void addWet(Microseconds time, std::vector<Stale> &stale) const;
    /// A stroke as it is once it has dried, if that is known: scrubbing through time comes back to it.
    SceneStrokePtr dryOf(std::size_t i, const PictureGrid &grid) const;
    /// Builds nodes in bulk, if there are many to be built. The others are null.
    std::vector<std::shared_ptr<const StrokeNodes>> buildBulk(const std::vector<Stale> &stale,
                                                              const std::vector<FrozenNodes *> &frozen,
                                                              const std::vector<char> &outside, Microseconds time,
                                                              const PictureGrid &grid, Threads threads) const;
    /// Returns false if it was stopped: then sources are copies where strokes are not prepared.
    bool prepare(const std::vector<Stale> &stale, Microseconds time, const PictureGrid &grid, Threads threads,
                 const std::atomic<bool> *stop);
    bool sameAge(std::size_t i, Microseconds time) const
    {
        return time == m_time || (m_driesAt[i] <= m_time && m_driesAt[i] <= time);
    }

    bool m_cull;
    BulkNodeBuilder *m_bulk;
    PictureGrid m_grid;
    Microseconds m_time = 0;
    StrokeList m_seen;           ///< the strokes of the painting, visible or not
    std::vector<Group> m_groups; ///< the groups of the painting
    /// the place of each stroke of m_seen among the visible ones; −1 if it is not visible
    std::vector<std::int64_t> m_place;
    std::vector<StrokePtr> m_sources;      ///< the visible strokes
    std::vector<SceneStrokePtr> m_strokes; ///< the visible strokes as they were prepared; null if that was never done
    std::vector<Microseconds> m_driesAt;   ///< when each visible stroke dries
    std::vector<PixelRect> m_bounds;       ///< the bounds of each visible stroke
    std::size_t m_nodeCount = 0;
    Composition m_composition;
    Washes m_washes;
    std::unordered_map<StrokeId, FrozenNodes> m_frozen; ///< for strokes that were wet in the last update
};

} // namespace suffuse

// The tree that the Strokes dock shows, as a value that follows a painting.
#pragma once

#include "model/document/document.h"

#include <memory>
#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

namespace suffuse {

/// The groups and strokes, the topmost first, and the number of segments of each stroke. It follows a painting by
/// comparing it with the state before, and meanwhile tells a listener which rows come, go and move.
class StrokesTree {
public:
    /// A row and what is below it. It is a group, a stroke, or the root, which is neither.
    struct Node {
        StrokeId stroke = 0;
        GroupId group = 0;
        Node *parent = nullptr;
        int row = 0;
        int segments = 0; ///< the number of rows below a stroke
        std::vector<std::unique_ptr<Node>> children;
    };

    /// Is told of rows before and after they change. Rows are counted below a node, from `first` to `last`.
    class Listener {
    public:
        virtual void rowsCome(const Node &parent, int first, int last) = 0;
        virtual void rowsCame() = 0;
        virtual void rowsGo(const Node &parent, int first, int last) = 0;
        virtual void rowsWent() = 0;
        virtual void rowsMove(const Node &parent) = 0;
        virtual void rowsMoved(const Node &parent) = 0;

    protected:
        ~Listener() = default;
    };

    /// The rows that stayed and whose values have changed.
    struct Changed {
        std::vector<const Node *> strokes;
        std::vector<const Node *> withSegments; ///< those of them whose segments have changed
        bool groups = false;                    ///< a group has another name, or is switched
        bool switches =
            false; ///< a stroke is shown, hidden, locked or unlocked, or strokes were added, removed or moved
    };

    StrokesTree() : m_root(std::make_unique<Node>()) {}

    /// Takes another painting, without comparing it with the one before.
    void build(const PaintingPtr &painting);
    /// Takes the same painting after a change. If its strokes are grouped in another way, nothing is done and nothing
    /// is returned: then the tree must be built anew.
    std::optional<Changed> follow(const PaintingPtr &painting, const Change &change, Listener &listener);

    /// The painting; null before the first one is built.
    const PaintingPtr &painting() const { return m_painting; }
    const Node &root() const { return *m_root; }
    /// The node of a stroke; null where there is no such stroke.
    const Node *nodeOf(StrokeId id) const;
    /// The stroke; null where there is none.
    StrokePtr strokeOf(StrokeId id) const;
    /// The group; null where there is none.
    const Group *groupOf(GroupId id) const;
    /// Whether the group is one of `groups`, or lies in one of them.
    bool isWithin(GroupId group, const std::set<GroupId> &groups) const;
    /// The strokes that belong to a node: the stroke itself, or all in the group.
    static std::set<StrokeId> strokesBelow(const Node &node);
    /// The lowest stroke of a node in the order of painting; 0 where a group is empty.
    static StrokeId lowestStrokeOf(const Node &node);

private:
    /// What stands below each parent from top to bottom. An entry has the id of a stroke or that of a group.
    struct Entry {
        StrokeId stroke = 0;
        GroupId group = 0;
    };
    using Entries = std::vector<Entry>;
    using Layout = std::unordered_map<GroupId, Entries>;
    using Values = std::unordered_map<StrokeId, StrokePtr>;

    static Layout layoutOf(const Painting &painting);
    static void renumber(Node &node);
    void buildBelow(Node &node, const Layout &layout);
    void followOrder(const Painting &painting, Listener &listener);
    void removeMissing(Node &node, const Entries &wanted, Listener &listener);
    void insertNew(Node &node, const Entries &wanted, Listener &listener);
    static void sortLike(Node &node, const Entries &wanted, Listener &listener);
    static void followSegments(Node &node, const Stroke &stroke, Listener &listener);
    Changed takeValues(const std::set<StrokeId> &ids, const Values &changed);

    PaintingPtr m_painting;
    std::vector<Group> m_groups;
    Values m_values;
    std::unordered_map<StrokeId, Node *> m_nodes;
    std::unique_ptr<Node> m_root;
};

} // namespace suffuse

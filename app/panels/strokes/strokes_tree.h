// The tree that the Strokes dock shows, as a value that follows a painting.
#pragma once

#include "model/document/document.h"

#include <memory>
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
        StrokePtr value; ///< the stroke in the state that the row shows
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
        /// Of the rows that go to the place that row `to` has before.
        virtual void rowsMove(const Node &parent, int first, int last, int to) = 0;
        virtual void rowsMoved() = 0;
        /// Of rows that come into any other order.
        virtual void rowsSort(const Node &parent) = 0;
        virtual void rowsSorted(const Node &parent) = 0;

    protected:
        ~Listener() = default;
    };

    /// The rows that stayed and whose values have changed.
    struct Changed {
        std::vector<const Node *> strokes;
        std::vector<const Node *> withSegments; ///< those of them whose segments have changed
        bool groups = false;                    ///< a group has another name, or is switched
        bool names = false;                     ///< a stroke or a group has another name
        bool switches =
            false; ///< a stroke is shown, hidden, locked or unlocked, or strokes were added, removed or moved
    };

    StrokesTree() : m_root(std::make_unique<Node>()) {}

    /// Takes another painting, without comparing it with the one before.
    void build(const PaintingPtr &painting);
    /// Takes the same painting after a change. What goes into another group is a row that goes and one that comes, with
    /// all that is below it.
    Changed follow(const PaintingPtr &painting, const Change &change, Listener &listener);

    /// The painting; null before the first one is built.
    const PaintingPtr &painting() const { return m_painting; }
    const Node &root() const { return *m_root; }
    /// The node of a stroke; null where there is no such stroke.
    const Node *nodeOf(StrokeId id) const;
    /// The node of a group; null where there is no such group.
    const Node *nodeOfGroup(GroupId id) const;
    /// The stroke; null where there is none.
    StrokePtr strokeOf(StrokeId id) const;
    /// The group; null where there is none.
    const Group *groupOf(GroupId id) const;
    /// Whether the group is one of `groups`, or lies in one of them.
    bool isWithin(GroupId group, const std::set<GroupId> &groups) const;
    /// The strokes that belong to a node: the stroke itself, or all in the group.
    static std::set<StrokeId> strokesBelow(const Node &node);

private:
    /// What stands below each parent from top to bottom. An entry is a stroke of the painting or a group.
    struct Entry {
        const StrokePtr *stroke = nullptr;
        GroupId group = 0;

        /// Most strokes are those that the rows have, which need not be looked at.
        bool is(const Node &node) const
        {
            return stroke ? *stroke == node.value || (*stroke)->id == node.stroke : group == node.group;
        }
    };
    using Entries = std::vector<Entry>;
    using Layout = std::unordered_map<GroupId, Entries>;

    static Layout layoutOf(const Painting &painting);
    static void renumber(Node &node, std::size_t from);
    static bool matches(const Node &node, const Entries &wanted);
    void takeGroups(const Painting &painting);
    std::unique_ptr<Node> made(const Entry &entry, Node &parent, const Layout &layout);
    void buildBelow(Node &node, const Layout &layout);
    void forget(const Node &node);
    const Node *nodeOf(const Entry &entry) const;
    /// Returns, as the two below it, whether anything has come or gone.
    bool followOrder(const Painting &painting, Listener &listener);
    bool removeMissing(Node &node, const Entries &wanted, Listener &listener);
    bool insertNew(Node &node, const Entries &wanted, const Layout &layout, Listener &listener);
    static void sortLike(Node &node, const Entries &wanted, Listener &listener);
    static void followSegments(Node &node, const Stroke &stroke, Listener &listener);
    Changed followValues(const Painting &painting, const std::vector<StrokeId> &ids, Listener &listener);

    PaintingPtr m_painting;
    std::vector<Group> m_groups;
    std::unordered_map<GroupId, std::size_t> m_places; ///< of the groups in that list
    std::unordered_map<StrokeId, Node *> m_nodes;
    std::unordered_map<GroupId, Node *> m_groupNodes;
    std::unique_ptr<Node> m_root;
};

} // namespace suffuse

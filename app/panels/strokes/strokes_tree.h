// The tree that the strokes dock shows, as a value that follows a painting.
#pragma once

#include "model/document/document.h"

#include <memory>
#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

namespace suffuse {

/// Groups and strokes, the topmost first, and how many segments each stroke has. Follows a painting by difference, and
/// tells a listener which rows come, go and move meanwhile.
class StrokesTree {
public:
    /// A row with what is below it: a group, a stroke, or the root, which is neither.
    struct Node {
        StrokeId stroke = 0;
        GroupId group = 0;
        Node *parent = nullptr;
        int row = 0;
        int segments = 0; ///< rows below a stroke
        std::vector<std::unique_ptr<Node>> children;
    };

    /// Hears of the rows before and after they change; rows are counted below a node, from `first` to `last`.
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

    /// Rows that stayed and whose values changed.
    struct Changed {
        std::vector<const Node *> strokes;
        std::vector<const Node *> withSegments; ///< of these: those of whose segments that changed
        bool groups = false;
    };

    StrokesTree() : m_root(std::make_unique<Node>()) {}

    /// Another painting, without a look at the one before.
    void build(const PaintingPtr &painting);
    /// The same painting after a change. None, and nothing is done, where its strokes are grouped in another way: then
    /// the tree is to be built anew.
    std::optional<Changed> follow(const PaintingPtr &painting, const Change &change, Listener &listener);

    /// Null before the first one is built.
    const PaintingPtr &painting() const { return m_painting; }
    const Node &root() const { return *m_root; }
    /// Null where there is no such stroke or group.
    const Node *nodeOf(StrokeId id) const;
    StrokePtr strokeOf(StrokeId id) const;
    const Group *groupOf(GroupId id) const;
    /// Whether the group is one of `groups`, or lies in one of them.
    bool isWithin(GroupId group, const std::set<GroupId> &groups) const;
    /// The stroke of a node, or all in the group.
    static std::set<StrokeId> strokesBelow(const Node &node);
    /// 0 where the group is empty.
    static StrokeId lowestStrokeOf(const Node &node);

private:
    /// What stands under each parent, top to bottom: strokes as themselves, groups marked.
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

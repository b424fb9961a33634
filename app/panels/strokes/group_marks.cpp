#include "app/panels/strokes/group_marks.h"

namespace suffuse {

namespace {

struct MarkCounts {
    int strokes = 0, hidden = 0, locked = 0;
};

Share shareOf(int marked, int all)
{
    return marked == 0 ? Share::None : marked < all ? Share::Some : Share::All;
}

class MarkCounting {
public:
    explicit MarkCounting(const StrokesTree &tree) : m_tree(tree)
    {
        for (const Group &group : tree.painting()->groups)
            m_groups.emplace(group.id, &group);
    }

    /// Counts what is below a node, and notes the marks of the groups there.
    MarkCounts countBelow(const StrokesTree::Node &node)
    {
        MarkCounts sum;
        for (const auto &child : node.children) {
            const MarkCounts part = child->stroke ? ofStroke(child->stroke) : ofGroup(*child);
            sum.strokes += part.strokes;
            sum.hidden += part.hidden;
            sum.locked += part.locked;
        }
        return sum;
    }

    MarksOfGroups marks;

private:
    MarkCounts ofStroke(StrokeId id) const
    {
        const StrokePtr stroke = m_tree.strokeOf(id);
        return {1, stroke && !stroke->visible, stroke && stroke->locked};
    }

    MarkCounts ofGroup(const StrokesTree::Node &node)
    {
        MarkCounts counts = countBelow(node);
        marks[node.group] = {shareOf(counts.hidden, counts.strokes), shareOf(counts.locked, counts.strokes)};
        if (const auto it = m_groups.find(node.group); it != m_groups.end()) {
            counts.hidden = it->second->visible ? counts.hidden : counts.strokes;
            counts.locked = it->second->locked ? counts.strokes : counts.locked;
        }
        return counts;
    }

    const StrokesTree &m_tree;
    std::unordered_map<GroupId, const Group *> m_groups;
};

} // namespace

MarksOfGroups marksOf(const StrokesTree &tree)
{
    if (!tree.painting() || tree.painting()->groups.empty())
        return {};
    MarkCounting counting(tree);
    counting.countBelow(tree.root());
    return std::move(counting.marks);
}

} // namespace suffuse

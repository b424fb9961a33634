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
    explicit MarkCounting(const StrokesTree &tree) : m_tree(tree) {}

    /// Counts what is below a node, and notes the marks of the groups there.
    MarkCounts countBelow(const StrokesTree::Node &node)
    {
        MarkCounts sum;
        for (const auto &child : node.children) {
            const MarkCounts part = child->stroke ? ofStroke(*child->value) : ofGroup(*child);
            sum.strokes += part.strokes;
            sum.hidden += part.hidden;
            sum.locked += part.locked;
        }
        return sum;
    }

    MarksOfGroups marks;

private:
    static MarkCounts ofStroke(const Stroke &stroke) { return {1, !stroke.visible, stroke.locked}; }

    MarkCounts ofGroup(const StrokesTree::Node &node)
    {
        MarkCounts counts = countBelow(node);
        marks[node.group] = {shareOf(counts.hidden, counts.strokes), shareOf(counts.locked, counts.strokes)};
        if (const Group *group = m_tree.groupOf(node.group)) {
            counts.hidden = group->visible ? counts.hidden : counts.strokes;
            counts.locked = group->locked ? counts.strokes : counts.locked;
        }
        return counts;
    }

    const StrokesTree &m_tree;
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

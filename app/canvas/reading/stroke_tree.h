// The strokes of a painting as a tree of groups, with every place found at once.
#pragma once

#include "model/painting/painting.h"

#include <unordered_map>
#include <vector>

namespace suffuse {

/// A stroke or a group.
struct TreeItem {
    StrokeId stroke = 0; ///< 0: it is a group
    GroupId group = 0;   ///< 0: it is a stroke
    friend bool operator==(const TreeItem &, const TreeItem &) = default;
};

/// Groups and strokes from bottom to top. Groups without a stroke are left out. It is made in one walk over the strokes,
/// and answers each question at once.
class StrokeTree {
public:
    StrokeTree() = default;
    explicit StrokeTree(PaintingPtr painting);

    const PaintingPtr &painting() const { return m_painting; }
    /// What stands in a group; in 0: what stands in none.
    const std::vector<TreeItem> &in(GroupId group) const;
    bool contains(const TreeItem &item) const;
    /// The group that an item stands in; 0: none.
    GroupId parentOf(const TreeItem &item) const;
    /// Its place among what stands in the same group; -1 where it is not there.
    int placeOf(const TreeItem &item) const;

private:
    struct Place {
        GroupId parent = 0;
        int index = 0;
    };
    void add(const TreeItem &item, GroupId parent);
    void addGroup(GroupId group);
    const Place *find(const TreeItem &item) const;

    PaintingPtr m_painting;
    std::unordered_map<GroupId, std::vector<TreeItem>> m_children;
    std::unordered_map<StrokeId, Place> m_strokes;
    std::unordered_map<GroupId, Place> m_groups;
};

} // namespace suffuse

// What groups can be to what is beside them and in them: clipped, a mask, a wash, or a draft.
#pragma once

#include "undo/edits.h"

#include <array>
#include <unordered_map>

namespace suffuse {

enum class GroupRole { Clipped, Mask, Wash, Draft };
inline constexpr std::array groupRoles{GroupRole::Clipped, GroupRole::Mask, GroupRole::Wash, GroupRole::Draft};

bool hasRole(const Group &group, GroupRole role);

/// Which roles the groups of a painting can have, found for all of them in one pass. The painting outlives it.
class GroupRoles {
public:
    explicit GroupRoles(const Painting &painting);

    /// Of several groups, those that have a role or can have it, and how many of them have it.
    struct State {
        std::vector<GroupId> possible;
        std::ptrdiff_t having = 0;
        bool all() const { return having > 0 && having == std::ssize(possible); }
    };
    State of(const std::vector<GroupId> &groups, GroupRole role) const;
    /// Whether a group that gets the role does something by it: for being clipped, something lies below it in the same
    /// group that is neither clipped nor a mask; for being a mask, anything is beside it there; and no wash is around a
    /// wash. Any group can be a draft.
    bool canHave(const Group &group, GroupRole role) const;
    /// The wash that a group becomes: style and mixing of its lowest stroke that is not filled, or else of its lowest
    /// one.
    Wash usualWash(GroupId group) const;

private:
    struct Facts {
        const Group *group = nullptr;   ///< null: what is in no group
        bool isEntered = false;         ///< whether a stroke in it was passed
        bool hasBase = false;           ///< whether something in it can be clipped to
        bool isOverBase = false;        ///< whether that lay below it when it was entered
        std::size_t things = 0;         ///< strokes and groups directly in it
        const Stroke *lowest = nullptr; ///< not a filled one, if it has another
    };
    void enter(Facts &facts);
    void noteLowest(const Stroke &stroke);
    const Facts *factsOf(GroupId group) const;

    std::unordered_map<GroupId, Facts> m_facts;
};

/// Gives the role to those of the groups that can have it, or takes it from all of them. Groups that are locked stay as
/// they were, and so do washes that are there.
Edit setGroupRole(const Document &document, const std::vector<GroupId> &groups, GroupRole role, bool on);
/// Marks groups that are not locked with a colour.
Edit setGroupTag(const Document &document, const std::vector<GroupId> &groups, GroupTag tag);

} // namespace suffuse

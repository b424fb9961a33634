// Which strokes of a painting are locked, and which may be changed: found once for many strokes.
#pragma once

#include "model/painting/painting.h"

namespace suffuse {

/// Which strokes of a painting are locked, by themselves or by a group around them.
class Locks {
public:
    Locks() = default; ///< none but what is locked by itself
    explicit Locks(const std::vector<Group> &groups);

    bool operator()(const Stroke &stroke) const { return stroke.locked || (*this)(stroke.group); }
    /// Of a group; what is in none is not locked by one.
    bool operator()(GroupId group) const { return group != 0 && m_locked.contains(group); }

private:
    std::unordered_set<GroupId> m_locked;
};

/// Which strokes of a painting tools may change: those that are visible and not locked.
class Editable {
public:
    explicit Editable(const std::vector<Group> &groups) : m_isVisible(groups), m_isLocked(groups) {}

    bool operator()(const Stroke &stroke) const { return m_isVisible(stroke) && !m_isLocked(stroke); }

private:
    Visibility m_isVisible;
    Locks m_isLocked;
};

} // namespace suffuse

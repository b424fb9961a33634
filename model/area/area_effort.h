// A bound for the work on areas that others drew.
#pragma once

#include <algorithm>
#include <cstdint>

namespace suffuse {

/// How much work on areas is left, in steps of a few nanoseconds. Who takes outlines from files that others made hands
/// one to all calls. Once it is spent, calls return at once, with parts of what they should return, or nothing.
class AreaEffort {
public:
    explicit AreaEffort(std::uint64_t steps) : m_left(steps) {}

    std::uint64_t left() const { return m_left; }
    bool isSpent() const { return m_left == 0; }
    /// Takes steps. Returns whether any are left.
    bool spend(std::uint64_t steps)
    {
        m_left -= std::min(steps, m_left);
        return m_left > 0;
    }

private:
    std::uint64_t m_left;
};

/// The same where there may be no bound.
inline bool spend(AreaEffort *effort, std::uint64_t steps)
{
    return !effort || effort->spend(steps);
}

} // namespace suffuse

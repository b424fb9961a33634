// A bound for the work on areas that others drew.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>

namespace suffuse {

/// How much work on areas is left, in steps of a few nanoseconds. Who takes outlines from files that others made hands
/// one to all calls. Once it is spent, calls return at once, with parts of what they should return, or nothing.
class AreaEffort {
public:
    explicit AreaEffort(std::uint64_t steps) : m_left(steps) {}
    /// Work that somebody may stop: all is spent once `stop`, if there is one, becomes true.
    explicit AreaEffort(const std::atomic<bool> *stop) : m_left(std::numeric_limits<std::uint64_t>::max()), m_stop(stop)
    {}

    std::uint64_t left() const { return m_left; }
    bool isSpent() const { return m_left == 0; }
    /// Takes steps. Returns whether any are left.
    bool spend(std::uint64_t steps)
    {
        m_left -= m_stop && m_stop->load(std::memory_order_relaxed) ? m_left : std::min(steps, m_left);
        return m_left > 0;
    }

private:
    std::uint64_t m_left;
    const std::atomic<bool> *m_stop = nullptr;
};

/// The same where there may be no bound.
inline bool spend(AreaEffort *effort, std::uint64_t steps)
{
    return !effort || effort->spend(steps);
}

} // namespace suffuse

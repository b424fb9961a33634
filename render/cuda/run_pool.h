// A pool hands out runs of records in one array, and takes them back.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace suffuse::cuda {

/// Stands for `count` records from `begin` on, with room for `room`.
struct Run {
    std::uint32_t begin = 0, count = 0, room = 0;
};

/// Rooms are rounded up by at most a quarter, so that another run fits where one has been.
class RunPool {
public:
    /// Returns the length of the array.
    std::size_t size() const { return m_size; }
    /// Returns the number of records for which runs have room.
    std::size_t used() const { return m_used; }

    /// Makes a run have `count` records, which may then lie elsewhere.
    void fit(Run &run, std::uint32_t count)
    {
        if (count > run.room || 4 * std::uint64_t(count) < run.room) {
            give(run);
            run = take(count);
        }
        run.count = count;
    }
    void give(Run &run)
    {
        if (run.room)
            m_free[run.room].push_back(run.begin);
        m_used -= run.room;
        run = {};
    }
    void clear() { *this = {}; }

private:
    Run take(std::uint32_t count)
    {
        if (count == 0)
            return {};
        const std::uint32_t step = std::bit_floor(std::max(count, 8u)) / 4, room = (count + step - 1) / step * step;
        m_used += room;
        if (auto &free = m_free[room]; !free.empty()) {
            const std::uint32_t begin = free.back();
            free.pop_back();
            return {begin, count, room};
        }
        const auto begin = std::uint32_t(m_size);
        m_size += room;
        return {begin, count, room};
    }

    std::size_t m_size = 0, m_used = 0;
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> m_free; ///< where free runs begin, by their room
};

} // namespace suffuse::cuda

// Work on several cores where no task library is needed.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace suffuse {

/// Calls body(0) … body(count − 1), each once, on as many threads as there are cores, and returns when all are done.
/// Threads are made for the call, so it is meant for work that takes milliseconds or more.
template <typename Body>
void forEachInParallel(std::size_t count, const Body &body)
{
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t k = next++; k < count; k = next++)
            body(k);
    };
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::jthread> others; // They are joined at the end of the scope.
    for (std::size_t k = 1; k < std::min(cores, count); ++k)
        others.emplace_back(work);
    work();
}

} // namespace suffuse

#pragma once

#include <cstddef>
#include <functional>

namespace suffuse {

/// Cores of this machine, at least 1.
int hardwareThreads();

/// Calls body(0) … body(count − 1), each once, on up to `threads` threads (0: all cores); returns when all are done.
/// The one seam to the task library: oneTBB, or std::jthread where SUFFUSE_JTHREAD is defined.
void parallelFor(std::size_t count, int threads, const std::function<void(std::size_t)> &body);

} // namespace suffuse

#include "render/parallel.h"

#include <algorithm>
#include <thread>

#ifdef SUFFUSE_JTHREAD
#include <atomic>
#include <vector>
#else
#include <optional>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace suffuse {

int hardwareThreads()
{
    return std::max(1, int(std::thread::hardware_concurrency()));
}

void parallelFor(std::size_t count, int threads, const std::function<void(std::size_t)> &body)
{
    threads = threads > 0 ? threads : hardwareThreads();
    if (threads == 1 || count < 2) {
        for (std::size_t i = 0; i < count; ++i)
            body(i);
        return;
    }
#ifdef SUFFUSE_JTHREAD
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++)
            body(i);
    };
    std::vector<std::jthread> pool;
    for (int i = 1; i < threads; ++i)
        pool.emplace_back(work);
    work();
#else
    std::optional<tbb::global_control> more; // by itself oneTBB starts a thread a core
    if (threads > hardwareThreads())
        more.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
    tbb::task_arena arena(threads);
    arena.execute([&] { tbb::parallel_for(std::size_t(0), count, body); });
#endif
}

} // namespace suffuse

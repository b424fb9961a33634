#include "render/threads/parallel.h"

#include "render/threads/crew.h"

#include <algorithm>
#include <thread>
#include <utility>

#ifdef SUFFUSE_JTHREAD
#include <atomic>
#include <vector>
#else
#include <optional>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace suffuse {

#ifndef SUFFUSE_JTHREAD
namespace {

/// Marks that a thread is in the body of a loop. Loops in there share the outer loop's threads.
class InLoop {
public:
    InLoop() : m_before(std::exchange(s_now, true)) {}
    ~InLoop() { s_now = m_before; }
    InLoop(const InLoop &) = delete;
    InLoop &operator=(const InLoop &) = delete;
    static bool now() { return s_now; }

private:
    static inline thread_local bool s_now = false;
    const bool m_before; // A thread that waits for an inner loop may run more bodies of the outer one.
};

/// The arena of a calling thread. After a loop, oneTBB's threads wait in it for the next one for a while; into a new
/// arena they must be woken, which takes as long as a small loop.
tbb::task_arena &arenaOf(int threads)
{
    thread_local std::optional<tbb::task_arena> arena;
    if (!arena || arena->max_concurrency() != threads)
        arena.emplace(threads);
    return *arena;
}

} // namespace
#endif

int hardwareThreads()
{
    // It is asked once, since each call reads a file. oneTBB counts the cores that this process may use, and warns on
    // the error output if it is asked for more threads.
#ifdef SUFFUSE_JTHREAD
    static const int threads = std::max(1, int(std::thread::hardware_concurrency()));
#else
    static const int threads = std::max(1, tbb::info::default_concurrency());
#endif
    return threads;
}

Threads Threads::within(std::size_t bodies) const
{
    return bodies < 2 ? *this : Threads(std::max(1, m_count / int(bodies)));
}

void parallelFor(std::size_t count, const Threads &on, const std::function<void(std::size_t)> &body)
{
    const int threads = on.count();
    if (threads == 1 || count < 2) {
        for (std::size_t i = 0; i < count; ++i)
            body(i);
        return;
    }
    if (on.crew())
        return on.crew()->run(count, threads, body);
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
    const auto loop = [&] {
        tbb::parallel_for(std::size_t(0), count, [&](std::size_t i) {
            const InLoop inLoop;
            body(i);
        });
    };
    if (InLoop::now())
        return loop();
    std::optional<tbb::global_control> more; // By itself oneTBB starts one thread for each core.
    if (threads > hardwareThreads())
        more.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
    arenaOf(threads).execute(loop);
#endif
}

} // namespace suffuse

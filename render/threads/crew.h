// Threads for a renderer whose frames follow each other within milliseconds. They wait awake for the next loop.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace suffuse {

/// Waking a thread that sleeps takes as long as all loops of a small frame. So these threads fall asleep only when
/// nothing has come for longer than the time between frames at 500 a second. Between loops they yield the core to
/// whoever else wants it.
class Crew {
public:
    using Body = std::function<void(std::size_t)>;

    /// `threads` includes the calling thread. The others start with the first loop.
    explicit Crew(int threads);
    Crew(const Crew &) = delete;
    Crew &operator=(const Crew &) = delete;
    ~Crew();

    /// Runs a loop as parallelFor does, which calls it. Only one thread may call it at a time, and never from within a
    /// body (Threads::within).
    void run(std::size_t count, int threads, const Body &body);

private:
    struct Loop {
        std::size_t count = 0;
        const Body &body;
        std::atomic<int> room;            ///< how many more threads may join
        std::atomic<std::size_t> next{0}; ///< the next index to be done
        std::mutex failing;
        std::exception_ptr failure; ///< the first failure
    };
    void serve();
    /// Takes part in the present loop, if there is one.
    void help();
    static void work(Loop &loop);
    /// Waits until something was posted after `seen`.
    void await(std::uint32_t seen) const;

    const int m_size;
    std::atomic<Loop *> m_loop{nullptr};
    std::atomic<std::uint32_t> m_posted{0}; ///< the number of loops so far
    std::atomic<int> m_inside{0};           ///< the number of threads that may look at m_loop
    std::atomic<bool> m_end{false};
    std::vector<std::thread> m_threads;
};

} // namespace suffuse

// Threads for a renderer whose frames follow each other within milliseconds: they wait awake for the next loop.
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

/// Waking a thread that sleeps takes as long as all loops of a small frame; so these fall asleep only when nothing came
/// for longer than frames at 500 a second are apart. Between loops they yield to whoever else wants the core.
class Crew {
public:
    using Body = std::function<void(std::size_t)>;

    /// `threads`: with the calling one; they start with the first loop.
    explicit Crew(int threads);
    Crew(const Crew &) = delete;
    Crew &operator=(const Crew &) = delete;
    ~Crew();

    /// As parallelFor, which calls it. One thread at a time, and not from within a body (Threads::within).
    void run(std::size_t count, int threads, const Body &body);

private:
    struct Loop {
        std::size_t count = 0;
        const Body &body;
        std::atomic<int> room;            ///< for so many more threads
        std::atomic<std::size_t> next{0}; ///< index to be done
        std::mutex failing;
        std::exception_ptr failure; ///< the first one
    };
    void serve();
    /// Takes part in the loop that is there, if any.
    void help();
    static void work(Loop &loop);
    /// Until something was posted after `seen`.
    void await(std::uint32_t seen) const;

    const int m_size;
    std::atomic<Loop *> m_loop{nullptr};
    std::atomic<std::uint32_t> m_posted{0}; ///< loops so far
    std::atomic<int> m_inside{0};           ///< threads that may look at m_loop
    std::atomic<bool> m_end{false};
    std::vector<std::thread> m_threads;
};

} // namespace suffuse

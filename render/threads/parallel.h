// Loops over many threads: the one interface to them, and which threads run which loop.
//
// | loop | runs on | why |
// |---|---|---|
// | parallelFor with a number of threads | oneTBB | Tiles and strokes cost unevenly, and oneTBB balances them. |
// | the same, built with SUFFUSE_JTHREAD | std::jthread | ThreadSanitizer reports races of oneTBB that are none. |
// | parallelFor with a crew (crew.h) | the crew's threads | Loops of a CUDA frame end sooner than oneTBB wakes up. |
// | forEachInParallel (model/parallel.h) | threads made for the call | Model reads and writes files without oneTBB. |
//
// Two places have threads of their own, since these wait for each other instead of sharing a loop: a CudaRenderer has
// one for each further device, and render/sequence.h draws pictures while the ones before are written.
#pragma once

#include <cstddef>
#include <functional>

namespace suffuse {

class Crew;

/// The number of cores that this process may use, at least 1.
int hardwareThreads();

/// The threads on which the loops of a task run. Whoever begins the task chooses them, and hands them to all code that
/// has loops.
class Threads {
public:
    /// At most `count` threads, or one for each core if it is 0. They are those of `crew` if there is one, and of the
    /// task library otherwise.
    Threads(int count = 0, Crew *crew = nullptr) : m_count(count > 0 ? count : hardwareThreads()), m_crew(crew) {}

    int count() const { return m_count; } ///< at least 1
    Crew *crew() const { return m_crew; }
    /// The threads that each body of a loop of `bodies` has for loops of its own. A crew runs one loop at a time, so
    /// bodies that run at the same time have no further threads.
    Threads within(std::size_t bodies) const;

private:
    int m_count;
    Crew *m_crew;
};

/// Calls body(0) … body(count − 1), each once, and returns when all are done.
void parallelFor(std::size_t count, const Threads &on, const std::function<void(std::size_t)> &body);

} // namespace suffuse

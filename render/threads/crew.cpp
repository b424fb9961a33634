#include "render/threads/crew.h"

#include "render/threads/parallel.h"

#include <algorithm>
#include <chrono>

namespace suffuse {

namespace {

constexpr std::chrono::milliseconds awake{2};
constexpr int mostThreads = 12; // More threads would share too little work of a frame to pay for waking them.

} // namespace

Crew::Crew(int threads) : m_size(std::min({threads, hardwareThreads(), mostThreads})) {}

Crew::~Crew()
{
    m_end = true;
    ++m_posted;
    m_posted.notify_all();
    for (std::thread &thread : m_threads)
        thread.join();
}

void Crew::work(Loop &loop)
{
    try {
        for (std::size_t i = loop.next++; i < loop.count; i = loop.next++)
            loop.body(i);
    } catch (...) {
        loop.next = loop.count;
        const std::lock_guard lock(loop.failing);
        if (!loop.failure)
            loop.failure = std::current_exception();
    }
}

void Crew::help()
{
    // This comes before the loop is looked at, since run() takes the loop away first and then waits for all that are
    // inside.
    ++m_inside;
    if (Loop *loop = m_loop; loop && loop->next < loop->count && loop->room-- > 0)
        work(*loop);
    --m_inside;
}

void Crew::await(std::uint32_t seen) const
{
    const auto until = std::chrono::steady_clock::now() + awake;
    while (m_posted == seen) {
        std::this_thread::yield();
        if (std::chrono::steady_clock::now() > until)
            return m_posted.wait(seen);
    }
}

void Crew::serve()
{
    for (;;) {
        const std::uint32_t seen = m_posted;
        if (m_end) // It is set before the last post.
            return;
        help();
        await(seen);
    }
}

void Crew::run(std::size_t count, int threads, const Body &body)
{
    while (int(m_threads.size()) < m_size - 1)
        m_threads.emplace_back([this] { serve(); });
    Loop loop{count, body, int(std::min(std::size_t(threads), count)) - 1, {}, {}, {}};
    m_loop = &loop;
    ++m_posted;
    m_posted.notify_all();
    work(loop);
    m_loop = nullptr;
    while (m_inside > 0)
        std::this_thread::yield();
    if (loop.failure)
        std::rethrow_exception(loop.failure);
}

} // namespace suffuse

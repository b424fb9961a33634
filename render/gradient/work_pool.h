// Memory of threads that draw tiles.
#pragma once

#include "render/gradient/tile_work.h"

#include <memory>
#include <mutex>

namespace suffuse::gradient {

/// Lends each thread memory to work in. Which memory it is changes nothing.
template <class Number>
class WorkPool {
public:
    class Loan {
    public:
        explicit Loan(WorkPool &pool) : m_pool(pool), m_work(pool.take()) {}
        Loan(const Loan &) = delete;
        Loan &operator=(const Loan &) = delete;
        ~Loan() { m_pool.giveBack(std::move(m_work)); }
        TileWork<Number> &operator*() const { return *m_work; }

    private:
        WorkPool &m_pool;
        std::unique_ptr<TileWork<Number>> m_work;
    };

private:
    std::unique_ptr<TileWork<Number>> take()
    {
        const std::scoped_lock lock(m_mutex);
        if (m_free.empty())
            return std::make_unique<TileWork<Number>>();
        auto work = std::move(m_free.back());
        m_free.pop_back();
        return work;
    }
    void giveBack(std::unique_ptr<TileWork<Number>> work)
    {
        const std::scoped_lock lock(m_mutex);
        m_free.push_back(std::move(work));
    }

    std::mutex m_mutex;
    std::vector<std::unique_ptr<TileWork<Number>>> m_free;
};

} // namespace suffuse::gradient

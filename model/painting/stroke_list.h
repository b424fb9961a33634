// The strokes in order, as a sequence whose copies share what none of them has written to since.
#pragma once

#include "model/painting/stroke.h"

#include <QList>

#include <compare>
#include <initializer_list>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace suffuse {

/// Behaves like a vector of strokes. It consists of blocks, which copies share until one of them writes to a block. So
/// a snapshot of 10,000 strokes costs 157 pointers, and two snapshots are compared by blocks. As with a vector, a
/// shared list may be read from several threads, but not written to.
class StrokeList {
    template <class List, class Reference>
    class Cursor;

public:
    using value_type = StrokePtr;
    using reference = StrokePtr &;
    using const_reference = const StrokePtr &;
    using iterator = Cursor<StrokeList, reference>;
    using const_iterator = Cursor<const StrokeList, const_reference>;
    using const_reverse_iterator = std::reverse_iterator<const_iterator>;
    using difference_type = std::ptrdiff_t;
    using size_type = std::size_t;

    StrokeList() = default;
    StrokeList(std::initializer_list<StrokePtr> strokes) : StrokeList(strokes.begin(), strokes.end()) {}
    template <class It>
    StrokeList(It from, It to)
    {
        for (; from != to; ++from)
            push_back(*from);
    }

    std::size_t size() const
    {
        return m_blocks.empty() ? 0 : (m_blocks.size() - 1) * blockSize + std::size_t(m_blocks.back().size());
    }
    bool empty() const { return m_blocks.empty(); }

    const StrokePtr &operator[](std::size_t i) const { return m_blocks[i / blockSize][qsizetype(i % blockSize)]; }
    /// Throws std::out_of_range.
    const StrokePtr &at(std::size_t i) const
    {
        if (i >= size())
            throw std::out_of_range("StrokeList::at");
        return (*this)[i];
    }
    /// A write access makes the block this list's own.
    StrokePtr &operator[](std::size_t i) { return m_blocks[i / blockSize][qsizetype(i % blockSize)]; }
    const StrokePtr &front() const { return (*this)[0]; }
    StrokePtr &front() { return (*this)[0]; }
    const StrokePtr &back() const { return (*this)[size() - 1]; }
    StrokePtr &back() { return (*this)[size() - 1]; }

    const_iterator begin() const;
    const_iterator end() const;
    iterator begin();
    iterator end();
    const_iterator cbegin() const;
    const_iterator cend() const;
    const_reverse_iterator rbegin() const;
    const_reverse_iterator rend() const;

    void clear() { m_blocks.clear(); }
    void push_back(StrokePtr stroke)
    {
        if (size() % blockSize == 0)
            m_blocks.emplace_back().reserve(blockSize);
        m_blocks.back().push_back(std::move(stroke));
    }
    void pop_back()
    {
        m_blocks.back().pop_back();
        if (m_blocks.back().isEmpty())
            m_blocks.pop_back();
    }
    /// Strokes that are added are null.
    void resize(std::size_t n);
    /// The cost is in proportion to what lies above the place.
    iterator insert(const_iterator place, StrokePtr stroke);
    iterator erase(const_iterator place);

    /// Calls visit(i) for the places where two lists of equal size have different strokes. A shared block costs one
    /// comparison.
    template <class Visit>
    void forEachDifference(const StrokeList &other, Visit visit) const
    {
        for (std::size_t b = 0; b < m_blocks.size(); ++b) {
            if (m_blocks[b].isSharedWith(other.m_blocks[b]))
                continue;
            for (qsizetype i = 0; i < m_blocks[b].size(); ++i)
                if (m_blocks[b][i] != other.m_blocks[b][i])
                    visit(b * blockSize + std::size_t(i));
        }
    }

private:
    static constexpr std::size_t blockSize = 64;
    std::vector<QList<StrokePtr>> m_blocks; ///< all are full except the last, and none is empty
};

/// A place in a list, as an index. Writing to the list does not move it.
template <class List, class Reference>
class StrokeList::Cursor {
public:
    using iterator_category = std::random_access_iterator_tag;
    using value_type = StrokePtr;
    using difference_type = std::ptrdiff_t;
    using reference = Reference;
    using pointer = std::remove_reference_t<Reference> *;

    Cursor() = default;
    Cursor(List *list, std::size_t index) : m_list(list), m_index(index) {}
    operator Cursor<const StrokeList, const_reference>() const { return {m_list, m_index}; }

    std::size_t index() const { return m_index; }
    Reference operator*() const { return (*m_list)[m_index]; }
    pointer operator->() const { return &**this; }
    Reference operator[](difference_type n) const { return *(*this + n); }
    Cursor &operator+=(difference_type n) { return m_index += std::size_t(n), *this; }
    Cursor &operator-=(difference_type n) { return m_index -= std::size_t(n), *this; }
    Cursor &operator++() { return ++m_index, *this; }
    Cursor &operator--() { return --m_index, *this; }
    Cursor operator++(int) { return {m_list, m_index++}; }
    Cursor operator--(int) { return {m_list, m_index--}; }
    friend Cursor operator+(Cursor c, difference_type n) { return c += n; }
    friend Cursor operator+(difference_type n, Cursor c) { return c += n; }
    friend Cursor operator-(Cursor c, difference_type n) { return c -= n; }
    friend difference_type operator-(const Cursor &a, const Cursor &b) { return difference_type(a.m_index - b.m_index); }
    friend bool operator==(const Cursor &a, const Cursor &b) { return a.m_index == b.m_index; }
    friend auto operator<=>(const Cursor &a, const Cursor &b) { return a.m_index <=> b.m_index; }

private:
    List *m_list = nullptr;
    std::size_t m_index = 0;
};

inline StrokeList::const_iterator StrokeList::begin() const
{
    return {this, 0};
}
inline StrokeList::const_iterator StrokeList::end() const
{
    return {this, size()};
}
inline StrokeList::iterator StrokeList::begin()
{
    return {this, 0};
}
inline StrokeList::iterator StrokeList::end()
{
    return {this, size()};
}
inline StrokeList::const_iterator StrokeList::cbegin() const
{
    return begin();
}
inline StrokeList::const_iterator StrokeList::cend() const
{
    return end();
}
inline StrokeList::const_reverse_iterator StrokeList::rbegin() const
{
    return const_reverse_iterator(end());
}
inline StrokeList::const_reverse_iterator StrokeList::rend() const
{
    return const_reverse_iterator(begin());
}

inline void StrokeList::resize(std::size_t n)
{
    while (size() > n)
        pop_back();
    while (size() < n)
        push_back({});
}

inline StrokeList::iterator StrokeList::insert(const_iterator place, StrokePtr stroke)
{
    const iterator at = begin() + std::ptrdiff_t(place.index());
    push_back(std::move(stroke));
    for (iterator i = end() - 1; i != at; --i)
        std::swap(*i, *(i - 1));
    return at;
}

inline StrokeList::iterator StrokeList::erase(const_iterator place)
{
    const iterator at = begin() + std::ptrdiff_t(place.index());
    for (iterator i = at; i + 1 != end(); ++i)
        std::swap(*i, *(i + 1));
    pop_back();
    return at;
}

} // namespace suffuse

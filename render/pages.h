// Memory of pictures: zero, and free of cost before it is first written.
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace suffuse {

/// Zeroed memory, which the system hands out page by page when it is first touched. Large pieces are asked for in pages
/// of 2 MiB, of which a picture of 16384 × 12288 pixels has a thousand instead of half a million. Throws
/// std::bad_alloc.
void *freshPages(std::size_t bytes);
void releasePages(void *pages) noexcept;

/// For vectors that are zero without anybody writing the zeros: threads that draw a picture touch its memory first, at
/// once, and each where it draws. `Pixels(n)` are n zeros. A vector that shrinks and grows again keeps what was there.
template <class T>
struct FreshPages {
    using value_type = T;

    FreshPages() = default;
    template <class U>
    FreshPages(const FreshPages<U> &)
    {}

    T *allocate(std::size_t n)
    {
        if (n > std::size_t(-1) / sizeof(T))
            throw std::bad_alloc();
        return static_cast<T *>(freshPages(n * sizeof(T)));
    }
    void deallocate(T *p, std::size_t) noexcept { releasePages(p); }

    template <class U>
    void construct(U *) noexcept
    {}
    template <class U, class... Values>
    void construct(U *p, Values &&...values)
    {
        ::new (static_cast<void *>(p)) U(std::forward<Values>(values)...);
    }

    friend bool operator==(const FreshPages &, const FreshPages &) { return true; }
};

template <class T>
using Pixels = std::vector<T, FreshPages<T>>;

} // namespace suffuse

// Vectors whose `resize` does not set what it adds. They are for large ones that several threads write at once.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace suffuse {

template <class T>
struct UnsetAllocator : std::allocator<T> {
    template <class U>
    struct rebind {
        using other = UnsetAllocator<U>;
    };
    void construct(T *) noexcept { static_assert(std::is_trivially_copyable_v<T>); }
    template <class... Arguments>
    void construct(T *at, Arguments &&...arguments)
    {
        std::construct_at(at, std::forward<Arguments>(arguments)...);
    }
};

/// What `resize` adds must be written before it is read.
template <class T>
using UnsetVector = std::vector<T, UnsetAllocator<T>>;

} // namespace suffuse

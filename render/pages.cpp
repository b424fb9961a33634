#include "render/pages.h"

#include <cstdint>
#include <cstdlib>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace suffuse {

void *freshPages(std::size_t bytes)
{
    void *pages = std::calloc(bytes, 1);
    if (!pages && bytes > 0)
        throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    constexpr std::uintptr_t huge = std::uintptr_t(1) << 21;
    const std::uintptr_t begin = (std::uintptr_t(pages) + huge - 1) & ~(huge - 1),
                         end = (std::uintptr_t(pages) + bytes) & ~(huge - 1);
    if (begin + huge < end) // Only a wish: where the system cannot, its usual pages serve.
        madvise(reinterpret_cast<void *>(begin), end - begin, MADV_HUGEPAGE);
#endif
    return pages;
}

void releasePages(void *pages) noexcept
{
    std::free(pages);
}

} // namespace suffuse

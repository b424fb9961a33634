// How the functions of modules fail.
#pragma once

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <string>

namespace suffuse {

/// Puts the message into `error` (cut to `size` bytes), and returns false.
inline bool fail(char *error, std::size_t size, const std::string &message)
{
    if (size > 0) {
        const std::size_t n = std::min(size - 1, message.size());
        std::memcpy(error, message.data(), n);
        error[n] = 0;
    }
    return false;
}

/// Calls a function so that no exception leaves the module.
template <typename Work>
bool guarded(const Work &work, char *error, std::size_t size)
{
    try {
        return work();
    } catch (const std::bad_alloc &) {
        return fail(error, size, "there is not enough memory");
    } catch (const std::exception &e) {
        return fail(error, size, e.what());
    } catch (...) {
        return fail(error, size, "unknown failure");
    }
}

} // namespace suffuse

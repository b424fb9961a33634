// Preloaded (LD_PRELOAD), it lets system calls that bring files to the disk fail, by the environment variable
//   SUFFUSE_FAULT="CALL N ERRNO LAST"    calls number N to LAST of CALL fail; a write that fails may have put down a
//   part
// Armed and disarmed by the program, so that only what is tested meets faults.
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <sys/types.h>

namespace {

struct Fault {
    char call[16] = "";
    int first = 0, error = 0, last = 0;
    int count = 0, hits = 0;
    bool armed = false;
};

Fault &fault()
{
    static Fault f = [] {
        Fault read;
        const char *text = std::getenv("SUFFUSE_FAULT");
        if (text)
            std::sscanf(text, "%15s %d %d %d", read.call, &read.first, &read.error, &read.last);
        return read;
    }();
    return f;
}

bool fails(const char *call)
{
    Fault &f = fault();
    if (!f.armed || std::strcmp(f.call, call) != 0)
        return false;
    ++f.count;
    if (f.count < f.first || f.count > f.last)
        return false;
    ++f.hits;
    errno = f.error;
    return true;
}

template <typename Function>
Function real(const char *name)
{
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

} // namespace

extern "C" {

void suffuseArmFaults(int on)
{
    fault().armed = on != 0;
}

int suffuseFaultHits()
{
    return fault().hits;
}

ssize_t write(int file, const void *bytes, size_t size)
{
    static const auto call = real<ssize_t (*)(int, const void *, size_t)>("write");
    if (file <= 2 || !fails("write"))
        return call(file, bytes, size);
    const int error = errno;
    if (size > 1 && error == ENOSPC)
        (void)!call(file, bytes, size / 2); // what a full disk takes before it says so
    errno = error;
    return -1;
}

int fsync(int file)
{
    static const auto call = real<int (*)(int)>("fsync");
    return fails("fsync") ? -1 : call(file);
}

int fdatasync(int file)
{
    static const auto call = real<int (*)(int)>("fdatasync");
    return fails("fdatasync") ? -1 : call(file);
}

int rename(const char *from, const char *to)
{
    static const auto call = real<int (*)(const char *, const char *)>("rename");
    return fails("rename") ? -1 : call(from, to);
}

int link(const char *from, const char *to)
{
    static const auto call = real<int (*)(const char *, const char *)>("link");
    return fails("link") ? -1 : call(from, to);
}
}

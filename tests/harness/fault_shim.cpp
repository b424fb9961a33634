// Preloaded (LD_PRELOAD), it lets system calls that bring files to the disk fail, by the environment variable
//   SUFFUSE_FAULT="CALL N ERRNO LAST"    calls number N to LAST of CALL fail; a write that fails may have put down a
//   part
// Armed and disarmed by the program, so that only what is tested meets faults.
//
// It also keeps what the power could not take (SUFFUSE_DISK names the folder that stands for the disk, SUFFUSE_DURABLE
// one beside it): in files named after inodes their contents as of their last fsync, in `names` the folder's entries as
// of its own last fsync, "inode name" a line.
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

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

/// Brings one file's contents, or the names in the disk's folder, to what is kept. Each change there is one rename.
void keep(int file)
{
    namespace fs = std::filesystem;
    static const char *const disk = std::getenv("SUFFUSE_DISK"), *const durable = std::getenv("SUFFUSE_DURABLE");
    static std::mutex one;
    struct stat info {};
    if (!disk || !durable || ::fstat(file, &info) != 0)
        return;
    const std::lock_guard lock(one);
    const fs::path to = durable, fresh = to / "fresh", open = "/proc/self/fd/" + std::to_string(file);
    std::error_code ignored;
    if (S_ISDIR(info.st_mode) && fs::equivalent(open, disk, ignored)) {
        std::ofstream names(fresh);
        for (const fs::directory_entry &entry : fs::directory_iterator(disk)) {
            struct stat named {};
            if (::stat(entry.path().c_str(), &named) == 0)
                names << named.st_ino << ' ' << entry.path().filename().string() << '\n';
        }
        names.close();
        fs::rename(fresh, to / "names");
    } else if (S_ISREG(info.st_mode) && fs::equivalent(fs::read_symlink(open, ignored).parent_path(), disk, ignored)) {
        const std::string inode = std::to_string(info.st_ino);
        fs::copy_file(open, fresh, fs::copy_options::overwrite_existing);
        // A link to the file itself, so that its inode means no other file once it is deleted.
        (void)::linkat(AT_FDCWD, open.c_str(), AT_FDCWD, (to / ("held" + inode)).c_str(), AT_SYMLINK_FOLLOW);
        fs::rename(fresh, to / inode);
    }
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
    const int result = fails("fsync") ? -1 : call(file);
    if (result == 0)
        keep(file);
    return result;
}

int fdatasync(int file)
{
    static const auto call = real<int (*)(int)>("fdatasync");
    const int result = fails("fdatasync") ? -1 : call(file);
    if (result == 0)
        keep(file);
    return result;
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

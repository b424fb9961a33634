// Every test program is linked with this. Before its main begins, the program gets folders of its own in place of the
// user's, so that no test reads or changes what the person who runs it has, nor what a test beside it does. What a test
// wants otherwise it sets itself. The platform (QT_QPA_PLATFORM) is set by tests/CMakeLists.txt: some need a screen.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace {

constexpr const char *marker = "SUFFUSE_TEST_FOLDER";

class OwnFolders {
public:
    OwnFolders()
    {
        if (std::getenv(marker)) // a test started this program, and has set what it wants
            return;
        std::string folder = (std::filesystem::temp_directory_path() / "suffuse-test-XXXXXX").string();
        if (!::mkdtemp(folder.data())) {
            std::perror("no folder for the test");
            std::abort();
        }
        m_folder = folder;
        ::setenv(marker, folder.c_str(), 1);
        ::setenv("HOME", folder.c_str(), 1);
        ::setenv("SUFFUSE_SETTINGS", (folder + "/settings.ini").c_str(), 1);
        ::setenv("SUFFUSE_JOURNALS", (folder + "/journals").c_str(), 1);
        // Qt Test stops a function after five minutes, which says nothing about it where a machine does other work, too.
        // What hangs is stopped by ctest.
        ::setenv("QTEST_FUNCTION_TIMEOUT", "36000000", 0);
        for (const char *name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME"})
            ::unsetenv(name); // they follow HOME
    }
    ~OwnFolders()
    {
        std::error_code ignored;
        if (::getpid() == m_owner && !m_folder.empty()) // not in what it forks
            std::filesystem::remove_all(m_folder, ignored);
    }
    OwnFolders(const OwnFolders &) = delete;
    OwnFolders &operator=(const OwnFolders &) = delete;

private:
    const pid_t m_owner = ::getpid();
    std::filesystem::path m_folder;
};

const OwnFolders ownFolders;

} // namespace

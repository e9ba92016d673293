#ifndef TICKER_TESTS_SUPPORT_COMPILERCACHE_H
#define TICKER_TESTS_SUPPORT_COMPILERCACHE_H

#include <grader/tests/support/RunCommand.h>

#include <filesystem>
#include <string>

namespace ticker::tests {

/// Options for bwrap that give a jail the user's ccache, and let CMake compile with it: a package
/// whose files are those of the last time compiles in seconds. Empty where ccache is not installed.
/// @param where  The cache's folder in the jail. Paths in the jail have to be the same each time:
///               to ccache another path is another file.
[[nodiscard]] inline std::string compilerCacheFor(const std::string& where) {
    CommandResult folder = runCommand("ccache --get-config cache_dir");
    if (folder.status != 0) return "";
    folder.output.erase(folder.output.find_last_not_of('\n') + 1);
    std::filesystem::create_directories(folder.output);
    return "--bind '" + folder.output + "' " + where + " --setenv CCACHE_DIR " + where +
           " --setenv CMAKE_CXX_COMPILER_LAUNCHER ccache ";
}

}  // namespace ticker::tests

#endif

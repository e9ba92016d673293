#include "CleanRoot.h"

#include <grader/base/ShellQuoted.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace ticker::tests {
namespace {

namespace fs = std::filesystem;

// Jails of root reserve their uids by locks in this folder (grader/sandbox/UserSlots.cpp). The
// clean root shares it, so that graders of other tests can run at the same time.
std::string sharedLocks() {
    constexpr const char* kLocks = "/run/ticker";
    if (geteuid() != 0) return "";
    fs::create_directory(kLocks);
    fs::permissions(kLocks, fs::perms::owner_all);
    return std::string{" --bind "} + kLocks + " " + kLocks;
}

}  // namespace

CleanRoot& CleanRoot::bind(const fs::path& host, const std::string& inside) {
    words_.insert(words_.end(), {"--bind", host.string(), inside});
    return *this;
}

CleanRoot& CleanRoot::bindReadOnly(const fs::path& host, const std::string& inside) {
    words_.insert(words_.end(), {"--ro-bind", host.string(), inside});
    return *this;
}

CleanRoot& CleanRoot::set(const std::string& variable, const std::string& value) {
    words_.insert(words_.end(), {"--setenv", variable, value});
    return *this;
}

CleanRoot& CleanRoot::withSystemLibraries() {
    for (const char* path : {"/etc/alternatives", "/etc/ld.so.cache"})
        bindReadOnly(path, path);
    return *this;
}

RootRun CleanRoot::runShell(const std::string& inside) const {
    std::string command =
        "bwrap --unshare-pid --unshare-net --unshare-ipc --unshare-uts --die-with-parent "
        "--ro-bind /usr /usr --symlink usr/bin /bin --symlink usr/sbin /sbin "
        "--symlink usr/lib /lib --symlink usr/lib64 /lib64 --proc /proc --dev /dev --tmpfs /tmp "
        "--tmpfs /run --tmpfs /var/tmp --chdir / --clearenv --setenv PATH /usr/bin:/bin" +
        sharedLocks();
    for (const std::string& word : words_)
        command += " " + shellQuoted(word);
    return runHere(command + " " + inside);
}

RootRun CleanRoot::run(const std::string& command) const {
    return runShell("sh -c " + shellQuoted(command));
}

RootRun CleanRoot::runInContainer(const std::string& command) const {
    if (geteuid() != 0) return run(command);
    CleanRoot container = *this;
    container.bindReadOnly(TICKER_BINARY_DIR "/bin/simulated_container", "/run/container");
    return container.runShell("/run/container --docker -- /bin/sh -c " + shellQuoted(command));
}

RootRun runHere(const std::string& command) {
    const TemporaryFolder folder;
    const fs::path errors = folder.path() / "errors";
    std::FILE* const pipe = popen(("(" + command + ") 2>" + errors.string()).c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
    RootRun ran;
    std::array<char, 4096> buffer{};
    for (std::size_t got = 0; (got = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
        ran.output.append(buffer.data(), got);
    const int status = pclose(pipe);
    ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
    ran.errors = textOf(errors);
    return ran;
}

std::string textOf(const fs::path& file) {
    std::ifstream stream{file, std::ios::binary};
    return {std::istreambuf_iterator<char>{stream}, {}};
}

}  // namespace ticker::tests

#include <grader/sandbox/HelperProgram.h>
#include <grader/sandbox/Obstacle.h>

#include <filesystem>
#include <fstream>
#include <system_error>

namespace ticker::sandbox {
namespace {

namespace fs = std::filesystem;

std::string setting(const char* name) {
    std::ifstream stream{fs::path{"/proc/sys"} / name};
    std::string value;
    stream >> value;
    return value;
}

bool exists(const char* file) {
    std::error_code error;
    return fs::exists(file, error);
}

}  // namespace

NamespaceSettings namespaceSettings() {
    return {.hasBubblewrap = !findBubblewrap().empty(),
            .isContainer = exists("/.dockerenv") || exists("/run/.containerenv"),
            .unprivilegedClone = setting("kernel/unprivileged_userns_clone"),
            .apparmorRestricts = setting("kernel/apparmor_restrict_unprivileged_userns"),
            .mostUserNamespaces = setting("user/max_user_namespaces")};
}

std::string commandForNamespaces(const NamespaceSettings& settings) {
    if (!settings.hasBubblewrap) return "apt-get install bubblewrap";
    if (settings.unprivilegedClone == "0") return "sysctl -w kernel.unprivileged_userns_clone=1";
    if (settings.mostUserNamespaces == "0") return "sysctl -w user.max_user_namespaces=10000";
    // The container's own filter of system calls comes before the host's AppArmor.
    if (settings.isContainer)
        return "docker run --security-opt seccomp=unconfined --security-opt apparmor=unconfined "
               "...";
    if (settings.apparmorRestricts == "1")
        return "sysctl -w kernel.apparmor_restrict_unprivileged_userns=0";
    return {};
}

std::string adviceForNamespaces(const NamespaceSettings& settings) {
    const std::string command = commandForNamespaces(settings);
    return command.empty() ? "needs bubblewrap 0.8 or later and unprivileged user namespaces"
                           : "run: " + command;
}

}  // namespace ticker::sandbox

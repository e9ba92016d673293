#include <grader/sandbox/jail/Lockdown.h>

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>

namespace ticker::jail {
namespace {

// Access rights, by the Landlock ABI that introduced them (kernel documentation, "Landlock:
// unprivileged access control"). The kernel headers of Debian 12 know only the first ones.
constexpr std::uint64_t kExecute = 1U << 0U;
constexpr std::uint64_t kWriteFile = 1U << 1U;
constexpr std::uint64_t kReadFile = 1U << 2U;
constexpr std::uint64_t kReadFolder = 1U << 3U;
constexpr std::uint64_t kAbi1 = (1U << 13U) - 1U;
constexpr std::uint64_t kRefer = 1U << 13U;                       // ABI 2
constexpr std::uint64_t kTruncate = 1U << 14U;                    // ABI 3
constexpr std::uint64_t kDeviceIoctl = 1U << 15U;                 // ABI 5
constexpr std::uint64_t kMakeDevices = (1U << 6U) | (1U << 11U);  // character and block devices

struct Ruleset {
    std::uint64_t files = 0;
    std::uint64_t network = 0;  // ABI 4: TCP bind and connect
    std::uint64_t scoped = 0;   // ABI 6: abstract sockets, signals
};

Ruleset everything(long abi) {
    Ruleset rules{kAbi1};
    if (abi >= 2) rules.files |= kRefer;
    if (abi >= 3) rules.files |= kTruncate;
    if (abi >= 5) rules.files |= kDeviceIoctl;
    if (abi >= 4) rules.network = 3;
    if (abi >= 6) rules.scoped = 3;
    return rules;
}

std::size_t rulesetSize(long abi) {
    if (abi >= 6) return sizeof(Ruleset);
    return abi >= 4 ? 2 * sizeof(std::uint64_t) : sizeof(std::uint64_t);
}

bool allow(int ruleset, const char* path, std::uint64_t forFiles, std::uint64_t forFolders) {
    const int target = open(path, O_PATH | O_CLOEXEC);
    if (target < 0) return errno == ENOENT;
    struct stat status {};
    const bool known = fstat(target, &status) == 0;
    landlock_path_beneath_attr rule{};
    rule.allowed_access = known && S_ISDIR(status.st_mode) ? forFolders : forFiles;
    rule.parent_fd = target;
    const long result =
        syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
    close(target);
    return known && result == 0;
}

}  // namespace

Failure restrictFiles(const Options& options) {
    if (!options.landlock) return nullptr;
    const long abi =
        syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    if (abi < 1) return "Landlock";
    const Ruleset rules = everything(abi);
    const long created = syscall(SYS_landlock_create_ruleset, &rules, rulesetSize(abi), 0);
    if (created < 0) return "Landlock ruleset";
    const int ruleset = static_cast<int>(created);

    const std::uint64_t truncate = rules.files & kTruncate;
    for (const std::string& path : options.readOnly) {
        const std::uint64_t read = kExecute | kReadFile;
        if (!allow(ruleset, path.c_str(), read, read | kReadFolder)) return "Landlock rule";
    }
    if (options.filter == Filter::compile &&
        !allow(ruleset, "/dev/null", kReadFile | kWriteFile | truncate, 0))
        return "Landlock /dev/null";
    const std::uint64_t write = rules.files & ~(kMakeDevices | kDeviceIoctl | kRefer);
    if (!options.scratch.empty() && !allow(ruleset, options.scratch.c_str(), 0, write))
        return "Landlock scratch";
    if (syscall(SYS_landlock_restrict_self, ruleset, 0) != 0) return "Landlock restrict";
    close(ruleset);
    return nullptr;
}

}  // namespace ticker::jail

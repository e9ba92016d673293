#include <grader/sandbox/JailCommand.h>
#include <grader/sandbox/jail/JailOptions.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

namespace ticker::sandbox {
namespace fs = std::filesystem;
namespace {

constexpr const char* kHelperInside = "/.ticker-jail";
constexpr const char* kNobody = "65534";

void append(std::vector<std::string>& words, std::vector<std::string> more) {
    std::move(more.begin(), more.end(), std::back_inserter(words));
}

// Mounts /bin, /lib and the like the way the host has them, as symbolic links or as folders:
// programs name their ELF interpreter by such a path.
void addSystemFolders(std::vector<std::string>& words) {
    for (const char* name : {"/bin", "/lib", "/lib64", "/lib32"}) {
        std::error_code error;
        if (fs::is_symlink(name, error))
            append(words, {"--symlink", fs::read_symlink(name, error).string(), name});
        else if (fs::is_directory(name, error))
            append(words, {"--ro-bind", name, name});
    }
}

bool showsInside(const Command& command, const fs::path& inside) {
    return std::any_of(command.readOnly.begin(), command.readOnly.end(),
                       [&](const ReadOnlyPath& path) { return path.inside == inside; });
}

void addMounts(std::vector<std::string>& words, const Command& command) {
    // The scratch folder comes first, since shown files may lie below it, such as the kit of a
    // checkout in /tmp.
    if (command.wantsScratch)
        append(words, {"--size", std::to_string(command.limits.fileSizeBytes * kScratchFiles),
                       "--tmpfs", kScratchFolder});
    for (const ReadOnlyPath& path : command.readOnly)
        append(words, {"--ro-bind", path.host.string(), path.inside.string()});
    if (showsInside(command, "/usr")) {
        addSystemFolders(words);
        // Private software of the host, which jobs have no reason to see.
        if (!showsInside(command, "/usr/local")) append(words, {"--tmpfs", "/usr/local"});
    }
    if (command.policy == Policy::compile)
        append(words, {"--dir", "/dev", "--dev-bind", "/dev/null", "/dev/null"});
}

std::vector<std::string> bubblewrap(const Command& command, const JailPlace& place) {
    std::vector<std::string> words{place.bubblewrap.string(),
                                   "--unshare-user",
                                   "--unshare-all",
                                   "--die-with-parent",
                                   "--as-pid-1",
                                   "--uid",
                                   kNobody,
                                   "--gid",
                                   kNobody,
                                   "--hostname",
                                   "sandbox"};
    addMounts(words, command);
    append(words, {"--ro-bind", place.helper.string(), kHelperInside, "--remount-ro", "/", "--",
                   kHelperInside});
    return words;
}

std::uint64_t wholeSeconds(double seconds) {
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::ceil(seconds)));
}

std::vector<std::string> landlockPaths(const Command& command, const JailPlace& place) {
    const bool inside = place.level == Level::namespaces;
    std::vector<std::string> paths;
    for (const ReadOnlyPath& path : command.readOnly)
        paths.push_back(inside ? path.inside.string() : path.host.string());
    // On some systems these are folders, not links into /usr, and need a permission of their own.
    if (showsInside(command, "/usr"))
        for (const char* name : {"/bin", "/lib", "/lib64", "/lib32"})
            paths.emplace_back(name);
    return paths;
}

// Translates a path inside of the jail to the host's path; unchanged if no mapping applies.
fs::path behind(const Command& command, const JailPlace& place, const fs::path& inside) {
    if (place.level == Level::namespaces) return inside;
    if (command.wantsScratch && inside == kScratchFolder) return place.scratch;
    for (const ReadOnlyPath& path : command.readOnly) {
        if (inside == path.inside) return path.host;
        const fs::path below = inside.lexically_relative(path.inside);
        if (!below.empty() && *below.begin() != "..") return path.host / below;
    }
    return inside;
}

jail::Filter filterOf(const Command& command, Level level) {
    if (level == Level::none) return jail::Filter::none;
    return command.policy == Policy::run ? jail::Filter::run : jail::Filter::compile;
}

// RLIMIT_NPROC counts all processes of a uid; since Linux 5.14 a user namespace is counted
// separately. A limit that included the caller's own processes would fail correct jobs.
bool countsOnlyItsOwnProcesses(const JailPlace& place) {
    if (place.user >= 0) return true;
    return place.level == Level::namespaces && place.countsProcesses;
}

jail::Options innerOptions(const Command& command, const JailPlace& place) {
    jail::Options options;
    options.reports = true;
    // With namespaces, Landlock is a second barrier: a kernel without it is accepted.
    const bool needed = place.level == Level::ownUser || place.level == Level::sameUser;
    options.landlock = needed || (place.level == Level::namespaces && place.landlock);
    options.filter = filterOf(command, place.level);
    options.cpuSeconds = wholeSeconds(command.limits.cpuSeconds);
    options.addressSpaceBytes = command.limits.addressSpaceBytes;
    options.fileSizeBytes = command.limits.fileSizeBytes;
    options.stackBytes = command.limits.stackBytes;
    if (countsOnlyItsOwnProcesses(place))
        options.processes = static_cast<std::uint64_t>(std::max(1, command.limits.processes));
    options.openFiles = static_cast<std::uint64_t>(std::max(1, command.limits.openFiles));
    options.folder = behind(command, place, command.folder).string();
    if (command.wantsScratch) options.scratch = behind(command, place, kScratchFolder).string();
    options.readOnly = landlockPaths(command, place);
    for (const Descriptor& descriptor : command.descriptors)
        options.descriptors.push_back(descriptor.inside);
    int next = jail::kFirstProductDescriptor;
    for (const Product& product : command.products)
        options.products.push_back({product.name, next++});
    options.command = command.arguments;
    if (!options.command.empty())
        options.command.front() = behind(command, place, command.arguments.front()).string();
    return options;
}

}  // namespace

std::vector<std::string> jailArguments(const Command& command, const JailPlace& place) {
    jail::Options inner = innerOptions(command, place);
    if (place.level != Level::namespaces) {
        inner.user = place.user;
        inner.parent = getpid();
        return toArguments(inner);
    }
    jail::Options outer;
    outer.user = place.user;
    outer.parent = getpid();
    outer.descriptors = inner.descriptors;
    outer.descriptors.push_back(jail::kStatusDescriptor);
    for (const jail::Product& product : inner.products)
        outer.descriptors.push_back(product.descriptor);
    outer.command = bubblewrap(command, place);
    append(outer.command, toArguments(inner));
    return toArguments(outer);
}

}  // namespace ticker::sandbox

#include <grader/sandbox/DiskRoom.h>
#include <grader/sandbox/HelperProgram.h>
#include <grader/sandbox/JailCommand.h>
#include <grader/sandbox/RunAt.h>
#include <grader/sandbox/SandboxPolicy.h>
#include <grader/sandbox/UserSlots.h>
#include <grader/sandbox/Watch.h>
#include <grader/sandbox/jail/JailOptions.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <linux/landlock.h>
#include <sys/syscall.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

namespace ticker::sandbox {
namespace fs = std::filesystem;
namespace {

// How long a job waits for a uid: a machine may have several times as many threads as uids, and
// each job of a grading holds one for 90 s at most.
constexpr std::chrono::minutes kPatience{10};

// Shared by all runs of this process: the staging folder, and the copy of the helper in it, which
// the jail's user can reach wherever the project lies.
struct Workshop {
    StagingFolder staging;
    fs::path helper = copyProgram("ticker-jail", staging.path());
};

const Workshop& workshop() {
    static const Workshop shared;
    return shared;
}

// A scratch folder of one run, removed on destruction.
class ScratchFolder {
public:
    explicit ScratchFolder(long user) {
        path_ = workshop().staging.makeFolder(fs::perms::owner_all);
        const uid_t owner = static_cast<uid_t>(user);
        if (user >= 0 && chown(path_.c_str(), owner, owner) != 0)
            throw raytracer::Error("sandbox: cannot give the scratch folder away");
    }
    ~ScratchFolder() {
        std::error_code ignored;
        if (!path_.empty()) fs::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

// The disk that holds all scratch folders.
DiskRoom& scratchDisk() {
    static DiskRoom room{[] { return freeBytesOf(workshop().staging.path()); }};
    return room;
}

// Most bytes that a job may write: its scratch folder, as large as level A allows, and the copies
// of its products.
std::uint64_t mostBytesOf(const Command& command) {
    return command.limits.fileSizeBytes * (kScratchFiles + command.products.size());
}

Outcome withoutRoom(std::uint64_t wanted) {
    constexpr std::uint64_t kMegabyte = 1'000'000;
    Outcome outcome;
    outcome.output = fmt::format(
        "sandbox: {} has {} MB free, and this may take up to {} MB; free some, or set TMPDIR to a "
        "folder with room",
        workshop().staging.path().parent_path().string(), scratchDisk().freeBytes() / kMegabyte,
        wanted / kMegabyte);
    return outcome;
}

bool hasLandlock() {
    static const bool has =
        syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) >= 1;
    return has;
}

bool kernelCountsProcessesByNamespace() {
    utsname name{};
    int major = 0;
    int minor = 0;
    if (uname(&name) != 0) return false;
    const char* const end = name.release + std::strlen(name.release);
    const auto [dot, error] = std::from_chars(name.release, end, major);
    if (error != std::errc{} || dot == end) return false;
    std::from_chars(dot + 1, end, minor);
    return major > 5 || (major == 5 && minor >= 14);
}

Launch describe(const Command& command, const JailPlace& place, const UserSlot& slot) {
    Launch launch;
    launch.program = place.helper;
    launch.arguments = jailArguments(command, place);
    for (const Descriptor& descriptor : command.descriptors)
        launch.redirections.push_back({descriptor.host, descriptor.inside});
    int next = jail::kFirstProductDescriptor;
    for (const Product& product : command.products)
        launch.redirections.push_back({product.host, next++});
    if (slot.lock() >= 0) launch.redirections.push_back({slot.lock(), jail::kUserLockDescriptor});
    return launch;
}

// The jail lets no command send SIGKILL, and none that fills the machine's memory gets here. So
// this came from outside: another ticker with the same uids, or the kernel, because of others.
bool wasKilledByOthers(const Outcome& outcome, Level level, const Command& command) {
    return level != Level::none && outcome.end == Outcome::End::signalled &&
           outcome.code == SIGKILL && usedLittleMemory(outcome, command.limits, command.policy);
}

Outcome killedByOthers(Outcome outcome) {
    outcome.end = Outcome::End::failed;
    outcome.code = 0;
    outcome.output =
        "sandbox: the job was killed from outside: by the kernel, because the machine's memory was "
        "full (then use fewer --jobs), or by another ticker with the same uids (then give each a "
        "range of its own in grader/sandbox/limits.json, and build again)";
    return outcome;
}

// How many processes the kernel has ended for want of memory since it started; 0 if it does not
// say.
std::uint64_t processesEndedForMemory() {
    std::ifstream lines{"/proc/vmstat"};
    std::uint64_t count = 0;
    for (std::string name; lines >> name >> count;)
        if (name == "oom_kill") return count;
    return 0;
}

Outcome watchCommand(const Command& command, const JailPlace& place, const UserSlot& slot) {
    const bool asks = command.policy == Policy::compile;
    const std::uint64_t before = asks ? processesEndedForMemory() : 0;
    Outcome outcome = watch(describe(command, place, slot), command.limits);
    outcome.machineRanOut = asks && processesEndedForMemory() > before;
    return wasKilledByOthers(outcome, place.level, command) ? killedByOthers(std::move(outcome))
                                                            : outcome;
}

}  // namespace

Outcome runAt(Level level, const Command& command) {
    const UserSlot slot = takeUserSlot(defaultPolicy().users, kPatience);
    JailPlace place;
    place.level = level;
    place.landlock = hasLandlock();
    place.countsProcesses = kernelCountsProcessesByNamespace();
    place.helper = workshop().helper;
    if (level == Level::namespaces) place.bubblewrap = findBubblewrap();
    if (level != Level::sameUser) place.user = slot.user();
    if (!command.wantsScratch || level == Level::namespaces)
        return watchCommand(command, place, slot);

    const std::uint64_t wanted = mostBytesOf(command);
    const std::optional<DiskRoom::Share> room = scratchDisk().take(wanted);
    if (!room) return withoutRoom(wanted);
    const ScratchFolder scratch{place.user};
    place.scratch = scratch.path();
    Outcome outcome = watchCommand(command, place, slot);
    // Another process filled the disk in the meantime: then a failure of the command is not its
    // fault.
    const bool isFull = scratchDisk().freeBytes() < command.limits.fileSizeBytes;
    const bool hasAll = outcome.succeeded() && !outcome.productsMissing;
    return isFull && !hasAll ? withoutRoom(wanted) : outcome;
}

Outcome runNothing(Level level) {
    Command command;
    command.readOnly = {{workshop().helper, "/nothing"}};
    command.arguments = {"/nothing", "nothing"};
    // Bubblewrap before 0.8 has no --size, so the trial run asks for a scratch folder as well.
    command.wantsScratch = true;
    command.limits = defaultPolicy().decode;
    command.limits.fileSizeBytes =
        1U << 16U;  // small, so that a full disk does not count against a level
    return runAt(level, command);
}

const StagingFolder& staging() {
    return workshop().staging;
}

}  // namespace ticker::sandbox

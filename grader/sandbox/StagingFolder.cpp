#include <grader/sandbox/StagingFolder.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <system_error>
#include <vector>

namespace ticker::sandbox {
namespace fs = std::filesystem;
namespace {

constexpr const char* kPrefix = "ticker-stage-";
constexpr const char* kNewPrefix = "ticker-new-";

bool programsRunIn(const fs::path& folder) {
    struct statvfs status {};
    return statvfs(folder.c_str(), &status) == 0 && (status.f_flag & ST_NOEXEC) == 0;
}

std::vector<fs::path> places() {
    std::vector<fs::path> result;
    // NOLINTNEXTLINE(concurrency-mt-unsafe): read once, before threads write the environment.
    if (const char* chosen = std::getenv("TMPDIR")) result.emplace_back(chosen);
    for (const char* usual : {"/tmp", "/var/tmp", "/dev/shm"})
        result.emplace_back(usual);
    return result;
}

FileDescriptor lockFolder(const fs::path& folder) {
    FileDescriptor lock{open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC)};
    if (lock.isOpen() && flock(lock.get(), LOCK_EX | LOCK_NB) == 0) return lock;
    return {};
}

bool isOurs(const fs::path& folder) {
    struct stat status {};
    return lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) &&
           status.st_uid == geteuid();
}

// True if the folder is older than a minute: far longer than a new folder stays unlocked.
bool isPastItsBeginning(const fs::path& folder) {
    struct stat status {};
    return lstat(folder.c_str(), &status) == 0 && std::time(nullptr) - status.st_mtime > 60;
}

// A free lock means that the owning process has exited.
void removeAbandoned(const fs::path& place) {
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator{place, ignored}) {
        const std::string name = entry.path().filename().string();
        const bool began = name.starts_with(kPrefix);
        if (!began && !(name.starts_with(kNewPrefix) && isPastItsBeginning(entry.path()))) continue;
        if (!isOurs(entry.path())) continue;
        const FileDescriptor lock = lockFolder(entry.path());
        if (lock.isOpen()) fs::remove_all(entry.path(), ignored);
    }
}

// The folder is locked first and then renamed, so that removeAbandoned never sees it unlocked under
// its final name.
std::optional<std::pair<fs::path, FileDescriptor>> create(const fs::path& place) {
    if (!place.is_absolute() || !jobsCanReach(place) || !programsRunIn(place)) return {};
    const std::string name = randomName();
    const fs::path first = place / (kNewPrefix + name);
    if (mkdir(first.c_str(), 0711) != 0) return {};
    FileDescriptor lock = lockFolder(first);
    const fs::path last = place / (kPrefix + name);
    // fchmod, because the umask may have removed the permissions of other users.
    if (lock.isOpen() && fchmod(lock.get(), 0711) == 0 && rename(first.c_str(), last.c_str()) == 0)
        return std::pair{last, std::move(lock)};
    rmdir(first.c_str());
    return {};
}

}  // namespace

StagingFolder::StagingFolder() {
    for (const fs::path& place : places()) {
        auto created = create(place);
        if (!created) continue;
        path_ = created->first;
        lock_ = std::move(created->second);
        removeAbandoned(place);
        return;
    }
    throw raytracer::Error(
        "sandbox: no folder for staging: $TMPDIR, /tmp, /var/tmp and /dev/shm are not writable, "
        "not "
        "reachable by every user, or mounted noexec; set TMPDIR to a folder that will do");
}

StagingFolder::~StagingFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

fs::path StagingFolder::makeFolder(fs::perms mode) const {
    const fs::path folder = path_ / randomName();
    if (mkdir(folder.c_str(), 0700) != 0)
        throw raytracer::Error(fmt::format("sandbox: cannot make {}: {}", folder.string(),
                                           std::generic_category().message(errno)));
    fs::permissions(folder, mode);
    return folder;
}

bool jobsCanReach(const fs::path& folder) {
    if (geteuid() != 0) return true;
    for (fs::path at = folder;; at = at.parent_path()) {
        struct stat status {};
        if (stat(at.c_str(), &status) != 0 || (status.st_mode & S_IXOTH) == 0) return false;
        if (at == at.root_path()) return true;
    }
}

std::string randomName() {
    std::array<std::uint64_t, 2> bits{};
    if (getrandom(bits.data(), sizeof bits, 0) != static_cast<ssize_t>(sizeof bits))
        throw raytracer::Error("sandbox: the system gives no random numbers");
    return fmt::format("{:016x}{:016x}", bits[0], bits[1]);
}

}  // namespace ticker::sandbox

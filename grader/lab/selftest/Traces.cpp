#include <grader/lab/selftest/Traces.h>

#include <grader/sandbox/RunAt.h>

#include <raytracer/base/Error.h>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <system_error>

namespace ticker::selftest {
namespace fs = std::filesystem;
namespace {

constexpr const char* kEscaped = "/tmp/ticker-escaped";  // the path that the corpus uses

struct Process {
    std::string path;  ///< /proc/123
    long user = -1;
};

// The real uid; -1 if the process is gone. Read from the status file: the folder of a process that
// is not dumpable belongs to root.
long userOf(const fs::path& process) {
    std::ifstream stream{process / "status"};
    for (std::string word; stream >> word;) {
        long user = -1;
        if (word == "Uid:" && stream >> user) return user;
    }
    return -1;
}

std::vector<Process> processesOf(const sandbox::UserRange& users) {
    std::vector<Process> found;
    std::error_code gone;
    for (const fs::directory_entry& entry : fs::directory_iterator{"/proc", gone}) {
        const std::string name = entry.path().filename().string();
        if (name.find_first_not_of("0123456789") != std::string::npos) continue;
        const long user = userOf(entry.path());
        if (user >= users.first && user < users.first + users.count)
            found.push_back({entry.path().string(), user});
    }
    return found;
}

// A running jail holds the lock of its uid.
bool isFree(long user) {
    try {
        return sandbox::takeUserSlot({user, 1}).user() == user;
    } catch (const raytracer::Error&) {
        return false;
    }
}

// "Shmem:   1234 kB" in megabytes; 0 without such a line.
double megabytesOf(const fs::path& file, const std::string& key) {
    std::ifstream stream{file};
    for (std::string word; stream >> word;) {
        double kilobytes = 0.0;
        if (word == key && stream >> kilobytes) return kilobytes / 1024.0;
    }
    return 0.0;
}

std::size_t linesOf(const fs::path& file) {
    std::ifstream stream{file};
    return static_cast<std::size_t>(std::count(std::istreambuf_iterator<char>{stream}, {}, '\n'));
}

std::size_t filesBelow(const fs::path& folder) {
    std::error_code gone;
    const fs::recursive_directory_iterator all{folder, gone};
    return static_cast<std::size_t>(std::distance(fs::begin(all), fs::end(all)));
}

}  // namespace

Traces::Traces() {
    std::string pattern = (fs::temp_directory_path() / "ticker-selftest-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr)
        throw raytracer::Error("cannot make a folder in " + pattern);
    folder_ = pattern;
    std::random_device system;
    secret_ = fmt::format("planted-{:08x}{:08x}", system(), system());
    fs::permissions(folder_, fs::perms{0755});
    std::ofstream stream{secretFile()};
    stream << secret_ << '\n';
    if (!stream.flush()) throw raytracer::Error("cannot write " + secretFile().string());
    fs::permissions(secretFile(), fs::perms{0644});
    static_cast<void>(takeEscaped());
}

Traces::~Traces() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

bool Traces::takeEscaped() const {
    std::error_code ignored;
    return fs::remove_all(kEscaped, ignored) > 0;
}

std::vector<std::string> processesLeft(const sandbox::UserRange& users) {
    std::vector<std::string> left;
    if (geteuid() != 0) return left;
    for (const Process& process : processesOf(users))
        if (isFree(process.user) && userOf(process.path) == process.user)
            left.push_back(process.path);
    return left;
}

bool hasChildLeft() {
    siginfo_t child{};
    return waitid(P_ALL, 0, &child, WEXITED | WNOHANG | WNOWAIT) == 0;
}

Footprint footprint(const sandbox::UserRange& users) {
    Footprint now;
    now.processes = processesLeft(users).size() + (hasChildLeft() ? 1 : 0);
    now.files = filesBelow(sandbox::staging().path());
    now.mounts = linesOf("/proc/self/mountinfo");
    now.residentMb = megabytesOf("/proc/self/status", "VmRSS:");
    now.sharedMb = megabytesOf("/proc/meminfo", "Shmem:");
    now.availableMb = megabytesOf("/proc/meminfo", "MemAvailable:");
    return now;
}

std::vector<std::string> leftBehind(const Footprint& before, const Footprint& after) {
    constexpr double kMostMb = 100.0;
    std::vector<std::string> left;
    const auto count = [&](const char* what, std::size_t then, std::size_t now) {
        if (now > then) left.push_back(fmt::format("{} {} more than before", now - then, what));
    };
    count("processes", before.processes, after.processes);
    count("files", before.files, after.files);
    count("mounts", before.mounts, after.mounts);
    const double more =
        after.residentMb - before.residentMb + std::max(0.0, after.sharedMb - before.sharedMb);
    if (more > kMostMb) left.push_back(fmt::format("{:.0f} MB more memory than before", more));
    return left;
}

}  // namespace ticker::selftest

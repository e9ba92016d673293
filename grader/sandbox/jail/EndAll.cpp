#include <grader/sandbox/jail/EndAll.h>

#include <dirent.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace ticker::jail {
namespace {

constexpr pid_t kNamespaceInit = 1;

// kill(-1) as the jail's uid signals all its processes at once, so that none escapes by forking.
void sweepUser(long user) {
    const pid_t sweeper = fork();
    if (sweeper == 0) {
        const uid_t id = static_cast<uid_t>(user);
        if (setresgid(id, id, id) != 0 || setresuid(id, id, id) != 0) _exit(1);
        kill(-1, SIGKILL);
        _exit(0);
    }
    if (sweeper > 0) waitpid(sweeper, nullptr, 0);
}

pid_t parentOf(pid_t pid) {
    char path[32];
    std::snprintf(path, sizeof path, "/proc/%d/stat", pid);
    std::FILE* file = std::fopen(path, "re");
    if (file == nullptr) return -1;
    char line[512] = {};
    const std::size_t size = std::fread(line, 1, sizeof line - 1, file);
    std::fclose(file);
    line[size] = '\0';
    // The line is "pid (name) state parent". A name may contain any byte, including ')', so search
    // from the end.
    const char* nameEnd = std::strrchr(line, ')');
    if (nameEnd == nullptr || std::strlen(nameEnd) < 4) return -1;
    return static_cast<pid_t>(std::strtol(nameEnd + 4, nullptr, 10));
}

void killChildren() {
    DIR* folder = opendir("/proc");
    if (folder == nullptr) return;
    const pid_t self = getpid();
    while (const dirent* entry = readdir(folder)) {
        const pid_t pid = static_cast<pid_t>(std::strtol(entry->d_name, nullptr, 10));
        if (pid > 0 && parentOf(pid) == self) kill(pid, SIGKILL);
    }
    closedir(folder);
}

// Reaps all ended children. True while some child is still running.
bool reapEnded() {
    while (true) {
        const pid_t pid = waitpid(-1, nullptr, WNOHANG);
        if (pid == 0) return true;
        if (pid < 0 && errno != EINTR) return false;
    }
}

}  // namespace

void killAll(pid_t group, long user) {
    if (getpid() == kNamespaceInit) {
        kill(-1, SIGKILL);
    } else if (user >= 0) {
        sweepUser(user);
    } else {
        kill(-group, SIGKILL);
        killChildren();
    }
}

void endAll(pid_t group, long user) {
    while (reapEnded()) {
        killAll(group, user);
        // Orphans of a dying process become our children: check again after each one.
        waitpid(-1, nullptr, 0);
    }
}

}  // namespace ticker::jail

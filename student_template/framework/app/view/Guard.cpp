#ifndef _WIN32
#include "Guard.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

#include <cstddef>
#include <cstdlib>

// Between fork and exec nothing may be called that takes a lock.

namespace raytracer::view {
namespace {

constexpr int kLifeline = 3;  // of a guard

[[noreturn]] void becomeProgram(char* const* command) {
    setpgid(0, 0);
    close(kLifeline);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    for (const int signal : {SIGPIPE, SIGINT, SIGTERM, SIGHUP})
        std::signal(signal, SIG_DFL);
    execvp(command[0], command);
    _exit(kNotFound);
}

/// True once the program has ended, within `tries` looks.
bool hasEnded(pid_t program, int& status, int tries) {
    constexpr int kLookEveryMs = 10;
    for (; tries > 0; --tries) {
        if (waitpid(program, &status, WNOHANG) == program) return true;
        poll(nullptr, 0, kLookEveryMs);
    }
    return false;
}

/// Ends the orphans of the program, which the system hands to its guard: a build tool gives each of
/// its compilers a group of its own.
void endOrphans() {
#ifdef __linux__
    for (int tries = 100; tries > 0; --tries) {
        while (waitpid(-1, nullptr, WNOHANG) > 0)
            ;
        std::array<char, 1024> list{};
        const int file = open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);
        const ssize_t size = file < 0 ? 0 : ::read(file, list.data(), list.size() - 1);
        if (file >= 0) close(file);
        if (size <= 0) return;
        const char* at = list.data();
        for (long child = takeWholeNumber(at); child >= 0; child = takeWholeNumber(at))
            if (child > 1) ::kill(static_cast<pid_t>(child), SIGKILL);
        poll(nullptr, 0, 2);
    }
#endif
}

/// Waits until the program ends, or until the lifeline closes: only the viewer holds its other end.
/// Then ends the program and everything that it started.
[[noreturn]] void guard(pid_t program) {
    constexpr int kLookEveryMs = 15;
    constexpr int kPatience = 30;  // looks: a build tool ends its compilers when it is asked to end
    for (const int file : {0, 1, 2})
        close(file);
    pollfd lifeline{kLifeline, POLLIN, 0};
    int status = 0;
    bool isOver = false;
    while (!isOver && poll(&lifeline, 1, kLookEveryMs) <= 0)
        isOver = waitpid(program, &status, WNOHANG) == program;
    if (!isOver) {
        ::kill(-program, SIGTERM);
        ::kill(program, SIGTERM);  // where it has no group yet
        isOver = hasEnded(program, status, kPatience);
    }
    ::kill(-program, SIGKILL);
    if (!isOver) waitpid(program, &status, 0);
    // The program's own status counts even if the lifeline closed first: the viewer may notice the
    // end of a crashed program's output before this guard notices the crash.
    const int result = statusOf(status);
    endOrphans();
    _exit(result);
}

}  // namespace

long takeWholeNumber(const char*& list) {
    char* end = nullptr;
    const long number = std::strtol(list, &end, 10);
    if (end == list || *end != ' ') return -1;
    list = end + 1;
    return number;
}

void closeFrom(int first) {
#ifdef SYS_close_range
    if (syscall(SYS_close_range, static_cast<unsigned>(first), ~0U, 0U) == 0) return;
#endif
    constexpr int kMost = 4096;
    for (int file = first; file < kMost; ++file)
        close(file);
}

int statusOf(int status) {
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void becomeGuard(char* const* command, const std::array<int, 4>& ends) {
    setpgid(0, 0);  // Ctrl-C is for the program that asked
    std::array<int, 4> copies{};
    for (std::size_t i = 0; i < ends.size(); ++i)
        copies[i] = fcntl(ends[i], F_DUPFD, 10);
    for (std::size_t i = 0; i < ends.size(); ++i)
        dup2(copies[i], static_cast<int>(i));
    closeFrom(kLifeline + 1);
#ifdef __linux__
    prctl(PR_SET_CHILD_SUBREAPER, 1);
#endif
    const pid_t program = fork();
    if (program == 0) becomeProgram(command);
    if (program < 0) _exit(kNotFound);
    setpgid(program, program);
    guard(program);
}

}  // namespace raytracer::view
#endif

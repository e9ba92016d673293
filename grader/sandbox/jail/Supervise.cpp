#include <grader/sandbox/jail/EndAll.h>
#include <grader/sandbox/jail/Products.h>
#include <grader/sandbox/jail/Start.h>
#include <grader/sandbox/jail/Supervise.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace ticker::jail {
namespace {

Report failed(int error, const char* step) {
    Report report;
    report.code = error;
    std::strncpy(report.step, step, sizeof report.step - 1);
    return report;
}

std::uint64_t microseconds(const timeval& time) {
    return static_cast<std::uint64_t>(time.tv_sec) * 1'000'000U +
           static_cast<std::uint64_t>(time.tv_usec);
}

Report describe(int status) {
    Report report;
    report.kind = WIFEXITED(status) ? Report::Kind::exited : Report::Kind::signalled;
    report.code = WIFEXITED(status) ? WEXITSTATUS(status) : WTERMSIG(status);
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    report.cpuMicroseconds = microseconds(usage.ru_utime) + microseconds(usage.ru_stime);
    report.peakMemoryBytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024U;
    return report;
}

sigset_t watchedSignals() {
    sigset_t watched;
    sigemptyset(&watched);
    sigaddset(&watched, SIGCHLD);
    sigaddset(&watched, SIGTERM);
    return watched;
}

// Reaps ended processes; true once `child` is among them. The others are orphans of the command.
bool reap(pid_t child, int& status) {
    while (true) {
        int ended = 0;
        const pid_t pid = waitpid(-1, &ended, WNOHANG);
        if (pid <= 0) return false;
        if (pid != child) continue;
        status = ended;
        return true;
    }
}

bool toldToStop(int signals) {
    signalfd_siginfo info{};
    while (read(signals, &info, sizeof info) == sizeof info)
        if (info.ssi_signo == SIGTERM) return true;
    return false;
}

// Ends the command at SIGTERM, and also if the reader of the report has gone: the parent-death
// signal can be missed while bubblewrap starts, a closed pipe cannot.
int waitFor(pid_t child, int signals, const Options& options) {
    const bool reports = fcntl(kStatusDescriptor, F_GETFD) >= 0;
    std::array<pollfd, 2> watched{{{signals, POLLIN, 0}, {reports ? kStatusDescriptor : -1, 0, 0}}};
    int status = 0;
    while (!reap(child, status)) {
        poll(watched.data(), watched.size(), -1);
        const bool abandoned = (watched[1].revents & POLLERR) != 0;
        if (abandoned) watched[1].fd = -1;
        if (toldToStop(signals) || abandoned) killAll(child, options.user);
    }
    return status;
}

// The child's end of `pipe` closes on exec, so an empty pipe means that the command has begun.
StartFailure readFailure(int pipe) {
    StartFailure failure;
    ssize_t got = 0;
    do {
        got = read(pipe, &failure, sizeof failure);
    } while (got < 0 && errno == EINTR);
    return got == static_cast<ssize_t>(sizeof failure) ? failure : StartFailure{};
}

}  // namespace

Report supervise(const Options& options) {
    std::array<int, 2> pipe{};
    if (pipe2(pipe.data(), O_CLOEXEC) != 0) return failed(errno, "pipe");
    const sigset_t watched = watchedSignals();
    sigprocmask(SIG_BLOCK, &watched, nullptr);
    const int signals = signalfd(-1, &watched, SFD_CLOEXEC | SFD_NONBLOCK);
    if (signals < 0) return failed(errno, "signalfd");
    prctl(PR_SET_DUMPABLE, 0);
    if (prctl(PR_SET_CHILD_SUBREAPER, 1) != 0) return failed(errno, "subreaper");

    const pid_t self = getpid();
    const pid_t child = fork();
    if (child < 0) return failed(errno, "fork");
    if (child == 0) {
        const StartFailure failure = becomeCommand(options, self, pipe[1]);
        if (write(pipe[1], &failure, sizeof failure) < 0) _exit(126);
        _exit(125);
    }
    close(pipe[1]);
    const StartFailure failure = readFailure(pipe[0]);
    const int status = waitFor(child, signals, options);
    Report report = describe(status);
    endAll(child, options.user);
    if (failure.step[0] != '\0') return failed(failure.error, failure.step);
    if (report.kind == Report::Kind::exited && report.code == 0)
        report.productsMissing = copyProducts(options);
    return report;
}

}  // namespace ticker::jail

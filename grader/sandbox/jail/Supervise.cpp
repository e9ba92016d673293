#include <grader/sandbox/jail/EndAll.h>
#include <grader/sandbox/jail/Products.h>
#include <grader/sandbox/jail/Start.h>
#include <grader/sandbox/jail/Supervise.h>

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <ctime>

namespace ticker::jail {
namespace {

// How often the CPU time of a program is looked at.
constexpr int kGlanceMs = 200;

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

/// How the command ended.
struct End {
    int status = 0;
    bool outOfTime = false;  ///< the helper killed it: it computed for too long
};

Report describe(const End& end) {
    Report report;
    const int status = end.status;
    report.kind = WIFEXITED(status) ? Report::Kind::exited : Report::Kind::signalled;
    report.code = WIFEXITED(status) ? WEXITSTATUS(status) : WTERMSIG(status);
    // The same limit as that of SIGXCPU, which the command ignored, so the same result.
    if (WIFSIGNALED(status) && report.code == SIGKILL && end.outOfTime) report.code = SIGXCPU;
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

// True for a program that has ignored SIGXCPU for a second. The kernel's own hard limit will not
// do: it counts whole ticks. A program that computes only while they are counted reaches it with
// hardly any CPU time used, which looks like a kill from outside.
bool ignoresItsCpuLimit(pid_t child, const Options& options) {
    if (options.filter != Filter::run || options.cpuSeconds == 0) return false;
    clockid_t clock{};
    timespec used{};
    if (clock_getcpuclockid(child, &clock) != 0 || clock_gettime(clock, &used) != 0) return false;
    return static_cast<std::uint64_t>(used.tv_sec) > options.cpuSeconds;
}

// Ends the command at SIGTERM, at its CPU limit, and also if the reader of the report has gone: the
// parent-death signal can be missed while bubblewrap starts, a closed pipe cannot.
End waitFor(pid_t child, int signals, const Options& options) {
    const bool reports = fcntl(kStatusDescriptor, F_GETFD) >= 0;
    std::array<pollfd, 2> watched{{{signals, POLLIN, 0}, {reports ? kStatusDescriptor : -1, 0, 0}}};
    const int glance = options.filter == Filter::run ? kGlanceMs : -1;
    End end;
    while (!reap(child, end.status)) {
        poll(watched.data(), watched.size(), glance);
        const bool abandoned = (watched[1].revents & POLLERR) != 0;
        if (abandoned) watched[1].fd = -1;
        end.outOfTime = end.outOfTime || ignoresItsCpuLimit(child, options);
        if (toldToStop(signals) || abandoned || end.outOfTime) killAll(child, options.user);
    }
    return end;
}

struct Child {
    const Options& options;
    pid_t parent;
    int pipe;
};

int runChild(void* argument) {
    const Child& child = *static_cast<const Child*>(argument);
    const StartFailure failure = becomeCommand(child.options, child.parent, child.pipe);
    if (write(child.pipe, &failure, sizeof failure) < 0) _exit(126);
    _exit(125);
}

// The child shares this process's memory until it is the command, and this process waits until
// then, as with vfork(): a copy of all page tables would take longer than the other steps.
pid_t start(Child child) {
    constexpr std::size_t kStackBytes = 256U << 10U;
    std::array<std::max_align_t, kStackBytes / sizeof(std::max_align_t)> stack;
    return clone(runChild, stack.data() + stack.size(), CLONE_VM | CLONE_VFORK | SIGCHLD, &child);
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

    const pid_t child = start({options, getpid(), pipe[1]});
    if (child < 0) return failed(errno, "clone");
    close(pipe[1]);
    const StartFailure failure = readFailure(pipe[0]);
    const End end = waitFor(child, signals, options);
    Report report = describe(end);
    endAll(child, options.user);
    if (failure.step[0] != '\0') return failed(failure.error, failure.step);
    if (report.kind == Report::Kind::exited && report.code == 0)
        report.productsMissing = copyProducts(options);
    return report;
}

}  // namespace ticker::jail

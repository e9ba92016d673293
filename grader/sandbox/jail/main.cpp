// ticker-jail: the last trusted step before an untrusted program. It starts one command with the
// rights that the options leave it, and reports how the command ended over a descriptor that the
// command never holds. Level A runs it twice: outside of bubblewrap, to change the uid and to reap
// bubblewrap; inside, as the first process of the pid namespace.
#include <grader/sandbox/jail/JailOptions.h>
#include <grader/sandbox/jail/Supervise.h>

#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

namespace {

using ticker::jail::Options;
using ticker::jail::Report;

// SIGTERM instead of SIGKILL: the helper ends the command and its descendants before it exits.
bool dieWithParent(long parent) {
    if (prctl(PR_SET_PDEATHSIG, SIGTERM) != 0) return false;
    return parent < 0 || getppid() == static_cast<pid_t>(parent);
}

void explain(const char* what, const char* why) {
    dprintf(STDERR_FILENO, "ticker-jail: %s: %s\n", what, why);
}

int run(const Options& options) {
    if (options.reports) fcntl(ticker::jail::kStatusDescriptor, F_SETFD, FD_CLOEXEC);
    if (options.parent >= 0 && !dieWithParent(options.parent)) return 125;
    const Report report = ticker::jail::supervise(options);
    if (report.kind == Report::Kind::setupFailed) explain(report.step, strerror(report.code));
    if (options.reports &&
        write(ticker::jail::kStatusDescriptor, &report, sizeof report) != sizeof report)
        return 125;
    return report.kind == Report::Kind::setupFailed ? 125 : 0;
}

}  // namespace

int main(int count, char** words) {
    // "nothing" is the command of a level's trial run.
    if (count == 2 && std::strcmp(words[1], "nothing") == 0) return 0;
    const ticker::jail::ParsedOptions parsed =
        ticker::jail::parseOptions({words + (count > 0 ? 1 : 0), words + count});
    if (!parsed.error.empty()) {
        explain(parsed.error.c_str(), "not understood");
        return 2;
    }
    return run(parsed.options);
}

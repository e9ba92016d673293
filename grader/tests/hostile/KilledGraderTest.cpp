// kill -9 of ticker while it grades a class of hostile and honest submissions: no process of a
// submission survives. TICKER_KILLS=50 sets the number of kills.
#include "../support/TemporaryFolder.h"

#include <grader/base/FileDescriptor.h>
#include <grader/corpus/Entry.h>
#include <grader/sandbox/Spawner.h>
#include <grader/sandbox/StagingFolder.h>

#include <gtest/gtest.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace ticker::hostile {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

const fs::path kRoot{TICKER_SOURCE_DIR};

// Loops, bombs and submissions that try to outlive the grader, between honest ones.
void writeClass(const fs::path& folder) {
    for (const corpus::Entry& each : corpus::readEntries(kRoot, {"hostile"}))
        for (const char* name : {"blocks-all-signals", "busy-threads", "constexpr-endless",
                                 "daemon", "fork-bomb", "ignores-the-limit", "render-endless"})
            if (each.name == name) {
                fs::create_directory(folder / name);
                corpus::writeSubmission(each, "/nowhere", folder / name);
            }
    for (const char* name : {"reference-bump", "reference-distributed"})
        fs::copy(kRoot / "grader/corpus/samples/awarded" / name, folder / name);
}

// Its orphans become our children, so that we can wait for their end.
class Grading {
public:
    Grading(const fs::path& folder, const fs::path& output) : nothing_(open("/dev/null", O_RDWR)) {
        sandbox::Launch ticker;
        ticker.program = fs::path{TICKER_BINARY_DIR} / "bin/ticker";
        ticker.arguments = {"grade", folder.string(), "-o", output.string(), "--jobs", "2"};
        ticker.redirections = {{nothing_.get(), 0}, {nothing_.get(), 1}, {nothing_.get(), 2}};
        pid_ = sandbox::launch(ticker).pid;
        handle_ = FileDescriptor{static_cast<int>(syscall(SYS_pidfd_open, pid_, 0))};
    }

    [[nodiscard]] bool hasBegun() const { return pid_ > 0 && handle_.isOpen(); }

    void killAfter(int milliseconds) {
        pollfd ended{handle_.get(), POLLIN, 0};
        poll(&ended, 1, milliseconds);
        kill(pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
    }

private:
    FileDescriptor nothing_;
    pid_t pid_ = -1;
    FileDescriptor handle_;
};

// Returns when no descendant of the grader is left; the test's time limit ends it otherwise.
double millisecondsUntilAllHaveEnded() {
    const Clock::time_point start = Clock::now();
    while (waitpid(-1, nullptr, 0) > 0) {
    }
    return Milliseconds{Clock::now() - start}.count();
}

int killsWanted() {
    const char* chosen = std::getenv("TICKER_KILLS");
    return chosen == nullptr ? 3 : std::atoi(chosen);
}

TEST(KilledGrader, LeavesNoProcessOfASubmission) {
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    const tests::TemporaryFolder folder;
    fs::create_directory(folder.path() / "class");
    writeClass(folder.path() / "class");
    std::mt19937 random{6};
    double slowest = 0.0;
    for (int i = 0; i < killsWanted(); ++i) {
        Grading grading{folder.path() / "class", folder.path() / "out"};
        ASSERT_TRUE(grading.hasBegun());
        grading.killAfter(static_cast<int>(random() % 4000));
        slowest = std::max(slowest, millisecondsUntilAllHaveEnded());
    }
    prctl(PR_SET_CHILD_SUBREAPER, 0);
    const sandbox::StagingFolder sweeper;  // removes the folders of the killed graders
    std::printf("%d kills; the slowest end of all processes came after %.0f ms\n", killsWanted(),
                slowest);
}

}  // namespace
}  // namespace ticker::hostile

// kill -9 of the program that started a jail ends the jail.
#include "JailFixture.h"

#include <grader/base/FileDescriptor.h>
#include <grader/sandbox/Spawner.h>
#include <grader/sandbox/StagingFolder.h>
#include <grader/sandbox/UserSlots.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>
#include <string>

namespace ticker::sandbox {
namespace {

constexpr int kPatienceMs = 20'000;

class KilledParent : public AtLevel {
protected:
    void SetUp() override {
        AtLevel::SetUp();
        // This process adopts the victim's orphans, so that it can wait for their end.
        prctl(PR_SET_CHILD_SUBREAPER, 1);
    }
    void TearDown() override {
        prctl(PR_SET_CHILD_SUBREAPER, 0);
        AtLevel::TearDown();
        // A killed victim cannot remove its staging folder: making a new one removes the old ones.
        const StagingFolder sweeper;
    }

    // All descendants of the victim inherit the pipe's other end: an end of file means that none of
    // them is left.
    void startVictim() {
        std::array<int, 2> ends{};
        ASSERT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
        pipe_ = FileDescriptor{ends[0]};
        const FileDescriptor other{ends[1]};
        Launch victim;
        victim.program = programBeside("sandbox_victim");
        victim.arguments = {toString(GetParam()), programBeside("sandbox_tricks").string(),
                            marker()};
        victim.redirections = {{0, 0}, {1, 1}, {2, 2}, {other.get(), 3}};
        victim_ = launch(victim).pid;
        ASSERT_GT(victim_, 0);
    }

    void killVictim() {
        kill(victim_, SIGKILL);
        waitpid(victim_, nullptr, 0);
    }

    // True when the sleeper has begun.
    [[nodiscard]] bool hasBegun(int waitMs) {
        char byte = 0;
        return canReadPipe(waitMs) && read(pipe_.get(), &byte, 1) == 1;
    }

    [[nodiscard]] bool allHaveEnded() {
        if (!reachesEndOfPipe()) return false;
        // A helper that was just being started holds no pipe: it ends at once.
        waitForChildren();
        return true;
    }

private:
    // True when the pipe has bytes or its end within this time.
    [[nodiscard]] bool canReadPipe(int waitMs) {
        pollfd polled{pipe_.get(), POLLIN, 0};
        return poll(&polled, 1, waitMs) == 1;
    }

    // Drops what sleepers wrote, until every process has closed the pipe's other end. False when
    // nothing comes for too long.
    [[nodiscard]] bool reachesEndOfPipe() {
        std::array<char, 8> dropped{};
        while (canReadPipe(kPatienceMs)) {
            const bool isEnd = read(pipe_.get(), dropped.data(), dropped.size()) == 0;
            if (isEnd) return true;
        }
        return false;
    }

    // Waits for the victim's orphans, which this process has adopted.
    static void waitForChildren() {
        while (waitpid(-1, nullptr, 0) > 0) {
        }
    }

    FileDescriptor pipe_;
    pid_t victim_ = -1;
};

INSTANTIATE_TEST_SUITE_P(Sandbox, KilledParent,
                         testing::Values(Level::namespaces, Level::ownUser, Level::sameUser,
                                         Level::none),
                         levelName);

class KilledParentOfOwnUser : public KilledParent {
protected:
    struct Sleeper {
        long user = -1;
        pid_t helper = -1;
    };
    [[nodiscard]] Sleeper sleeper() const {
        Sleeper found;
        std::ifstream lines{"/proc/" + std::to_string(trickProcess()) + "/status"};
        for (std::string word; lines >> word;) {
            if (word == "PPid:") lines >> found.helper;
            if (word == "Uid:") lines >> found.user;
        }
        return found;
    }
};
INSTANTIATE_TEST_SUITE_P(Sandbox, KilledParentOfOwnUser, testing::Values(Level::ownUser),
                         levelName);

// The helper kills every process of its uid. If another run had the uid already, it would kill that
// run's process, too.
TEST_P(KilledParentOfOwnUser, LeavesTheUidToNobodyBeforeTheHelperHasEnded) {
    startVictim();
    ASSERT_TRUE(hasBegun(kPatienceMs));
    const Sleeper found = sleeper();
    ASSERT_GT(found.user, 0);
    ASSERT_GT(found.helper, 1);
    kill(found.helper, SIGSTOP);
    killVictim();
    EXPECT_THROW(static_cast<void>(takeUserSlot({found.user, 1})), raytracer::Error);
    kill(found.helper, SIGCONT);
    EXPECT_TRUE(allHaveEnded());
}

TEST_P(KilledParent, EndsTheJailThatRuns) {
    startVictim();
    ASSERT_TRUE(hasBegun(kPatienceMs));
    killVictim();
    EXPECT_TRUE(allHaveEnded());
}

TEST_P(KilledParent, EndsTheJailAtWhateverMoment) {
    for (int moment = 0; moment < 8; ++moment) {
        startVictim();
        static_cast<void>(hasBegun(2 * moment));
        killVictim();
        EXPECT_TRUE(allHaveEnded()) << "killed after " << 2 * moment << " ms";
    }
}

}  // namespace
}  // namespace ticker::sandbox

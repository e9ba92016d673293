// Whether the program itself or a signal from outside of the jail has ended a run.
#include "JailFixture.h"

#include <grader/base/FileDescriptor.h>
#include <grader/sandbox/RunAt.h>

#include <gtest/gtest.h>

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <thread>

namespace ticker::sandbox {
namespace {

class Blame : public AtLevel {
protected:
    /// Starts a trick that writes to descriptor 3 once it has begun, and then kills its process as
    /// another user of the machine would.
    [[nodiscard]] Outcome killDuring(const std::vector<std::string>& words) const {
        std::array<int, 2> ends{};
        EXPECT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
        const FileDescriptor begun{ends[0]};
        FileDescriptor other{ends[1]};
        Command command = trick(words);
        command.descriptors = {{other.get(), 3}};
        // Filling memory has taken more than a second on a busy virtual machine.
        command.limits.cpuSeconds = 30;
        const std::jthread killer{[&] {
            char byte = 0;
            if (read(begun.get(), &byte, 1) == 1) kill(trickProcess(), SIGKILL);
        }};
        Outcome outcome = run(command);
        other.reset();  // else the killer would wait for ever for a trick that never began
        return outcome;
    }
};

class LockedBlame : public Blame {};
INSTANTIATE_TEST_SUITE_P(Sandbox, LockedBlame,
                         testing::Values(Level::namespaces, Level::ownUser, Level::sameUser),
                         levelName);

TEST_P(LockedBlame, TakesAKillFromOutsideForOurs) {
    const Outcome outcome = killDuring({"sleep"});
    EXPECT_EQ(outcome.end, Outcome::End::failed) << describe(outcome);
    EXPECT_NE(outcome.output.find("killed from outside"), std::string::npos) << outcome.output;
}

// The kernel kills such a program itself where the machine has less memory than the limit.
TEST_P(LockedBlame, LeavesAKillToAProgramThatTookMuchMemory) {
    EXPECT_EQ(describe(killDuring({"fill", "160"})), "signal 9");
    EXPECT_EQ(killDuring({"fill", "16"}).end, Outcome::End::failed);
}

// A program that kills itself must not look like one that was killed from outside. The kernel reads
// the lower 32 bits of the signal's number.
TEST_P(LockedBlame, EndsWhoSendsItselfTheSignalOfOthers) {
    for (const char* number : {"9", "0x100000009", "0x7fffffff00000009"})
        EXPECT_EQ(describe(runTrick({"kill-itself", number})), kForbidden) << number;
}

TEST_P(LockedBlame, LetsAProgramSendItselfAnyOtherSignal) {
    for (const char* number : {"1", "6", "8", "10", "11", "14", "16", "24", "31", "34", "63", "64"})
        EXPECT_EQ(describe(runTrick({"kill-itself", number})), std::string{"signal "} + number);
    EXPECT_EQ(describe(runTrick({"kill-itself", "65"})), "exit 40");
}

TEST_P(LockedBlame, TakesTheEndAtTheCpuLimitForTheProgramsOwn) {
    for (const char* name : {"ignore-cpu-limit", "ignore-cpu-limit-in-threads"})
        EXPECT_EQ(describe(runTrick({name})), "signal 24") << name;
}

class UnlockedBlame : public Blame {};
INSTANTIATE_TEST_SUITE_P(Sandbox, UnlockedBlame, testing::Values(Level::none), levelName);

// Without a filter of system calls a program can send itself any signal.
TEST_P(UnlockedBlame, LeavesEveryKillToTheProgram) {
    EXPECT_EQ(describe(killDuring({"sleep"})), "signal 9");
    EXPECT_EQ(describe(runTrick({"kill-itself", "9"})), "signal 9");
}

// From now on pidfd_open fails in this process, as on a kernel without it.
void loseProcessHandles() {
    std::array<sock_filter, 4> rules{{
        {BPF_LD | BPF_W | BPF_ABS, 0, 0, offsetof(seccomp_data, nr)},
        {BPF_JMP | BPF_JEQ | BPF_K, 0, 1, SYS_pidfd_open},
        {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ERRNO | ENOSYS},
        {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW},
    }};
    const sock_fprog filter{static_cast<unsigned short>(rules.size()), rules.data()};
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) != 0) _exit(3);
}

TEST(WatchDeathTest, SaysThatItCannotWatchWithoutWaitingForEver) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto attempt = [] {
        constexpr unsigned kPatienceSeconds = 20;
        alarm(kPatienceSeconds);
        loseProcessHandles();
        const Outcome outcome = runNothing(Level::none);
        const bool isTold = outcome.output.find("pidfd_open") != std::string::npos;
        _exit(outcome.end == Outcome::End::failed && isTold ? 0 : 1);
    };
    EXPECT_EXIT(attempt(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace ticker::sandbox

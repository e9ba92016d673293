// What levels A, B and C prevent a hostile program from doing.
#include "JailFixture.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <csignal>
#include <filesystem>

namespace ticker::sandbox {
namespace {

namespace fs = std::filesystem;

class Locked : public AtLevel {};
INSTANTIATE_TEST_SUITE_P(Sandbox, Locked,
                         testing::Values(Level::namespaces, Level::ownUser, Level::sameUser),
                         levelName);

TEST_P(Locked, EndsWhoStartsProcesses) {
    EXPECT_EQ(describe(runTrick({"fork-bomb"})), kForbidden);
    EXPECT_EQ(describe(runTrick({"daemon"})), kForbidden);
}

TEST_P(Locked, EndsWhoSignalsOrTracesOthers) {
    for (const char* name : {"kill-parent", "kill-all", "trace-parent"})
        EXPECT_EQ(describe(runTrick({name})), kForbidden) << name;
}

TEST_P(Locked, EndsWhoOpensSockets) {
    EXPECT_EQ(describe(runTrick({"internet-socket"})), kForbidden);
    EXPECT_EQ(describe(runTrick({"abstract-socket"})), kForbidden);
}

TEST_P(Locked, EndsWhoWantsMoreOfTheKernel) {
    for (const char* name : {"new-namespaces", "io-uring", "memory-file", "become-root"})
        EXPECT_EQ(describe(runTrick({name})), kForbidden) << name;
}

TEST_P(Locked, EndsWhoEntersByAnotherArchitecture) {
    // A kernel without the 32-bit entry answers with SIGSEGV instead.
    const std::string end = describe(runTrick({"other-architecture"}));
    EXPECT_TRUE(end == kForbidden || end == "signal 11") << end;
}

TEST_P(Locked, ShowsNoFile) {
    for (const std::string& file :
         {secretFile().string(), std::string{"/etc/passwd"}, std::string{"/proc/self/status"},
          std::string{"/proc/1/environ"}, std::string{"/dev/null"}, std::string{"/tricks"}})
        EXPECT_EQ(describe(runTrick({"read-file", file})), "exit 40") << file;
    for (const char* folder : {"/", "/proc", "/tmp", "/usr"})
        EXPECT_EQ(describe(runTrick({"list-folder", folder})), "exit 40") << folder;
}

TEST_P(Locked, TellsNeitherSizeNorOwnerOfAFile) {
    for (const std::string& file : {secretFile().string(), std::string{"/etc/passwd"},
                                    std::string{"/etc/shadow"}, std::string{"/"}})
        EXPECT_EQ(describe(runTrick({"file-status", file})), "exit 40") << file;
}

TEST_P(Locked, LetsNoFileBeMade) {
    const fs::path file = fs::path{"/tmp"} / marker();
    EXPECT_EQ(describe(runTrick({"write-file", file.string()})), "exit 40");
    EXPECT_EQ(describe(runTrick({"make-link", file.string()})), kForbidden);
    EXPECT_FALSE(fs::exists(fs::symlink_status(file)));
}

TEST_P(Locked, LetsNoOtherProgramRun) {
    EXPECT_EQ(describe(runTrick({"other-program"})), "exit 40");
}

TEST_P(Locked, GivesNoInterpreterToAProgram) {
    EXPECT_EQ(describe(runText("#!/bin/sh\nexit 0\n")), "exit 126");
}

TEST_P(Locked, LetsNobodyTypeIntoATerminal) {
    EXPECT_EQ(describe(runTrick({"type-into-terminal"})), "exit 40");
}

TEST_P(Locked, BoundsThreads) {
    Command command = trick({"thread-bomb"});
    command.limits.addressSpaceBytes = 256U << 20U;
    EXPECT_EQ(describe(run(command)), "exit 40");
}

class LockedSlow : public Locked {};
// One level suffices: these differ in the program's behaviour, not in its confinement.
INSTANTIATE_TEST_SUITE_P(Sandbox, LockedSlow, testing::Values(Level::namespaces), levelName);

TEST_P(LockedSlow, EndsAProgramThatSpins) {
    for (const char* name : {"busy-threads", "block-all-signals", "segv-handler-loop"})
        EXPECT_EQ(describe(runTrick({name})), "signal 24") << name;
}

class Unlocked : public AtLevel {};
INSTANTIATE_TEST_SUITE_P(Sandbox, Unlocked, testing::Values(Level::none), levelName);

TEST_P(Unlocked, LeavesNoDaemonBehind) {
    EXPECT_EQ(describe(runTrick({"daemon"})), "exit 0");
    EXPECT_EQ(processesLeft(marker()), std::vector<std::string>{});
}

TEST_P(Unlocked, LeavesNothingOfAForkBomb) {
    if (geteuid() != 0) GTEST_SKIP() << "only a uid of its own lets a job's processes be counted";
    Command command = trick({"fork-bomb"});
    command.limits.wallSeconds = 0.3;
    EXPECT_EQ(describe(run(command)), "wall limit");
}

}  // namespace
}  // namespace ticker::sandbox

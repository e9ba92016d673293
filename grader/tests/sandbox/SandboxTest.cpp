// Ordinary commands, limits and cleanliness: what every level promises.
#include "JailFixture.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <thread>

namespace ticker::sandbox {
namespace {

class EveryLevel : public AtLevel {};
INSTANTIATE_TEST_SUITE_P(Sandbox, EveryLevel,
                         testing::Values(Level::namespaces, Level::ownUser, Level::sameUser,
                                         Level::none),
                         levelName);

TEST_P(EveryLevel, TellsTheExitStatus) {
    for (const int code : {0, 1, 7, 125, 137, 255})
        EXPECT_EQ(describe(runTrick({"exit-with", std::to_string(code)})),
                  "exit " + std::to_string(code));
}

TEST_P(EveryLevel, LetsHonestProgramsWork) {
    for (const char* name :
         {"threads", "random-device", "exceptions", "memory", "stream-descriptor"}) {
        Command command = trick({name});
        command.limits.cpuSeconds = 30;
        EXPECT_EQ(describe(run(command)), "exit 0") << name;
    }
}

TEST_P(EveryLevel, HandsOverTheOutput) {
    EXPECT_EQ(runTrick({"exceptions"}).output, "caught 1.5\n");
}

TEST_P(EveryLevel, EndsAnEndlessLoopAtItsCpuLimit) {
    const Outcome outcome = runTrick({"loop"});
    EXPECT_EQ(describe(outcome), "signal 24");
    // The kernel counts whole ticks towards the limit of 1 s, including ticks that a busy machine
    // divided among several processes; the reported time is exact.
    EXPECT_GE(outcome.cpuMs, 250.0);
}

TEST_P(EveryLevel, EndsWhoIgnoresTheCpuLimit) {
    EXPECT_EQ(describe(runTrick({"ignore-cpu-limit"})), "signal 24");
}

TEST_P(EveryLevel, EndsASleeperAtItsWallLimit) {
    Command command = trick({"sleep"});
    command.limits.wallSeconds = 0.2;
    EXPECT_EQ(describe(run(command)), "wall limit");
}

TEST_P(EveryLevel, EndsAFloodAndKeepsOnlyItsBeginning) {
    for (const char* descriptor : {"1", "2"}) {
        const Command command = trick({"flood", descriptor});
        const Outcome outcome = run(command);
        EXPECT_EQ(describe(outcome), "output limit");
        EXPECT_EQ(outcome.output, std::string(command.limits.outputBytes, 'x'));
    }
}

TEST_P(EveryLevel, RefusesMemoryBeyondTheLimit) {
    for (const char* bomb : {"new-bomb", "map-bomb"}) {
        Command command = trick({bomb});
        // Some virtual machines take seconds to hand out a gigabyte.
        command.limits.cpuSeconds = 30;
        command.limits.wallSeconds = 60.0;
        EXPECT_EQ(describe(run(command)), "exit 40") << bomb;
    }
}

TEST_P(EveryLevel, TellsAStackOverflow) {
    EXPECT_EQ(describe(runTrick({"stack-overflow"})), "signal 11");
}

TEST_P(EveryLevel, RefusesFilesBeyondTheLimit) {
    std::array<char, 32> name{"/tmp/ticker-test-XXXXXX"};
    const int file = mkstemp(name.data());
    unlink(name.data());
    Command command = trick({"big-file"});
    command.descriptors = {{file, 3}};
    EXPECT_EQ(describe(run(command)), "signal 25");
    EXPECT_LE(lseek(file, 0, SEEK_END), 1 << 20);
    close(file);
}

TEST_P(EveryLevel, RefusesToRaiseLimits) {
    EXPECT_EQ(describe(runTrick({"raise-limits"})), "exit 40");
}

TEST_P(EveryLevel, HandsOverDescriptors) {
    std::array<int, 2> in{};
    std::array<int, 2> out{};
    ASSERT_EQ(pipe2(in.data(), O_CLOEXEC), 0);
    ASSERT_EQ(pipe2(out.data(), O_CLOEXEC), 0);
    ASSERT_EQ(write(in[1], "question", 8), 8);
    Command command = trick({"copy-descriptors"});
    // Crosswise, so that moving them one after the other would overwrite one.
    command.descriptors = {{in[0], 3}, {out[1], 4}};
    EXPECT_EQ(describe(run(command)), "exit 0");
    std::array<char, 16> text{};
    EXPECT_EQ(read(out[0], text.data(), text.size()), 8);
    EXPECT_STREQ(text.data(), "question");
    for (const int descriptor : {in[0], in[1], out[0], out[1]})
        close(descriptor);
}

TEST_P(EveryLevel, HandsOverNoDescriptorThatIsNotNamed) {
    const int secret = open(secretFile().c_str(), O_RDWR);
    ASSERT_EQ(fcntl(secret, F_DUPFD, 40) >= 0 && fcntl(secret, F_DUPFD, 200) >= 0, true);
    // The program writes a forged report to every descriptor from 3 on; 7: there was none.
    EXPECT_EQ(describe(runTrick({"forge-report"})), "exit 7");
    close_range(static_cast<unsigned>(secret), ~0U, 0);
}

TEST_P(EveryLevel, LeavesOtherChildrenAlone) {
    const pid_t other = fork();
    if (other == 0) _exit(42);
    EXPECT_EQ(describe(runTrick({"nothing"})), "exit 0");
    int status = 0;
    EXPECT_EQ(waitpid(other, &status, 0), other);
    EXPECT_EQ(WEXITSTATUS(status), 42);
}

TEST_P(EveryLevel, RunsForManyThreadsAtOnce) {
    std::array<Outcome, 8> outcomes;
    {
        std::vector<std::jthread> workers;
        for (std::size_t i = 0; i < outcomes.size(); ++i)
            workers.emplace_back([&, i] {
                outcomes[i] = Sandbox::at(GetParam()).run(trick({"exit-with", std::to_string(i)}));
            });
    }
    for (std::size_t i = 0; i < outcomes.size(); ++i)
        EXPECT_EQ(describe(outcomes[i]), "exit " + std::to_string(i));
}

// A student's linker can make such a file, so it is not an error of the grader.
TEST_P(EveryLevel, TellsAFileThatIsNoProgram) {
    EXPECT_EQ(describe(runText("#!/not-there\n")), "exit 126");
}

TEST_P(EveryLevel, SaysThatAMissingProgramIsOurFault) {
    Command command = trick({"nothing"});
    command.arguments[0] = "/not-there";
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.end, Outcome::End::failed);
    EXPECT_NE(outcome.output.find("execve"), std::string::npos) << outcome.output;
}

}  // namespace
}  // namespace ticker::sandbox

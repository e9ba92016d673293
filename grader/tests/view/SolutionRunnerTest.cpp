#include "FakeKit.h"

#include <student_template/framework/app/view/SolutionRunner.h>

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <future>
#include <string>
#include <thread>
#include <vector>

namespace raytracer::view {
namespace {

constexpr const char* kNoEnd =
    "Your code does not come to an end: look for a loop whose condition never becomes false.";

constexpr const char* kNotStarted =
    "The program could not be started: it is being built, or is missing. "
    "Ask again when the build is done.";

// A solution that takes every question and answers none.
constexpr const char* kSilent = "exec tail -f /dev/null";

SolutionRunner::Listener deaf() {
    return {[](int, const std::string&) {}, [](const std::string&) {}};
}

/// A listener for what goes wrong.
SolutionRunner::Listener troubleIn(std::vector<std::string>& troubles) {
    return {[](int, const std::string&) {},
            [&troubles](const std::string& words) { troubles.push_back(words); }};
}

TEST(SolutionRunner, DropsAPictureThatIsOlderThanTheLastOne) {
    FakeKit kit;
    std::vector<std::string> asked;
    SolutionRunner runner{kit.home().program, troubleIn(asked)};
    runner.render(2, {"newer"});
    runner.render(1, {"older"});
    EXPECT_EQ(runner.ask("pixel", {}).payload, "pixel\t1000001");
    EXPECT_EQ(asked, (std::vector<std::string>{"picture\t2\tnewer"}));
}

TEST(SolutionRunner, CallsACrashByItsNameOnEverySystem) {
    EXPECT_EQ(endInWords(3), "Your code ended the program with the status 3.");
    EXPECT_NE(endInWords(139).find("Your code crashed (signal 11)."), std::string::npos);
    EXPECT_NE(endInWords(-1073741819).find("Your code crashed."), std::string::npos);
}

TEST(SolutionRunner, CallsAMissingProgramNoCrash) {
    const FakeKit kit;
    std::filesystem::remove(kit.home().program);
    std::vector<std::string> troubles;
    {
        SolutionRunner runner{kit.home().program, troubleIn(troubles)};
        const SolutionRunner::Answer answer = runner.ask("pixel", {});
        EXPECT_FALSE(answer.isGood);
        EXPECT_EQ(answer.payload, kNotStarted);
    }
    EXPECT_EQ(troubles, std::vector<std::string>{kNotStarted});
}

TEST(SolutionRunner, SaysThatTheSolutionCrashedAndStartsItAgain) {
    const FakeKit kit{"read -r line; kill -SEGV $$"};
    std::vector<std::string> troubles;
    SolutionRunner runner{kit.home().program, troubleIn(troubles)};
    const SolutionRunner::Answer crash = runner.ask("pixel", {});
    EXPECT_FALSE(crash.isGood);
    EXPECT_EQ(crash.payload, "Your code crashed at this question.");

    kit.script("program", "read -r line; printf 'drawing 1000002 2\\n{}'; read -r line");
    const SolutionRunner::Answer answer = runner.ask("pixel", {});
    EXPECT_TRUE(answer.isGood);
    EXPECT_EQ(answer.payload, "{}");
    EXPECT_EQ(troubles, std::vector<std::string>{endInWords(139)});
}

TEST(SolutionRunner, SaysThatTheSystemGivesNoProcessAndGoesOn) {
    const FakeKit kit;
    std::vector<std::string> troubles;
    SolutionRunner runner{kit.home().program, troubleIn(troubles)};
    const std::string words = "Your code could not be started: the system gives no pipe.";
    {
        const FewFiles few;
        EXPECT_EQ(runner.ask("pixel", {}).payload, words);
        runner.render(1, {});
    }
    EXPECT_EQ(troubles, std::vector<std::string>{words});
    EXPECT_EQ(runner.ask("pixel", {}).payload, "pixel\t1000001");
}

TEST(SolutionRunner, EndsASolutionThatPrintsWhatIsNoAnswer) {
    for (const char* output :
         {"echo one two three four; exec cat", "echo drawing 1000001; exec cat",
          "echo drawing 1000001 100; echo cut short; exec cat > /dev/null"}) {
        const FakeKit kit{std::string{"read -r line; "} + output};
        SolutionRunner runner{kit.home().program, deaf()};
        EXPECT_EQ(runner.ask("pixel", {}).payload, "Your code crashed at this question.") << output;
    }
}

TEST(SolutionRunner, EndsASolutionThatNeverAnswers) {
    const FakeKit kit{kSilent};
    std::vector<std::string> troubles;
    SolutionRunner runner{kit.home().program, troubleIn(troubles), std::chrono::milliseconds{0}};
    const SolutionRunner::Answer answer = runner.ask("pixel", {});
    EXPECT_FALSE(answer.isGood);
    EXPECT_EQ(answer.payload, kNoEnd);
    EXPECT_TRUE(troubles.empty());  // the answer says it
}

TEST(SolutionRunner, EndsASolutionThatBeginsNoPicture) {
    const FakeKit kit{kSilent};
    std::vector<std::string> troubles;
    SolutionRunner impatient{kit.home().program, troubleIn(troubles), std::chrono::milliseconds{0}};
    impatient.look();
    EXPECT_TRUE(troubles.empty());  // no question waits
    impatient.render(1, {});
    impatient.look();
    impatient.look();
    EXPECT_EQ(troubles, std::vector<std::string>{kNoEnd});
}

TEST(SolutionRunner, WaitsNoLongerForAPictureOnceAPartIsThere) {
    const FakeKit kit{"read -r line; printf 'part 1 3\\nrgb'; exec tail -f /dev/null"};
    std::promise<std::string> part;
    std::vector<std::string> troubles;
    SolutionRunner::Listener listener = troubleIn(troubles);
    listener.onPart = [&](int number, const std::string& payload) {
        part.set_value(std::to_string(number) + payload);
    };
    SolutionRunner runner{kit.home().program, listener, std::chrono::milliseconds{0}};
    runner.render(1, {});
    EXPECT_EQ(part.get_future().get(), "1rgb");
    runner.look();
    EXPECT_EQ(troubles, std::vector<std::string>{});
}

TEST(SolutionRunner, LeavesOutTheTroubleOfAnEarlierPicture) {
    const FakeKit kit{
        "read -r line; read -r line; read -r line; printf 'failed 1 3\\nold'\n"
        "printf 'drawing 1000001 2\\n{}'; exec tail -f /dev/null"};
    std::vector<std::string> troubles;
    SolutionRunner runner{kit.home().program, troubleIn(troubles)};
    runner.render(1, {});
    runner.render(2, {});
    EXPECT_EQ(runner.ask("pixel", {}).payload, "{}");
    EXPECT_TRUE(troubles.empty());
}

TEST(SolutionRunner, AsksToAskAgainWhereABuildCameBetween) {
    const FakeKit kit{"read -r line; printf 'part 1 0\\n'; exec tail -f /dev/null"};
    std::promise<void> isAsked;
    std::vector<std::string> troubles;
    SolutionRunner::Listener listener = troubleIn(troubles);
    listener.onPart = [&](int, const std::string&) { isAsked.set_value(); };
    SolutionRunner runner{kit.home().program, listener};
    SolutionRunner::Answer answer;
    std::jthread asking{[&] { answer = runner.ask("pixel", {}); }};
    isAsked.get_future().wait();
    runner.restart();
    runner.render(2, {});  // the next process runs before the question is looked after
    asking.join();
    EXPECT_FALSE(answer.isGood);
    EXPECT_EQ(answer.payload, "Your code was just built again: ask once more.");
    EXPECT_TRUE(troubles.empty());
}

}  // namespace
}  // namespace raytracer::view

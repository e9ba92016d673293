#include <grader/exercise/Exercise.h>
#include <grader/tests/support/Files.h>

#include <raytracer/base/Unfinished.h>

#include <gtest/gtest.h>

#include <string>
#include <thread>

namespace raytracer {
namespace {

TEST(Unfinished, KeepsARemarkForEachTaskWhateverTheThreads) {
    EXPECT_FALSE(isUnfinished("T2.1"));
    EXPECT_EQ(unfinishedRemark("T2.1"), "");
    testing::internal::CaptureStderr();
    const auto callOften = [] {
        for (int i = 0; i < 100; ++i)
            unfinished("T2.1", "do this");
    };
    std::thread other{callOften};
    callOften();
    other.join();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(unfinishedRemark("T2.1"), "T2.1 is not done yet: do this");
    EXPECT_TRUE(isUnfinished("T2.1"));
    EXPECT_FALSE(isUnfinished("T2.2"));
}

TEST(Unfinished, TakesTheIdOfAnyTask) {
    EXPECT_FALSE(isUnfinished("T9"));
    unfinished("T9", "do that");
    unfinished("T9", "or this");
    EXPECT_EQ(unfinishedRemark("T9"), "T9 is not done yet: do that");
    EXPECT_FALSE(isUnfinished("t9"));
}

// The id in a stub is compared with that of a public test: a misspelt one would never be found.
TEST(Unfinished, IsCalledInEachTasksStubWithItsId) {
    for (const ticker::Exercise& exercise : ticker::knownExercises())
        for (const ticker::TaskEntry& task : exercise.tasks)
            EXPECT_NE(ticker::tests::readFile(exercise.stubs + "/" + task.file)
                          .find("unfinished(\"" + task.id + "\","),
                      std::string::npos)
                << task.file << " has no stub of " << task.id;
}

}  // namespace
}  // namespace raytracer

#include <grader/exercise/Exercise.h>

#include <raytracer/base/Error.h>
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

TEST(Unfinished, KnowsEveryTaskOfEveryExercise) {
    for (const ticker::Exercise& exercise : ticker::knownExercises())
        for (const ticker::TaskEntry& task : exercise.tasks)
            EXPECT_NO_THROW(static_cast<void>(isUnfinished(task.id))) << task.id;
}

TEST(Unfinished, RefusesTasksThatDoNotExist) {
    EXPECT_THROW(unfinished("T9", ""), Error);
    EXPECT_THROW(static_cast<void>(isUnfinished("t1")), Error);
}

}  // namespace
}  // namespace raytracer

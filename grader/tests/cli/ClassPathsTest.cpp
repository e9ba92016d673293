#include <grader/cli/ClassPaths.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::cli {
namespace {

const std::vector<Exercise>& bothExercises() {
    static const std::vector<Exercise> kBoth{
        defaultExercise(), readExercise(std::filesystem::path{TICKER_SOURCE_DIR} /
                                        "grader/tests/exercise/toy/exercise.json")};
    return kBoth;
}

/// What is said of a class whose submissions have one file each.
std::string complaintAbout(const std::vector<std::string>& files) {
    const tests::TemporaryFolder folder;
    for (std::size_t i = 0; i < files.size(); ++i)
        folder.write("student-" + std::to_string(i) + "/" + files[i], "int x;");
    const ClassPaths from{{folder.path().string()}};
    try {
        expectOneExercise(from, locate(from), bothExercises());
    } catch (const raytracer::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(ClassPaths, OfThisExerciseAreTakenAsTheyAre) {
    EXPECT_EQ(complaintAbout({"BumpySphere.cpp", "Renderer.cpp"}), "");
}

TEST(ClassPaths, OfAnotherExerciseSayWhichItIs) {
    EXPECT_EQ(complaintAbout({"Toy.cpp", "Toy.cpp"}),
              "these are submissions to toy, not to tick1star; --exercise toy grades them");
}

TEST(ClassPaths, OfOneSubmissionAreLeftToIntake) {
    EXPECT_EQ(complaintAbout({"Toy.cpp"}), "");
}

TEST(ClassPaths, ThatMixTwoExercisesAreRefused) {
    EXPECT_EQ(complaintAbout({"BumpySphere.cpp", "work/Toy.cpp"}),
              "1 of 2 submissions bring files of toy, not of tick1star: \"student-1\"; grade each "
              "exercise's submissions in a folder of their own");
}

}  // namespace
}  // namespace ticker::cli

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

/// The error message for a class whose submissions have one file each; empty without an error.
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

std::vector<std::string> namesOf(const ClassPaths& from) {
    std::vector<std::string> names;
    for (const intake::Located& located : locate(from))
        names.push_back(located.name);
    return names;
}

TEST(ClassPaths, GiveNoTwoSubmissionsOneName) {
    const tests::TemporaryFolder folder;
    for (const char* place : {"day1/ann", "day1/ann-2", "day2/ann", "day2/bob", "day3/ann"})
        folder.write(std::string{place} + "/Renderer.cpp", "x");
    const auto at = [&](const char* day) { return (folder.path() / day).string(); };
    EXPECT_EQ(namesOf({{at("day1"), at("day2"), at("day3")}}),
              (std::vector<std::string>{"ann", "ann-2", "ann-3", "bob", "ann-4"}));
    EXPECT_EQ(namesOf({{at("day2"), at("day3"), at("day1")}}),
              (std::vector<std::string>{"ann", "bob", "ann-3", "ann-4", "ann-2"}))
        << "a folder's own name comes before one that is made up";
}

TEST(ClassPaths, OfAShareAreEveryNthByName) {
    const auto namesIn = [](const std::string& share) {
        std::vector<std::string> names;
        for (const intake::Located& located :
             shareOf({{"ann", ""}, {"bob", ""}, {"cyd", ""}, {"dan", ""}}, share))
            names.push_back(located.name);
        return names;
    };
    EXPECT_EQ(namesIn("2/3"), std::vector<std::string>{"bob"});
    EXPECT_EQ(namesIn("1/3"), (std::vector<std::string>{"ann", "dan"}));
    EXPECT_EQ(namesIn("5/18446744073709551615"), std::vector<std::string>{});
    for (const char* wrong :
         {"1/-1", "-1/2", "+1/2", "1 / 2", "1/", "/1", "", "1/2/3", "1/18446744073709551616"})
        EXPECT_THROW(static_cast<void>(namesIn(wrong)), raytracer::InputError) << wrong;
}

TEST(ClassPaths, LeaveOutTheFolderOfTheResults) {
    const tests::TemporaryFolder folder;
    folder.write("ann/Renderer.cpp", "x");
    folder.write("out/ann/code/Renderer.cpp", "x");
    ClassPaths from{{folder.path().string()}};
    from.out = (folder.path() / "out").string();
    EXPECT_EQ(namesOf(from), std::vector<std::string>{"ann"});
    EXPECT_EQ(skippedLine(from), "");
}

}  // namespace
}  // namespace ticker::cli

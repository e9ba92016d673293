#include <grader/exercise/Exercise.h>
#include <grader/tasks/Tasks.h>
#include <grader/tests/support/Files.h>
#include <grader/tests/support/FitsSchema.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace ticker {
namespace {

namespace fs = std::filesystem;

const std::string kFile = "grader/exercises/tick1star/exercise.json";

std::string complaintAbout(const std::string& from, const std::string& to) {
    std::string text = tests::readFile(kFile);
    text.replace(text.find(from), from.size(), to);
    try {
        static_cast<void>(parseExercise("x.json", text));
    } catch (const raytracer::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(ReadExercise, TheProgramCarriesTheProjectsFile) {
    const Exercise fromFile = readExercise(fs::path{TICKER_SOURCE_DIR} / kFile);
    EXPECT_EQ(fromFile.parts(), theExercise().parts());
    EXPECT_EQ(fromFile.reported(), theExercise().reported());
}

TEST(ReadExercise, TheFileFitsItsSchemaAndNamesWhatIsThere) {
    EXPECT_TRUE(tests::fitsSchema(tests::readFile(kFile), "exercise"));
    const fs::path root{TICKER_SOURCE_DIR};
    EXPECT_TRUE(fs::exists(root / theExercise().handout));
    for (const std::string& file : theExercise().files()) {
        EXPECT_TRUE(fs::exists(root / theExercise().stubs / file)) << file;
        EXPECT_TRUE(fs::exists(root / theExercise().reference / file)) << file;
    }
    for (const SceneEntry& scene : theExercise().scenes)
        EXPECT_TRUE(fs::exists(root / "scenes" / (scene.name + ".xml"))) << scene.name;
}

TEST(ReadExercise, EveryTaskHasOneRowAndEveryRowATask) {
    EXPECT_EQ(tasks::theTasks().size(), theExercise().tasks.size());
    for (const Task& task : tasks::theTasks())
        EXPECT_NE(theExercise().task(task.id), nullptr) << task.id;
}

TEST(ReadExercise, SaysWhereAFaultIsAndWhatWasExpected) {
    EXPECT_NE(complaintAbout("\"title\": \"Soft", "\"titel\": \"Soft")
                  .find("x.json:10: /tasks/1/titel: expected no member of this name; known are: "
                        "id, title, file"),
              std::string::npos)
        << complaintAbout("\"title\": \"Soft", "\"titel\": \"Soft");
    EXPECT_NE(complaintAbout("[\"T2.1\", \"T2.2\"]", "[\"T2.1\", \"T9\"]")
                  .find("/options/1/tasks/1: expected the id of a task"),
              std::string::npos);
    EXPECT_NE(complaintAbout("\"id\": \"T2.1\"", "\"id\": \"T1\"").find("more than one task"),
              std::string::npos);
    EXPECT_NE(complaintAbout("\"width\": 320", "\"width\": 0").find("from 1"), std::string::npos);
    EXPECT_NE(complaintAbout("{", "").find("not JSON"), std::string::npos);
}

}  // namespace
}  // namespace ticker

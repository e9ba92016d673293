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

fs::path fileOf(const Exercise& exercise) {
    return fs::path{TICKER_SOURCE_DIR} / "grader/exercises" / exercise.name / "exercise.json";
}

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

TEST(ReadExercise, TheProgramCarriesTheProjectsFiles) {
    EXPECT_EQ(defaultExercise().name, "tick1star");
    for (const Exercise& exercise : knownExercises()) {
        const Exercise fromFile = readExercise(fileOf(exercise));
        EXPECT_EQ(fromFile.name, exercise.name);
        EXPECT_EQ(fromFile.parts(), exercise.parts());
        EXPECT_EQ(fromFile.reported(), exercise.reported());
    }
}

TEST(ReadExercise, EachFileFitsItsSchemaAndNamesWhatIsThere) {
    const fs::path root{TICKER_SOURCE_DIR};
    for (const Exercise& exercise : knownExercises()) {
        EXPECT_TRUE(
            tests::fitsSchema(tests::readFile(fs::relative(fileOf(exercise), root)), "exercise"));
        EXPECT_TRUE(fs::exists(root / exercise.handout));
        EXPECT_TRUE(fs::exists(root / exercise.rubric));
        for (const std::string& file : exercise.files()) {
            EXPECT_TRUE(fs::exists(root / exercise.stubs / file)) << file;
            EXPECT_TRUE(fs::exists(root / exercise.reference / file)) << file;
        }
        for (const SceneEntry& scene : exercise.scenes)
            EXPECT_TRUE(fs::exists(root / "scenes" / (scene.name + ".xml"))) << scene.name;
    }
}

TEST(ReadExercise, ATaskMayHaveFormulasOfTheHandout) {
    const Exercise& exercise = exerciseNamed("tick1star");
    const std::vector<Formula>& formulas = exercise.task("T2.2")->formulas;
    ASSERT_FALSE(formulas.empty());
    EXPECT_EQ(formulas.front().type, "raytracer::Vector3");
    EXPECT_EQ(formulas.front().of, "raytracer::Ray");
    EXPECT_TRUE(exercise.task("T1")->formulas.empty());
}

TEST(ReadExercise, FormulasOfAFileLeaveOutFunctionsThatAreLeftAloneByTheirWholeNames) {
    const Exercise& exercise = exerciseNamed("tick1star");
    const std::size_t all = exercise.formulasOf("Renderer.cpp", "").size();
    ASSERT_GT(all, 0U);
    EXPECT_LT(exercise.formulasOf("Renderer.cpp", "illuminate,render").size(), all);
    EXPECT_EQ(exercise.formulasOf("Renderer.cpp", "renderRow,illuminateAll").size(), all);
    EXPECT_TRUE(exercise.formulasOf("BumpySphere.cpp", "").empty());
}

TEST(ReadExercise, EveryTaskHasOneRowAndEveryRowATask) {
    for (const Exercise& exercise : knownExercises()) {
        EXPECT_EQ(tasks::tasksOf(exercise.name).size(), exercise.tasks.size())
            << "the rows of " << exercise.name << " in grader/tasks/Tasks.cpp";
        for (const Task& task : tasks::tasksOf(exercise.name))
            EXPECT_NE(exercise.task(task.id), nullptr) << task.id;
        for (const Task& task : tasks::tasksOf(exercise.name))
            EXPECT_FALSE(task.findings.empty()) << task.id;
    }
}

TEST(ReadExercise, IsFoundByItsNameAndAnUnknownNameIsTold) {
    EXPECT_EQ(&exerciseNamed("tick1star"), &defaultExercise());
    try {
        static_cast<void>(exerciseNamed("tick9"));
        FAIL();
    } catch (const raytracer::InputError& error) {
        EXPECT_NE(std::string{error.what()}.find("there is no exercise \"tick9\"; expected "),
                  std::string::npos);
    }
}

TEST(ReadExercise, OfAResultIsTheOneThatItNames) {
    SubmissionResult old;
    SubmissionResult fresh;
    fresh.exercise = defaultExercise().name;
    EXPECT_EQ(&exerciseOf({old, fresh}), &defaultExercise());
    SubmissionResult unknown;
    unknown.exercise = "tick9";
    EXPECT_THROW(static_cast<void>(exerciseOf(unknown)), raytracer::InputError);
}

TEST(ReadExercise, SaysWhereAFaultIsAndWhatWasExpected) {
    EXPECT_NE(complaintAbout("\"title\": \"Soft", "\"titel\": \"Soft")
                  .find("x.json:13: /tasks/1/titel: expected no member of this name; known are: "
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

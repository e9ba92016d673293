#include <grader/intake/Intake.h>
#include <grader/report/ClassPage.h>
#include <grader/report/SummaryCsv.h>
#include <grader/report/student/StudentView.h>
#include <grader/tests/pipeline/TestGrader.h>
#include <grader/tests/support/Files.h>
#include <grader/tests/support/SampleQuestions.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

// A third task in a third file passes through all stages of a submission. This folder has
// everything that it needs: an entry in exercise.json, a row, a judge, a stub and a solution.
namespace ticker {
namespace {

namespace fs = std::filesystem;

const fs::path kToy{fs::path{TICKER_SOURCE_DIR} / "grader/tests/exercise/toy"};
constexpr std::uint64_t kSeed = 3;

const Exercise& toyExercise() {
    static const Exercise kExercise = readExercise(kToy / "exercise.json");
    return kExercise;
}

// The probe has no question about fog: the toy's judge accepts every program that answers.
TaskJudgement judgeFog(probe::Examinee& examinee, std::uint64_t /*seed*/) {
    const probe::Run run = examinee.ask({tests::normalQuestion()});
    TaskJudgement judgement;
    judgement.state = run.answers.size() == 1 ? TaskState::passed : TaskState::failed;
    return judgement;
}

bool isFoggy(const raytracer::SceneDescription& /*scene*/) {
    return false;
}

const std::vector<Task>& toyTasks() {
    static const std::vector<Task> kTasks = [] {
        const auto known = tasks::tasksOf(defaultExercise().name);
        std::vector<Task> tasks{known.begin(), known.end()};
        tasks.push_back({"T3", judgeFog, isFoggy, nullptr});
        return tasks;
    }();
    return kTasks;
}

void run(const std::string& command) {
    if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
}

/// The kit that CMake would make from the toy's exercise.json.
class ToyKit {
public:
    ToyKit() { make(); }
    [[nodiscard]] build::Kit at() const { return build::Kit::at(folder_.path() / "kit"); }

private:
    void make() const {
        const build::Kit real = build::Kit::besideProgram();
        const fs::path kit = folder_.path() / "kit";
        fs::copy(real.folder(), kit, fs::copy_options::recursive);
        std::string json = tests::readFile(fs::relative(kit / "kit.json", TICKER_SOURCE_DIR));
        json.replace(json.find("\"Renderer.cpp\""), 14, R"("Renderer.cpp", "Fog.cpp")");
        std::ofstream{kit / "kit.json"} << json;
        fs::copy(kToy / "stub/Fog.cpp", kit / "template/Fog.cpp");
        run(real.compiler() + " -O2 -std=c++20 -c " + (kit / "template/Fog.cpp").string() + " -o " +
            (kit / "template/Fog.o").string());
        fs::permissions(folder_.path(), fs::perms{0755});
    }

    tests::TemporaryFolder folder_;
};

/// The result of one file in a class with the toy's exercise.
SubmissionResult graded(const std::string& file, const std::string& source) {
    const tests::TemporaryFolder folder;
    folder.write(file, source);
    intake::IntakeLimits limits;
    limits.exercise = &toyExercise();
    const auto located = intake::findSubmissions(folder.path(), toyExercise());
    const intake::Submission submission = intake::readSubmission(located.at(0), limits);
    const ToyKit kit;
    pipeline::Grader grader = tests::testGrader();
    grader.exercise = &toyExercise();
    grader.tasks = toyTasks();
    grader.rubric = rubric::readRubric(kToy / "rubric.json", toyExercise());
    grader.kit = kit.at();
    return pipeline::gradeSubmission(submission, grader, kSeed);
}

std::string fog(const std::string& folder) {
    return tests::readFile("grader/tests/exercise/toy/" + folder + "/Fog.cpp");
}

TEST(ToyTask, ThatIsSolvedEarnsTheTickAndStandsInEveryReport) {
    const SubmissionResult result = graded("Fog.cpp", fog("solved"));
    EXPECT_EQ(tests::taskOf(result, "T3").state, TaskState::passed);
    EXPECT_EQ(tests::taskOf(result, "T3").title, "Fog");
    EXPECT_EQ(tests::taskOf(result, "T1").state, TaskState::notAttempted);
    EXPECT_EQ(result.verdict, Verdict::awarded);
    EXPECT_EQ(result.option, "fog");
    EXPECT_EQ(result.sources.at(0).file, "Fog.cpp");

    EXPECT_NE(report::summaryCsv({result}, {}, toyExercise()).find(",T2.2,T3,screenshot,"),
              std::string::npos);
    EXPECT_NE(report::classPage({result}, toyExercise()).find(">T3<"), std::string::npos);
    const report::StudentView view{result, {}, "", {}, toyExercise()};
    EXPECT_NE(report::wholeText(view).find("T3 Fog, passed"), std::string::npos);
}

TEST(ToyTask, ThatIsTheStubIsNotAttempted) {
    const SubmissionResult result = graded("Fog.cpp", fog("stub"));
    EXPECT_EQ(tests::taskOf(result, "T3").state, TaskState::notAttempted);
    const report::StudentView view{result, {}, "", {}, toyExercise()};
    EXPECT_NE(report::wholeText(view).find("Edit Fog.cpp (T3)."), std::string::npos);
}

TEST(ToyTask, ThatDoesNotCompileIsBlockedWithTheCompilersWords) {
    const SubmissionResult broken = graded("Fog.cpp", "int x = nonsense;\n");
    EXPECT_EQ(tests::findingIds(tests::taskOf(broken, "T3")).at(0), "build.failed");
    EXPECT_EQ(broken.diagnostics.at(0).file, "Fog.cpp");
}

TEST(ToyTask, LeavesTheOtherTasksAsTheyAre) {
    const SubmissionResult result =
        graded("BumpySphere.cpp", tests::readFile("reference_solution/exercise/BumpySphere.cpp"));
    EXPECT_EQ(tests::taskOf(result, "T1").state, TaskState::passed);
    EXPECT_EQ(tests::taskOf(result, "T3").state, TaskState::notAttempted);
}

}  // namespace
}  // namespace ticker

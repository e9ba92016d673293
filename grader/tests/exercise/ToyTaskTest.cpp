#include <grader/intake/Intake.h>
#include <grader/report/ClassPage.h>
#include <grader/report/SummaryCsv.h>
#include <grader/report/student/StudentView.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tasks/support/FindingOrder.h>
#include <grader/tasks/support/RunEnd.h>
#include <grader/tests/pipeline/TestGrader.h>
#include <grader/tests/support/Files.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// A further task in a third file passes through all stages of a submission. This folder has an
// entry in exercise.json, the call of its function, a stub and a solution; its row of the table of
// tasks, its judge and its finding are below. No real task has its id or its file's name.
namespace ticker {
namespace {

namespace fs = std::filesystem;

const fs::path kToy{fs::path{TICKER_SOURCE_DIR} / "grader/tests/exercise/toy"};
constexpr std::uint64_t kSeed = 3;

const Exercise& toyExercise() {
    static const Exercise kExercise = readExercise(kToy / "exercise.json");
    return kExercise;
}

constexpr FindingText kFogWrong{.id = "fog.wrong",
                                .words = "let another share of the light through",
                                .meaning = "the share is another one than exp(-distance)"};
constexpr std::array<const FindingText*, 1> kFogFindings{&kFogWrong};

TaskJudgement judgeFog(probe::Examinee& examinee, std::uint64_t seed) {
    tasks::Draw draw{seed, 9};
    probe::CallQuestion question{"transmittance", {}, seed, 1, {}};
    for (int i = 0; i < 8; ++i)
        question.arguments.push_back(draw.between(0.1, 4.0));
    const probe::Run run = examinee.ask({question});
    if (auto blocked = tasks::judgeUnanswered(run, "transmittance")) return *std::move(blocked);
    const auto& values = std::get<probe::CallAnswer>(run.answers.at(0)).values;
    std::vector<Finding> findings;
    for (std::size_t i = 0; i < values.size() && findings.empty(); ++i)
        if (!(std::abs(values[i].x - std::exp(-question.arguments[i])) < 1e-9))
            findings.push_back(
                tasks::distributedFinding(kFogWrong, Severity::fail, "another share"));
    return tasks::judgementOf(std::move(findings), kFogFindings);
}

const std::vector<Task>& toyTasks() {
    static const std::vector<Task> kTasks = [] {
        std::vector<Task> tasks;
        for (const Task& task : tasks::tasksOf(defaultExercise().name))
            if (toyExercise().task(task.id) != nullptr) tasks.push_back(task);
        tasks.push_back({"T9", kFogFindings, judgeFog});
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
        json.replace(json.find("\"Renderer.cpp\""), 14, R"("Renderer.cpp", "Toy.cpp")");
        std::ofstream{kit / "kit.json"} << json;
        fs::copy(kToy / "stub/Toy.cpp", kit / "template/Toy.cpp");
        compile(real, kit / "template/Toy.cpp", kit / "template/Toy.o");
        compile(real, kToy / "Calls.cpp", kit / "lib/calls.o");
        // The real exercise may name functions of its own.
        const std::string library = (kit / "lib/libkit.a").string();
        run("ar d " + library + " " + defaultExercise().name + ".calls.o");
        run("ar r " + library + " " + (kit / "lib/calls.o").string() + " 2>/dev/null");
        fs::permissions(folder_.path(), fs::perms{0755});
    }

    static void compile(const build::Kit& kit, const fs::path& source, const fs::path& object) {
        run(kit.compiler() + " -O2 -std=c++20 -I" + (kit.folder() / "include").string() +
            " -I" TICKER_SOURCE_DIR " -c " + source.string() + " -o " + object.string());
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
    return tests::readFile("grader/tests/exercise/toy/" + folder + "/Toy.cpp");
}

TEST(ToyTask, ThatIsSolvedEarnsTheTickAndStandsInEveryReport) {
    const SubmissionResult result = graded("Toy.cpp", fog("solved"));
    EXPECT_EQ(tests::taskOf(result, "T9").state, TaskState::passed);
    EXPECT_EQ(tests::taskOf(result, "T9").title, "Fog");
    EXPECT_EQ(tests::taskOf(result, "T1").state, TaskState::notAttempted);
    EXPECT_EQ(result.verdict, Verdict::awarded);
    EXPECT_EQ(result.option, "fog");
    EXPECT_EQ(result.sources.at(0).file, "Toy.cpp");

    EXPECT_NE(report::summaryCsv({result}, {}, toyExercise()).find(",T2.2,T9,screenshot,"),
              std::string::npos);
    EXPECT_NE(report::classPage({result}, toyExercise()).find(">T9<"), std::string::npos);
    const report::StudentView view{result, {}, "", {}, toyExercise()};
    EXPECT_NE(report::wholeText(view).find("T9 Fog, passed"), std::string::npos);
}

TEST(ToyTask, ThatIsWrongFailsWithItsFinding) {
    std::string grows = fog("solved");
    grows.replace(grows.find("exp(-"), 5, "exp(");
    const SubmissionResult result = graded("Toy.cpp", grows);
    EXPECT_EQ(tests::taskOf(result, "T9").state, TaskState::failed);
    EXPECT_EQ(tests::findingIds(tests::taskOf(result, "T9")).at(0), "fog.wrong");
}

TEST(ToyTask, ThatIsTheStubIsNotAttempted) {
    const SubmissionResult result = graded("Toy.cpp", fog("stub"));
    EXPECT_EQ(tests::taskOf(result, "T9").state, TaskState::notAttempted);
    const report::StudentView view{result, {}, "", {}, toyExercise()};
    EXPECT_NE(report::wholeText(view).find("Edit Toy.cpp (T9)."), std::string::npos);
}

TEST(ToyTask, ThatDoesNotCompileIsBlockedWithTheCompilersWords) {
    const SubmissionResult broken = graded("Toy.cpp", "int x = nonsense;\n");
    EXPECT_EQ(tests::findingIds(tests::taskOf(broken, "T9")).at(0), "build.failed");
    EXPECT_EQ(broken.diagnostics.at(0).file, "Toy.cpp");
}

TEST(ToyTask, LeavesTheOtherTasksAsTheyAre) {
    const SubmissionResult result =
        graded("BumpySphere.cpp", tests::readFile("reference_solution/exercise/BumpySphere.cpp"));
    EXPECT_EQ(tests::taskOf(result, "T1").state, TaskState::passed);
    EXPECT_EQ(tests::taskOf(result, "T9").state, TaskState::notAttempted);
}

}  // namespace
}  // namespace ticker

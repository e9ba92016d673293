#include <grader/base/WholeFile.h>
#include <grader/corpus/Entry.h>
#include <grader/repair/Explain.h>
#include <grader/repair/Proof.h>
#include <grader/tests/pipeline/TestGrader.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace ticker::repair {
namespace {

constexpr std::uint64_t kSeed = 11;

corpus::Entry mistake(const std::string& task, const std::string& name) {
    for (corpus::Entry& entry : corpus::readEntries(TICKER_SOURCE_DIR, {"mistakes"}))
        if (entry.group == task && entry.name == name) return entry;
    throw std::runtime_error("no mistake " + name);
}

intake::Submission handedIn(const std::string& file, const std::string& text) {
    intake::Submission submission;
    submission.name = "a-student";
    submission.parts[file] = text;
    return submission;
}

struct Explained {
    SubmissionResult result;
    Explanation explanation;
};

/// How much slower sanitizers make the search.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kSlowdown = 10.0;
#else
constexpr double kSlowdown = 1.0;
#endif

/// The default limits of CPU time, with a wall clock that suffices on a busy machine.
SearchLimits longWall() {
    SearchLimits limits = defaultSearchLimits();
    limits.all.cpuSeconds *= kSlowdown;
    limits.all.wallSeconds = 3600.0;
    return limits;
}

/// Eight times the default CPU time: for what must be found, however slow the machine is.
/// docs/repairs.md has the rates under the default limits.
SearchLimits ample() {
    constexpr double kSlowMachine = 8.0;
    SearchLimits limits = longWall();
    limits.all.cpuSeconds *= kSlowMachine;
    return limits;
}

Explained explained(const intake::Submission& submission, const SearchLimits& limits = ample()) {
    const pipeline::Grader& grader = tests::testGrader();
    SubmissionResult result = pipeline::gradeSubmission(submission, grader, kSeed);
    Explanation explanation = explain(submission, grader, result, kSeed + 1, limits);
    return {std::move(result), std::move(explanation)};
}

std::string reference(const std::string& file) {
    return readWhole(std::filesystem::path{TICKER_SOURCE_DIR} / "reference_solution/exercise" /
                     file);
}

std::vector<TaskReport> failedBefore(const std::string& task) {
    std::vector<TaskReport> before(1);
    before.front().id = task;
    before.front().state = TaskState::failed;
    return before;
}

std::optional<Proof> proofOf(const std::string& edited) {
    Clock clock{defaultSearchLimits().all};
    return prove(edited, "BumpySphere.cpp", "T1", failedBefore("T1"), tests::testGrader(), kSeed,
                 clock);
}

TEST(Explain, FindsTheLineOfAWrongSignAndProvesTheEdit) {
    const corpus::Entry entry = mistake("T1", "equation-with-slopes-as-printed");
    const std::string text = corpus::textsOf(entry).at("BumpySphere.cpp");
    const auto [result, explanation] = explained(handedIn("BumpySphere.cpp", text));

    ASSERT_FALSE(explanation.repairs.empty());
    const Repair& best = explanation.repairs.front();
    EXPECT_TRUE(best.proven);
    EXPECT_EQ(best.task, "T1");
    EXPECT_EQ(best.finding, "bump.inverted-u");
    EXPECT_EQ(best.next, "");
    ASSERT_EQ(best.edits.size(), 1U);
    EXPECT_NE(best.edits.front().from.find("return (normal - Bu"), std::string::npos);
    EXPECT_NE(best.edits.front().from, best.edits.front().to);
}

// Asked two hundred at a time, the edits of such code took longer than the search may.
TEST(Explain, ProvesAnEarlyEditBeforeItAsksAllOthers) {
    const std::string text = corpus::applyEdits(
        reference("Renderer.cpp"),
        {{"ColourRGB sum;",
          "ColourRGB sum = trace(scene, pinholeRay, settings().bounces);\n"
          "sum = ColourRGB{};"},
         {"sum += trace(scene, ray, settings().bounces);", "sum += trace(scene, ray, 1);"}},
        "test");
    const auto [result, explanation] = explained(handedIn("Renderer.cpp", text));
    ASSERT_FALSE(explanation.repairs.empty());
    EXPECT_TRUE(explanation.repairs.front().proven);
    EXPECT_LT(explanation.tried, 200U) << explanation.tried;
}

// Ramps do not show a place that moves by half a texel: such code passes the cheap questions.
TEST(Explain, AsksOtherCheapQuestionsWhereTheFirstShowNothing) {
    const std::string text = corpus::applyEdits(
        reference("BumpySphere.cpp"),
        {{"#include <numbers>", "#include <numbers>\n#include <raytracer/math/Random.h>"},
         {"static_cast<int>(u * map.width())",
          "static_cast<int>(u * map.width() + randomBetween(-0.5, 0.5))"}},
        "test");
    const auto [result, explanation] = explained(handedIn("BumpySphere.cpp", text));
    ASSERT_FALSE(explanation.repairs.empty());
    EXPECT_NE(explanation.repairs.front().edits.front().from.find("randomBetween"),
              std::string::npos);
    EXPECT_LT(explanation.tried, 200U) << "as many are asked where nothing shows the mistake";
}

TEST(Explain, ReadsFilesThatAreNotUtf8) {
    const corpus::Entry entry = mistake("T1", "equation-with-slopes-as-printed");
    const std::string text = "// gr\xfcn\n" + corpus::textsOf(entry).at("BumpySphere.cpp");
    const auto [result, explanation] = explained(handedIn("BumpySphere.cpp", text));
    ASSERT_FALSE(explanation.repairs.empty());
    EXPECT_NE(explanation.repairs.front().edits.front().from.find("return (normal - Bu"),
              std::string::npos);
}

TEST(Explain, EveryEditThatItShowsMakesTheTaskPass) {
    const corpus::Entry entry = mistake("T1", "row-beyond-the-last");
    const std::string text = corpus::textsOf(entry).at("BumpySphere.cpp");
    const auto [result, explanation] = explained(handedIn("BumpySphere.cpp", text));

    ASSERT_FALSE(explanation.repairs.empty());
    for (const Repair& repair : explanation.repairs) {
        EXPECT_TRUE(repair.proven);
        std::string edited = text;
        for (const RepairEdit& edit : repair.edits) {
            const std::size_t at = edited.find(edit.from);
            ASSERT_NE(at, std::string::npos);
            edited.replace(at, edit.from.size(), edit.to);
        }
        const SubmissionResult again = pipeline::gradeSubmission(
            handedIn("BumpySphere.cpp", edited), tests::testGrader(), kSeed + 7);
        EXPECT_EQ(tests::taskOf(again, "T1").state, TaskState::passed) << edited;
    }
}

// The program with all edits is compiled without optimisation.
TEST(Explain, NamesTasksWhoseCodeCannotBeCompiledWithItsEdits) {
    const corpus::Entry entry = mistake("T1", "equation-with-slopes-as-printed");
    const std::string text =
        "#ifndef __OPTIMIZE__\n#error\n#endif\n" + corpus::textsOf(entry).at("BumpySphere.cpp");
    const auto [result, explanation] = explained(handedIn("BumpySphere.cpp", text));

    EXPECT_EQ(tests::taskOf(result, "T1").state, TaskState::failed);
    EXPECT_TRUE(explanation.repairs.empty());
    EXPECT_EQ(explanation.notSearched, std::vector<std::string>{"T1"});
    EXPECT_TRUE(explanation.cutOff.empty());
}

TEST(Explain, MendsTheSameMistakeAtBothOfItsPlaces) {
    const corpus::Entry entry = mistake("T2.2", "off-centre-quarter");
    const std::string text = corpus::textsOf(entry).at("Renderer.cpp");
    const auto [result, explanation] = explained(handedIn("Renderer.cpp", text));

    ASSERT_FALSE(explanation.repairs.empty());
    ASSERT_EQ(explanation.repairs.front().edits.size(), 1U);
    const std::string& to = explanation.repairs.front().edits.front().to;
    const std::string bound = "randomBetween(-settings().dofAmount, settings().dofAmount)";
    EXPECT_NE(to.find(bound + ", " + bound), std::string::npos) << to;
}

TEST(Explain, PutsInWhatTheFunctionCouldName) {
    const corpus::Entry entry = mistake("T2.2", "focal-distance");
    const std::string text = corpus::textsOf(entry).at("Renderer.cpp");
    const auto [result, explanation] = explained(handedIn("Renderer.cpp", text));

    ASSERT_FALSE(explanation.repairs.empty());
    EXPECT_NE(explanation.repairs.front().edits.front().to.find("/ pinholeRay.direction.z"),
              std::string::npos);
}

TEST(Explain, KeepsAReferenceToWhatWasRemembered) {
    const corpus::Entry entry = mistake("T1", "map-remembered");
    const std::string text = corpus::textsOf(entry).at("BumpySphere.cpp");
    const auto [result, explanation] = explained(handedIn("BumpySphere.cpp", text));

    ASSERT_FALSE(explanation.repairs.empty());
    EXPECT_NE(explanation.repairs.front().edits.front().to.find("const HeightMap& map"),
              std::string::npos);
}

pipeline::Grader mainTickGrader() {
    const Exercise& exercise = exerciseNamed("tick1");
    const std::filesystem::path root{TICKER_SOURCE_DIR};
    return {.kit = build::Kit::besideProgram(exercise),
            .sandbox = sandbox::Sandbox::best(),
            .policy = sandbox::defaultPolicy(),
            .rubric = rubric::readRubric(root / exercise.rubric, exercise),
            .toolVersion = "test",
            .exercise = &exercise};
}

TEST(Explain, MendsTwoMistakesInTwoStatements) {
    const pipeline::Grader grader = mainTickGrader();
    std::string text = readWhole(std::filesystem::path{TICKER_SOURCE_DIR} /
                                 "reference_solution/tick1/exercise/Renderer.cpp");
    text = corpus::applyEdits(text,
                              {{"(O - P).normalised()", "(P - O).normalised()"},
                               {"std::max(0.0, N.dot(L))", "std::max(0.0, N.dot(V))"}},
                              "two mistakes");
    const intake::Submission submission = handedIn("Renderer.cpp", text);
    const SubmissionResult result = pipeline::gradeSubmission(submission, grader, kSeed);
    ASSERT_EQ(tests::taskOf(result, "M2").state, TaskState::failed);
    const Explanation explanation = explain(submission, grader, result, kSeed + 1, ample());

    const auto first = std::ranges::find(explanation.repairs, "M2", &Repair::task);
    ASSERT_NE(first, explanation.repairs.end());
    EXPECT_EQ(first->next, "");
    ASSERT_EQ(first->edits.size(), 2U);
    // The viewer's direction may be turned round where it is made or where it is used.
    EXPECT_TRUE(std::ranges::any_of(first->edits, [](const RepairEdit& edit) {
        return edit.from.find("N.dot(V)") != std::string::npos;
    }));
    EXPECT_NE(first->edits.front().line, first->edits.back().line);
}

// Some edits pass the first questions and end the process at later ones: reflections without end.
TEST(Explain, GoesOnAfterAnEditThatEndsTheProcessAtLaterQuestions) {
    const pipeline::Grader grader = mainTickGrader();
    std::string text = readWhole(std::filesystem::path{TICKER_SOURCE_DIR} /
                                 "reference_solution/tick1/exercise/Renderer.cpp");
    text = corpus::applyEdits(text,
                              {{"namespace {\n",
                                "namespace {\nColourRGB saturate(ColourRGB c) {\n"
                                "for (double* channel : {&c.r, &c.g, &c.b})\n"
                                "*channel = std::clamp(*channel, 0.0, 1.0);\nreturn c;\n}\n"},
                               {"trace(scene, reflected, bouncesLeft - 1) * share",
                                "saturate(trace(scene, reflected, bouncesLeft - 1)) * share"}},
                              "clamped");
    const intake::Submission submission = handedIn("Renderer.cpp", text);
    const SubmissionResult result = pipeline::gradeSubmission(submission, grader, kSeed);
    ASSERT_EQ(tests::taskOf(result, "M4").state, TaskState::failed);

    const Explanation explanation = explain(submission, grader, result, kSeed + 1, ample());
    ASSERT_FALSE(explanation.repairs.empty());
    EXPECT_EQ(explanation.repairs.front().edits.front().to.find("saturate"), std::string::npos);
}

TEST(Explain, SaysThatItsTimeEnded) {
    const corpus::Entry entry = mistake("T1", "tangents-of-another-axis");
    const std::string text = corpus::textsOf(entry).at("BumpySphere.cpp");
    const intake::Submission submission = handedIn("BumpySphere.cpp", text);
    const pipeline::Grader& grader = tests::testGrader();
    const SubmissionResult result = pipeline::gradeSubmission(submission, grader, kSeed);
    SearchLimits limits = longWall();
    limits.all.cpuSeconds = 1.0;
    const Explanation explanation = explain(submission, grader, result, kSeed + 1, limits);

    EXPECT_TRUE(explanation.repairs.empty());
    EXPECT_EQ(explanation.cutOff, std::vector<std::string>{"T1"});
}

TEST(Explain, RunsNothingForARightSubmission) {
    const auto [result, explanation] =
        explained(handedIn("BumpySphere.cpp", reference("BumpySphere.cpp")));

    EXPECT_TRUE(explanation.repairs.empty());
    EXPECT_EQ(explanation.tried, 0U);
    EXPECT_EQ(explanation.cpuMs, 0.0);
}

TEST(Explain, ShowsNothingWhereNoSmallEditMendsIt) {
    const corpus::Entry entry = mistake("T1", "tangents-of-another-axis");
    const std::string text = corpus::textsOf(entry).at("BumpySphere.cpp");
    const auto [result, explanation] = explained(handedIn("BumpySphere.cpp", text), longWall());

    EXPECT_TRUE(explanation.repairs.empty());
    EXPECT_EQ(tests::taskOf(result, "T1").state, TaskState::failed);
}

TEST(Proof, HoldsForTheReference) {
    const auto proof = proofOf(reference("BumpySphere.cpp"));
    ASSERT_TRUE(proof);
    EXPECT_EQ(proof->next, "");
}

TEST(Proof, NamesTheFindingThatAnEditLeaves) {
    const corpus::Entry entry = mistake("T1", "inverted");
    const auto proof = proofOf(corpus::textsOf(entry).at("BumpySphere.cpp"));
    ASSERT_TRUE(proof);
    EXPECT_EQ(proof->next, "bump.inverted");
}

// Twice the lens is as large as the light, in all settings but one: the judge passes it and warns.
TEST(Proof, FailsForAnEditThatBringsAWarning) {
    const std::string text =
        corpus::applyEdits(reference("Renderer.cpp"),
                           {{"randomInsideUnitSphere() * settings().lightSize",
                             "randomInsideUnitSphere() * (2.0 * settings().dofAmount)"}},
                           "a quantity of the lens");
    Clock clock{longWall().all};
    EXPECT_FALSE(prove(text, "Renderer.cpp", "T2.1", failedBefore("T2.1"), tests::testGrader(),
                       kSeed, clock));
}

TEST(Proof, RunsNothingWhenTheTimeIsUsedUp) {
    Clock clock{defaultSearchLimits().all};
    clock.add(Work::ask, 1000.0 * defaultSearchLimits().all.cpuSeconds);
    EXPECT_FALSE(prove(reference("BumpySphere.cpp"), "BumpySphere.cpp", "T1", failedBefore("T1"),
                       tests::testGrader(), kSeed, clock));
    EXPECT_EQ(clock.cpuMs(Work::prove), 0.0);
}

TEST(Proof, FailsForCodeThatDoesNotCompile) {
    EXPECT_FALSE(proofOf("int x = nonsense;\n"));
}

}  // namespace
}  // namespace ticker::repair

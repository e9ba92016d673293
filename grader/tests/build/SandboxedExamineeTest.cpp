#include <grader/build/Build.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/probe/AnswerMemory.h>
#include <grader/sandbox/SandboxPolicy.h>
#include <grader/tests/support/Files.h>
#include <grader/tests/support/SampleQuestions.h>

#include <gtest/gtest.h>

#include <cmath>

namespace ticker::build {
namespace {

using probe::AnswerState;
using probe::NormalAnswer;
using probe::ProcessEnd;
using EndKind = ProcessEnd::Kind;

/// Builds a submission and puts questions to it, under limits that keep the test short.
/// @param cpuSeconds  The default is enough to fill the memory on a slow machine.
probe::Run ask(const std::string& file, const std::string& source,
               const std::vector<probe::Question>& questions, double cpuSeconds = 4.0) {
    static const sandbox::Sandbox theSandbox = sandbox::Sandbox::best();
    static const Kit kit = Kit::besideProgram();
    const BuildResult built =
        buildProgram(kit, theSandbox, sandbox::defaultPolicy().compile, file, source);
    EXPECT_EQ(built.kind, BuildResult::Kind::built) << built.diagnostics;
    if (!built.program) return {};
    sandbox::Limits limits = sandbox::defaultPolicy().run;
    limits.cpuSeconds = cpuSeconds;
    limits.wallSeconds = 20.0;
    limits.addressSpaceBytes = 400'000'000;
    SandboxedExaminee examinee{*built.program, theSandbox, limits};
    return examinee.ask(questions);
}

/// A BumpySphere.cpp whose getNormalAt has this body.
std::string bumpySphere(const std::string& body, const std::string& before = {}) {
    return "#include <raytracer/geometry/BumpySphere.h>\n#include <cstdlib>\n#include <thread>\n"
           "#include <unistd.h>\n" +
           before +
           "\nnamespace raytracer {\nVector3 BumpySphere::getNormalAt(const Vector3& position) "
           "const {\n" +
           body + "\n}\n}\n";
}

probe::Run askBumpySphere(const std::string& body, const std::string& before = {},
                          double cpuSeconds = 4.0) {
    return ask("BumpySphere.cpp", bumpySphere(body, before), {tests::normalQuestion()}, cpuSeconds);
}

TEST(SandboxedExaminee, AnswersAsTheSolutionDoes) {
    const probe::Run run =
        ask("Renderer.cpp", tests::readFile("reference_solution/exercise/Renderer.cpp"),
            {tests::normalQuestion(), tests::illuminateQuestion(100), tests::renderQuestion(50)});

    EXPECT_EQ(run.end.kind, EndKind::finished) << run.end.detail;
    ASSERT_EQ(run.answers.size(), 3U);
    EXPECT_EQ(std::get<NormalAnswer>(run.answers[0]).state, AnswerState::answered);
    EXPECT_EQ(std::get<probe::IlluminateAnswer>(run.answers[1]).events.size(), 4U);
    const auto& render = std::get<probe::RenderAnswer>(run.answers[2]);
    EXPECT_EQ(render.events.size(), 50U);
    EXPECT_TRUE(render.eventsCut);
    EXPECT_NE(render.images[0], render.images[1]);
}

TEST(SandboxedExaminee, LetsThreadsRun) {
    probe::RenderQuestion question = tests::renderQuestion();
    const std::string source = tests::readFile("reference_solution/exercise/Renderer.cpp");
    const probe::Run one = ask("Renderer.cpp", source, {question});
    question.settings.threads = 2;
    const probe::Run two = ask("Renderer.cpp", source, {question});
    EXPECT_EQ(two.end.kind, EndKind::finished) << two.end.detail;
    EXPECT_EQ(std::get<probe::RenderAnswer>(one.answers.at(0)).images,
              std::get<probe::RenderAnswer>(two.answers.at(0)).images);
}

TEST(SandboxedExaminee, KeepsWhatWasAnsweredBeforeACrash) {
    const probe::Run run = askBumpySphere(
        "if (position.x > 0.9) *static_cast<volatile int*>(nullptr) = 1;\n"
        "return Sphere::getNormalAt(position);");

    EXPECT_EQ(run.end.kind, EndKind::crashed);
    EXPECT_NE(run.end.detail.find("SIGSEGV"), std::string::npos) << run.end.detail;
    const auto& answer = std::get<NormalAnswer>(run.answers.at(0));
    EXPECT_EQ(answer.state, AnswerState::missing);
    EXPECT_EQ(answer.normals[0], (raytracer::Vector3{0.0, 0.0, -1.0}));
    EXPECT_TRUE(probe::isUnanswered(answer.normals[1]));
}

TEST(SandboxedExaminee, CountsExceptionsAndGoesOn) {
    const probe::Run run = askBumpySphere(
        "if (position.x == 1.0) throw std::runtime_error(\"column \\x01 <b>\");\n"
        "return Sphere::getNormalAt(position);",
        "#include <stdexcept>");

    EXPECT_EQ(run.end.kind, EndKind::finished);
    const auto& answer = std::get<NormalAnswer>(run.answers.at(0));
    EXPECT_EQ(answer.state, AnswerState::threw);
    EXPECT_EQ(answer.exceptions, 1U);
    EXPECT_EQ(answer.message, "column \x01 <b>");
    EXPECT_TRUE(probe::isUnanswered(answer.normals[1]));
    EXPECT_FALSE(probe::isUnanswered(answer.normals[2]));
}

TEST(SandboxedExaminee, NamesTheMemoryLimitAfterACrashNearIt) {
    const probe::Run run = askBumpySphere(
        "kept = new char[300'000'000];\n"
        "std::memset(kept, 1, 300'000'000);\n"
        "std::abort();",
        "#include <cstring>\nstatic char* volatile kept;");
    EXPECT_EQ(run.end.kind, EndKind::memory);
    EXPECT_NE(run.end.detail.find("may have 400 MB"), std::string::npos) << run.end.detail;
}

TEST(SandboxedExaminee, SaysThatExitStatus126MayMeanThatTheProgramDidNotStart) {
    const probe::Run run = askBumpySphere("_exit(126);");
    EXPECT_NE(run.end.detail.find("not be started"), std::string::npos) << run.end.detail;
}

// Sets the mark that all questions are answered, as the probe does after the last one.
constexpr const char* kMark =
    "static void mark() { const unsigned long long word = 0x646F'6E65'2A2A'2A2A;\n"
    "pwrite(4, &word, sizeof word, 0); }";

TEST(SandboxedExaminee, RunsNothingOfTheSubmissionAfterTheLastAnswer) {
    const probe::Run run = askBumpySphere(
        "static const int registered = std::atexit([] { fork(); });\n"
        "return registered == 0 ? Sphere::getNormalAt(position) : Vector3{};",
        "struct AtTheEnd { ~AtTheEnd() { fork(); } };\nstatic AtTheEnd atTheEnd;");
    EXPECT_EQ(run.end.kind, EndKind::finished) << run.end.detail;
}

TEST(SandboxedExaminee, SharesOneBudgetAmongItsRuns) {
    const sandbox::Sandbox theSandbox = sandbox::Sandbox::best();
    const Kit kit = Kit::besideProgram();
    const BuildResult built =
        buildProgram(kit, theSandbox, sandbox::defaultPolicy().compile, "BumpySphere.cpp",
                     bumpySphere("for (volatile int i = 0;; i = i + 1) {}"));
    ASSERT_TRUE(built.program) << built.diagnostics;
    TimeBudget budget{{1.0, 600.0}};
    SandboxedExaminee examinee{*built.program, theSandbox, sandbox::defaultPolicy().run, &budget};

    EXPECT_EQ(examinee.ask({tests::normalQuestion()}).end.kind, EndKind::timedOut);
    EXPECT_TRUE(budget.isSpent());
    const double before = examinee.wallMs();
    const probe::Run second = examinee.ask({tests::normalQuestion()});
    EXPECT_EQ(second.end.kind, EndKind::timedOut);
    EXPECT_NE(second.end.detail.find("all runs of a submission together may take 600 s"),
              std::string::npos)
        << second.end.detail;
    EXPECT_EQ(examinee.wallMs(), before) << "it was started once more";
}

// Sleeping uses no CPU time. Without the budget this program would finish.
TEST(SandboxedExaminee, CountsTimeAsleepForTheBudget) {
    const sandbox::Sandbox theSandbox = sandbox::Sandbox::best();
    const Kit kit = Kit::besideProgram();
    const BuildResult built = buildProgram(
        kit, theSandbox, sandbox::defaultPolicy().compile, "BumpySphere.cpp",
        bumpySphere("static const bool slept = [] {\n"
                    "std::this_thread::sleep_for(std::chrono::seconds(10)); return true; }();\n"
                    "return slept ? Sphere::getNormalAt(position) : Vector3{};",
                    "#include <chrono>"));
    ASSERT_TRUE(built.program) << built.diagnostics;
    TimeBudget budget{{600.0, 1.0}};
    SandboxedExaminee examinee{*built.program, theSandbox, sandbox::defaultPolicy().run, &budget};

    for (const char* which : {"first", "second"}) {
        const probe::Run run = examinee.ask({tests::normalQuestion()});
        EXPECT_EQ(run.end.kind, EndKind::timedOut) << which << ": " << run.end.detail;
        EXPECT_NE(run.end.detail.find("all runs of a submission together may take 1 s"),
                  std::string::npos)
            << which << ": " << run.end.detail;
        EXPECT_TRUE(budget.isSpent()) << which;
    }
}

struct Ending {
    const char* name;
    const char* body;
    const char* before;
    EndKind expected;
};

void PrintTo(const Ending& ending, std::ostream* out) {
    *out << ending.name;
}

class SandboxedExamineeEnds : public testing::TestWithParam<Ending> {};

TEST_P(SandboxedExamineeEnds, AsTheKernelSaysAndWithNothingAnswered) {
    const double cpuSeconds = GetParam().expected == EndKind::timedOut ? 1.0 : 20.0;
    const probe::Run run = askBumpySphere(GetParam().body, GetParam().before, cpuSeconds);
    EXPECT_EQ(run.end.kind, GetParam().expected) << run.end.detail;
    ASSERT_EQ(run.answers.size(), 1U);
    EXPECT_TRUE(probe::isUnanswered(std::get<NormalAnswer>(run.answers[0]).normals[2]));
}

INSTANTIATE_TEST_SUITE_P(
    EveryWay, SandboxedExamineeEnds,
    testing::Values(
        Ending{"ALoopWithoutEnd", "for (volatile int i = 0;; i = i + 1) {}", "", EndKind::timedOut},
        Ending{"AnExit", "std::exit(0);", "", EndKind::exitedEarly},
        Ending{"AnExitThatImitatesASignal", "_exit(137);", "", EndKind::exitedEarly},
        Ending{"AnExitBeforeMain", "return {};", "static int x = (_exit(0), 1);",
               EndKind::exitedEarly},
        Ending{"AnAbort", "std::abort();", "", EndKind::crashed},
        Ending{"AVectorWithoutEnd",
               "std::vector<double> v; for (;;) v.resize(v.size() * 2 + 1000);",
               "#include <vector>", EndKind::memory},
        Ending{"MemoryThatIsGivenUpOnWithoutAWord",
               "for (;;) { auto* room = static_cast<char*>(std::malloc(1 << 20));\n"
               "std::memset(room, 1, 1 << 20); }",
               "#include <cstring>", EndKind::memory},
        Ending{"ARequestForFarTooMuch", "kept = new char[1ULL << 40]; return {};",
               "static char* volatile kept;", EndKind::memory},
        Ending{"TooMuchRoomForItsVariables", "room[0] = 1; return {};",
               "static volatile char room[500'000'000];", EndKind::memory},
        Ending{"AnAbortThatSpeaksOfOtherThings",
               "std::fputs(\"bad memory\", stderr); std::abort();", "#include <cstdio>",
               EndKind::crashed},
        Ending{"AStatusLikeThatOfNoProgram", "_exit(126);", "", EndKind::exitedEarly},
        Ending{"AKillByItself", "std::raise(SIGKILL); return {};", "#include <csignal>",
               EndKind::forbiddenCall},
        Ending{"AFork", "fork(); return {};", "", EndKind::forbiddenCall},
        Ending{"ASocket", "socket(AF_INET, SOCK_STREAM, 0); return {};", "#include <sys/socket.h>",
               EndKind::forbiddenCall},
        Ending{"AForkAfterAForgedMark", "mark(); fork(); return {};", kMark,
               EndKind::forbiddenCall},
        Ending{"ACrashAfterAForgedMark", "mark(); __builtin_trap();", kMark, EndKind::crashed},
        Ending{"AnExitAfterAForgedMark", "mark(); _exit(0);", kMark, EndKind::exitedEarly},
        Ending{"ALoopAfterAForgedMark", "mark(); for (volatile int i = 0;; i = i + 1) {}", kMark,
               EndKind::timedOut},
        Ending{"AFlood", "for (;;) write(2, \"0123456789abcdef\", 16);", "", EndKind::outputLimit}),
    [](const auto& ending) { return ending.param.name; });

}  // namespace
}  // namespace ticker::build

#include <grader/sandbox/HelperProgram.h>
#include <grader/sandbox/LevelDiagnosis.h>
#include <grader/sandbox/RunAt.h>
#include <grader/sandbox/SandboxPolicy.h>
#include <grader/sandbox/jail/JailOptions.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <future>
#include <optional>
#include <string>
#include <string_view>

namespace ticker::sandbox {
namespace {

namespace fs = std::filesystem;

const fs::path kLimits = fs::path{TICKER_SOURCE_DIR} / "grader/sandbox/limits.json";

std::string replaced(const std::string& what, const std::string& by) {
    std::string text = R"({"users": {"first": 60800, "count": 64},
        "compile": {"cpuSeconds": 30, "wallSeconds": 90, "addressSpaceBytes": 2000000000,
          "fileSizeBytes": 67108864, "stackBytes": 67108864, "processes": 16, "openFiles": 128,
          "outputBytes": 65536},
        "run": {}, "decode": {}})";
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos);
    return text.replace(at, what.size(), by);
}

std::string complaint(const std::string& text) {
    try {
        static_cast<void>(parsePolicy(text, "limits.json"));
    } catch (const raytracer::InputError& error) {
        return error.what();
    }
    return "none";
}

TEST(SandboxPolicy, IsTheFileThatTheProgramWasBuiltWith) {
    const SandboxPolicy read = readPolicy(kLimits);
    EXPECT_EQ(read.users.first, defaultPolicy().users.first);
    EXPECT_EQ(read.run.addressSpaceBytes, defaultPolicy().run.addressSpaceBytes);
}

TEST(SandboxPolicy, GivesTheWallThreeTimesTheCpu) {
    const SandboxPolicy& policy = defaultPolicy();
    for (const Limits& limits : {policy.compile, policy.run, policy.decode, policy.match})
        EXPECT_EQ(limits.wallSeconds, 3 * limits.cpuSeconds);
}

// One sleeper in a class of thirty holds one of two workers no longer than this.
TEST(SandboxPolicy, BoundsAllRunsOfASubmissionTogether) {
    const SandboxPolicy& policy = defaultPolicy();
    EXPECT_GE(policy.submission.cpuSeconds, 2 * policy.run.cpuSeconds);
    EXPECT_LE(policy.submission.wallSeconds, 90.0);
}

// A class of 600 took 26 s of the processor, and the time grows with the square of the class.
TEST(SandboxPolicy, LetsAClassOf2000BeComparedHoweverLongOneFileMayCompile) {
    EXPECT_GE(defaultPolicy().match.cpuSeconds, 3 * 26.0 * (2000.0 / 600.0) * (2000.0 / 600.0));
    // A line for each pair in each direction.
    EXPECT_GE(defaultPolicy().match.outputBytes, 2000U * 2000U * 52U);
}

TEST(SandboxPolicy, NamesTheFieldThatIsWrong) {
    EXPECT_TRUE(complaint("{").starts_with("limits.json:1: not JSON"));
    EXPECT_EQ(complaint("[]"), "limits.json:1: the file: expected an object");
    EXPECT_EQ(complaint(replaced("\"cpuSeconds\": 30", "\"cpuSeconds\": \"30\"")),
              "limits.json:2: /compile/cpuSeconds: expected a number from 1 to 3600");
    EXPECT_EQ(complaint(replaced("\"wallSeconds\": 90", "\"wallSeconds\": 29")),
              "limits.json:2: /compile/wallSeconds: expected a number from 30 to 10800");
    EXPECT_TRUE(complaint(replaced("\"openFiles\"", "\"openfiles\""))
                    .starts_with("limits.json:3: /compile/openfiles: expected no member of this "
                                 "name; did you mean \"openFiles\"?"));
    EXPECT_EQ(complaint(replaced("\"run\": {}", "\"run\": {}")),
              "limits.json:5: /run: expected an object with a member \"cpuSeconds\"");
    EXPECT_EQ(complaint(replaced("60800", "65500")),
              "limits.json:1: /users/count: the range holds the uid 65534, which is nobody's");
}

TEST(SandboxPolicy, NamesTheFileThatIsMissing) {
    EXPECT_THROW(static_cast<void>(readPolicy("/not-there.json")), raytracer::InputError);
}

TEST(JailOptions, SurviveTheCommandLine) {
    jail::Options options;
    options.user = 60800;
    options.parent = 12;
    options.reports = true;
    options.landlock = true;
    options.filter = jail::Filter::run;
    options.cpuSeconds = 7;
    options.addressSpaceBytes = 5'000'000'000;
    options.folder = "/with space";
    options.scratch = "/tmp";
    options.readOnly = {"/usr", "--"};
    options.descriptors = {3, 4};
    options.products = {{"a:b", 32}};
    options.command = {"/program", "--user", "0"};
    const std::vector<std::string> words = toArguments(options);
    const jail::ParsedOptions parsed = jail::parseOptions({words.begin(), words.end()});
    EXPECT_EQ(parsed.error, "");
    EXPECT_EQ(toArguments(parsed.options), words);
    EXPECT_EQ(parsed.options.user, 60800);
    EXPECT_EQ(parsed.options.products.at(0).name, "a:b");
    EXPECT_EQ(parsed.options.command, options.command);
}

TEST(JailOptions, NameTheWordThatIsNotUnderstood) {
    EXPECT_EQ(jail::parseOptions({"--user", "x", "--", "/p"}).error, "--user");
    EXPECT_EQ(jail::parseOptions({"--cpu"}).error, "--cpu");
    EXPECT_EQ(jail::parseOptions({"--colour", "red", "--", "/p"}).error, "--colour");
    EXPECT_EQ(jail::parseOptions({"--"}).error, "no command");
}

TEST(Staging, CanBeReachedButNotListedByOthers) {
    const StagingFolder folder;
    struct stat status {};
    ASSERT_EQ(stat(folder.path().c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777U, 0711U);
}

TEST(Staging, GoesWithItsOwner) {
    fs::path path;
    {
        const StagingFolder folder;
        path = folder.path();
        fs::create_directories(folder.makeFolder(fs::perms{0755}) / "deep");
        EXPECT_TRUE(fs::exists(path));
    }
    EXPECT_FALSE(fs::exists(path));
}

TEST(Staging, RemovesWhatAKilledProcessLeftButNothingOfALivingOne) {
    const StagingFolder living;
    std::array<int, 2> pipe{};
    ASSERT_EQ(pipe2(pipe.data(), O_CLOEXEC), 0);
    const pid_t child = fork();
    if (child == 0) {
        const StagingFolder abandoned;
        const std::string path = abandoned.path();
        if (write(pipe[1], path.data(), path.size()) < 0) _exit(1);
        kill(getpid(), SIGKILL);
    }
    waitpid(child, nullptr, 0);
    std::array<char, 256> text{};
    const ssize_t size = read(pipe[0], text.data(), text.size());
    ASSERT_GT(size, 0);
    const fs::path abandoned{std::string_view{text.data(), static_cast<std::size_t>(size)}};
    EXPECT_TRUE(fs::exists(abandoned));
    const StagingFolder next;
    EXPECT_FALSE(fs::exists(abandoned));
    EXPECT_TRUE(fs::exists(living.path()));
    close(pipe[0]);
    close(pipe[1]);
}

TEST(UserSlots, AreNeverGivenTwice) {
    if (geteuid() != 0) GTEST_SKIP() << "only root gives jobs uids of their own";
    const UserRange range{60950, 2};
    const UserSlot first = takeUserSlot(range);
    {
        const UserSlot second = takeUserSlot(range);
        EXPECT_NE(first.user(), second.user());
        EXPECT_THROW(static_cast<void>(takeUserSlot(range)), raytracer::Error);
    }
    EXPECT_EQ(takeUserSlot(range).user(), 60951);
}

TEST(UserSlots, AreWaitedForWhileAllAreInUse) {
    if (geteuid() != 0) GTEST_SKIP() << "only root gives jobs uids of their own";
    using std::chrono::milliseconds;
    const UserRange range{60952, 1};
    std::optional<UserSlot> first = takeUserSlot(range);
    auto second = std::async(std::launch::async,
                             [&] { return takeUserSlot(range, std::chrono::minutes{10}).user(); });
    EXPECT_EQ(second.wait_for(milliseconds{50}), std::future_status::timeout);
    first.reset();
    EXPECT_EQ(second.get(), 60952);
}

TEST(CopyProgram, SaysWhatToDoWhereTheTemporaryDiskTakesNoCopy) {
    try {
        static_cast<void>(copyProgram("ticker-jail", "/not-there"));
        FAIL() << "it was copied";
    } catch (const raytracer::Error& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("No such file or directory"), std::string::npos) << text;
        EXPECT_NE(text.find("set TMPDIR"), std::string::npos) << text;
    }
}

TEST(DiagnoseSandbox, SaysWhatIsInTheWayOfALevelThatIsMissing) {
    const std::vector<Diagnosis> all = diagnose();
    ASSERT_EQ(all.size(), 4U);
    EXPECT_EQ(all.back().level, Level::none);
    for (const Diagnosis& diagnosis : all) {
        EXPECT_NE(diagnosis.reason, "");
        if (diagnosis.available) continue;
        EXPECT_THROW(static_cast<void>(Sandbox::at(diagnosis.level)), raytracer::Error);
    }
}

TEST(DiagnoseSandbox, SaysWhyThereIsNoLevelAndWhereToReadOn) {
    EXPECT_EQ(refusalOf({{Level::namespaces, false, "no bubblewrap", "install it"},
                         {Level::ownUser, false, "not root", ""},
                         {Level::none, true, "never for strangers' code", ""}}),
              "this machine gives no sandbox; A: no bubblewrap; B: not root; `ticker doctor` says "
              "what each level needs");
}

TEST(DiagnoseSandbox, NeverTakesNoneForTheBest) {
    bool locked = false;
    for (const Diagnosis& diagnosis : diagnose())
        locked = locked || (diagnosis.available && diagnosis.level != Level::none);
    if (!locked) {
        EXPECT_THROW(static_cast<void>(Sandbox::best()), raytracer::Error);
        return;
    }
    EXPECT_NE(Sandbox::best().level(), Level::none);
}

}  // namespace
}  // namespace ticker::sandbox

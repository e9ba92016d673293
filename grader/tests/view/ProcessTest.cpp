#include <grader/tests/support/TemporaryFolder.h>
#include <student_template/framework/app/view/Guard.h>
#include <student_template/framework/app/view/Lines.h>
#include <student_template/framework/app/view/process/Process.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

namespace raytracer::view {
namespace {

std::vector<std::string> shell(const std::string& script) {
    return {"/bin/sh", "-c", script};
}

std::string everythingFrom(Process& process) {
    std::string text;
    char bytes[256];
    while (const std::size_t got = process.read(bytes, sizeof(bytes)))
        text.append(bytes, got);
    return text;
}

std::string lineFrom(Process& process) {
    LineReader lines{[&](char* bytes, std::size_t size) { return process.read(bytes, size); }};
    return lines.next().value_or("");
}

/// Waits until there is no such process; the test's own time limit ends a wait in vain.
void expectGone(pid_t process) {
    while (kill(process, 0) == 0)
        std::this_thread::yield();
}

TEST(ViewProcess, ReadsWritesAndTellsTheStatus) {
    Process process{shell("read line; echo got $line; echo more >&2; exit 7"),
                    Process::Errors::withItsOutput};
    EXPECT_TRUE(process.write("this\n"));
    EXPECT_EQ(everythingFrom(process), "got this\nmore\n");
    EXPECT_EQ(process.wait(), 7);
}

TEST(ViewProcess, TellsACrashAndAMissingProgram) {
    Process crashing{shell("kill -SEGV $$"), Process::Errors::toOurs};
    EXPECT_EQ(crashing.wait(), 128 + SIGSEGV);
    Process missing{{"/there/is/no/such/program"}, Process::Errors::toOurs};
    EXPECT_EQ(missing.wait(), 127);
}

TEST(ViewProcess, TellsACrashWhereTheLifelineEndsWithTheOutput) {
    Process crashing{shell("kill -SEGV $$"), Process::Errors::toOurs};
    EXPECT_EQ(everythingFrom(crashing), "");
    crashing.kill();
    EXPECT_EQ(crashing.wait(), 128 + SIGSEGV);
}

TEST(ViewProcess, EndsWhatItStartedAlsoInGroupsOfTheirOwn) {
    // As a build tool does: a compiler in another group, which nothing has told to end.
    Process process{shell("setsid /bin/sh -c 'trap \"\" TERM; echo $$; while :; do sleep 1; done'"),
                    Process::Errors::toOurs};
    const pid_t compiler = std::stoi(lineFrom(process));
    EXPECT_EQ(kill(compiler, 0), 0);
    process.kill();
    static_cast<void>(process.wait());
    expectGone(compiler);
}

TEST(ViewProcess, EndsNoProcessWhoseNumberWasCut) {
    const auto numbersIn = [](const char* list) {
        std::vector<long> numbers;
        for (long one = takeWholeNumber(list); one >= 0; one = takeWholeNumber(list))
            numbers.push_back(one);
        return numbers;
    };
    EXPECT_EQ(numbersIn("12 1234567 "), (std::vector<long>{12, 1234567}));
    EXPECT_EQ(numbersIn("12 345"), std::vector<long>{12});  // the beginning of 345678
    EXPECT_EQ(numbersIn("123"), std::vector<long>{});
    EXPECT_EQ(numbersIn(""), std::vector<long>{});
}

TEST(ViewProcess, EndsWithTheProgramThatIsKilled) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t viewer = fork();
    if (viewer == 0) {
        Process process{shell("echo $$; while :; do sleep 1; done"), Process::Errors::toOurs};
        const std::string number = lineFrom(process) + "\n";
        if (write(ends[1], number.data(), number.size()) < 0) _exit(1);
        pause();
        _exit(0);
    }
    close(ends[1]);
    LineReader lines{[&](char* bytes, std::size_t size) {
        const ssize_t got = read(ends[0], bytes, size);
        return got > 0 ? static_cast<std::size_t>(got) : 0U;
    }};
    const pid_t child = std::stoi(lines.next().value_or("0"));
    ASSERT_GT(child, 1);
    kill(viewer, SIGKILL);
    waitpid(viewer, nullptr, 0);
    expectGone(child);
    close(ends[0]);
}

// Of the six ends of its pipes only four can be had.
TEST(ViewProcess, ClosesThePipesOfAProcessThatTheSystemDoesNotGive) {
    std::array<int, 5> opened{};
    for (int& end : opened)
        end = open("/dev/null", O_RDONLY);
    rlimit before{};
    getrlimit(RLIMIT_NOFILE, &before);
    rlimit few = before;
    few.rlim_cur = static_cast<rlim_t>(opened.back());
    setrlimit(RLIMIT_NOFILE, &few);
    for (const int end : opened)
        close(end);
    for (int attempt = 0; attempt < 2; ++attempt)
        EXPECT_THROW(Process(shell("true"), Process::Errors::toOurs), Error);
    const int next = open("/dev/null", O_RDONLY);
    EXPECT_EQ(next, opened.front()) << "the lowest number is free again";
    close(next);
    setrlimit(RLIMIT_NOFILE, &before);
}

TEST(ViewProcess, WritesToNoneThatReadsNoMore) {
    Process process{shell("exec true"), Process::Errors::toOurs};
    EXPECT_EQ(process.wait(), 0);
    EXPECT_FALSE(process.write("too late\n"));
    EXPECT_EQ(everythingFrom(process), "");
}

/// What a desktop's opener of addresses prints when a program with this stdout calls openInBrowser.
/// @param readEnd  The other end of `output`. @param display  $DISPLAY; empty: none.
std::string toldToTheOpener(int output, int readEnd, const char* display) {
    const ticker::tests::TemporaryFolder folder;
    const auto opener = folder.write("xdg-open", "#!/bin/sh\necho \"open $*\"\n");
    std::filesystem::permissions(opener, std::filesystem::perms::owner_all);
    const pid_t program = fork();
    if (program == 0) {
        setenv("PATH", (folder.path().string() + ":/usr/bin:/bin").c_str(), 1);
        setenv("DISPLAY", display, 1);
        unsetenv("WAYLAND_DISPLAY");
        if (*display == '\0') unsetenv("DISPLAY");
        dup2(output, STDOUT_FILENO);
        openInBrowser("http://127.0.0.1:1/");
        _exit(0);
    }
    close(output);
    std::string told;
    std::array<char, 256> bytes{};
    // A terminal's end of file is an error.
    for (ssize_t got = 1; got > 0;) {
        got = read(readEnd, bytes.data(), bytes.size());
        if (got > 0) told.append(bytes.data(), static_cast<std::size_t>(got));
    }
    waitpid(program, nullptr, 0);
    close(readEnd);
    return told;
}

TEST(ViewProcess, OpensTheBrowserOfADesktopFromATerminalAlone) {
    const auto fromATerminal = [](const char* display) {
        const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
        EXPECT_EQ(grantpt(terminal), 0);
        EXPECT_EQ(unlockpt(terminal), 0);
        const int output = open(ptsname(terminal), O_RDWR | O_NOCTTY);
        return toldToTheOpener(output, terminal, display);
    };
    EXPECT_EQ(fromATerminal(":1"), "open http://127.0.0.1:1/\r\n");
    EXPECT_EQ(fromATerminal(""), "");
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe(ends.data()), 0);
    EXPECT_EQ(toldToTheOpener(ends[1], ends[0], ":1"), "");
}

}  // namespace
}  // namespace raytracer::view

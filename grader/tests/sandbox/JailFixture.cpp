#include "JailFixture.h"

#include <grader/base/WholeFile.h>
#include <grader/sandbox/LevelDiagnosis.h>
#include <grader/sandbox/RunAt.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace ticker::sandbox {
namespace fs = std::filesystem;
namespace {

bool isRequired(Level level) {
    const char* required = std::getenv("TICKER_REQUIRE_LEVELS");
    if (required == nullptr) return false;
    std::istringstream words{required};
    for (std::string word; words >> word;)
        if (word == toString(level)) return true;
    return false;
}

const fs::path& stagedTricks() {
    static const fs::path program = [] {
        const fs::path copy = Sandbox::makeStagingFolder() / "tricks";
        fs::copy_file(programBeside("sandbox_tricks"), copy);
        fs::permissions(copy, fs::perms{0755});
        return copy;
    }();
    return program;
}

}  // namespace

fs::path programBeside(const std::string& name) {
    return fs::read_symlink("/proc/self/exe").parent_path() / name;
}

std::string newMarker() {
    return "marker-" + randomName();
}

std::vector<std::string> processesLeft(const std::string& marker) {
    std::vector<std::string> left;
    for (const fs::directory_entry& entry : fs::directory_iterator{"/proc"}) {
        const std::string words = readIfThere(entry.path() / "cmdline").value_or("");
        if (words.find(marker) != std::string::npos) left.push_back(entry.path().string());
    }
    siginfo_t info{};
    if (waitid(P_ALL, 0, &info, WEXITED | WNOHANG | WNOWAIT) == 0)
        left.emplace_back("a child that was not waited for");
    return left;
}

const fs::path& secretFile() {
    static const fs::path file = [] {
        const fs::path folder = Sandbox::makeStagingFolder();
        fs::permissions(folder, fs::perms{0755});
        std::ofstream{folder / "secret.h"} << kSecret << '\n';
        return folder / "secret.h";
    }();
    return file;
}

void AtLevel::SetUp() {
    const Diagnosis& diagnosis = diagnose(GetParam());
    if (diagnosis.available) return;
    if (isRequired(GetParam())) FAIL() << diagnosis.reason;
    GTEST_SKIP() << "level " << toString(GetParam()) << ": " << diagnosis.reason;
}

void AtLevel::TearDown() {
    EXPECT_EQ(processesLeft(marker_), std::vector<std::string>{});
}

Command AtLevel::trick(const std::vector<std::string>& words) const {
    Command command;
    command.readOnly = {{stagedTricks(), "/tricks"}};
    command.arguments = {"/tricks", marker_};
    command.arguments.insert(command.arguments.end(), words.begin(), words.end());
    command.limits.cpuSeconds = 1;
    command.limits.wallSeconds = 60;
    command.limits.addressSpaceBytes = 512U << 20U;
    command.limits.fileSizeBytes = 1U << 20U;
    command.limits.stackBytes = 1U << 20U;
    return command;
}

Outcome AtLevel::run(const Command& command) const {
    const fs::path stage = staging().path();
    const auto count = [&] {
        return std::distance(fs::directory_iterator{stage}, fs::directory_iterator{});
    };
    const auto before = count();
    Outcome outcome = Sandbox::at(GetParam()).run(command);
    EXPECT_EQ(count(), before) << "the run left files";
    EXPECT_EQ(outcome.output.find(kSecret), std::string::npos);
    return outcome;
}

// The command lines of the helpers contain the marker, too, but begin with another program.
pid_t AtLevel::trickProcess() const {
    for (const std::string& path : processesLeft(marker_)) {
        std::ifstream stream{fs::path{path} / "cmdline"};
        std::string first;
        std::getline(stream, first, '\0');
        if (fs::path{first}.filename() == "tricks")
            return static_cast<pid_t>(std::stol(fs::path{path}.filename()));
    }
    ADD_FAILURE() << "the trick does not run";
    return getpid();
}

Outcome AtLevel::runText(const std::string& text) const {
    const fs::path folder = Sandbox::makeStagingFolder();
    std::ofstream{folder / "program"} << text;
    fs::permissions(folder / "program", fs::perms{0755});
    Command command = trick({});
    command.readOnly = {{folder / "program", "/program"}};
    command.arguments[0] = "/program";
    Outcome outcome = run(command);
    fs::remove_all(folder);
    return outcome;
}

std::string describe(const Outcome& outcome) {
    switch (outcome.end) {
        case Outcome::End::exited:
            return "exit " + std::to_string(outcome.code);
        case Outcome::End::signalled:
            return "signal " + std::to_string(outcome.code);
        case Outcome::End::wallLimit:
            return "wall limit";
        case Outcome::End::outputLimit:
            return "output limit";
        case Outcome::End::failed:
            break;
    }
    return "failed: " + outcome.output;
}

}  // namespace ticker::sandbox

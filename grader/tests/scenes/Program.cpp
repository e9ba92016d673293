#include "Program.h"

#include <grader/tests/io/TemporaryFolder.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

extern char** environ;

namespace ticker::testing {
namespace {

const std::string kProgram = std::string(TICKER_BINARY_DIR) + "/bin/tick1star-reference";

class FileActions {
public:
    FileActions() { posix_spawn_file_actions_init(&actions_); }
    ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;

    void open(int descriptor, const std::string& file, int flags) {
        constexpr mode_t kOwnerOnly = 0600;
        posix_spawn_file_actions_addopen(&actions_, descriptor, file.c_str(), flags, kOwnerOnly);
    }
    [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_{};
};

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts)
        pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

pid_t start(std::vector<std::string> arguments, std::vector<std::string> environment,
            const FileActions& actions) {
    arguments.insert(arguments.begin(), kProgram);
    for (char** variable = environ; *variable != nullptr; ++variable)
        if (!std::string(*variable).starts_with("NO_COLOR=")) environment.emplace_back(*variable);
    pid_t process = 0;
    if (posix_spawn(&process, kProgram.c_str(), actions.get(), nullptr,
                    pointersTo(arguments).data(), pointersTo(environment).data()) != 0)
        throw std::runtime_error("cannot start " + kProgram);
    return process;
}

int waitFor(pid_t process) {
    int status = 0;
    waitpid(process, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

ProgramResult runTick1Star(const std::vector<std::string>& arguments,
                           const std::filesystem::path& scratch) {
    const std::string out = scratch / "stdout.txt";
    const std::string err = scratch / "stderr.txt";
    FileActions actions;
    actions.open(STDOUT_FILENO, out, O_WRONLY | O_CREAT | O_TRUNC);
    actions.open(STDERR_FILENO, err, O_WRONLY | O_CREAT | O_TRUNC);
    const int exitCode = waitFor(start(arguments, {}, actions));
    return {exitCode, bytesOf(out), bytesOf(err)};
}

Tick1StarOnTerminal::Tick1StarOnTerminal(const std::vector<std::string>& arguments,
                                         const std::vector<std::string>& extraEnvironment)
    : terminal_(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)), process_(-1) {
    if (terminal_ < 0 || grantpt(terminal_) != 0 || unlockpt(terminal_) != 0)
        throw std::runtime_error("no terminal can be made");
    FileActions actions;
    actions.open(STDERR_FILENO, ptsname(terminal_), O_RDWR | O_NOCTTY);
    process_ = start(arguments, extraEnvironment, actions);
}

Tick1StarOnTerminal::~Tick1StarOnTerminal() {
    if (process_ > 0) {
        kill(process_, SIGKILL);
        waitFor(process_);
    }
    close(terminal_);
}

std::string Tick1StarOnTerminal::read() const {
    std::array<char, 4096> block{};
    // A terminal whose other side is closed gives an error and no end of file.
    const ssize_t count = ::read(terminal_, block.data(), block.size());
    return count > 0 ? std::string(block.data(), static_cast<std::size_t>(count)) : std::string();
}

void Tick1StarOnTerminal::interrupt() const {
    kill(process_, SIGINT);
}

int Tick1StarOnTerminal::wait() {
    const int exitCode = waitFor(process_);
    process_ = -1;
    return exitCode;
}

}  // namespace ticker::testing

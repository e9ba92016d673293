#include "StudentProgram.h"

#include <grader/tests/io/BytesOf.h>

#include <fcntl.h>
#include <pty.h>
#include <spawn.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <utility>

extern char** environ;  // NOLINT: POSIX

namespace ticker::testing {
namespace {

const std::string kProgram = std::string(TICKER_BINARY_DIR) + "/bin/tick1star-";

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

/// Our environment without NO_COLOR, after `before`: the first of two values counts.
std::vector<std::string> environmentAfter(std::vector<std::string> before) {
    for (char** variable = environ; *variable != nullptr; ++variable)
        if (!std::string(*variable).starts_with("NO_COLOR=")) before.emplace_back(*variable);
    return before;
}

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts)
        pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

pid_t start(const std::string& program, std::vector<std::string> arguments,
            const FileActions& actions) {
    arguments.insert(arguments.begin(), program);
    std::vector<std::string> environment = environmentAfter({});
    pid_t process = 0;
    if (posix_spawn(&process, program.c_str(), actions.get(), nullptr, pointersTo(arguments).data(),
                    pointersTo(environment).data()) != 0)
        throw std::runtime_error("cannot start " + program);
    return process;
}

int waitFor(pid_t process) {
    int status = 0;
    waitpid(process, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

ProgramResult runTick1Star(const std::vector<std::string>& arguments,
                           const std::filesystem::path& scratch, const std::string& solution) {
    const std::string out = scratch / "stdout.txt";
    const std::string err = scratch / "stderr.txt";
    FileActions actions;
    actions.open(STDOUT_FILENO, out, O_WRONLY | O_CREAT | O_TRUNC);
    actions.open(STDERR_FILENO, err, O_WRONLY | O_CREAT | O_TRUNC);
    const int exitCode = waitFor(start(kProgram + solution, arguments, actions));
    return {exitCode, bytesOf(out), bytesOf(err)};
}

Tick1StarOnTerminal::Tick1StarOnTerminal(std::vector<std::string> arguments,
                                         std::vector<std::string> environment, int columns,
                                         int lines) {
    const std::string program = kProgram + "reference";
    arguments.insert(arguments.begin(), program);
    environment = environmentAfter(std::move(environment));
    const std::vector<char*> argumentPointers = pointersTo(arguments);
    const std::vector<char*> environmentPointers = pointersTo(environment);
    const winsize size{static_cast<unsigned short>(lines), static_cast<unsigned short>(columns), 0,
                       0};
    process_ = forkpty(&terminal_, nullptr, nullptr, &size);
    if (process_ < 0) throw std::runtime_error("no terminal can be made");
    if (process_ == 0) {
        execve(program.c_str(), argumentPointers.data(), environmentPointers.data());
        _exit(127);
    }
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
    // A terminal whose other side is closed gives an error instead of an end of file.
    const ssize_t count = ::read(terminal_, block.data(), block.size());
    return count > 0 ? std::string(block.data(), static_cast<std::size_t>(count)) : std::string();
}

std::string Tick1StarOnTerminal::readAll() const {
    std::string all;
    for (std::string more = read(); !more.empty(); more = read())
        all += more;
    return all;
}

void Tick1StarOnTerminal::interrupt() const {
    constexpr char kCtrlC = '\003';
    if (write(terminal_, &kCtrlC, 1) != 1) throw std::runtime_error("the terminal is gone");
}

int Tick1StarOnTerminal::wait() {
    const int exitCode = waitFor(process_);
    process_ = -1;
    return exitCode;
}

}  // namespace ticker::testing

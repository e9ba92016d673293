#include "RunningTicker.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <stdexcept>

namespace ticker::cli {

RunningTicker::RunningTicker(const std::vector<std::string>& arguments,
                             const std::string& errorsFile) {
    std::array<int, 2> pipe{};
    if (pipe2(pipe.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    output_ = pipe[0];
    std::vector<std::string> words{std::string{TICKER_BINARY_DIR} + "/bin/ticker"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipe[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errorsFile.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0644);
    const int error = posix_spawn(&process_, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(pipe[1]);
    if (error != 0) throw std::runtime_error("cannot run " + words[0]);
}

RunningTicker::~RunningTicker() {
    if (!status_) {
        send(SIGKILL);
        wait();
    }
    close(output_);
}

std::optional<std::string> RunningTicker::readLine() {
    for (;;) {
        if (const std::size_t end = buffer_.find('\n'); end != std::string::npos) {
            std::string line = buffer_.substr(0, end);
            buffer_.erase(0, end + 1);
            return line;
        }
        std::array<char, 4096> block{};
        const ssize_t size = read(output_, block.data(), block.size());
        if (size < 0 && errno == EINTR) continue;
        if (size <= 0) return std::nullopt;
        buffer_.append(block.data(), static_cast<std::size_t>(size));
    }
}

void RunningTicker::send(int signal) const {
    if (!status_) kill(process_, signal);
}

int RunningTicker::wait() {
    if (status_) return *status_;
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return *status_;
}

}  // namespace ticker::cli

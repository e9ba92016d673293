#ifndef _WIN32
#include "../Guard.h"
#include "Process.h"

#include <raytracer/base/Error.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <utility>

namespace raytracer::view {
namespace {

namespace fs = std::filesystem;

void closeEnd(int& end) {
    if (end >= 0) close(end);
    end = -1;
}

/// Both ends of a pipe. The destructor closes an end unless its number was taken out (-1).
struct Pipe {
    Pipe(int readEnd, int writeEnd) : read(readEnd), write(writeEnd) {}
    ~Pipe() {
        closeEnd(read);
        closeEnd(write);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    int read;
    int write;
};

// Two forks at a time would hand each other's pipes on, which then never end.
std::mutex& forking() {
    static std::mutex mutex;
    return mutex;
}

Pipe makePipe() {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw Error("the system gives no pipe");
    for (const int end : ends)
        fcntl(end, F_SETFD, FD_CLOEXEC);
    return {ends[0], ends[1]};
}

std::size_t readAll(int file, char* bytes, std::size_t size) {
    for (;;) {
        const ssize_t got = ::read(file, bytes, size);
        if (got >= 0) return static_cast<std::size_t>(got);
        if (errno != EINTR) return 0;
    }
}

bool writeAll(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

}  // namespace

struct Process::Handles {
    pid_t guard = -1;
    int in = -1;   // what it reads
    int out = -1;  // what it writes
    int lifeline = -1;
    int status = kKilled;
    std::mutex mutex{};
};

Process::Process(const std::vector<std::string>& command, Errors errors)
    : handles_(std::make_unique<Handles>()) {
    std::signal(SIGPIPE, SIG_IGN);
    std::vector<char*> words;
    for (const std::string& word : command)
        words.push_back(const_cast<char*>(word.c_str()));  // exec's old-fashioned type
    words.push_back(nullptr);

    const std::lock_guard lock{forking()};
    Pipe in = makePipe();
    Pipe out = makePipe();
    Pipe life = makePipe();
    const int err = errors == Errors::withItsOutput ? out.write : STDERR_FILENO;
    handles_->guard = fork();
    if (handles_->guard == 0) becomeGuard(words.data(), {in.read, out.write, err, life.read});
    if (handles_->guard < 0) throw Error("the system gives no process");
    handles_->in = std::exchange(in.write, -1);
    handles_->out = std::exchange(out.read, -1);
    handles_->lifeline = std::exchange(life.write, -1);
}

Process::~Process() {
    kill();
    static_cast<void>(wait());
    closeEnd(handles_->in);
    closeEnd(handles_->out);
}

std::size_t Process::read(char* bytes, std::size_t size) {
    return readAll(handles_->out, bytes, size);
}

bool Process::write(std::string_view bytes) {
    return writeAll(handles_->in, bytes);
}

void Process::kill() {
    const std::lock_guard lock{handles_->mutex};
    closeEnd(handles_->lifeline);
}

int Process::wait() {
    if (handles_->guard > 0) {
        int status = 0;
        while (waitpid(handles_->guard, &status, 0) < 0 && errno == EINTR)
            ;
        handles_->status = statusOf(status);
        handles_->guard = -1;
    }
    return handles_->status;
}

Parent::Parent() : in_(STDIN_FILENO), out_(dup(STDOUT_FILENO)) {
    dup2(STDERR_FILENO, STDOUT_FILENO);
    std::signal(SIGPIPE, SIG_IGN);
}

std::size_t Parent::read(char* bytes, std::size_t size) {
    return readAll(in_, bytes, size);
}

bool Parent::write(std::string_view bytes) {
    return writeAll(out_, bytes);
}

void yieldToOthers() {
    constexpr int kSteps = 5;  // a third of the processor where others want all of it
    static_cast<void>(nice(kSteps));
}

fs::path moveAside(const fs::path& /*program*/) {
    return {};
}

void openInBrowser(const std::string& address) {
#ifdef __APPLE__
    const char* opener = "open";
#else
    const char* opener = "xdg-open";
    if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
#endif
    if (isatty(STDOUT_FILENO) != 1) return;
    const std::array<const char*, 3> command{opener, address.c_str(), nullptr};
    // The browser outlives this program, so nothing guards it.
    const pid_t child = fork();
    if (child == 0) {
        closeFrom(STDERR_FILENO + 1);
        if (fork() != 0) _exit(0);
        setsid();
        execvp(opener, const_cast<char* const*>(command.data()));
        _exit(kNotFound);
    }
    if (child > 0) waitpid(child, nullptr, 0);
}

}  // namespace raytracer::view
#endif

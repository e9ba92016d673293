#include <grader/base/FileDescriptor.h>
#include <grader/sandbox/Watch.h>
#include <grader/sandbox/jail/JailOptions.h>
#include <grader/sandbox/jail/Report.h>

#include <fmt/core.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <optional>
#include <system_error>
#include <utility>

namespace ticker::sandbox {
namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

// Time for a helper to end and reap a jail before the helper itself is killed.
constexpr Milliseconds kGrace{10'000.0};

struct Pipe {
    FileDescriptor read;
    FileDescriptor write;
};

std::optional<Pipe> makePipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return std::nullopt;
    Pipe pipe{FileDescriptor{ends[0]}, FileDescriptor{ends[1]}};
    if (fcntl(pipe.read.get(), F_SETFL, O_NONBLOCK) != 0) return std::nullopt;
    return pipe;
}

Outcome ourFault(const std::string& what, int error) {
    Outcome outcome;
    outcome.output = fmt::format("sandbox: {}: {}", what, std::generic_category().message(error));
    return outcome;
}

class Watcher {
public:
    /// @param handle  The helper's, readable once it has ended.
    Watcher(pid_t helper, FileDescriptor handle, Pipe output, Pipe status, const Limits& limits)
        : helper_(helper),
          handle_(std::move(handle)),
          output_(std::move(output)),
          status_(std::move(status)),
          limits_(limits),
          deadline_(after(Milliseconds{limits.wallSeconds * 1000.0})) {
        output_.write.reset();
        status_.write.reset();
    }

    Outcome wait() {
        while (!ended()) {
        }
        readOutput();
        return conclude();
    }

private:
    static Clock::time_point after(Milliseconds time) {
        return Clock::now() + std::chrono::duration_cast<Clock::duration>(time);
    }

    // One step of waiting: true once the helper has ended.
    bool ended() {
        const Milliseconds left = deadline_ - Clock::now();
        if (left.count() <= 0) onDeadline();
        std::array<pollfd, 2> polled{
            {{handle_.get(), POLLIN, 0}, {outputOpen_ ? output_.read.get() : -1, POLLIN, 0}}};
        const int timeout = static_cast<int>(std::clamp(left.count(), 0.0, 60'000.0)) + 1;
        if (poll(polled.data(), polled.size(), timeout) < 0 && errno != EINTR) return true;
        if (polled[1].revents != 0) readOutput();
        return polled[0].revents != 0;
    }

    void readOutput() {
        std::array<char, 16384> buffer{};
        while (outputOpen_) {
            const ssize_t got = read(output_.read.get(), buffer.data(), buffer.size());
            if (got < 0 && errno == EINTR) continue;
            if (got < 0 && errno == EAGAIN) return;
            if (got <= 0) {
                outputOpen_ = false;
                return;
            }
            keepOutput({buffer.data(), static_cast<std::size_t>(got)});
        }
    }

    void keepOutput(std::string_view text) {
        const std::size_t room = limits_.outputBytes - outcome_.output.size();
        outcome_.output.append(text.substr(0, room));
        if (text.size() <= room) return;
        outputOpen_ = false;
        stop(Outcome::End::outputLimit);
    }

    void onDeadline() {
        if (stopped_) {
            kill(helper_, SIGKILL);
            deadline_ = after(kGrace);
        } else {
            stop(Outcome::End::wallLimit);
        }
    }

    // SIGTERM, not SIGKILL: the helper then ends and reaps all processes of the jail.
    void stop(Outcome::End reason) {
        if (stopped_) return;
        stopped_ = reason;
        deadline_ = after(kGrace);
        kill(helper_, SIGTERM);
    }

    Outcome conclude() {
        rusage usage{};
        int status = 0;
        while (wait4(helper_, &status, 0, &usage) < 0 && errno == EINTR) {
        }
        outcome_.wallMs = Milliseconds(Clock::now() - began_).count();
        jail::Report report;
        const bool reported = read(status_.read.get(), &report, sizeof report) == sizeof report &&
                              report.magic == jail::Report::kMagic;
        if (reported && report.kind != jail::Report::Kind::setupFailed)
            take(report);
        else
            take(usage);
        if (stopped_) {
            outcome_.end = *stopped_;
            outcome_.code = 0;
        }
        return std::move(outcome_);
    }

    void take(const jail::Report& report) {
        outcome_.cpuMs = static_cast<double>(report.cpuMicroseconds) / 1000.0;
        outcome_.peakMemoryBytes = report.peakMemoryBytes;
        outcome_.productsMissing = report.productsMissing != 0;
        outcome_.code = report.code;
        const bool exited = report.kind == jail::Report::Kind::exited;
        outcome_.end = exited ? Outcome::End::exited : Outcome::End::signalled;
        // A compiler that ignores SIGXCPU gets SIGKILL a second later: the same limit, so the same
        // result. For a program the helper reports SIGXCPU itself.
        if (!exited && report.code == SIGKILL && outcome_.cpuMs >= limits_.cpuSeconds * 1000.0)
            outcome_.code = SIGXCPU;
    }

    // No report arrived: the helper was killed from outside, or failed before the command began.
    void take(const rusage& usage) {
        const auto milliseconds = [](const timeval& time) {
            return static_cast<double>(time.tv_sec) * 1000.0 +
                   static_cast<double>(time.tv_usec) / 1000.0;
        };
        outcome_.cpuMs = milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime);
        outcome_.peakMemoryBytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024U;
        outcome_.end = Outcome::End::failed;
    }

    pid_t helper_;
    FileDescriptor handle_;
    Pipe output_;
    Pipe status_;
    const Limits& limits_;
    Clock::time_point began_ = Clock::now();
    Clock::time_point deadline_;
    std::optional<Outcome::End> stopped_;
    bool outputOpen_ = true;
    Outcome outcome_;
};

// SIGTERM, as Watcher::stop: the helper ends and reaps what it may have started by now.
void endUnwatched(pid_t helper) {
    kill(helper, SIGTERM);
    while (waitpid(helper, nullptr, 0) < 0 && errno == EINTR) {
    }
}

}  // namespace

Outcome watch(Launch launch, const Limits& limits) {
    std::optional<Pipe> output = makePipe();
    std::optional<Pipe> status = makePipe();
    const FileDescriptor nothing{open("/dev/null", O_RDONLY | O_CLOEXEC)};
    if (!output || !status || !nothing.isOpen()) return ourFault("no descriptors left", errno);
    launch.redirections.push_back({nothing.get(), 0});
    launch.redirections.push_back({output->write.get(), 1});
    launch.redirections.push_back({output->write.get(), 2});
    launch.redirections.push_back({status->write.get(), jail::kStatusDescriptor});
    const Launched launched = sandbox::launch(launch);
    if (launched.pid < 0) return ourFault("cannot start the helper", launched.error);
    FileDescriptor handle{static_cast<int>(syscall(SYS_pidfd_open, launched.pid, 0))};
    if (!handle.isOpen()) {
        const int error = errno;
        endUnwatched(launched.pid);
        return ourFault("pidfd_open", error);
    }
    return Watcher{launched.pid, std::move(handle), std::move(*output), std::move(*status), limits}
        .wait();
}

}  // namespace ticker::sandbox

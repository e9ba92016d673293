#include <grader/cli/Interrupt.h>

#include <raytracer/base/Error.h>

#include <unistd.h>
#include <csignal>
#include <string_view>

namespace ticker::cli {
namespace {

// Signal handlers may access only this.
std::atomic<bool> stopAsked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void askToStop(int /*signal*/) {
    if (stopAsked.exchange(true)) _exit(raytracer::toInt(raytracer::ExitCode::interrupted));
    constexpr std::string_view kWords =
        "\nticker: finishing what is being graded; Ctrl-C again stops at once\n";
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kWords.data(), kWords.size());
}

}  // namespace

const std::atomic<bool>& catchInterrupts() {
    std::signal(SIGINT, askToStop);
    std::signal(SIGTERM, askToStop);
    return stopAsked;
}

}  // namespace ticker::cli

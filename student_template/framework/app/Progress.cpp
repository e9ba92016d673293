#include "Progress.h"

#include "ProgressText.h"

#include <csignal>
#include <cstdio>
#include <utility>

namespace raytracer {
namespace {

constexpr std::chrono::milliseconds kRedrawEvery{100};

// A signal handler may only set a flag: it has no other way to report.
std::atomic<bool> interruptAsked{false};
static_assert(std::atomic<bool>::is_always_lock_free, "needed in a signal handler");

void askToStop(int signal) {
    interruptAsked = true;
    std::signal(signal, SIG_DFL);
}

}  // namespace

Progress::Progress(bool drawn) : drawn_(drawn) {
    interruptAsked = false;
    std::signal(SIGINT, askToStop);
}

Progress::~Progress() {
    std::signal(SIGINT, SIG_DFL);
    if (drawn_) std::fputs("\r\033[K", stderr);
}

void Progress::drawAbove(std::function<std::string()> text) {
    above_ = std::move(text);
}

void Progress::rowFinished(int /*row*/, int done, int rows) {
    ++done_;
    if (!drawn_ && !above_) return;
    const std::lock_guard lock{mutex_};
    const Clock::time_point now = Clock::now();
    if (now - lastDrawn_ < kRedrawEvery) return;
    lastDrawn_ = now;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    std::string text = above_ ? above_() : std::string();
    if (drawn_) text += "\r" + progressText(done, rows, seconds) + "\033[K";
    std::fputs(text.c_str(), stderr);
}

bool Progress::interrupted() const {
    return interruptAsked;
}

}  // namespace raytracer

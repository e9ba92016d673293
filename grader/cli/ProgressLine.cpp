#include <grader/cli/ProgressLine.h>
#include <grader/result/Names.h>

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace ticker::cli {
namespace {

constexpr std::size_t kBarWidth = 24;
constexpr const char* kClear = "\r\x1B[K";

std::string clock(double seconds) {
    const auto whole = std::lround(seconds);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::size_t columnsOfTerminal() {
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

void drawOver(std::string_view text) {
    std::fputs(drawnLine(text, columnsOfTerminal()).c_str(), stderr);
    std::fflush(stderr);
}

}  // namespace

// The last column stays free: some terminals wrap as soon as it is written.
std::string drawnLine(std::string_view text, std::size_t columns) {
    return kClear + std::string{columns == 0 ? text : text.substr(0, columns - 1)};
}

bool mayDraw(bool quiet) {
    return !quiet && std::getenv("NO_COLOR") == nullptr && ::isatty(STDERR_FILENO) == 1;
}

Progress::Progress(std::size_t total, bool draw)
    : total_(total), draw_(draw), start_(std::chrono::steady_clock::now()) {
    if (draw_) drawLine();
}

Progress::~Progress() {
    if (draw_) std::fputs(kClear, stderr);
}

void Progress::finished(Verdict verdict, bool isKept) {
    const std::lock_guard lock{mutex_};
    ++done_;
    if (isKept) ++kept_;
    ++counts_[verdict];
    if (draw_) drawLine();
}

void Progress::print(const std::string& line) {
    const std::lock_guard lock{mutex_};
    if (draw_) std::fputs(kClear, stderr);
    std::fputs((line + "\n").c_str(), stdout);
    std::fflush(stdout);
    if (draw_) drawLine();
}

void Progress::drawLine() const {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    const std::size_t filled = total_ == 0 ? kBarWidth : done_ * kBarWidth / total_;
    std::string line = fmt::format("[{}{}] {}/{}", std::string(filled, '#'),
                                   std::string(kBarWidth - filled, '.'), done_, total_);
    if (done_ > kept_) {
        const double each = passed.count() / static_cast<double>(done_ - kept_);
        line += fmt::format("  {:.1f}/s  {} left", 1.0 / each,
                            clock(each * static_cast<double>(total_ - done_)));
    }
    for (const auto& [verdict, count] : counts_)
        line += fmt::format("  {} {}", count, toString(verdict));
    drawOver(line);
}

Countdown::Countdown(std::string what, std::size_t already, bool draw)
    : what_(std::move(what)),
      already_(already),
      draw_(draw),
      start_(std::chrono::steady_clock::now()) {}

Countdown::~Countdown() {
    if (draw_) std::fputs(kClear, stderr);
}

void Countdown::show(std::size_t done, std::size_t of) const {
    if (!draw_ || done <= already_) return;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    const double each = passed.count() / static_cast<double>(done - already_);
    drawOver(fmt::format("{}: {} of {}  {} left", what_, done, of,
                         clock(each * static_cast<double>(of - done))));
}

}  // namespace ticker::cli

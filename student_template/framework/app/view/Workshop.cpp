#include "Workshop.h"

#include "BuildOutput.h"
#include "Json.h"
#include "Lines.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

namespace raytracer::view {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kLongestRun{120};
constexpr std::size_t kMostOutput = 20'000;

std::string textOf(const fs::path& file) {
    std::ifstream stream{file, std::ios::binary};
    return {std::istreambuf_iterator<char>{stream}, {}};
}

std::string lineOf(const fs::path& file, int number) {
    const std::vector<std::string> lines = splitAt(textOf(file), '\n');
    const auto index = static_cast<std::size_t>(number) - 1;
    return number > 0 && index < lines.size() ? lines[index] : std::string{};
}

Members state(std::string_view name) {
    return Members{}.add("state", json(name));
}

}  // namespace

Workshop::Workshop(const ViewHome& home, Board& board, Listener listener)
    : home_(home), board_(board), listener_(std::move(listener)), seen_(stamps()) {
    thread_ = std::thread{[this] { work(); }};
}

Workshop::~Workshop() {
    {
        const std::lock_guard lock{mutex_};
        isEnding_ = true;
        if (running_ != nullptr) running_->kill();
        asked_.notify_all();
    }
    thread_.join();
}

std::map<fs::path, Workshop::Stamp> Workshop::stamps() const {
    std::map<fs::path, Stamp> stamps;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator{home_.exercise, error}) {
        if (entry.path().extension() != ".cpp") continue;
        const fs::file_time_type time = entry.last_write_time(error);
        if (!error) stamps[entry.path()] = {time, entry.file_size(error)};
    }
    return stamps;
}

void Workshop::look() {
    const std::map<fs::path, Stamp> now = stamps();
    const std::lock_guard lock{mutex_};
    if (running_ != nullptr && Clock::now() > deadline_) running_->kill();
    // Editors that save by renaming leave a moment without the file.
    if (now == seen_ || now.size() < seen_.size()) return;
    for (const auto& [file, stamp] : now)
        if (!seen_.contains(file) || seen_.at(file) != stamp) tasks_.merge(tasksIn(textOf(file)));
    seen_ = now;
    isAsked_ = true;
    if (running_ != nullptr) running_->kill();
    asked_.notify_all();
}

bool Workshop::isOver() {
    const std::lock_guard lock{mutex_};
    return isAsked_ || isEnding_;
}

void Workshop::work() {
    for (bool isFirst = true;; isFirst = false) {
        std::set<std::string> tasks;
        {
            std::unique_lock lock{mutex_};
            asked_.wait(lock, [this] { return isAsked_ || isEnding_; });
            if (isEnding_) return;
            isAsked_ = false;
            tasks = tasks_;
        }
        if (!isFirst) listener_.onSaved();
        buildAndTest(tasks);
    }
}

void Workshop::buildAndTest(const std::set<std::string>& tasks) {
    std::error_code error;
    const auto before = fs::last_write_time(home_.program, error);
    board_.set("build", state("building").object());
    const Outcome built = build(home_.target);
    if (isOver()) return;
    if (built.status != 0) {
        tellOfErrors(built.output);
        return listener_.onUnchanged();
    }
    board_.set("build", state("built").object());
    if (fs::last_write_time(home_.program, error) != before)
        listener_.onBuilt();
    else
        listener_.onUnchanged();
    test(tasks);
    // Saves during a build that was given up count for the next one, too.
    const std::lock_guard lock{mutex_};
    if (!isAsked_) tasks_.clear();
}

Workshop::Outcome Workshop::build(const std::string& target) {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    if (target == home_.target) moveAside(home_.program);
    return run({home_.cmake, "--build", home_.build.string(), "--target", target, "--parallel",
                std::to_string(cores)});
}

Workshop::Outcome Workshop::run(const std::vector<std::string>& command) {
    Process process{command, Process::Errors::withItsOutput};
    {
        const std::lock_guard lock{mutex_};
        running_ = &process;
        deadline_ = Clock::now() + kLongestRun;
        if (isAsked_ || isEnding_) process.kill();
    }
    Outcome outcome;
    std::array<char, 4096> bytes{};
    while (const std::size_t got = process.read(bytes.data(), bytes.size()))
        if (outcome.output.size() < 10 * kMostOutput) outcome.output.append(bytes.data(), got);
    outcome.status = process.wait();
    const std::lock_guard lock{mutex_};
    running_ = nullptr;
    return outcome;
}

void Workshop::tellOfErrors(const std::string& output) {
    Members members = state("failed");
    const auto error = firstErrorIn(output);
    if (error) {
        const fs::path file{error->file};
        members.add("file", json(file.filename().string()))
            .add("line", std::to_string(error->line))
            .add("message", json(error->message))
            .add("source",
                 json(lineOf(file.is_absolute() ? file : home_.build / file, error->line)));
    }
    board_.set("build", members.add("all", json(output.substr(0, kMostOutput))).object());
}

void Workshop::test(const std::set<std::string>& tasks) {
    if (home_.testTarget.empty()) return board_.set("tests", state("none").object());
    board_.set("tests", state("running").object());
    const Outcome built = build(home_.testTarget);
    if (isOver()) return;
    if (built.status != 0) return tellOfErrors(built.output);
    const Outcome ran = run({home_.tests.string()});
    if (isOver()) return;
    const TestOutcome outcome = testOutcomeIn(ran.output, tasks);
    // The status counts the other tasks' tests as well, but a crash leaves no summary.
    const bool isCutShort = outcome.summary.empty() && !outcome.hasFailed;
    Members members = state(outcome.hasFailed || isCutShort ? "failed" : "passed");
    members.add("title", json(isCutShort ? "The public tests ended too early" : outcome.title))
        .add("text", json(isCutShort ? ran.output.substr(0, kMostOutput) : outcome.text))
        .add("summary", json(outcome.summary));
    board_.set("tests", members.object());
}

}  // namespace raytracer::view

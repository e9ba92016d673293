#include "Workshop.h"

#include "Json.h"
#include "Lines.h"

#include <raytracer/base/Error.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <system_error>

namespace raytracer::view {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostOutput = 20'000;  // shown
constexpr std::size_t kMostKept = 10 * kMostOutput;
constexpr int kMostLooksWithoutAFile = 20;  // a second

/// The first error is near the beginning, a crash at the end.
void keep(std::string& output, std::string_view bytes) {
    output += bytes;
    if (output.size() > 2 * kMostKept) output.erase(kMostKept / 2, output.size() - kMostKept);
}

std::string_view endOf(std::string_view output) {
    return output.substr(output.size() - std::min(output.size(), kMostOutput));
}

std::string textOf(const fs::path& file) {
    std::ifstream stream{file, std::ios::binary};
    return {std::istreambuf_iterator<char>{stream}, {}};
}

std::string lineOf(const fs::path& file, int number) {
    const std::vector<std::string> lines = splitAt(textOf(file), '\n');
    const auto index = static_cast<std::size_t>(number) - 1;
    return number > 0 && index < lines.size() ? lines[index] : std::string{};
}

std::string limitInWords() {
    return std::to_string(kLongestBuild.count()) + " minutes";
}

Members state(std::string_view name) {
    return Members{}.add("state", json(name));
}

}  // namespace

Workshop::Workshop(const ViewHome& home, Board& board, Listener listener,
                   std::chrono::milliseconds patience)
    : home_(home),
      board_(board),
      listener_(std::move(listener)),
      patience_(patience),
      seen_(stamps()) {
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
    if (running_ != nullptr && Clock::now() > deadline_) {
        isTooLate_ = true;
        running_->kill();
    }
    // Editors that save by renaming leave a moment without the file.
    looksWithoutAFile_ = now.size() < seen_.size() ? looksWithoutAFile_ + 1 : 0;
    const bool isAMoment = looksWithoutAFile_ > 0 && looksWithoutAFile_ < kMostLooksWithoutAFile;
    if (now == seen_ || isAMoment) return;
    looksWithoutAFile_ = 0;
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
        board_.set("tests", state("unasked").object());
        tellOfFailure("build", "failed", built);
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
    const fs::path aside = target == home_.target ? moveAside(home_.program) : fs::path{};
    Outcome built = run({home_.cmake, "--build", home_.build.string(), "--target", target,
                         "--parallel", std::to_string(cores)});
    // Where nothing was linked, the last program goes on.
    std::error_code error;
    if (!aside.empty() && !fs::exists(home_.program, error))
        fs::rename(aside, home_.program, error);
    return built;
}

Workshop::Outcome Workshop::run(const std::vector<std::string>& command,
                                const std::function<void(std::string_view)>& hear) {
    std::optional<Process> process;
    try {
        process.emplace(command, Process::Errors::withItsOutput);
    } catch (const Error& error) {
        return {error.what(), kNotFound};
    }
    {
        const std::lock_guard lock{mutex_};
        running_ = &*process;
        deadline_ = Clock::now() + patience_;
        isTooLate_ = false;
        if (isAsked_ || isEnding_) process->kill();
    }
    Outcome outcome;
    std::array<char, 4096> bytes{};
    while (const std::size_t got = process->read(bytes.data(), bytes.size())) {
        hear({bytes.data(), got});
        keep(outcome.output, {bytes.data(), got});
    }
    outcome.status = process->wait();
    const std::lock_guard lock{mutex_};
    running_ = nullptr;
    outcome.isStopped = isTooLate_ && outcome.status != 0;
    return outcome;
}

void Workshop::tellOfFailure(const std::string& entry, std::string_view failed,
                             const Outcome& built) {
    if (built.isStopped)
        return board_.set(entry, state("stopped").add("after", json(limitInWords())).object());
    Members members = state(failed);
    const auto error = firstErrorIn(built.output);
    if (error) {
        const fs::path file{error->file};
        members.add("file", json(file.filename().string()))
            .add("line", std::to_string(error->line))
            .add("message", json(error->message))
            .add("source",
                 json(lineOf(file.is_absolute() ? file : home_.build / file, error->line)));
    }
    board_.set(entry, members.add("all", json(built.output.substr(0, kMostOutput))).object());
}

void Workshop::test(const std::set<std::string>& tasks) {
    if (home_.testTarget.empty()) return board_.set("tests", state("none").object());
    board_.set("tests", state("running").object());
    const Outcome built = build(home_.testTarget);
    if (isOver()) return;
    if (built.status != 0) return tellOfFailure("tests", "unbuilt", built);
    const TestOutcome outcome = ask(tasks);
    if (isOver()) return;
    Members members = state(outcome.hasFailed ? "failed" : "passed");
    members.add("title", json(outcome.title))
        .add("text", json(outcome.text))
        .add("summary", json(outcome.summary));
    board_.set("tests", members.object());
}

TestOutcome Workshop::ask(const std::set<std::string>& tasks) {
    TestReader reader{tasks};
    for (const auto& [task, suite] : home_.suites) {
        if (!tasks.empty() && !tasks.contains(task)) continue;
        const Outcome ran = run({home_.tests.string(), "--gtest_filter=" + suite + ".*"},
                                [&](std::string_view bytes) { reader.add(bytes); });
        if (isOver()) break;
        reader.add("\n\n");  // ends what was cut off
        // 1: a test failed, and said so.
        const bool isWhole = ran.status == 0 || (ran.status == 1 && reader.outcome().hasFailed);
        if (!isWhole)
            reader.addEarlyEnd(task,
                               ran.isStopped ? "was stopped after " + limitInWords() +
                                                   ": look for a loop without end"
                                             : "ended too early",
                               endOf(ran.output));
    }
    return reader.outcome();
}

}  // namespace raytracer::view

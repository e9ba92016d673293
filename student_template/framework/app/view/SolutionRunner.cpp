#include "SolutionRunner.h"

#include "Lines.h"
#include "Worker.h"

#include <raytracer/base/Text.h>

#include <exception>
#include <utility>

namespace raytracer::view {
namespace {

constexpr int kSignalled = 128;

constexpr const char* kNoEnd =
    "Your code does not come to an end: look for a loop whose condition "
    "never becomes false.";

constexpr const char* kNotStarted =
    "The program could not be started: it is being built, or is missing. "
    "Ask again when the build is done.";

}  // namespace

std::string endInWords(int status) {
    if (status == kNotFound) return kNotStarted;
    if (status >= 0 && status <= kSignalled)
        return "Your code ended the program with the status " + std::to_string(status) + ".";
    const std::string signal =
        status > kSignalled ? " (signal " + std::to_string(status - kSignalled) + ")" : "";
    return "Your code crashed" + signal + ". The debug build tells the line: see README.md.";
}

SolutionRunner::SolutionRunner(std::filesystem::path program, Listener listener,
                               std::chrono::milliseconds patience)
    : program_(std::move(program)), listener_(std::move(listener)), patience_(patience) {}

SolutionRunner::~SolutionRunner() {
    stop();
}

void SolutionRunner::render(int number, const std::vector<std::string>& options) {
    const std::lock_guard lock{starting_};
    if (number < lastPicture_) return;  // another thread was faster
    if (!start()) return listener_.onTrouble(noProcess_);
    {
        const std::lock_guard waiting{mutex_};
        waitingSince_ = Clock::now();
        lastPicture_ = number;
    }
    send("picture", number, options);
}

SolutionRunner::Answer SolutionRunner::ask(const std::string& verb,
                                           const std::vector<std::string>& arguments) {
    int number = 0;
    {
        const std::lock_guard lock{starting_};
        if (!start()) return {false, noProcess_};
        {
            const std::lock_guard counting{mutex_};
            number = ++lastQuestion_;
            answers_[number] = isRunning_ ? std::nullopt : std::optional{unanswered()};
        }
        send(verb, number, arguments);
    }
    std::unique_lock lock{mutex_};
    answered_.wait_for(lock, patience_, [&] { return answers_[number].has_value(); });
    const std::optional<Answer> answer = answers_[number];
    answers_.erase(number);
    lock.unlock();
    if (answer) return *answer;
    restart();
    return {false, kNoEnd};
}

/// What a question hears whose process has ended.
SolutionRunner::Answer SolutionRunner::unanswered() const {
    if (isStopping_) return {false, "Your code was just built again: ask once more."};
    return {false, lastStatus_ == kNotFound ? kNotStarted : "Your code crashed at this question."};
}

void SolutionRunner::restart() {
    const std::lock_guard lock{starting_};
    stop();
}

void SolutionRunner::look() {
    {
        const std::lock_guard lock{mutex_};
        if (!waitingSince_ || Clock::now() - *waitingSince_ < patience_) return;
        waitingSince_.reset();
    }
    restart();
    listener_.onTrouble(kNoEnd);
}

bool SolutionRunner::start() {
    {
        const std::lock_guard lock{mutex_};
        if (isRunning_) return true;
    }
    stop();
    try {
        process_ = std::make_unique<Process>(
            std::vector<std::string>{program_.string(), std::string{kWorkerArgument}},
            Process::Errors::toOurs);
        setRunning(true);
        reader_ = std::thread{[this, process = process_.get()] { listen(*process); }};
    } catch (const std::exception& error) {
        setRunning(false);
        process_.reset();
        noProcess_ = std::string{"Your code could not be started: "} + error.what() + ".";
        return false;
    }
    return true;
}

void SolutionRunner::setRunning(bool isRunning) {
    const std::lock_guard lock{mutex_};
    isRunning_ = isRunning;
    isStopping_ = false;
}

void SolutionRunner::stop() {
    {
        const std::lock_guard lock{mutex_};
        isStopping_ = true;
    }
    if (process_) process_->kill();
    if (reader_.joinable()) reader_.join();
    process_.reset();
}

void SolutionRunner::send(const std::string& verb, int number,
                          const std::vector<std::string>& arguments) {
    std::string line = verb + "\t" + std::to_string(number);
    for (const std::string& argument : arguments)
        line += "\t" + argument;
    process_->write(line + "\n");  // where it has ended, the reader says so
}

void SolutionRunner::listen(Process& process) {
    LineReader lines{[&](char* bytes, std::size_t size) { return process.read(bytes, size); }};
    while (const auto head = lines.next()) {
        const std::vector<std::string> words = splitAt(*head, ' ');
        if (words.size() != 3) break;
        const auto payload = lines.block(parseCount(words[2]).value_or(0));
        if (!payload) break;
        hear(words[0], static_cast<int>(parseCount(words[1]).value_or(0)), *payload);
    }
    process.kill();
    tellOfEnd(process.wait());
}

void SolutionRunner::hear(const std::string& kind, int number, const std::string& payload) {
    {
        const std::lock_guard lock{mutex_};
        const auto question = answers_.find(number);
        if (question != answers_.end()) {
            question->second = Answer{kind != "failed", payload};
            answered_.notify_all();
            return;
        }
        if (number < lastPicture_) return;  // of an earlier picture
        waitingSince_.reset();
    }
    if (kind == "part") listener_.onPart(number, payload);
    if (kind == "failed") listener_.onTrouble(payload);
}

void SolutionRunner::tellOfEnd(int status) {
    bool isUnexpected = false;
    {
        const std::lock_guard lock{mutex_};
        isRunning_ = false;
        lastStatus_ = status;
        isUnexpected = !isStopping_;
        waitingSince_.reset();
        // Those who wait may look only when the next process runs.
        for (auto& [number, answer] : answers_)
            if (!answer) answer = unanswered();
        answered_.notify_all();
    }
    if (!isUnexpected) return;
    listener_.onTrouble(endInWords(status));
}

}  // namespace raytracer::view

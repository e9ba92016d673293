#ifndef RAYTRACER_APP_VIEW_SOLUTIONRUNNER_H
#define RAYTRACER_APP_VIEW_SOLUTIONRUNNER_H

#include "process/Process.h"

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace raytracer::view {

/// What a student is told when the solution's process ends by itself.
[[nodiscard]] std::string endInWords(int status);

/// The process in which the solution runs (see Worker.h): started where it is needed, ended where
/// it does not answer.
class SolutionRunner {
public:
    /// Called on a thread of the runner's, or on that which asks for a picture.
    struct Listener {
        std::function<void(int number, const std::string& payload)> onPart;
        std::function<void(const std::string& words)> onTrouble;
    };

    /// The answer to a question: JSON or bytes, else words on what went wrong.
    struct Answer {
        bool isGood = false;
        std::string payload;
    };

    /// @param patience  How long an answer, or the first part of a picture, may take.
    SolutionRunner(std::filesystem::path program, Listener listener,
                   std::chrono::milliseconds patience = std::chrono::seconds{10});
    ~SolutionRunner();
    SolutionRunner(const SolutionRunner&) = delete;
    SolutionRunner& operator=(const SolutionRunner&) = delete;

    /// Asks for a picture; it comes to the listener. One older than the last is not asked for.
    void render(int number, const std::vector<std::string>& options);
    /// Asks, and waits for the answer.
    [[nodiscard]] Answer ask(const std::string& verb, const std::vector<std::string>& arguments);
    /// Ends the process: the program has been built again.
    void restart();
    /// To be called now and then: ends a process that gives no first part of a picture.
    void look();

private:
    using Clock = std::chrono::steady_clock;

    /// False if the system gives no process: `noProcess_` says why.
    [[nodiscard]] bool start();
    void setRunning(bool isRunning);
    void stop();
    void listen(Process& process);
    void hear(const std::string& kind, int number, const std::string& payload);
    void send(const std::string& verb, int number, const std::vector<std::string>& arguments);
    void tellOfEnd(int status);
    [[nodiscard]] Answer unanswered() const;

    std::filesystem::path program_;
    Listener listener_;
    std::chrono::milliseconds patience_;
    std::mutex starting_;  // taken before mutex_
    std::unique_ptr<Process> process_;
    std::thread reader_;
    std::string noProcess_;
    int lastPicture_ = 0;  // written under both mutexes
    std::mutex mutex_;
    std::condition_variable answered_;
    std::map<int, std::optional<Answer>> answers_;
    int lastQuestion_ = 1'000'000;  // pictures have smaller numbers
    bool isRunning_ = false;
    int lastStatus_ = 0;  // of the process that has ended last
    bool isStopping_ = false;
    std::optional<Clock::time_point> waitingSince_;
};

}  // namespace raytracer::view

#endif

#ifndef RAYTRACER_APP_VIEW_WORKSHOP_H
#define RAYTRACER_APP_VIEW_WORKSHOP_H

#include "Board.h"
#include "BuildOutput.h"
#include "ViewHome.h"
#include "process/Process.h"

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace raytracer::view {

/// How long a build, or the tests of a task, may take.
inline constexpr std::chrono::minutes kLongestBuild{2};

/// Watches the exercise's files. When one is saved, it builds, says so, and runs the public tests
/// of that file's tasks; a save meanwhile begins again.
class Workshop {
public:
    /// Called on the workshop's thread.
    struct Listener {
        std::function<void()> onSaved;      ///< a build is about to begin
        std::function<void()> onBuilt;      ///< there is a new program
        std::function<void()> onUnchanged;  ///< the build failed or linked nothing new
    };

    /// @param patience  In place of `kLongestBuild`, which is what a person is told.
    Workshop(const ViewHome& home, Board& board, Listener listener,
             std::chrono::milliseconds patience = kLongestBuild);
    ~Workshop();
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;

    /// Looks whether a file was saved; to be called often.
    void look();

private:
    using Clock = std::chrono::steady_clock;
    using Stamp = std::pair<std::filesystem::file_time_type, std::uintmax_t>;

    /// How a command ended.
    struct Outcome {
        std::string output;
        int status = 0;
        bool isStopped = false;  ///< it took too long
    };

    [[nodiscard]] std::map<std::filesystem::path, Stamp> stamps() const;
    void work();
    void buildAndTest(const std::set<std::string>& tasks);
    /// Runs a command until it ends.
    /// @param hear  Gets all of its output. The result lacks the middle of long output.
    [[nodiscard]] Outcome run(
        const std::vector<std::string>& command,
        const std::function<void(std::string_view)>& hear = [](std::string_view) {});
    [[nodiscard]] Outcome build(const std::string& target);
    void test(const std::set<std::string>& tasks);
    /// Runs the public tests of each task in a process of its own, so that a crash in one task does
    /// not end the others.
    [[nodiscard]] TestOutcome ask(const std::set<std::string>& tasks);
    /// Tells that a build failed. @param entry  Of the board. @param failed  Its state where the
    /// compiler found errors.
    void tellOfFailure(const std::string& entry, std::string_view failed, const Outcome& built);
    [[nodiscard]] bool isOver();

    const ViewHome& home_;
    Board& board_;
    Listener listener_;
    std::chrono::milliseconds patience_;
    std::map<std::filesystem::path, Stamp> seen_;
    std::mutex mutex_;
    std::condition_variable asked_;
    int looksWithoutAFile_ = 0;
    std::set<std::string> tasks_;  // tasks of the files that were saved since the last build began
    bool isAsked_ = true;          // the program may be older than the files
    bool isEnding_ = false;
    Process* running_ = nullptr;
    Clock::time_point deadline_;
    bool isTooLate_ = false;  // what runs was stopped at the deadline
    std::thread thread_;
};

}  // namespace raytracer::view

#endif

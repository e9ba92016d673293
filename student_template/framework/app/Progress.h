#ifndef RAYTRACER_APP_PROGRESS_H
#define RAYTRACER_APP_PROGRESS_H

#include <raytracer/base/RenderObserver.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <string>

namespace raytracer {

/// Draws a progress bar with the time left on stderr, and stops the render at Ctrl-C.
class Progress final : public RenderMonitor {
public:
    /// @param drawn  Whether the bar is drawn at all; Ctrl-C works in any case. The first Ctrl-C
    ///         asks the render to stop, a second one ends the program.
    explicit Progress(bool drawn);

    /// Text that is drawn above the bar each time, even if the bar itself is not drawn.
    void drawAbove(std::function<std::string()> text);
    /// Erases the bar.
    ~Progress() override;
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void rowFinished(int row, int done, int rows) override;
    [[nodiscard]] bool interrupted() const override;

    /// Rows finished so far.
    [[nodiscard]] int done() const { return done_; }

private:
    using Clock = std::chrono::steady_clock;

    bool drawn_;
    Clock::time_point start_ = Clock::now();
    std::atomic<int> done_{0};
    std::mutex mutex_;
    Clock::time_point lastDrawn_;
    std::function<std::string()> above_;
};

}  // namespace raytracer

#endif

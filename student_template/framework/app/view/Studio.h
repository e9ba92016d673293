#ifndef RAYTRACER_APP_VIEW_STUDIO_H
#define RAYTRACER_APP_VIEW_STUDIO_H

#include "../Options.h"
#include "Board.h"
#include "SolutionRunner.h"
#include "ViewHome.h"
#include "Workshop.h"

#include <atomic>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace raytracer::view {

/// The viewer without its page: renders with the current settings, answers questions about pixels
/// and points, and builds saved files.
class Studio {
public:
    /// @param options  The first settings, with a scene.
    Studio(const ViewHome& home, const Options& options);
    ~Studio();
    Studio(const Studio&) = delete;
    Studio& operator=(const Studio&) = delete;

    [[nodiscard]] Board& board() { return board_; }

    /// Changes settings and renders again. @param changes  By the names of the page's controls.
    /// @throws InputError where a value is out of range, or a name or scene is unknown.
    void change(const std::map<std::string, std::string>& changes);

    [[nodiscard]] SolutionRunner::Answer pixel(const std::string& x, const std::string& y);
    [[nodiscard]] SolutionRunner::Answer point(const std::string& x, const std::string& y,
                                               const std::string& z);
    /// The pixels of the pinhole camera's picture with hard shadows: red, green, blue.
    [[nodiscard]] SolutionRunner::Answer pinhole();

private:
    void render();
    /// Stops an unfinished picture, since the compiler needs the processor.
    void pause();
    void takeProgram();
    /// Renders the picture again that `pause` stopped.
    void goOn();
    void hearPart(int number, const std::string& payload);
    [[nodiscard]] std::set<std::string> scenes() const;
    [[nodiscard]] std::vector<std::string> arguments();
    [[nodiscard]] std::vector<std::string> argumentsWhileLocked() const;  ///< by the caller
    [[nodiscard]] std::string settingsJson() const;

    const ViewHome& home_;
    Board board_;
    std::mutex mutex_;
    std::filesystem::path scenes_;
    std::string firstScene_;
    std::vector<std::string> others_;  // options without a control
    std::map<std::string, std::string> settings_;
    int pictures_ = 0;
    int builds_ = 0;
    bool isWhole_ = false;   // all of the newest picture is there
    bool isPaused_ = false;  // `pause` stopped the newest picture
    SolutionRunner runner_;
    Workshop workshop_;
    std::atomic<bool> isEnding_{false};
    std::thread clock_;
};

}  // namespace raytracer::view

#endif

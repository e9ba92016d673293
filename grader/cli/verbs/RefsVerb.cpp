#include <grader/base/MakeFolder.h>
#include <grader/cli/Home.h>
#include <grader/cli/ProgressLine.h>
#include <grader/cli/verbs/GradeOptions.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/exercise/Exercise.h>
#include <grader/oracle/references/ReferenceList.h>

#include <raytracer/base/RenderObserver.h>

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace ticker::cli {
namespace {

struct RefsOptions {
    bool check = false;
    std::string folder;
    std::string scenes;
    std::string exercise;
};

std::atomic<bool> refsStopAsked{false};
extern "C" void askRefsToStop(int /*signal*/) {
    refsStopAsked = true;
}

/// Lets Ctrl-C end a render between two rows.
class StopMonitor final : public raytracer::RenderMonitor {
public:
    void rowFinished(int /*row*/, int /*done*/, int /*rows*/) override {}
    [[nodiscard]] bool interrupted() const override { return refsStopAsked; }
};

std::vector<oracle::ReferenceScene> readScenes(const std::filesystem::path& folder,
                                               const std::filesystem::path& assets,
                                               StopMonitor& monitor) {
    std::vector<oracle::ReferenceScene> scenes = oracle::readReferenceList(folder, assets);
    for (oracle::ReferenceScene& scene : scenes) {
        scene.settings.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
        scene.settings.monitor = &monitor;
    }
    for (const std::string& name : oracle::scenesWithoutReference(folder, scenes))
        fmt::print(stderr, "{}.xml has no reference: {} does not list it\n", name,
                   (folder / "references.json").string());
    return scenes;
}

bool isNamedBy(const Exercise& exercise, const std::string& scene) {
    return std::ranges::find(exercise.scenes, scene, &SceneEntry::name) != exercise.scenes.end();
}

oracle::ReferenceListener listener(bool quiet) {
    return [draw = mayDraw(quiet)](const oracle::ReferenceProgress& progress) {
        if (!draw) return;
        const std::string left =
            progress.secondsLeft < 0.0 ? "" : fmt::format(", {:.0f} s left", progress.secondsLeft);
        fmt::print(stderr, "\r\x1B[K{} of {} {}{}", progress.done, progress.total, progress.scene,
                   left);
        if (progress.done == progress.total) fmt::print(stderr, "\r\x1B[K");
        std::fflush(stderr);
    };
}

raytracer::ExitCode checkThem(const std::filesystem::path& folder,
                              const std::vector<oracle::ReferenceScene>& scenes,
                              const oracle::ReferenceOptions& options,
                              const GlobalOptions& global) {
    std::error_code ignored;
    if (!std::filesystem::exists(folder / "manifest.json", ignored))
        throw raytracer::InputError(
            folder.string(), 0,
            fmt::format("holds no references; {} refs makes them", global.command));
    bool allPassed = true;
    const auto checks = oracle::checkReferences(folder, scenes, options, listener(global.quiet));
    for (const oracle::ReferenceCheck& one : checks) {
        fmt::print("{:<6} {}\n", one.passed ? "ok" : "DRIFT", one.message);
        allPassed = allPassed && one.passed;
    }
    // Ctrl-C ended the checks early: nothing is known about the other scenes.
    if (checks.size() < scenes.size()) return raytracer::ExitCode::interrupted;
    return allPassed ? raytracer::ExitCode::success : raytracer::ExitCode::checkFailed;
}

raytracer::ExitCode refs(const RefsOptions& options, const GlobalOptions& global) {
    const Home home = Home::find();
    std::signal(SIGINT, askRefsToStop);
    StopMonitor monitor;
    const std::filesystem::path folder = options.folder.empty()
                                             ? home.assets() / "references"
                                             : std::filesystem::path{options.folder};
    auto scenes =
        readScenes(options.scenes.empty() ? home.scenes() : std::filesystem::path{options.scenes},
                   home.assets(), monitor);
    if (!options.exercise.empty())
        std::erase_if(scenes, [&](const auto& one) {
            return !isNamedBy(exerciseNamed(options.exercise), one.name);
        });
    oracle::ReferenceOptions how;
    how.seed = std::random_device{}();
    how.toolVersion = TICKER_VERSION;
    if (options.check) return checkThem(folder, scenes, how, global);
    makeFolder(folder);
    if (!oracle::writeReferences(folder, scenes, how, listener(global.quiet)))
        return raytracer::ExitCode::interrupted;
    fmt::print("{} references in {}\n", scenes.size(), folder.string());
    return raytracer::ExitCode::success;
}

}  // namespace

Run addRefs(CLI::App& app, const GlobalOptions& global) {
    auto options = std::make_shared<RefsOptions>();
    CLI::App* verb = app.add_subcommand(
        "refs", "Make the reference pictures anew, or look whether they drifted");
    verb->add_flag("--check", options->check, "Render again and compare; exit 1 on a drift");
    verb->add_option("--folder", options->folder, "Instead of assets/references");
    verb->add_option("--scenes", options->scenes, "Instead of scenes/");
    verb->add_option("--exercise", options->exercise,
                     "Only the scenes that this exercise names; else all that are listed")
        ->check(CLI::IsMember(exerciseNames()));
    return [options, &global] { return refs(*options, global); };
}

}  // namespace ticker::cli

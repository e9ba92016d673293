#include "View.h"

#include "Process.h"
#include "Studio.h"
#include "ViewHome.h"
#include "ViewServer.h"

#include <raytracer/io/SceneReader.h>

#include "../Inputs.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <iostream>
#include <set>
#include <system_error>
#include <thread>

namespace raytracer::view {
namespace {

namespace fs = std::filesystem;

// A signal handler may only set a flag.
std::atomic<bool> endAsked{false};
static_assert(std::atomic<bool>::is_always_lock_free, "needed in a signal handler");

void askToEnd(int signal) {
    endAsked = true;
    std::signal(signal, SIG_DFL);
}

/// The scene that the options name, else the first one of the exercise.
fs::path sceneOf(const Options& options) {
    if (!options.scene.empty()) return options.scene;
    std::set<fs::path> scenes;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator{viewHome().scenes, error})
        if (entry.path().extension() == ".xml") scenes.insert(entry.path());
    if (scenes.empty()) throw InputError("", 0, "no scene found; name one: tick1star --view SCENE");
    return *scenes.begin();
}

}  // namespace

ExitCode run(const Options& options) {
    Options chosen = options;
    chosen.scene = sceneOf(options);
    static_cast<void>(readScene(chosen.scene, assetsOf(chosen)));  // to complain at once
    for (const int signal : {SIGINT, SIGTERM})
        std::signal(signal, askToEnd);
#ifdef SIGHUP
    std::signal(SIGHUP, askToEnd);  // the terminal was closed
#endif
    Studio studio{viewHome(), chosen};
    ViewServer server{studio};
    std::cout << server.address() << std::endl;  // whatever reads this waits for it
    if (!options.quiet && !openInBrowser(server.address()))
        std::cerr << "Open this address in your browser; Ctrl-C ends the viewer.\n";
    std::jthread waiter{[&] {
        while (!endAsked)
            std::this_thread::sleep_for(std::chrono::milliseconds{50});
        studio.board().close();
        server.stop();
    }};
    server.serve();
    endAsked = true;
    return ExitCode::success;
}

}  // namespace raytracer::view

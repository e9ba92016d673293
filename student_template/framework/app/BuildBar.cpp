// Reads what a build prints, line by line, writes it to a file, and shows how far the build is:
//   cmake --build . | build_bar LOG [drawn|told]
// `drawn` is a bar with the time left, for terminals; `told` are quarters, for files and pipes.
// Without arguments it only says whether stdout is a terminal, by its exit status: 0 if so.
#include "ProgressText.h"
#include "System.h"

#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

namespace {

/// Steps as ninja counts them, "[3/57] Building", or make's percent, "[  5%] Building".
struct Steps {
    int done = 0;
    int all = 1;
};

/// Reads the count at the start of a line into `steps`; other lines change nothing.
void readSteps(const std::string& line, Steps& steps) {
    Steps found;
    char mark = 0;
    if (std::sscanf(line.c_str(), "[%d/%d]", &found.done, &found.all) == 2 && found.all > 0)
        steps = found;
    else if (std::sscanf(line.c_str(), "[%d%c]", &found.done, &mark) == 2 && mark == '%')
        steps = {found.done, 100};
}

/// Redraws the bar while no line comes, so that the time goes on.
class Bar {
public:
    explicit Bar(bool isDrawn) {
        if (isDrawn) thread_ = std::thread([this] { drawUntilStopped(); });
    }
    ~Bar() {
        stopped_ = true;
        if (!thread_.joinable()) return;
        thread_.join();
        std::fputs("\r\033[K", stdout);
    }
    Bar(const Bar&) = delete;
    Bar& operator=(const Bar&) = delete;

    void show(const Steps& steps) { steps_ = steps; }

private:
    using Clock = std::chrono::steady_clock;

    void drawUntilStopped() {
        for (; !stopped_; std::this_thread::sleep_for(std::chrono::milliseconds(200))) {
            const Steps steps = steps_;
            const std::chrono::duration<double> seconds = Clock::now() - start_;
            const std::string text =
                raytracer::progressText(steps.done, steps.all, seconds.count());
            std::printf("\rBuilding: %s\033[K", text.c_str());
            std::fflush(stdout);
        }
    }

    Clock::time_point start_ = Clock::now();
    std::atomic<bool> stopped_{false};
    std::atomic<Steps> steps_{Steps{}};
    std::thread thread_;
};

/// Prints each quarter that is reached, once.
void tell(const Steps& steps, int& told) {
    const int quarter = 4 * steps.done / steps.all * 25;
    if (quarter <= told) return;
    told = quarter;
    std::printf("Building: %d %%\n", told);
    std::fflush(stdout);
}

void follow(std::FILE* log, bool draws, bool tells) {
    Bar bar{draws};
    Steps steps;
    int told = 0;
    std::string line;
    for (int c = std::getchar(); c != EOF; c = std::getchar()) {
        line += static_cast<char>(c);
        if (c != '\n') continue;
        std::fputs(line.c_str(), log);
        readSteps(line, steps);
        bar.show(steps);
        if (tells) tell(steps, told);
        line.clear();
    }
    std::fputs(line.c_str(), log);
}

}  // namespace

int main(int argc, char* argv[]) {
    if (argc < 2)
        return raytracer::isTerminal(raytracer::Stream::out) ? EXIT_SUCCESS : EXIT_FAILURE;
    std::FILE* log = std::fopen(argv[1], "w");
    if (log == nullptr) {
        std::fprintf(stderr, "%s cannot be written\n", argv[1]);
        return EXIT_FAILURE;
    }
    const std::string how = argc > 2 ? argv[2] : "";
    follow(log, how == "drawn", how == "told");
    return std::fclose(log) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

#ifndef TICKER_BENCH_HARNESS_H
#define TICKER_BENCH_HARNESS_H

#include <CLI/CLI.hpp>

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace ticker::bench {

/// One measured value: a line of the printed table, an object in the JSON.
struct Figure {
    std::string name;
    double value = 0.0;
    std::string unit;
};

/// Cost of a function call in milliseconds: wall-clock time, and CPU time (user and system) of this
/// process and of its child processes that have ended.
struct Cost {
    double wall = 0.0;
    double cpu = 0.0;
};
[[nodiscard]] Cost costOf(const std::function<void()>& work);

/// CPU time in milliseconds, as in `Cost`.
[[nodiscard]] double cpuOf(const std::function<void()>& work);

/// Medians of the costs of two functions that are called alternately, after one warm-up round.
struct Pair {
    Cost first;
    Cost second;
};
[[nodiscard]] Pair measurePair(int rounds, const std::function<void()>& first,
                               const std::function<void()>& second);

/// The median; the upper one of an even number of values. There must be at least one.
[[nodiscard]] double median(std::vector<double> values);

/// CPU time in seconds of all child processes that have ended, and of their descendants.
[[nodiscard]] double childSeconds();

/// Starts a program; its output goes to `output`. @throws raytracer::Error if it cannot be run.
[[nodiscard]] pid_t start(std::vector<std::string> words, const std::filesystem::path& output);

/// Waits for its end. @throws raytracer::Error, with the end of its output, if the program failed.
void finish(pid_t child, const std::filesystem::path& output);

/// Runs a program to its end, with its output to /dev/null.
/// @throws raytracer::Error if it cannot be run or fails.
void runProgram(const std::vector<std::string>& command);

/// A suite's `main`: reads the command line (the suite's options and --json FILE), measures,
/// prints.
/// @return  Exit status.
[[nodiscard]] int runSuite(CLI::App& app, int count, char** words,
                           const std::function<std::vector<Figure>()>& measure);

}  // namespace ticker::bench

#endif

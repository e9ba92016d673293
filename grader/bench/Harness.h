#ifndef TICKER_BENCH_HARNESS_H
#define TICKER_BENCH_HARNESS_H

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace ticker::bench {

/// One line of a suite's page, and one object of its JSON.
struct Figure {
    std::string name;
    double value = 0.0;
    std::string unit;
};

/// What some work took, in milliseconds: of the wall clock; of CPU (user and system) by this
/// process and by those that it started and that have ended.
struct Cost {
    double wall = 0.0;
    double cpu = 0.0;
};
[[nodiscard]] Cost costOf(const std::function<void()>& work);

/// Milliseconds of CPU, as in `Cost`.
[[nodiscard]] double cpuOf(const std::function<void()>& work);

/// Medians of two pieces of work that were done in turns, after one round that does not count.
struct Pair {
    Cost first;
    Cost second;
};
[[nodiscard]] Pair measurePair(int rounds, const std::function<void()>& first,
                               const std::function<void()>& second);

/// The upper one where there is an even number of values, of which there must be one.
[[nodiscard]] double median(std::vector<double> values);

/// Runs a program to its end, its output to /dev/null.
/// @throws raytracer::Error where it cannot be run or fails.
void runProgram(const std::vector<std::string>& command);

/// A suite's `main`: reads the command line (the suite's options and --json FILE), measures,
/// prints.
/// @return  Exit status.
[[nodiscard]] int runSuite(CLI::App& app, int count, char** words,
                           const std::function<std::vector<Figure>()>& measure);

}  // namespace ticker::bench

#endif

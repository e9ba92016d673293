#include <grader/bench/Harness.h>

#include <raytracer/base/Error.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>

extern char** environ;  // NOLINT: POSIX

namespace ticker::bench {
namespace {

double cpuMilliseconds(int who) {
    rusage usage{};
    getrusage(who, &usage);
    return 1e3 * static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-3 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

double cpuMilliseconds() {
    return cpuMilliseconds(RUSAGE_SELF) + cpuMilliseconds(RUSAGE_CHILDREN);
}

Cost medianOf(const std::vector<Cost>& costs) {
    std::vector<double> wall;
    std::vector<double> cpu;
    for (const Cost& cost : costs) {
        wall.push_back(cost.wall);
        cpu.push_back(cost.cpu);
    }
    return {median(std::move(wall)), median(std::move(cpu))};
}

void print(const std::vector<Figure>& figures, const std::string& file) {
    nlohmann::json list = nlohmann::json::array();
    for (const Figure& figure : figures) {
        fmt::print("{:<62} {:>8.3g} {}\n", figure.name, figure.value, figure.unit);
        list.push_back({{"name", figure.name}, {"value", figure.value}, {"unit", figure.unit}});
    }
    if (!file.empty()) std::ofstream{file} << list.dump(2) << '\n';
}

}  // namespace

Cost costOf(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    const double before = cpuMilliseconds();
    work();
    const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
    return {wall.count(), cpuMilliseconds() - before};
}

double cpuOf(const std::function<void()>& work) {
    return costOf(work).cpu;
}

Pair measurePair(int rounds, const std::function<void()>& first,
                 const std::function<void()>& second) {
    std::vector<Cost> ofFirst;
    std::vector<Cost> ofSecond;
    first();
    second();
    for (int round = 0; round < rounds; ++round) {
        ofFirst.push_back(costOf(first));
        ofSecond.push_back(costOf(second));
    }
    return {medianOf(ofFirst), medianOf(ofSecond)};
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values.at(values.size() / 2);
}

double childSeconds() {
    return 1e-3 * cpuMilliseconds(RUSAGE_CHILDREN);
}

pid_t start(std::vector<std::string> words, const std::filesystem::path& output) {
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t child = 0;
    const int error =
        posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw raytracer::Error("cannot run " + words[0]);
    return child;
}

void finish(pid_t child, const std::filesystem::path& output) {
    int status = 0;
    if (waitpid(child, &status, 0) == child && status == 0) return;
    std::string said{std::istreambuf_iterator<char>{std::ifstream{output}.rdbuf()}, {}};
    if (constexpr std::size_t most = 2000; said.size() > most) said.erase(0, said.size() - most);
    throw raytracer::Error("a program failed; it printed:\n" + said);
}

void runProgram(const std::vector<std::string>& command) {
    try {
        finish(start(command, "/dev/null"), "/dev/null");
    } catch (const raytracer::Error&) {
        throw raytracer::Error(command.front() + " cannot be run, or fails");
    }
}

int runSuite(CLI::App& app, int count, char** words,
             const std::function<std::vector<Figure>()>& measure) {
    std::string json;
    app.add_option("--json", json, "File for the figures, for machines");
    try {
        app.parse(count, words);
        print(measure(), json);
        return raytracer::toInt(raytracer::ExitCode::success);
    } catch (const CLI::ParseError& error) {
        return app.exit(error);
    } catch (const raytracer::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return raytracer::toInt(error.exitCode());
    }
}

}  // namespace ticker::bench

// Benchmarks of the oracle, as ratios in one run: user CPU time, medians of interleaved rounds.
// usage: ticker_bench_oracle SCENE [--limit PROGRAM] [--rounds N] [--json FILE]
#include <grader/oracle/HiddenScene.h>
#include <grader/oracle/Oracle.h>

#include <raytracer/base/Error.h>
#include <raytracer/io/SceneReader.h>
#include <raytracer/render/Renderer.h>

#include <fmt/format.h>
#include <hwy/highway.h>
#include <hwy/targets.h>

#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

extern char** environ;  // NOLINT: POSIX

namespace ticker::oracle {
namespace {

using raytracer::RenderSettings;
using raytracer::SceneDescription;

struct Options {
    std::string scene;
    std::string limit;  ///< a program to be compared with; empty: none
    int rounds = 7;
    std::string json;
};

struct Figure {
    std::string name;
    double value;
    std::string unit;
};

double userSeconds(int who) {
    rusage usage{};
    getrusage(who, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

double timed(const std::function<void()>& work) {
    const double before = userSeconds(RUSAGE_SELF);
    work();
    return userSeconds(RUSAGE_SELF) - before;
}

double timedProgram(const std::string& program) {
    std::vector<std::string> words{program, "640", "480", "50", "10", "2", "1", "0.2"};
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const double before = userSeconds(RUSAGE_CHILDREN);
    pid_t child = 0;
    int status = 0;
    if (posix_spawn(&child, program.c_str(), nullptr, nullptr, arguments.data(), environ) != 0 ||
        waitpid(child, &status, 0) < 0 || status != 0)
        throw raytracer::InputError(program, 0, "cannot be run");
    return userSeconds(RUSAGE_CHILDREN) - before;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

void withoutTargets(std::int64_t targets, const std::function<void()>& work) {
    hwy::DisableTargets(targets);
    work();
    hwy::DisableTargets(0);
}

constexpr std::int64_t kWide = HWY_AVX3 | HWY_AVX3_DL;

/// Throughput of student renders at the handout's size and ray counts.
std::vector<Figure> throughput(const SceneDescription& scene, const Options& options) {
    RenderSettings settings;
    const Oracle oracle{scene, settings};
    RenderSettings small;
    small.width = 128;
    small.height = 96;
    const raytracer::Scene framework{scene};
    std::vector<double> best;
    std::vector<double> avx2;
    std::vector<double> limit;
    std::vector<double> reference;
    for (int round = 0; round < options.rounds; ++round) {
        const auto seed = static_cast<std::uint64_t>(round);
        best.push_back(timed([&] { static_cast<void>(oracle.studentRender(seed)); }));
        withoutTargets(kWide, [&] {
            avx2.push_back(timed([&] { static_cast<void>(oracle.studentRender(seed)); }));
        });
        if (!options.limit.empty()) limit.push_back(timedProgram(options.limit));
        reference.push_back(
            timed([&] { static_cast<void>(raytracer::Renderer{small}.render(framework)); }));
    }
    const double scale = 640.0 * 480.0 / (128.0 * 96.0);
    std::vector<Figure> figures{
        {"student render 640x480, 50 x 10", median(best), "s"},
        {"student render, AVX2", median(avx2), "s"},
        {"reference solution, scaled from 128x96", scale * median(reference), "s"},
        {"throughput / reference", scale * median(reference) / median(best), "x"}};
    if (!limit.empty()) {
        figures.push_back({"given program", median(limit), "s"});
        figures.push_back({"throughput / given program", median(limit) / median(best), "x"});
        figures.push_back(
            {"throughput with AVX2 / given program", median(limit) / median(avx2), "x"});
    }
    return figures;
}

double rootMeanSquare(const Moments& a, const Moments& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.mean.size(); ++i) {
        const raytracer::ColourRGB off = a.mean[i] - b.mean[i];
        sum += off.r * off.r + off.g * off.g + off.b * off.b;
    }
    return std::sqrt(sum / (3.0 * static_cast<double>(a.mean.size())));
}

/// CPU time to a mean of a given error, against plain random sampling by the same oracle.
std::vector<Figure> equalError(const SceneDescription& scene) {
    constexpr double kGoal = 0.0005;
    RenderSettings settings;
    settings.width = 320;
    settings.height = 240;
    Precision precision;
    precision.share = 0.0;
    precision.rms = 0.1 * kGoal;
    const Moments converged = Oracle{scene, settings}.moments(99, precision);
    precision.rms = kGoal;
    Moments clever;
    const double cleverTime = timed([&] {
        clever = Oracle{scene, settings}.moments(1, precision);
    });
    // The same count of paths everywhere, random points, every shadow ray of a student traced. The
    // time to the goal follows from the error of a shorter run: squares fall with the paths.
    Tricks plainly;
    plainly.lowDiscrepancy = plainly.closedForms = plainly.pairedShadows = false;
    plainly.allocation = false;
    precision.minLensPaths = precision.maxLensPaths = 1024;
    Moments plain;
    const double plainTime = timed([&] {
        plain = Oracle{scene, settings, {}, {}, plainly}.moments(2, precision);
    });
    const double plainError = rootMeanSquare(plain, converged);
    const double plainToGoal = plainTime * (plainError / kGoal) * (plainError / kGoal);
    return {{"mean 320x240, error of all tricks", rootMeanSquare(clever, converged), "RMS"},
            {"mean 320x240, all tricks", cleverTime, "s"},
            {"mean 320x240, plain random to 0.0005", plainToGoal, "s"},
            {"plain / all tricks", plainToGoal / cleverTime, "x"}};
}

/// Mean and variance of one hidden scene.
std::vector<Figure> hidden(int rounds) {
    std::vector<double> cpu;
    std::vector<double> wall;
    double share = 0.0;
    for (int round = 0; round < rounds; ++round) {
        HiddenScene scene =
            hiddenScene(HiddenTask::depthOfField, static_cast<std::uint64_t>(round));
        scene.settings.threads = 2;
        const auto start = std::chrono::steady_clock::now();
        cpu.push_back(timed([&] {
            const Moments moments = Oracle{scene.scene, scene.settings}.moments(1);
            share = std::max(share, moments.shareOfVariance(16));
        }));
        wall.push_back(
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return {{"hidden scene 32x24, mean and variance, CPU", 1e3 * median(cpu), "ms"},
            {"hidden scene 32x24, two threads, wall clock", 1e3 * median(wall), "ms"},
            {"largest share of the statistic's variance", 100.0 * share, "%"}};
}

Options parsed(int count, char** words) {
    if (count < 2)
        throw raytracer::InputError("", 0,
                                    "usage: ticker_bench_oracle SCENE [--limit "
                                    "PROGRAM] [--rounds N] [--json FILE]");
    Options options;
    options.scene = words[1];
    for (int i = 2; i + 1 < count; i += 2) {
        const std::string name = words[i];
        if (name == "--limit") options.limit = words[i + 1];
        if (name == "--rounds") options.rounds = std::max(1, std::stoi(words[i + 1]));
        if (name == "--json") options.json = words[i + 1];
    }
    return options;
}

void print(const std::vector<Figure>& figures, const std::string& json) {
    std::string lines;
    for (const Figure& figure : figures) {
        fmt::print("{:<46} {:>10.4g} {}\n", figure.name, figure.value, figure.unit);
        lines += fmt::format("{}  {{\"name\": \"{}\", \"value\": {:.6g}, \"unit\": \"{}\"}}",
                             lines.empty() ? "" : ",\n", figure.name, figure.value, figure.unit);
    }
    if (!json.empty()) std::ofstream{json} << "[\n" << lines << "\n]\n";
}

int run(int count, char** words) {
    const Options options = parsed(count, words);
    const SceneDescription scene = raytracer::readScene(options.scene, {});
    std::vector<Figure> figures = throughput(scene, options);
    for (const std::vector<Figure>& more : {equalError(scene), hidden(options.rounds)})
        figures.insert(figures.end(), more.begin(), more.end());
    print(figures, options.json);
    return raytracer::toInt(raytracer::ExitCode::success);
}

}  // namespace
}  // namespace ticker::oracle

int main(int count, char** words) {
    try {
        return ticker::oracle::run(count, words);
    } catch (const raytracer::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return raytracer::toInt(error.exitCode());
    }
}

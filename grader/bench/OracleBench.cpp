// Benchmarks of the oracle, as ratios in one run: CPU time, medians of interleaved rounds.
#include <grader/bench/Harness.h>
#include <grader/oracle/Oracle.h>

#include <raytracer/base/Error.h>
#include <raytracer/io/SceneReader.h>
#include <raytracer/render/Renderer.h>

#include <hwy/highway.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace ticker::oracle {
namespace {

using raytracer::RenderSettings;
using raytracer::SceneDescription;

struct Options {
    std::string scene;
    std::string limit;  ///< a program for comparison; empty: none
    int rounds = 7;
};

using bench::Figure;
using bench::median;
using bench::runProgram;

double timed(const std::function<void()>& work) {
    return 1e-3 * bench::cpuOf(work);
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
        if (!options.limit.empty())
            limit.push_back(timed([&] {
                runProgram({options.limit, "640", "480", "50", "10", "2", "1", "0.2"});
            }));
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

/// CPU time until the mean has a given error, relative to plain random sampling by the same oracle.
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
    // Baseline: the same number of paths for every pixel, random points, and every shadow ray of a
    // student traced. Its time to the goal is extrapolated from a shorter run: the squared error
    // falls inversely with the number of paths.
    Tricks plainly;
    plainly.lowDiscrepancy = plainly.closedForms = plainly.pairedShadows = false;
    plainly.allocation = false;
    precision.minLensPaths = precision.maxLensPaths = 1024;
    Moments plain;
    const double plainTime = timed([&] {
        plain = Oracle{scene, settings, {}, {}, plainly}.moments(2, precision);
    });
    const double plainError = rootMeanSquare(plain, converged);
    const double cleverError = rootMeanSquare(clever, converged);
    const auto plainTo = [&](double error) {
        return plainTime * (plainError / error) * (plainError / error);
    };
    return {{"mean 320x240, error of all tricks", cleverError, "RMS"},
            {"mean 320x240, all tricks", cleverTime, "s"},
            {"mean 320x240, plain random to 0.0005", plainTo(kGoal), "s"},
            {"plain / all tricks", plainTo(kGoal) / cleverTime, "x"},
            {"mean 320x240, plain random to the same error", plainTo(cleverError), "s"},
            {"plain / all tricks, at the same error", plainTo(cleverError) / cleverTime, "x"}};
}

std::vector<Figure> measure(const Options& options) {
    const SceneDescription scene = raytracer::readScene(options.scene, {});
    std::vector<Figure> figures = throughput(scene, options);
    const std::vector<Figure> more = equalError(scene);
    figures.insert(figures.end(), more.begin(), more.end());
    return figures;
}

}  // namespace
}  // namespace ticker::oracle

int main(int count, char** words) {
    CLI::App app{"What the oracle costs, as ratios", "ticker_bench_oracle"};
    ticker::oracle::Options options;
    app.add_option("scene", options.scene, "A scene without maps")->required();
    app.add_option("--limit", options.limit, "A program to be compared with");
    app.add_option("--rounds", options.rounds, "Rounds")->check(CLI::PositiveNumber);
    return ticker::bench::runSuite(app, count, words,
                                   [&] { return ticker::oracle::measure(options); });
}

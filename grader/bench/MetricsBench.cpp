// Cost of all metrics of a picture, relative to OpenCV's structural similarity, in alternating
// rounds.
#include <grader/bench/Harness.h>
#include <grader/metrics/Compare.h>
#include <grader/metrics/Flip.h>
#include <grader/metrics/Structure.h>

#include <raytracer/io/ImageReader.h>

#include <filesystem>

namespace ticker::bench {
namespace {

std::vector<Figure> measure(const std::filesystem::path& project, int rounds) {
    const auto read = [&](const char* sample) {
        return raytracer::readImage(project / "grader/corpus/samples" / sample / "screenshot.png");
    };
    const raytracer::ByteImage right = read("awarded/reference-bump");
    const raytracer::ByteImage wrong = read("notAwarded/bump-inverted-u");
    const metrics::ByteView a{right.width, right.height, right.rgb};
    const metrics::ByteView b{wrong.width, wrong.height, wrong.rgb};
    const Pair pair = measurePair(
        rounds, [&] { static_cast<void>(metrics::flip(a, b)); },
        [&] { static_cast<void>(metrics::ssim(a, b)); });
    const Pair all = measurePair(
        rounds, [&] { static_cast<void>(metrics::score(a, b)); },
        [&] { static_cast<void>(metrics::gmsd(a, b)); });
    return {{"FLIP, 640 x 480, CPU", pair.first.cpu, "ms"},
            {"SSIM (OpenCV), CPU", pair.second.cpu, "ms"},
            {"FLIP / SSIM", pair.first.cpu / pair.second.cpu, "x"},
            {"all metrics of a report, CPU", all.first.cpu, "ms"},
            {"GMSD (OpenCV), CPU", all.second.cpu, "ms"}};
}

}  // namespace
}  // namespace ticker::bench

int main(int count, char** words) {
    CLI::App app{"What a picture's metrics cost, as ratios", "ticker_bench_metrics"};
    std::string project;
    int rounds = 15;
    app.add_option("project", project, "The project's folder")->required();
    app.add_option("--rounds", rounds, "Rounds")->check(CLI::PositiveNumber);
    return ticker::bench::runSuite(app, count, words,
                                   [&] { return ticker::bench::measure(project, rounds); });
}

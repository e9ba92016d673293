#include <grader/base/MakeFolder.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/metrics/Colours.h>
#include <grader/metrics/Compare.h>
#include <grader/metrics/Flip.h>

#include <raytracer/io/ImageReader.h>
#include <raytracer/io/ImageWriter.h>

#include <fmt/core.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;
using metrics::Comparison;
using metrics::Map;

// Two pictures of a million tiles exceed this number of standard errors with a chance of 10^-8.
constexpr double kFullNoiseScore = 10.0;

struct CompareOptions {
    std::string reference;
    std::string test;
    std::string maps;
    bool json = false;
    double pixelsPerDegree = metrics::kUsualPixelsPerDegree;
};

nlohmann::ordered_json number(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json patchJson(const metrics::Patch& patch) {
    return {{"left", patch.left},
            {"top", patch.top},
            {"right", patch.right},
            {"bottom", patch.bottom},
            {"meanDifference", number(patch.meanDifference)},
            {"rmse", number(patch.rmse)}};
}

std::string jsonText(const Comparison& comparison) {
    nlohmann::ordered_json json;
    json["width"] = comparison.width;
    json["height"] = comparison.height;
    json["outcome"] = metrics::toString(comparison.outcome);
    for (const metrics::Row& row : comparison.rows)
        json["metrics"][row.name] = number(row.value);
    json["noise"] = {{"tileSize", comparison.noise.tileSize},
                     {"tiles", comparison.noise.score.values.size()},
                     {"differing", comparison.noise.differing},
                     {"smallestProbability", number(comparison.noise.smallest)}};
    if (comparison.where)
        json["where"] = {{"box", patchJson(comparison.where->box)},
                         {"worstTile", patchJson(comparison.where->worst)}};
    json["summary"] = comparison.summary;
    return json.dump(2) + "\n";
}

/// Enlarges every tile to its size in the picture.
Map spread(const Map& tiles, int tileSize, int width, int height) {
    Map map{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            map.values.push_back(
                tiles.values[static_cast<std::size_t>(y / tileSize * tiles.width + x / tileSize)]);
    return map;
}

void writeMaps(const Comparison& comparison, const fs::path& folder) {
    makeFolder(folder);
    for (const metrics::Row& row : comparison.rows) {
        if (row.map.values.empty()) continue;
        Map map = row.map;
        if (row.inverted)
            for (float& value : map.values)
                value = 1.0F - value;
        raytracer::writePng({map.width, map.height, metrics::magma(map, row.full)},
                            folder / (row.name + ".png"));
    }
    const Map noise = spread(comparison.noise.score, comparison.noise.tileSize, comparison.width,
                             comparison.height);
    raytracer::writePng({noise.width, noise.height, metrics::blueWhiteRed(noise, kFullNoiseScore)},
                        folder / "noise.png");
}

raytracer::ExitCode compare(const CompareOptions& options, const GlobalOptions& global) {
    const raytracer::ByteImage reference = raytracer::readImage(options.reference);
    const raytracer::ByteImage test = raytracer::readImage(options.test);
    if (reference.width != test.width || reference.height != test.height)
        throw raytracer::InputError(
            options.test, 0,
            fmt::format("{} x {} pixels, but {} has {} x {}; render both at the same size",
                        test.width, test.height, options.reference, reference.width,
                        reference.height));
    const Comparison comparison = metrics::compare(metrics::viewOf(reference),
                                                   metrics::viewOf(test), options.pixelsPerDegree);
    fmt::print("{}", options.json ? jsonText(comparison) : metrics::table(comparison));
    if (options.maps.empty()) return raytracer::ExitCode::success;
    writeMaps(comparison, options.maps);
    if (!global.quiet) fmt::print(stderr, "maps: {}\n", options.maps);
    return raytracer::ExitCode::success;
}

}  // namespace

Run addCompare(CLI::App& app, const GlobalOptions& global) {
    auto options = std::make_shared<CompareOptions>();
    CLI::App* verb =
        app.add_subcommand("compare", "Say how two pictures differ: numbers, maps, noise or more");
    verb->add_option("reference", options->reference, "PNG file: what is right")->required();
    verb->add_option("test", options->test, "PNG file of the same size")->required();
    verb->add_flag("--json", options->json, "JSON instead of a table");
    verb->add_option("--maps", options->maps, "Folder for a picture of each metric's map");
    verb->add_option("--ppd", options->pixelsPerDegree,
                     "Pixels in one degree of view, for FLIP; 67 if not given")
        ->check(CLI::Range(4.0, 500.0));
    return [options, &global] { return compare(*options, global); };
}

}  // namespace ticker::cli

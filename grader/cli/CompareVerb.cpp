#include <grader/cli/Verb.h>
#include <grader/metrics/Colours.h>
#include <grader/metrics/Compare.h>
#include <grader/metrics/Flip.h>

#include <raytracer/io/ImageReader.h>
#include <raytracer/io/ImageWriter.h>

#include <fmt/core.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

struct CompareOptions {
    std::string reference;
    std::string test;
    std::string maps;
    bool json = false;
    double pixelsPerDegree = metrics::kUsualPixelsPerDegree;
};

std::string asJson(const metrics::Comparison& comparison) {
    nlohmann::ordered_json document;
    document["width"] = comparison.width;
    document["height"] = comparison.height;
    for (const metrics::Row& row : comparison.rows)
        document["metrics"][row.name] =
            std::isfinite(row.value) ? nlohmann::ordered_json(row.value) : nullptr;
    document["differingTiles"] = comparison.noise.differing;
    document["summary"] = comparison.summary;
    return document.dump(2) + "\n";
}

void writeMaps(const metrics::Comparison& comparison, const fs::path& folder) {
    fs::create_directories(folder);
    for (const metrics::Row& row : comparison.rows) {
        if (row.map.values.empty()) continue;
        metrics::Map map = row.map;
        if (row.inverted)
            for (float& value : map.values)
                value = 1.0F - value;
        raytracer::writePng(
            raytracer::ByteImage{map.width, map.height, metrics::magma(map, row.full)},
            folder / (row.name + ".png"));
    }
}

raytracer::ExitCode compareImages(const CompareOptions& options) {
    const raytracer::ByteImage reference = raytracer::readImage(options.reference);
    const raytracer::ByteImage test = raytracer::readImage(options.test);
    const metrics::Comparison comparison =
        metrics::compare({reference.width, reference.height, reference.rgb},
                         {test.width, test.height, test.rgb}, options.pixelsPerDegree);
    if (!options.maps.empty()) writeMaps(comparison, options.maps);
    fmt::print("{}", options.json ? asJson(comparison) : metrics::table(comparison));
    return raytracer::ExitCode::success;
}

}  // namespace

Run addCompare(CLI::App& app, const Voice& /*voice*/) {
    auto options = std::make_shared<CompareOptions>();
    CLI::App* verb = app.add_subcommand("compare", "Say how much two pictures differ, and where");
    verb->add_option("reference", options->reference, "PNG file")->required();
    verb->add_option("test", options->test, "PNG file of the same size")->required();
    verb->add_flag("--json", options->json, "For machines");
    verb->add_option("--maps", options->maps, "Folder to write a picture of each metric's map to");
    verb->add_option("--pixels-per-degree", options->pixelsPerDegree, "Viewing distance for FLIP")
        ->check(CLI::PositiveNumber);
    return [options] { return compareImages(*options); };
}

}  // namespace ticker::cli

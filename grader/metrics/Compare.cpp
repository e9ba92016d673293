#include <grader/metrics/Compare.h>

#include <grader/metrics/ColourDistance.h>
#include <grader/metrics/Difference.h>
#include <grader/metrics/Flip.h>
#include <grader/metrics/Structure.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

namespace ticker::metrics {
namespace {

// What is brightest in a map of CIEDE2000: ten times what can just be seen.
constexpr double kFullColourDistance = 10.0;

Row row(std::string name, std::string title, std::string meaning, Measured measured,
        double full = 1.0) {
    return {.name = std::move(name),
            .title = std::move(title),
            .meaning = std::move(meaning),
            .value = measured.value,
            .map = std::move(measured.map),
            .full = full};
}

Row number(std::string name, std::string title, std::string meaning, double value) {
    return row(std::move(name), std::move(title), std::move(meaning), {value, {}});
}

std::vector<Row> perceptualRows(const ByteView& reference, const ByteView& test,
                                double pixelsPerDegree) {
    std::vector<Row> rows;
    Measured errors = flip(reference, test, pixelsPerDegree);
    const double median = weightedQuartiles(errors.map).median;
    rows.push_back(row("flip", "FLIP, mean", "0 equal, 1 black against white", std::move(errors)));
    rows.push_back(number("flipWeightedMedian", "FLIP, weighted median",
                          "half of all error lies above it", median));
    rows.push_back(row("ssim", "SSIM", "1 equal, 0 nothing in common", ssim(reference, test)));
    rows.back().inverted = true;
    rows.push_back(row("gmsd", "GMSD", "0 equal; edges alone count", gmsd(reference, test)));
    rows.back().inverted = true;
    rows.push_back(row("ciede2000", "CIEDE2000, mean", "1 can just be seen",
                       ciede2000(reference, test), kFullColourDistance));
    return rows;
}

std::vector<Row> pixelRows(const ByteView& reference, const ByteView& test) {
    std::vector<Row> rows;
    rows.push_back(number("rmse", "RMSE", "of bytes, 0 to 255", rmse(reference, test).value));
    rows.push_back(number("psnr", "PSNR, dB", "infinite: equal", psnr(reference, test).value));
    rows.push_back(number("relativeMse", "relative MSE", "dark places count as bright ones",
                          relativeMse(reference, test).value));
    rows.push_back(row("largestDifference", "largest difference", "of two bytes",
                       largestDifference(reference, test), 255.0));
    rows.push_back(number("differingPixels", "differing pixels", "in any channel by any amount",
                          differingPixels(reference, test).value));
    return rows;
}

/// "top left", "centre", "right": where in a picture the tiles that differ have their middle.
std::string whereabouts(const TileTest& noise, double threshold) {
    double x = 0.0;
    double y = 0.0;
    double weight = 0.0;
    for (int ty = 0; ty < noise.score.height; ++ty)
        for (int tx = 0; tx < noise.score.width; ++tx) {
            const auto i = static_cast<std::size_t>(ty * noise.score.width + tx);
            if (static_cast<double>(noise.probability.values[i]) > threshold) continue;
            x += (tx + 0.5) / noise.score.width;
            y += (ty + 0.5) / noise.score.height;
            weight += 1.0;
        }
    if (weight == 0.0) return {};
    const auto third = [&](double sum, std::string_view low, std::string_view high) {
        const double middle = sum / weight;
        return std::string{middle < 1.0 / 3.0 ? low : middle > 2.0 / 3.0 ? high : ""};
    };
    const std::string vertical = third(y, "top", "bottom");
    const std::string horizontal = third(x, "left", "right");
    if (vertical.empty() && horizontal.empty()) return "around the centre";
    return "towards the " + vertical + (vertical.empty() || horizontal.empty() ? "" : " ") +
           horizontal;
}

std::string summarise(const Comparison& comparison, double differing) {
    if (differing == 0.0) return "equal: every pixel is the same";
    const TileTest& noise = comparison.noise;
    if (noise.differing == 0)
        return fmt::format(
            "equal up to noise: no tile of {0} x {0} pixels differs by more than chance",
            noise.tileSize);
    const auto tiles = noise.score.values.size();
    std::vector<float> ordered = noise.probability.values;
    std::nth_element(ordered.begin(), ordered.begin() + (noise.differing - 1), ordered.end());
    const double threshold =
        static_cast<double>(ordered[static_cast<std::size_t>(noise.differing - 1)]);
    return fmt::format(
        "different beyond noise in {} of {} tiles of {}x{} pixels ({:.0f} %), {}; FLIP {:.4f}",
        noise.differing, tiles, noise.tileSize, noise.tileSize,
        100.0 * noise.differing / static_cast<double>(tiles), whereabouts(noise, threshold),
        comparison.rows.front().value);
}

}  // namespace

Scores score(const ByteView& reference, const ByteView& test) {
    Measured errors = flip(reference, test);
    return {.flip = errors.value,
            .ssim = ssim(reference, test).value,
            .gmsd = gmsd(reference, test).value,
            .rmse = rmse(reference, test).value,
            .errors = std::move(errors.map)};
}

Comparison compare(const ByteView& reference, const ByteView& test, double pixelsPerDegree) {
    Comparison comparison;
    comparison.width = reference.width;
    comparison.height = reference.height;
    comparison.rows = perceptualRows(reference, test, pixelsPerDegree);
    std::vector<Row> pixels = pixelRows(reference, test);
    const double differing = pixels.back().value;
    std::move(pixels.begin(), pixels.end(), std::back_inserter(comparison.rows));
    comparison.noise = noiseTiles(reference, test);
    comparison.summary = summarise(comparison, differing);
    return comparison;
}

std::string table(const Comparison& comparison) {
    std::string text = fmt::format("{} x {} pixels\n", comparison.width, comparison.height);
    for (const Row& each : comparison.rows)
        text += fmt::format("  {:<24}{:>12.6g}   {}\n", each.title, each.value, each.meaning);
    return text + comparison.summary + "\n";
}

}  // namespace ticker::metrics

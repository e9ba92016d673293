#include <grader/metrics/Compare.h>

#include <grader/metrics/ColourDistance.h>
#include <grader/metrics/Difference.h>
#include <grader/metrics/Flip.h>
#include <grader/metrics/Structure.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace ticker::metrics {
namespace {

// Brightest value in a map of CIEDE2000: ten times a just noticeable difference.
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

// Share of differing pixels below which noise cannot be told from an edit.
constexpr double kFewPixels = 0.01;
// Differences in units of the noise that the pictures show. Renders have 1 or less; a few isolated
// pixels give up to 2.25 (see `excessOverNoise`).
constexpr double kMuchMoreThanNoise = 10.0;

struct Evidence {
    double differing = 0.0;  // pixels
    double largest = 0.0;    // difference of two bytes
    double excess = 0.0;
};

Outcome outcomeOf(const Comparison& comparison, const Evidence& evidence) {
    if (evidence.differing == 0.0) return Outcome::equal;
    if (comparison.noise.differing > 0 || evidence.excess > kMuchMoreThanNoise)
        return Outcome::different;
    const double pixels = static_cast<double>(comparison.width) * comparison.height;
    return evidence.differing < kFewPixels * pixels ? Outcome::nearlyEqual
                                                    : Outcome::equalUpToNoise;
}

std::string brightness(double difference) {
    if (std::abs(difference) < 0.05) return "as bright on average";
    return fmt::format("{:.1f} of 255 {} on average", std::abs(difference),
                       difference < 0.0 ? "darker" : "brighter");
}

std::string differences(const Comparison& comparison) {
    const TileTest& noise = comparison.noise;
    const Whereabouts& where = *comparison.where;
    const double share = 100.0 * noise.differing / static_cast<double>(noise.score.values.size());
    return fmt::format(
        "different beyond noise in {} of {} tiles of {}x{} pixels ({:.3g} %), {}: mostly x {} to "
        "{}, "
        "y {} to {}, where the test picture is {} (RMSE {:.1f}); most at x {} to {}, y {} to {}: "
        "{} "
        "(RMSE {:.1f})",
        noise.differing, noise.score.values.size(), noise.tileSize, noise.tileSize, share,
        where.words, where.box.left, where.box.right - 1, where.box.top, where.box.bottom - 1,
        brightness(where.box.meanDifference), where.box.rmse, where.worst.left,
        where.worst.right - 1, where.worst.top, where.worst.bottom - 1,
        brightness(where.worst.meanDifference), where.worst.rmse);
}

std::string summarise(const Comparison& comparison, const Evidence& evidence) {
    const std::string few =
        fmt::format("{:.0f} of {} pixels differ, by up to {:.0f} of 255", evidence.differing,
                    comparison.width * comparison.height, evidence.largest);
    switch (comparison.outcome) {
        case Outcome::equal:
            return "equal: every pixel is the same";
        case Outcome::nearlyEqual:
            return "nearly equal: " + few + "; so few may be noise, rounding or an edit";
        case Outcome::equalUpToNoise:
            return fmt::format(
                "equal up to noise: no tile of {0}x{0} pixels differs by more than chance",
                comparison.noise.tileSize);
        case Outcome::different:
            break;
    }
    if (comparison.where) return differences(comparison);
    return "different: " + few + ", where neither picture is noisy";
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
    const Evidence evidence{pixels.back().value, pixels[pixels.size() - 2].value,
                            excessOverNoise(reference, test)};
    std::move(pixels.begin(), pixels.end(), std::back_inserter(comparison.rows));
    comparison.noise = noiseTiles(reference, test);
    comparison.outcome = outcomeOf(comparison, evidence);
    if (comparison.noise.differing > 0) {
        comparison.where = whereabouts(reference, test, comparison.noise);
        comparison.sketch = sketch(reference, test, comparison.noise);
    }
    comparison.summary = summarise(comparison, evidence);
    return comparison;
}

std::string_view toString(Outcome outcome) {
    switch (outcome) {
        case Outcome::equal:
            return "equal";
        case Outcome::nearlyEqual:
            return "nearlyEqual";
        case Outcome::equalUpToNoise:
            return "equalUpToNoise";
        case Outcome::different:
            return "different";
    }
    return "";
}

std::string table(const Comparison& comparison) {
    std::string text = fmt::format("{} x {} pixels\n", comparison.width, comparison.height);
    for (const Row& each : comparison.rows)
        text += fmt::format("  {:<24}{:>12.6g}   {}\n", each.title, each.value, each.meaning);
    text += comparison.summary + "\n";
    if (!comparison.sketch.empty())
        text +=
            "where: . equal up to noise, + brighter, - darker, ~ in detail\n" + comparison.sketch;
    return text;
}

}  // namespace ticker::metrics

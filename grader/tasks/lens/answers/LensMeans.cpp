#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/answers/LensMeans.h>
#include <grader/tasks/lens/answers/RayColours.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

namespace ticker::tasks {
namespace {

using probe::ColourRGB;

// Fewer pixels are no evidence.
constexpr std::size_t kEnoughPixels = 6;

double sumOf(const ColourRGB& colour) {
    return colour.r + colour.g + colour.b;
}

// Whether every pixel's colour is its mean plus another pixel's colour, whole or divided a second
// time. One pixel, the first that was rendered, may have its mean alone.
bool areCarriedOn(const std::vector<PixelMean>& pixels, bool dividedAgain) {
    std::size_t first = 0;
    for (const PixelMean& pixel : pixels) {
        const bool follows = std::any_of(pixels.begin(), pixels.end(), [&](const PixelMean& other) {
            const double share = dividedAgain ? 1.0 / std::max(1.0, pixel.rays) : 1.0;
            return &other != &pixel && isNear(pixel.colour, pixel.mean + other.colour * share);
        });
        if (!follows && (!isNear(pixel.colour, pixel.mean) || ++first > 1)) return false;
    }
    return true;
}

bool areScaled(const std::vector<PixelMean>& pixels, double& least, double& most) {
    least = std::numeric_limits<double>::infinity();
    most = 0.0;
    for (const PixelMean& pixel : pixels) {
        const double whole = sumOf(pixel.mean);
        if (!(whole > 1e-6)) return false;
        const double factor = sumOf(pixel.colour) / whole;
        if (!isNear(pixel.colour, pixel.mean * factor)) return false;
        least = std::min(least, factor);
        most = std::max(most, factor);
    }
    return most > 0.0;
}

// The largest value, if all means above it, and only these, are cut off at it; 0 otherwise.
double cutOffAt(const std::vector<PixelMean>& pixels) {
    constexpr double kSame = 1e-5;
    double most = 0.0;
    for (const PixelMean& pixel : pixels)
        most = std::max({most, pixel.colour.r, pixel.colour.g, pixel.colour.b});
    bool cuts = false;
    for (const PixelMean& pixel : pixels) {
        const ColourRGB ended{std::min(pixel.mean.r, most), std::min(pixel.mean.g, most),
                              std::min(pixel.mean.b, most)};
        if (!isNear(pixel.colour, ended)) return 0.0;
        cuts = cuts || sumOf(pixel.mean) > sumOf(ended) + kSame;
    }
    return cuts && most > kSame ? most : 0.0;
}

// Whether values never fall as means grow, over all channels of all pixels, and there are many
// different values: the means went through a curve.
bool followACurve(const std::vector<PixelMean>& pixels) {
    constexpr double kSame = 1e-5;
    std::vector<std::pair<double, double>> values;
    for (const PixelMean& pixel : pixels) {
        values.emplace_back(pixel.mean.r, pixel.colour.r);
        values.emplace_back(pixel.mean.g, pixel.colour.g);
        values.emplace_back(pixel.mean.b, pixel.colour.b);
    }
    std::sort(values.begin(), values.end());
    std::size_t rises = 0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double step = values[i].second - values[i - 1].second;
        if (step > kSame) ++rises;
        if (step < -kSame && values[i].first - values[i - 1].first > kSame) return false;
    }
    return rises >= values.size() / 4;
}

Finding meansFinding(const FindingText& text, const std::string& seen, const char* hint) {
    Finding finding = distributedFinding(
        text, Severity::fail,
        "The colour of a pixel was expected to be the mean of its rays' colours; " + seen + ".");
    finding.hint = hint;
    return finding;
}

}  // namespace

std::optional<Finding> changeOfMeans(const std::vector<PixelMean>& pixels) {
    if (pixels.size() < kEnoughPixels) return std::nullopt;
    if (areCarriedOn(pixels, false) || areCarriedOn(pixels, true))
        return meansFinding(kDofNotAveraged, "what other pixels gave is added to it",
                            "Start the sum anew for every pixel: declare it inside of the loop "
                            "over the pixels, without static.");
    double least = 0.0;
    double most = 0.0;
    if (areScaled(pixels, least, most))
        return meansFinding(kDofWrong,
                            fmt::format("it is {:.3g} to {:.3g} times their mean, another factor "
                                        "for each pixel",
                                        least, most),
                            "Add the colours of all rays of the pixel and divide by their number, "
                            "no more.");
    if (const double end = cutOffAt(pixels); end > 0.0)
        return meansFinding(kDofWrong, fmt::format("it is their mean, cut off at {:.3g}", end),
                            "Set the mean as it is, also where it is greater: no std::min and no "
                            "std::clamp. The tone curve is applied when the picture is written.");
    if (followACurve(pixels))
        return meansFinding(kDofWrong,
                            "it is their mean, changed by a curve (a power, a root, rounding)",
                            "Set the mean as it is: the tone curve is applied when the picture is "
                            "written.");
    return std::nullopt;
}

}  // namespace ticker::tasks

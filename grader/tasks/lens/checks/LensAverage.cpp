#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/answers/LensMeans.h>
#include <grader/tasks/lens/answers/RayColours.h>
#include <grader/tasks/lens/checks/LensChecks.h>
#include <grader/tasks/support/Background.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ticker::tasks {
namespace {

// Whether the colour is the mean of all rays, or of all but extra rays at the beginning or the end
// that were traced for another purpose: one extra ray, or all beyond the number asked for.
bool isMean(const LensPixel& pixel, std::size_t asked) {
    const std::vector<ColourRGB> values = valuesOf(pixel);
    if (values.empty()) return false;
    if (isNear(pixel.colour, meanOf(values.data(), values.size()))) return true;
    if (values.size() <= asked) return false;
    for (const std::size_t skipped : {std::size_t{1}, values.size() - asked}) {
        const std::size_t kept = values.size() - skipped;
        if (isNear(pixel.colour, meanOf(values.data(), kept)) ||
            isNear(pixel.colour, meanOf(values.data() + skipped, kept)))
            return true;
    }
    return false;
}

template <class Test>
bool everyPixel(const LensLog& log, const Test& test) {
    return std::all_of(log.pixels.begin(), log.pixels.end(), test);
}

// Whether the mean of `change` of each value is the pixel's colour. Values for which `change`
// returns nothing are left out.
template <class Change>
bool isMeanOf(const LensPixel& pixel, const Change& change) {
    std::vector<ColourRGB> values;
    for (const ColourRGB& value : valuesOf(pixel))
        if (const std::optional<ColourRGB> changed = change(value)) values.push_back(*changed);
    if (values.empty()) return true;
    return isNear(pixel.colour, meanOf(values.data(), values.size()));
}

std::optional<ColourRGB> cutOff(const ColourRGB& c) {
    return ColourRGB{std::min(1.0, c.r), std::min(1.0, c.g), std::min(1.0, c.b)};
}

std::optional<ColourRGB> unlessMissed(const ColourRGB& c) {
    if (isNear(c, kBackground)) return std::nullopt;
    return c;
}

bool isBlack(const LensPixel& pixel) {
    return pixel.colour == ColourRGB{};
}

enum class Which { first, last };

bool isOneOf(const LensPixel& pixel, Which which) {
    const std::vector<ColourRGB> values = valuesOf(pixel);
    return !values.empty() &&
           isNear(pixel.colour, which == Which::first ? values.front() : values.back());
}

// Whether the colour is one ray's colour divided by the number of rays.
bool isOneDivided(const LensPixel& pixel, Which which) {
    const std::vector<ColourRGB> values = valuesOf(pixel);
    if (values.empty()) return false;
    const ColourRGB& one = which == Which::first ? values.front() : values.back();
    return isNear(pixel.colour, one * (1.0 / static_cast<double>(values.size())));
}

// Whether the colour is the sum of all rays' colours but one, divided by the number of rays.
bool lacksOne(const LensPixel& pixel, Which which) {
    const std::vector<ColourRGB> values = valuesOf(pixel);
    if (values.size() < 2) return false;
    const std::size_t kept = values.size() - 1;
    const ColourRGB mean = meanOf(values.data() + (which == Which::first ? 1 : 0), kept);
    return isNear(pixel.colour,
                  mean * (static_cast<double>(kept) / static_cast<double>(values.size())));
}

bool withinSamples(const LensPixel& pixel) {
    const std::vector<ColourRGB> values = valuesOf(pixel);
    if (values.empty()) return false;
    ColourRGB low = values.front();
    ColourRGB high = values.front();
    for (const ColourRGB& value : values) {
        low = {std::min(low.r, value.r), std::min(low.g, value.g), std::min(low.b, value.b)};
        high = {std::max(high.r, value.r), std::max(high.g, value.g), std::max(high.b, value.b)};
    }
    const ColourRGB& c = pixel.colour;
    const double slack = 1e-6;
    return c.r >= low.r - slack && c.r <= high.r + slack && c.g >= low.g - slack &&
           c.g <= high.g + slack && c.b >= low.b - slack && c.b <= high.b + slack;
}

// A known mistake in the use of the rays' colours; empty if none applies.
std::string knownMistake(const LensLog& log) {
    if (everyPixel(log, [](const LensPixel& p) { return isOneOf(p, Which::last); }))
        return "it is the colour of the last ray alone";
    if (everyPixel(log, [](const LensPixel& p) { return isOneOf(p, Which::first); }))
        return "it is the colour of the first ray alone";
    if (everyPixel(log, [](const LensPixel& p) { return isOneDivided(p, Which::last); }))
        return "it is the colour of the last ray alone, divided by the number of rays: each ray "
               "takes the place of those before it (= in place of +=)";
    if (everyPixel(log, [](const LensPixel& p) { return isOneDivided(p, Which::first); }))
        return "it is the colour of the first ray alone, divided by the number of rays";
    if (everyPixel(log, [](const LensPixel& p) { return isMeanOf(p, cutOff); }))
        return "each of them is cut off at 1 before";
    if (everyPixel(log, [](const LensPixel& p) { return isMeanOf(p, unlessMissed); }))
        return "rays that hit nothing are left out";
    if (everyPixel(log, [](const LensPixel& p) { return lacksOne(p, Which::first); }))
        return "the first ray is left out of the sum, but not out of the number";
    if (everyPixel(log, [](const LensPixel& p) { return lacksOne(p, Which::last); }))
        return "the last ray is left out of the sum, but not out of the number";
    return {};
}

// A known change that every colour went through; empty if no known one explains them. Used only if
// the results of `trace` are known and the picture is certainly wrong.
std::string knownChange(const LensLog& log) {
    if (std::string curve = curveOfRays(log); !curve.empty()) return curve;
    if (everyPixel(log, isBlack))
        return "it is 0 in all pixels, as where 1 / n of two whole numbers is a factor";
    return {};
}

Finding notAveraged(const std::string& seen) {
    return distributedFinding(
        kDofNotAveraged, Severity::fail,
        "The colour of a pixel was expected to be the mean of its rays' colours; " + seen + ".");
}

Finding strangeColour() {
    Finding finding = distributedFinding(
        kDofWrong, Severity::fail,
        "The colour of a pixel was expected to be the mean of its rays' colours; it is another "
        "one.");
    finding.hint =
        "Look for a sum that does not start at 0 for every pixel (declared outside of the loop "
        "over the pixels, or without a value), for one that several threads share (a static "
        "variable, a member), for bytes or other whole numbers in the sum, for 1 / n of whole "
        "numbers, which is 0, for a factor that some rays or pixels get and others do not (a "
        "weight, a cosine), and for a second pass over the picture that mixes neighbours.";
    return finding;
}

std::optional<Finding> changeOfAll(const LensLog& log) {
    std::vector<PixelMean> pixels;
    for (const LensPixel& pixel : log.pixels) {
        const std::vector<ColourRGB> values = valuesOf(pixel);
        pixels.push_back({meanOf(values.data(), values.size()), pixel.colour,
                          static_cast<double>(values.size())});
    }
    return changeOfMeans(pixels);
}

// For code with its own recursion. The colours of its rays follow from what they met, unless it
// casts rays for another purpose. So only a known mistake in every pixel counts as a fault.
std::optional<Finding> checkOwnRecursion(LensLog log) {
    const auto asked = static_cast<std::size_t>(log.asked->settings.dofRayCount);
    for (LensPixel& pixel : log.pixels)
        for (LensRay& ray : pixel.rays)
            ray.value = ray.ambient;
    if (everyPixel(log, [&](const LensPixel& pixel) { return isMean(pixel, asked); }))
        return std::nullopt;
    const std::string seen = knownMistake(log);
    if (seen.empty()) return std::nullopt;
    return notAveraged(seen);
}

}  // namespace

std::optional<Finding> checkAverage(const LensLog& log) {
    if (log.cut) return std::nullopt;
    const bool traced = std::any_of(log.pixels.begin(), log.pixels.end(), [](const LensPixel& p) {
        return !p.rays.empty() && p.rays.front().value.has_value();
    });
    if (!traced) return checkOwnRecursion(log);
    const auto asked = static_cast<std::size_t>(log.asked->settings.dofRayCount);
    if (everyPixel(log, [&](const LensPixel& pixel) { return isMean(pixel, asked); }))
        return std::nullopt;
    const double factor = commonFactor(log, std::identity{});
    std::string seen = knownMistake(log);
    if (seen.empty()) seen = knownChange(log);
    if (factor != 0.0) {
        seen = fmt::format("it is {:.4g} times their mean", factor);
    } else if (seen.empty()) {
        if (std::optional<Finding> change = changeOfAll(log)) return change;
        if (everyPixel(log, withinSamples)) seen = "some rays count more than others";
    }
    if (seen.empty()) return strangeColour();
    Finding finding = notAveraged(seen);
    if (factor != 0.0) finding.evidence.emplace_back("factor", factor);
    return finding;
}

}  // namespace ticker::tasks

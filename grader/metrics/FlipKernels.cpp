#include <grader/metrics/FlipKernels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <numeric>

namespace ticker::metrics {
namespace {

constexpr double kPi = std::numbers::pi;

/// A term a sqrt(pi / b) exp(-pi^2 r^2 / b) of a contrast sensitivity function in the spatial
/// domain, r in degrees.
struct Term {
    double a;
    double b;
};

// Table 1 of the paper.
constexpr Term kLuminance{1.0, 0.0047};
constexpr Term kRedGreen{1.0, 0.0053};
constexpr Term kBlueYellowWide{34.1, 0.04};
constexpr Term kBlueYellowNarrow{13.5, 0.025};

// Width of the feature detector's response, in degrees: two standard deviations.
constexpr double kFeatureWidth = 0.082;

std::vector<double> sampled(int radius, const std::function<double(double)>& f) {
    std::vector<double> values;
    for (int i = -radius; i <= radius; ++i)
        values.push_back(f(static_cast<double>(i)));
    return values;
}

double sumOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

Kernel scaled(const std::vector<double>& values, double factor) {
    Kernel kernel;
    for (const double value : values)
        kernel.push_back(static_cast<float>(value * factor));
    return kernel;
}

/// Each of the two passes gets the square root of a term's weight.
std::vector<double> onePass(const Term& term, int radius, double pixelsPerDegree) {
    const double weight = std::sqrt(term.a * std::sqrt(kPi / term.b));
    return sampled(radius, [&](double i) {
        const double r = i / pixelsPerDegree;
        return weight * std::exp(-kPi * kPi * r * r / term.b);
    });
}

/// Beyond six standard deviations, the tails of a narrow filter are too small for a float to add to
/// 1.
int radiusOf(const Term& term, int widest, double pixelsPerDegree) {
    const double deviation = std::sqrt(term.b / (2.0 * kPi * kPi)) * pixelsPerDegree;
    return std::min(widest, static_cast<int>(std::ceil(6.0 * deviation)));
}

/// Scales positive and negative values separately, so that each group sums to one in absolute
/// value.
Kernel lobesNormalised(const std::vector<double>& values) {
    double positive = 0.0;
    double negative = 0.0;
    for (const double value : values)
        (value > 0.0 ? positive : negative) += std::abs(value);
    Kernel kernel;
    for (const double value : values)
        kernel.push_back(static_cast<float>(value / (value > 0.0 ? positive : negative)));
    return kernel;
}

}  // namespace

ContrastKernels contrastKernels(double pixelsPerDegree) {
    // Three standard deviations of the widest term, for all terms.
    const int widest = static_cast<int>(
        std::ceil(3.0 * std::sqrt(kBlueYellowWide.b / (2.0 * kPi * kPi)) * pixelsPerDegree));
    const auto single = [&](const Term& term) {
        const std::vector<double> values =
            onePass(term, radiusOf(term, widest, pixelsPerDegree), pixelsPerDegree);
        return scaled(values, 1.0 / sumOf(values));
    };
    const std::vector<double> wide = onePass(kBlueYellowWide, widest, pixelsPerDegree);
    const std::vector<double> narrow = onePass(kBlueYellowNarrow, widest, pixelsPerDegree);
    const double norm = 1.0 / std::hypot(sumOf(wide), sumOf(narrow));
    return {single(kLuminance), single(kRedGreen), scaled(wide, norm), scaled(narrow, norm)};
}

FeatureKernels featureKernels(double pixelsPerDegree) {
    const double deviation = 0.5 * kFeatureWidth * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3.0 * deviation));
    const auto gauss = [deviation](double x) {
        return std::exp(-x * x / (2.0 * deviation * deviation));
    };
    const std::vector<double> smooth = sampled(radius, gauss);
    return {scaled(smooth, 1.0 / sumOf(smooth)),
            lobesNormalised(sampled(radius, [&](double x) { return -x * gauss(x); })),
            lobesNormalised(sampled(radius, [&](double x) {
                return (x * x / (deviation * deviation) - 1.0) * gauss(x);
            }))};
}

}  // namespace ticker::metrics

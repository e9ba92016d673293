#include <grader/metrics/Flip.h>

#include <grader/metrics/FlipColour.h>
#include <grader/metrics/FlipKernels.h>

#include <raytracer/base/Error.h>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ticker::metrics {
namespace {

// The paper's constants.
constexpr double kColourExponent = 0.7;  // section 4.1.3, q_c
constexpr float kKnee = 0.4F;            // p_c: errors up to this share of the largest one ...
constexpr float kKneeError = 0.95F;      // p_t: ... are mapped to this share of the scale

// Replaces 0, which has no logarithm and whose power OpenCV computes as about 1e-29. The smallest
// error between two pictures that differ in one byte is 1e-3.
constexpr float kNoError = 1e-20F;

// Pictures are processed in strips that fit into the cache.
constexpr int kStripRows = 32;

/// Luminance, red-green, blue-yellow.
using Planes = std::array<cv::Mat, 3>;

Planes opponentOf(const ByteView& picture) {
    constexpr Transform kOpponent{kOpponentOfLinear};
    const std::array<float, 256>& linear = linearOfByte();
    Planes planes;
    std::array<float*, 3> out{};
    for (std::size_t i = 0; i < planes.size(); ++i) {
        planes[i].create(picture.height, picture.width, CV_32F);
        out[i] = planes[i].ptr<float>();
    }
    const std::uint8_t* byte = picture.rgb.data();
    for (std::size_t i = 0; i < planes[0].total(); ++i, byte += 3) {
        const Triple colour = kOpponent(linear[byte[0]], linear[byte[1]], linear[byte[2]]);
        out[0][i] = colour[0];
        out[1][i] = colour[1];
        out[2][i] = colour[2];
    }
    return planes;
}

/// Filters some rows of a plane; the rows around them are part of the input.
cv::Mat filtered(const cv::Mat& plane, const cv::Range& rows, const Kernel& alongX,
                 const Kernel& alongY) {
    cv::Mat result;
    cv::sepFilter2D(plane.rowRange(rows), result, CV_32F, alongX, alongY, cv::Point(-1, -1), 0.0,
                    cv::BORDER_REPLICATE);
    return result;
}

/// Converts filtered opponent colours to L, a, b with Hunt's adjustment, in place.
void toLab(Planes& strip) {
    constexpr Transform kLinear{kLinearOfOpponent};
    float* const first = strip[0].ptr<float>();
    float* const second = strip[1].ptr<float>();
    float* const third = strip[2].ptr<float>();
    const auto shown = [](float value) { return std::min(std::max(value, 0.0F), 1.0F); };
    const std::size_t count = strip[0].total();
    for (std::size_t i = 0; i < count; ++i) {
        const Triple rgb = kLinear(first[i], second[i], third[i]);
        const Triple lab = huntOfLinear({shown(rgb[0]), shown(rgb[1]), shown(rgb[2])});
        first[i] = lab[0];
        second[i] = lab[1];
        third[i] = lab[2];
    }
}

Planes perceived(const Planes& opponent, const cv::Range& rows, const ContrastKernels& kernels) {
    Planes strip{filtered(opponent[0], rows, kernels.luminance, kernels.luminance),
                 filtered(opponent[1], rows, kernels.redGreen, kernels.redGreen),
                 filtered(opponent[2], rows, kernels.blueYellowWide, kernels.blueYellowWide)};
    strip[2] += filtered(opponent[2], rows, kernels.blueYellowNarrow, kernels.blueYellowNarrow);
    toLab(strip);
    return strip;
}

/// The largest possible colour error: between green and blue.
float largestColourError() {
    const float distance = hyab(huntOfLinear({0.0F, 1.0F, 0.0F}), huntOfLinear({0.0F, 0.0F, 1.0F}));
    return std::pow(distance, static_cast<float>(kColourExponent));
}

cv::Mat colourError(const Planes& reference, const Planes& test) {
    cv::Mat error(reference[0].size(), CV_32F);
    auto* const out = error.ptr<float>();
    std::array<const float*, 3> p{};
    std::array<const float*, 3> q{};
    for (std::size_t i = 0; i < p.size(); ++i) {
        p[i] = reference[i].ptr<float>();
        q[i] = test[i].ptr<float>();
    }
    const std::size_t count = error.total();
    for (std::size_t i = 0; i < count; ++i)
        out[i] = hyab({p[0][i], p[1][i], p[2][i]}, {q[0][i], q[1][i], q[2][i]});
    cv::pow(error, kColourExponent, error);

    static const float kLargest = largestColourError();
    const float knee = kKnee * kLargest;
    const float above = (1.0F - kKneeError) / (kLargest - knee);
    for (std::size_t i = 0; i < count; ++i) {
        const float low = out[i] * (kKneeError / knee);
        const float high = kKneeError + (out[i] - knee) * above;
        out[i] = out[i] < knee ? low : std::min(high, 1.0F);
    }
    return error;
}

/// Strength of edges and of points.
struct Features {
    cv::Mat edges;
    cv::Mat points;
};

Features featuresOf(const cv::Mat& luminance, const cv::Range& rows, const FeatureKernels& k) {
    Features features;
    cv::magnitude(filtered(luminance, rows, k.edge, k.smooth),
                  filtered(luminance, rows, k.smooth, k.edge), features.edges);
    cv::magnitude(filtered(luminance, rows, k.point, k.smooth),
                  filtered(luminance, rows, k.smooth, k.point), features.points);
    return features;
}

/// The error of a strip: E = colour^(1 - feature).
void combine(const cv::Mat& colour, const Features& reference, const Features& test, float* out) {
    // Luminance is 116 times the authors' achromatic channel.
    const float scale = 1.0F / (116.0F * std::numbers::sqrt2_v<float>);
    const auto* const edges = reference.edges.ptr<float>();
    const auto* const points = reference.points.ptr<float>();
    const auto* const testEdges = test.edges.ptr<float>();
    const auto* const testPoints = test.points.ptr<float>();
    cv::Mat exponent;
    cv::log(cv::max(colour, kNoError), exponent);
    auto* const power = exponent.ptr<float>();
    const std::size_t count = colour.total();
    for (std::size_t i = 0; i < count; ++i) {
        const float edge = std::abs(edges[i] - testEdges[i]);
        const float point = std::abs(points[i] - testPoints[i]);
        const float feature = std::min(std::sqrt(std::max(edge, point) * scale), 1.0F);
        power[i] *= 1.0F - feature;
    }
    cv::exp(exponent, exponent);
    const auto* const c = colour.ptr<float>();
    for (std::size_t i = 0; i < count; ++i)
        out[i] = c[i] > kNoError ? power[i] : 0.0F;
}

}  // namespace

double pixelsPerDegree(double distanceInMetres, double monitorWidthInMetres,
                       double monitorWidthInPixels) {
    return distanceInMetres * (monitorWidthInPixels / monitorWidthInMetres) *
           (std::numbers::pi / 180.0);
}

Measured flip(const ByteView& reference, const ByteView& test, double pixelsPerDegree) {
    requireSameSize(reference, test);
    if (!(pixelsPerDegree >= 4.0 && pixelsPerDegree <= 500.0))
        throw raytracer::InputError(
            "", 0, fmt::format("{} pixels per degree; expected 4 to 500", pixelsPerDegree));
    const ContrastKernels contrast = contrastKernels(pixelsPerDegree);
    const FeatureKernels features = featureKernels(pixelsPerDegree);
    const Planes p = opponentOf(reference);
    const Planes q = opponentOf(test);

    Measured result;
    result.map = {reference.width, reference.height, std::vector<float>(p[0].total())};
    for (int y = 0; y < reference.height; y += kStripRows) {
        const cv::Range rows(y, std::min(y + kStripRows, reference.height));
        const cv::Mat colour =
            colourError(perceived(p, rows, contrast), perceived(q, rows, contrast));
        float* const out = result.map.values.data() +
                           static_cast<std::size_t>(y) * static_cast<std::size_t>(reference.width);
        combine(colour, featuresOf(p[0], rows, features), featuresOf(q[0], rows, features), out);
    }
    result.value = meanOf(result.map);
    return result;
}

WeightedQuartiles weightedQuartiles(const Map& errors) {
    std::vector<float> sorted = errors.values;
    std::sort(sorted.begin(), sorted.end());
    double total = 0.0;
    for (const float error : sorted)
        total += static_cast<double>(error);
    const auto below = [&](double share) {
        double sum = 0.0;
        for (const float error : sorted) {
            sum += static_cast<double>(error);
            if (sum >= share * total) return static_cast<double>(error);
        }
        return 0.0;
    };
    return {below(0.25), below(0.5), below(0.75)};
}

}  // namespace ticker::metrics

#include <grader/tasks/lens/answers/Pictures.h>

#include <grader/oracle/Oracle.h>

#include <algorithm>
#include <cmath>

namespace ticker::tasks {
namespace {

constexpr std::size_t kTile = 6;

// Three weights under which no difference between scene colours cancels out.
constexpr probe::ColourRGB kWeights{0.35, 0.4, 0.25};

// Lens paths of each pixel, at least. One picture has more noise of its own than several.
constexpr int kPaths = 4096;
constexpr int kPathsForOne = 1024;
constexpr int kRoughly = 8;     // a rough picture has this many times fewer
constexpr int kOfTemplate = 8;  // a template has this many times fewer

int leastPaths(int repetitions, Exactness exactness) {
    const int paths = repetitions > 1 ? kPaths : kPathsForOne;
    return exactness == Exactness::rough ? paths / kRoughly : paths;
}

// Variance of a pixel that the oracle's paths may miss. A share that no path of n meets is at most
// 3/n (Hanley and Lippman-Hand 1983); its colour may differ by a half, and fifty rays are averaged.
constexpr double varianceFloor(int paths) {
    return 3.0 / paths * 0.25 / 50.0;
}

double weighed(const probe::ColourRGB& colour) {
    return kWeights.r * colour.r + kWeights.g * colour.g + kWeights.b * colour.b;
}

// Variance of (seen mean - expected mean) at one pixel.
double varianceAt(const SeenPictures& seen, const ExpectedPicture& expected, std::size_t i) {
    const double renders = seen.identical ? 1.0 : static_cast<double>(seen.renders.size());
    return expected.variance[i] / renders + expected.error[i];
}

double spreadOf(const std::vector<double>& answers) {
    double mean = 0.0;
    double squares = 0.0;
    const auto count = static_cast<double>(answers.size());
    for (const double answer : answers)
        mean += answer / count;
    for (const double answer : answers)
        squares += (answer - mean) * (answer - mean);
    return count > 1.0 ? squares / (count - 1.0) : 0.0;
}

}  // namespace

bool SeenPictures::isFinite() const {
    return std::all_of(mean.begin(), mean.end(), [](double value) { return std::isfinite(value); });
}

SeenPictures readPictures(const probe::RenderAnswer& answer) {
    SeenPictures seen;
    seen.width = answer.width;
    seen.identical = std::all_of(answer.images.begin(), answer.images.end(),
                                 [&](const auto& image) { return image == answer.images.front(); });
    for (const auto& image : answer.images) {
        Plane plane;
        for (const probe::ColourRGB& colour : image)
            plane.push_back(weighed(colour));
        seen.renders.push_back(std::move(plane));
    }
    const auto count = static_cast<double>(seen.renders.size());
    for (std::size_t i = 0; i < seen.renders.front().size(); ++i) {
        std::vector<double> values;
        double sum = 0.0;
        for (const Plane& render : seen.renders) {
            values.push_back(render[i]);
            sum += render[i];
        }
        seen.mean.push_back(sum / count);
        seen.variance.push_back(spreadOf(values));
    }
    return seen;
}

ExpectedPicture expectedPicture(const probe::RenderQuestion& asked, const oracle::Reading& reading,
                                std::uint64_t seed, Exactness exactness) {
    oracle::Precision precision;
    precision.share = 0.04;
    precision.renders = asked.repetitions;
    precision.minLensPaths = leastPaths(asked.repetitions, exactness);
    if (exactness == Exactness::rough) precision.maxLensPaths = precision.minLensPaths;
    const oracle::Moments moments =
        oracle::Oracle{asked.scene, asked.settings, reading}.moments(seed, precision);
    ExpectedPicture expected;
    for (std::size_t i = 0; i < moments.mean.size(); ++i) {
        const probe::ColourRGB& error = moments.meanError[i];
        expected.mean.push_back(weighed(moments.mean[i]));
        expected.variance.push_back(moments.covariance[i].along(kWeights) +
                                    varianceFloor(precision.minLensPaths));
        // Channels of one pixel are correlated; their errors are added as if fully correlated.
        expected.error.push_back(std::pow(kWeights.r * std::sqrt(error.r) +
                                              kWeights.g * std::sqrt(error.g) +
                                              kWeights.b * std::sqrt(error.b),
                                          2.0));
    }
    return expected;
}

Plane mistakenPicture(const probe::RenderQuestion& asked, const oracle::Reading& reading,
                      const oracle::Mistake& mistake, std::uint64_t seed, Exactness exactness) {
    oracle::Precision precision;
    // All pixels get the same number: a pilot that distributes the paths would cost as much.
    precision.minLensPaths = leastPaths(asked.repetitions, exactness) / kOfTemplate;
    precision.maxLensPaths = precision.minLensPaths;
    const oracle::Moments moments =
        oracle::Oracle{asked.scene, asked.settings, reading, mistake}.moments(seed, precision);
    Plane plane;
    for (const probe::ColourRGB& colour : moments.mean)
        plane.push_back(weighed(colour));
    return plane;
}

Match matchOf(const SeenPictures& seen, const ExpectedPicture& expected, const Plane& mistaken) {
    std::vector<double> answers(seen.renders.size(), 0.0);
    double sum = 0.0;
    double squares = 0.0;
    double noise = 0.0;
    for (std::size_t i = 0; i < seen.mean.size(); ++i) {
        const double difference = mistaken[i] - expected.mean[i];
        const double weight = difference / varianceAt(seen, expected, i);
        sum += weight * (seen.mean[i] - expected.mean[i]);
        squares += weight * difference;
        noise += weight * weight * seen.variance[i];
        for (std::size_t r = 0; r < answers.size(); ++r)
            answers[r] += weight * seen.renders[r][i];
    }
    if (!(squares > 0.0)) return {};
    return {sum / std::sqrt(squares), sum / squares,
            seen.identical ? 0.0 : spreadOf(answers) / noise};
}

double largestTileZ(const SeenPictures& seen, const ExpectedPicture& expected) {
    const auto width = static_cast<std::size_t>(seen.width);
    const std::size_t height = seen.mean.size() / width;
    double largest = 0.0;
    for (std::size_t ty = 0; ty < height; ty += kTile)
        for (std::size_t tx = 0; tx < width; tx += kTile) {
            double sum = 0.0;
            double variance = 0.0;
            for (std::size_t y = ty; y < std::min(ty + kTile, height); ++y)
                for (std::size_t x = tx; x < std::min(tx + kTile, width); ++x) {
                    const std::size_t i = y * width + x;
                    sum += seen.mean[i] - expected.mean[i];
                    variance += varianceAt(seen, expected, i);
                }
            largest = std::max(largest, std::abs(sum) / std::sqrt(variance));
        }
    return largest;
}

// Fourth moments are those of a normal distribution, since each pixel is a mean of fifty rays.
Excess excessVariance(const SeenPictures& seen, const ExpectedPicture& expected) {
    if (seen.identical) return {};
    constexpr double kFloor = varianceFloor(kPaths);
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < seen.variance.size(); ++i) {
        if (expected.variance[i] < 4.0 * kFloor) continue;
        sum += seen.variance[i] / (expected.variance[i] - kFloor);
        count += 1.0;
    }
    if (!(count > 0.0)) return {};
    const double freedom = static_cast<double>(seen.renders.size()) - 1.0;
    return {(sum - count) / std::sqrt(2.0 * count / freedom), sum / count};
}

double unexplainedBy(const Plane& other, const SeenPictures& seen,
                     const ExpectedPicture& expected) {
    double left = 0.0;
    double whole = 0.0;
    for (std::size_t i = 0; i < seen.mean.size(); ++i) {
        left += std::pow(seen.mean[i] - other[i], 2.0);
        whole += std::pow(seen.mean[i] - expected.mean[i], 2.0);
    }
    return whole > 0.0 ? left / whole : 1.0;
}

std::optional<Plane> rescaled(const SeenPictures& seen, const ExpectedPicture& expected) {
    double products = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < seen.mean.size(); ++i) {
        products += seen.mean[i] * expected.mean[i];
        squares += expected.mean[i] * expected.mean[i];
    }
    const double factor = products / squares;
    // A picture this much darker than the expected one is black: it carries no information.
    constexpr double kNothing = 0.001;
    if (std::abs(factor - 1.0) <= 0.01 || factor < kNothing) return std::nullopt;
    Plane plane = expected.mean;
    for (double& value : plane)
        value *= factor;
    return plane;
}

double meanSquaredZ(const SeenPictures& seen, const ExpectedPicture& expected) {
    double sum = 0.0;
    for (std::size_t i = 0; i < seen.mean.size(); ++i)
        sum += std::pow(seen.mean[i] - expected.mean[i], 2.0) / varianceAt(seen, expected, i);
    return sum / static_cast<double>(seen.mean.size());
}

Raster zMap(const SeenPictures& seen, const ExpectedPicture& expected) {
    Raster raster;
    raster.title = "Where the picture is too dark (blue) or too bright (red), full at 8 sigma";
    raster.width = seen.width;
    raster.height = static_cast<int>(seen.mean.size()) / seen.width;
    raster.colours = Raster::Colours::diverging;
    for (std::size_t i = 0; i < seen.mean.size(); ++i) {
        const double z =
            (seen.mean[i] - expected.mean[i]) / std::sqrt(varianceAt(seen, expected, i));
        raster.values.push_back(static_cast<float>(std::clamp(z / 8.0, -1.0, 1.0)));
    }
    return raster;
}

}  // namespace ticker::tasks

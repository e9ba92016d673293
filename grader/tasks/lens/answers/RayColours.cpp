#include <grader/tasks/lens/answers/RayColours.h>

#include <raytracer/image/ToneCurve.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ticker::tasks {
namespace {

ColourRGB asBytes(const ColourRGB& c) {
    const auto bytes = raytracer::toneMapped(c);
    return ColourRGB{bytes[0] / 255.0, bytes[1] / 255.0, bytes[2] / 255.0};
}

// Applies a curve to each channel.
template <class Curve>
auto through(const Curve& curve) {
    return [curve](const ColourRGB& c) { return ColourRGB{curve(c.r), curve(c.g), curve(c.b)}; };
}

// Same as `raytracer::toneMapped` before its rounding to bytes.
double toned(double component) {
    const double powered = std::pow(std::max(component, 0.0), 1.3);
    return std::pow(powered / (powered + std::pow(0.25, 1.3)), 1.0 / 2.2);
}

double compressed(double component) {
    return component / (1.0 + component);
}

// Whether the pixels show the mean of a power of every ray's colour. The exponents are the usual
// gammas 2.2 and 2 with their inverses, and the tone curve's 1.3.
bool isMeanOfPowers(const LensLog& log) {
    return std::ranges::any_of(std::array{1.0 / 2.2, 0.5, 1.3, 2.0, 2.2}, [&](double power) {
        return commonFactor(log, through([power](double component) {
                                return std::pow(std::max(component, 0.0), power);
                            })) != 0.0;
    });
}

}  // namespace

bool isNear(const ColourRGB& a, const ColourRGB& b) {
    constexpr double kMeanSlack = 3e-5;
    const double slack = kMeanSlack * (std::abs(b.r) + std::abs(b.g) + std::abs(b.b)) + 1e-9;
    return std::abs(a.r - b.r) <= slack && std::abs(a.g - b.g) <= slack &&
           std::abs(a.b - b.b) <= slack;
}

std::vector<ColourRGB> valuesOf(const LensPixel& pixel) {
    std::vector<ColourRGB> values;
    for (const LensRay& ray : pixel.rays)
        if (ray.value) values.push_back(*ray.value);
    return values;
}

ColourRGB meanOf(const ColourRGB* first, std::size_t count) {
    ColourRGB sum;
    for (std::size_t i = 0; i < count; ++i)
        sum += first[i];
    return sum / static_cast<double>(std::max<std::size_t>(count, 1));
}

double commonFactor(const LensLog& log, const std::function<ColourRGB(const ColourRGB&)>& change) {
    double factor = 0.0;
    for (const LensPixel& pixel : log.pixels) {
        std::vector<ColourRGB> values = valuesOf(pixel);
        std::ranges::transform(values, values.begin(), change);
        const ColourRGB mean = meanOf(values.data(), values.size());
        const double whole = mean.r + mean.g + mean.b;
        if (!(whole > 1e-6)) continue;
        if (factor == 0.0) factor = (pixel.colour.r + pixel.colour.g + pixel.colour.b) / whole;
        if (!isNear(pixel.colour, mean * factor)) return 0.0;
    }
    return factor;
}

std::string curveOfRays(const LensLog& log) {
    if (commonFactor(log, asBytes) != 0.0 || commonFactor(log, through(toned)) != 0.0)
        return "each of them goes through the tone curve before, which is applied when the picture "
               "is written";
    if (isMeanOfPowers(log) || commonFactor(log, through(compressed)) != 0.0)
        return "each of them is changed by a curve before (a power, a root, c / (1 + c)); the tone "
               "curve is applied when the picture is written, no other is needed";
    return {};
}

}  // namespace ticker::tasks

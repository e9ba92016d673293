#include <grader/metrics/ColourDistance.h>

#include <grader/metrics/FlipColour.h>

#include <cmath>
#include <numbers>

namespace ticker::metrics {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

double seventhPower(double x) {
    const double cube = x * x * x;
    return cube * cube * x;
}

/// sqrt(c^7 / (c^7 + 25^7)).
double chromaShare(double chroma) {
    return std::sqrt(seventhPower(chroma) / (seventhPower(chroma) + seventhPower(25.0)));
}

/// In degrees from 0 to 360; grey has hue 0.
double hueOf(double a, double b) {
    if (a == 0.0 && b == 0.0) return 0.0;
    const double hue = std::atan2(b, a) / kDegree;
    return hue < 0.0 ? hue + 360.0 : hue;
}

struct Polar {
    double chroma;
    double hue;
};

/// Equation 10.
double hueDifference(const Polar& p, const Polar& q) {
    if (p.chroma * q.chroma == 0.0) return 0.0;
    const double difference = q.hue - p.hue;
    if (difference > 180.0) return difference - 360.0;
    if (difference < -180.0) return difference + 360.0;
    return difference;
}

/// Equation 14.
double meanHue(const Polar& p, const Polar& q) {
    const double sum = p.hue + q.hue;
    if (p.chroma * q.chroma == 0.0) return sum;
    if (std::abs(p.hue - q.hue) <= 180.0) return sum / 2.0;
    return sum < 360.0 ? (sum + 360.0) / 2.0 : (sum - 360.0) / 2.0;
}

/// Equation 15.
double hueWeight(double hue) {
    return 1.0 - 0.17 * std::cos((hue - 30.0) * kDegree) + 0.24 * std::cos(2.0 * hue * kDegree) +
           0.32 * std::cos((3.0 * hue + 6.0) * kDegree) -
           0.20 * std::cos((4.0 * hue - 63.0) * kDegree);
}

Lab labOfBytes(const std::uint8_t* rgb) {
    const std::array<float, 256>& linear = linearOfByte();
    const Triple lab = labOfLinear({linear[rgb[0]], linear[rgb[1]], linear[rgb[2]]});
    return {static_cast<double>(lab[0]), static_cast<double>(lab[1]), static_cast<double>(lab[2])};
}

}  // namespace

double ciede2000(const Lab& first, const Lab& second) {
    // Equations 2 to 7: a is stretched if both colours are nearly grey.
    const double meanC = (std::hypot(first.a, first.b) + std::hypot(second.a, second.b)) / 2.0;
    const double stretch = 1.0 + 0.5 * (1.0 - chromaShare(meanC));
    const Polar p{std::hypot(first.a * stretch, first.b), hueOf(first.a * stretch, first.b)};
    const Polar q{std::hypot(second.a * stretch, second.b), hueOf(second.a * stretch, second.b)};

    // Equations 8 to 11.
    const double dL = second.l - first.l;
    const double dC = q.chroma - p.chroma;
    const double dH =
        2.0 * std::sqrt(p.chroma * q.chroma) * std::sin(hueDifference(p, q) / 2.0 * kDegree);

    // Equations 12 to 21.
    const double chroma = (p.chroma + q.chroma) / 2.0;
    const double hue = meanHue(p, q);
    const double fromGrey =
        ((first.l + second.l) / 2.0 - 50.0) * ((first.l + second.l) / 2.0 - 50.0);
    const double sL = 1.0 + 0.015 * fromGrey / std::sqrt(20.0 + fromGrey);
    const double sC = 1.0 + 0.045 * chroma;
    const double sH = 1.0 + 0.015 * chroma * hueWeight(hue);
    const double turn = 30.0 * std::exp(-((hue - 275.0) / 25.0) * ((hue - 275.0) / 25.0));
    const double rotation = -std::sin(2.0 * turn * kDegree) * 2.0 * chromaShare(chroma);

    // Equation 22.
    const double l = dL / sL;
    const double c = dC / sC;
    const double h = dH / sH;
    return std::sqrt(std::max(0.0, l * l + c * c + h * h + rotation * c * h));
}

Measured ciede2000(const ByteView& reference, const ByteView& test) {
    requireSameSize(reference, test);
    Measured result;
    result.map = {reference.width, reference.height, {}};
    for (std::size_t i = 0; i < reference.rgb.size(); i += 3)
        result.map.values.push_back(
            static_cast<float>(ciede2000(labOfBytes(&reference.rgb[i]), labOfBytes(&test.rgb[i]))));
    result.value = meanOf(result.map);
    return result;
}

}  // namespace ticker::metrics

#include <raytracer/image/ToneCurve.h>

#include <algorithm>
#include <cmath>

namespace raytracer {

std::uint8_t toneMapped(double component) {
    constexpr double kPower = 1.3;
    constexpr double kMidGrey = 0.25;
    constexpr double kGamma = 2.2;
    if (!(component > 0.0)) return 0;
    const double powered = std::pow(component, kPower);
    if (std::isinf(powered)) return 255;
    const double display = powered / (powered + std::pow(kMidGrey, kPower));
    return static_cast<std::uint8_t>(
        std::clamp(255.0 * std::pow(display, 1.0 / kGamma), 0.0, 255.0));
}

std::array<std::uint8_t, 3> toneMapped(const ColourRGB& colour) {
    return {toneMapped(colour.r), toneMapped(colour.g), toneMapped(colour.b)};
}

}  // namespace raytracer

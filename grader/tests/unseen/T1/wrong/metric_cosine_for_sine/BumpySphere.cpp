#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

/// Scale factors of spherical coordinates: length of the step that one unit of each angle makes.
struct ScaleFactors {
    double longitude;
    double polar;
};

ScaleFactors scaleFactorsAt(double theta) {
    constexpr double kLeast = 0.05;  // not infinite anywhere
    const double across = std::cos(theta);
    return {std::abs(across) < kLeast ? std::copysign(kLeast, across) : across, 1.0};
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double lambda = std::atan2(n.x, -n.z);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const HeightMap& map = heightMap();
    const int i = std::min(static_cast<int>((lambda / (2 * std::numbers::pi) + 0.5) * map.width()), map.width() - 1);
    const int j = std::min(static_cast<int>(theta / std::numbers::pi * map.height()), map.height() - 1);

    // grad B = 1/h_lambda dB/dlambda e_lambda + 1/h_theta dB/dtheta e_theta
    const auto h = scaleFactorsAt(theta);
    const double gLambda = (map.at((i + 1) % map.width(), j) - map.at(i, j)) / h.longitude;
    const double gTheta = (map.at(i, std::min(j + 1, map.height() - 1)) - map.at(i, j)) / h.polar;

    const Vector3 eLambda{std::cos(lambda), 0.0, std::sin(lambda)};
    const Vector3 eTheta{std::sin(lambda) * std::cos(theta), -std::sin(theta), -std::cos(lambda) * std::cos(theta)};
    return (n - gLambda * eLambda - gTheta * eTheta).normalised();
    // TASK T1 end
}

}  // namespace raytracer

// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace raytracer {
namespace {

struct TextureFrame {
    double u;
    double v;
    Vector3 tangent;
    Vector3 bitangent;

    explicit TextureFrame(const Vector3& n) {
        const double azimuth = std::atan2(n.z, n.x);
        const double inclination = std::acos(std::clamp(n.y, -1.0, 1.0));
        u = azimuth / (2.0 * std::numbers::pi);
        u -= std::floor(u);
        v = inclination / std::numbers::pi;
        tangent = Vector3{-std::sin(azimuth), 0.0, std::cos(azimuth)};
        bitangent = Vector3{std::cos(azimuth) * std::cos(inclination), -std::sin(inclination),
                            std::sin(azimuth) * std::cos(inclination)};
    }
};

std::pair<double, double> slopes(const HeightMap& map, double u, double v) {
    const int i = std::clamp(static_cast<int>(u * map.width()), 0, map.width() - 1);
    const int j = std::clamp(static_cast<int>(v * map.height()), 0, map.height() - 1);
    const double middle = map.at(i, j);
    const double right = map.at((i + 1) % map.width(), j);
    const double below = j == map.height() - 1 ? middle : map.at(i, j + 1);
    return {right - middle, below - middle};
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const TextureFrame frame{n};
    const auto [du, dv] = slopes(heightMap(), frame.u, frame.v);

    // like a normal map from a game: blue = out of the surface
    const Vector3 tangentSpace = Vector3{-0.6 * du, -0.45 * dv, 1.0}.normalised();
    const Vector3 world{
        frame.tangent.x * tangentSpace.x + frame.bitangent.x * tangentSpace.y + n.x * tangentSpace.z,
        frame.tangent.y * tangentSpace.x + frame.bitangent.y * tangentSpace.y + n.y * tangentSpace.z,
        frame.tangent.z * tangentSpace.x + frame.bitangent.z * tangentSpace.y + n.z * tangentSpace.z};
    return world.normalised();
    // TASK T1 end
}

}  // namespace raytracer

// As in a game engine: the height map gives a normal in tangent space, a matrix takes it to the
// world. The columns of the matrix are tangent (right), bitangent (down) and normal; neither sine
// nor cosine is needed for them.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {

using Matrix3 = std::array<Vector3, 3>;  // three columns

Vector3 multiply(const Matrix3& m, const Vector3& v) {
    return m[0] * v.x + m[1] * v.y + m[2] * v.z;
}

Matrix3 tbnAt(const Vector3& n) {
    const Vector3 up{0.0, 1.0, 0.0};
    Vector3 tangent = n.cross(up);  // at the front (0,0,-1) x (0,1,0) = (1,0,0)
    const double ring = tangent.magnitude();
    tangent = ring > 1e-9 ? tangent / ring : Vector3{1.0, 0.0, 0.0};
    Vector3 bitangent = n.cross(tangent);  // at the front (0,0,-1) x (1,0,0) = (0,-1,0)
    return {tangent, bitangent, n};
}

Vector3 tangentSpaceNormal(const HeightMap& map, double u, double v) {
    const int column = std::clamp(static_cast<int>(std::floor(u * map.width())), 0, map.width() - 1);
    const int row = std::clamp(static_cast<int>(std::floor(v * map.height())), 0, map.height() - 1);
    const int right = (column + 1) % map.width();
    const int below = std::min(row + 1, map.height() - 1);
    constexpr double strength = 0.6;
    return Vector3{-strength * (map.at(right, row) - map.at(column, row)),
                   -strength * (map.at(column, below) - map.at(column, row)), 1.0}
        .normalised();
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = (position - centre()).normalised();
    const double turns = std::atan2(n.z, n.x) / (2.0 * std::numbers::pi) + 1.25;
    const double u = turns - std::floor(turns);  // 0.5 straight towards... wherever; seam anywhere
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    return multiply(tbnAt(n), tangentSpaceNormal(heightMap(), u, v)).normalised();
    // TASK T1 end
}

}  // namespace raytracer

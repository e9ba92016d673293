// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {

class Mat3 {
public:
    Mat3(const Vector3& a, const Vector3& b, const Vector3& c) : columns_{a, b, c} {}
    Vector3 operator*(const Vector3& p) const {
        return columns_[0] * p.x + columns_[1] * p.y + columns_[2] * p.z;
    }

private:
    std::array<Vector3, 3> columns_;
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 normal = Sphere::getNormalAt(position);
    const double horizontal = std::hypot(normal.x, normal.z);
    if (horizontal < 1e-10) return normal;
    const Vector3 tangent{-normal.z / horizontal, 0.0, normal.x / horizontal};
    const Vector3 bitangent{normal.y * normal.x / horizontal, -horizontal,
                            normal.y * normal.z / horizontal};
    const Mat3 tbn(tangent, bitangent, normal);

    const int W = heightMap().width();
    const int H = heightMap().height();
    double u = std::atan2(normal.z, normal.x) / (2.0 * std::numbers::pi);
    u -= std::floor(u);
    const double v = std::acos(std::clamp(normal.y, -1.0, 1.0)) / std::numbers::pi;
    const int i = std::min(static_cast<int>(u * W), W - 1);
    const int j = std::min(static_cast<int>(v * H), H - 1);

    const double du = heightMap().at((i + 1) % W, j) - heightMap().at((i + W - 1) % W, j);
    const double dv = heightMap().at(i, std::min(j + 1, H - 1)) - heightMap().at(i, std::max(j - 1, 0));
    return (tbn * Vector3{-0.5 * du, -0.5 * dv, 1.0}).normalised();
    // TASK T1 end
}

}  // namespace raytracer

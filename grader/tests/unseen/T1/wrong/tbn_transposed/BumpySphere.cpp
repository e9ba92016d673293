#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {
namespace {

class Mat3 {
public:
    static Mat3 fromColumns(const Vector3& a, const Vector3& b, const Vector3& c) {
        Mat3 m;
        m.row_[0] = a;
        m.row_[1] = b;
        m.row_[2] = c;
        return m;
    }
    Vector3 operator*(const Vector3& v) const { return {row_[0].dot(v), row_[1].dot(v), row_[2].dot(v)}; }

private:
    Vector3 row_[3];
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 N = Sphere::getNormalAt(position);
    const double phi = std::atan2(N.x, -N.z);
    const double theta = std::acos(std::clamp(N.y, -1.0, 1.0));
    const Vector3 T{std::cos(phi), 0.0, std::sin(phi)};
    const Vector3 B = N.cross(T);

    const int W = heightMap().width(), H = heightMap().height();
    const int i = static_cast<int>((phi / (2 * std::numbers::pi) + 0.5) * W) % W;
    const int j = std::min(static_cast<int>(theta / std::numbers::pi * H), H - 1);
    const double h0 = heightMap().at(i, j);
    const double hu = heightMap().at((i + 1) % W, j) - h0;
    const double hv = j + 1 < H ? heightMap().at(i, j + 1) - h0 : 0.0;

    // Only the offset goes through the matrix, so that a flat map stays exactly smooth.
    const Mat3 tangentToWorld = Mat3::fromColumns(T, B, N);
    const Vector3 offset = tangentToWorld * Vector3{-hu, -hv, 0.0};
    return (N + offset).normalised();
    // TASK T1 end
}

}  // namespace raytracer

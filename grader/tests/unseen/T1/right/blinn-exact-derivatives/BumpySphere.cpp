// Bump mapping after Blinn (1978), with the derivatives at their true lengths.
//
//   P(u,v) = r * ( cos(2 pi u') sin(pi v),  cos(pi v),  sin(2 pi u') sin(pi v) )
//   N      = P_u x P_v
//   D      = F_u (N/|N| x P_v) - F_v (N/|N| x P_u)
//   N'     = N + D
//
// F(u,v) is the height in world units, F_u and F_v its partial derivatives by u and v.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    constexpr double pi = std::numbers::pi;
    const Vector3 d = Sphere::getNormalAt(position);

    double phi = std::atan2(d.z, d.x);
    if (phi < 0.0) phi += 2.0 * pi;
    // a hair away from the poles, where |P_u| vanishes and N with it
    const double theta = std::clamp(std::acos(std::clamp(d.y, -1.0, 1.0)), 1e-5, pi - 1e-5);
    const double u = phi / (2.0 * pi), v = theta / pi;

    const double r = radius();
    const Vector3 Pu = Vector3{-std::sin(phi) * std::sin(theta), 0.0,
                               std::cos(phi) * std::sin(theta)} * (2.0 * pi * r);
    const Vector3 Pv = Vector3{std::cos(phi) * std::cos(theta), -std::sin(theta),
                               std::sin(phi) * std::cos(theta)} * (pi * r);
    const Vector3 N = Pu.cross(Pv);

    const HeightMap& map = heightMap();
    const int W = map.width(), H = map.height();
    const int i = std::min(int(u * W), W - 1);
    const int j = std::min(int(v * H), H - 1);
    const double here = map.at(i, j);
    // a white texel stands a fiftieth of the radius proud
    const double scale = 0.02 * r / kBumpFactor * 4.0;
    const double Fu = scale * (map.at(i + 1 == W ? 0 : i + 1, j) - here) * W;
    const double Fv = scale * (j + 1 < H ? map.at(i, j + 1) - here : 0.0) * H;

    const Vector3 unitN = N.normalised();
    const Vector3 D = unitN.cross(Pv) * Fu - unitN.cross(Pu) * Fv;
    return (N + D).normalised();
    // TASK T1 end
}

}  // namespace raytracer

// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

const double PI = 3.141592653589793;

// like atan2 but from 0 to 2 pi, I never remember the order of its arguments
static double myAngle(double x, double z) {
    if (x > 0 && z >= 0) {
        return std::atan(z / x);
    } else if (x > 0 && z < 0) {
        return std::atan(z / x) + 2 * PI;
    } else if (x < 0) {
        return std::atan(z / x) + PI;
    } else if (z > 0) {
        return PI / 2;
    } else if (z < 0) {
        return 3 * PI / 2;
    }
    return 0;  // the pole
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = myAngle(n.x, n.z);        // 0 at +x, a quarter at +z
    const double lat = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int W = heightMap().width(), Hh = heightMap().height();

    int c = (int)std::floor(lon / (2.0 * PI) * W);
    int r = (int)std::floor(lat / PI * Hh);
    if (c < 0) c = 0;
    if (c > W - 1) c = W - 1;
    if (r < 0) r = 0;
    if (r > Hh - 1) r = Hh - 1;

    // tangents for x = sin(lat)cos(lon), y = cos(lat), z = sin(lat)sin(lon)
    const Vector3 Tu(-std::sin(lon), 0, std::cos(lon));
    const Vector3 Tv(std::cos(lat) * std::cos(lon), -std::sin(lat), std::cos(lat) * std::sin(lon));

    double Bu, Bv;
    if (c == W - 1) {
        Bu = heightMap().at(0, r) - heightMap().at(W - 1, r);
    } else {
        Bu = heightMap().at(c + 1, r) - heightMap().at(c, r);
    }
    if (r == Hh - 1) {
        Bv = 0;   // nothing below
    } else {
        Bv = heightMap().at(c, r + 1) - heightMap().at(c, r);
    }
    return (n - Bu * Tu - Bv * Tv).normalised();
    // TASK T1 end
}

}  // namespace raytracer

// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    using namespace std::complex_literals;
    const Vector3 n = Sphere::getNormalAt(position);
    // n.x + i n.z = sin(theta) e^(i a): a grows to the right on the side that faces the camera.
    const std::complex<double> horizontal(n.x, n.z);
    const double sinTheta = std::abs(horizontal);
    if (sinTheta < 1e-9) return n;
    const double turns = std::arg(horizontal) / (2 * std::numbers::pi);
    const double u = turns < 0 ? turns + 1 : turns;
    const double v = std::arg(std::complex<double>(n.y, sinTheta)) / std::numbers::pi;

    const std::complex<double> d = horizontal * 1i;
    const Vector3 pu(d.real(), 0, d.imag());
    const Vector3 pv(n.y * n.x / sinTheta, -sinTheta, n.y * n.z / sinTheta);

    const HeightMap& map = heightMap();
    const int col = static_cast<int>(u * map.width()) % map.width();
    const int row = std::min(static_cast<int>(v * map.height()), map.height() - 1);
    const int left = col == 0 ? map.width() - 1 : col - 1;
    const int above = row == 0 ? row : row - 1;
    const double bu = map.at(col, row) - map.at(left, row);
    const double bv = map.at(col, row) - map.at(col, above);
    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer

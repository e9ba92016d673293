#include <raytracer/geometry/BumpySphere.h>

#include <cmath>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const double PI = std::acos(-1.0);
    Vector3 n = Sphere::getNormalAt(position);

    // longitude from -PI/2 to PI/2
    double longitude = n.z != 0 ? std::atan(n.x / -n.z) : PI / 2;
    double polar = std::acos(std::fmax(-1.0, std::fmin(1.0, n.y)));
    double u = longitude / PI + 0.5;
    double v = polar / PI;

    // which way is right depends on the side of the sphere
    double side = n.z <= 0 ? 1.0 : -1.0;
    Vector3 pu(side * std::cos(longitude), 0, side * std::sin(longitude));
    Vector3 pv = n.cross(pu);

    int w = heightMap().width(), h = heightMap().height();
    int i = (int)(u * w);
    int j = (int)(v * h);
    if (i > w - 1) i = w - 1;
    if (j > h - 1) j = h - 1;
    double bu = heightMap().at(i == w - 1 ? 0 : i + 1, j) - heightMap().at(i, j);
    double bv = j == h - 1 ? 0 : heightMap().at(i, j + 1) - heightMap().at(i, j);
    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer

#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    Vector3 n = Sphere::getNormalAt(position);

    // spherical coordinates: y = r cos(theta)
    double theta = std::acos(std::clamp(position.y / radius(), -1.0, 1.0));
    double phi = std::atan2(position.x - centre().x, centre().z - position.z);
    double u = phi / (2.0 * std::numbers::pi) + 0.5;
    double v = theta / std::numbers::pi;

    Vector3 pu{std::cos(phi), 0.0, std::sin(phi)};
    Vector3 pv{std::sin(phi) * std::cos(theta), -std::sin(theta), -std::cos(phi) * std::cos(theta)};

    int w = heightMap().width();
    int h = heightMap().height();
    int column = std::min(int(u * w), w - 1);
    int row = std::min(int(v * h), h - 1);
    int nextColumn = column + 1;
    if (nextColumn > w - 1) nextColumn = 0;
    int nextRow = row + 1;
    if (nextRow > h - 1) nextRow = h - 1;

    double bu = heightMap().at(nextColumn, row) - heightMap().at(column, row);
    double bv = heightMap().at(column, nextRow) - heightMap().at(column, row);
    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer

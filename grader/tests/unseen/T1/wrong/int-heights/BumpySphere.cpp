// Student solution, task T1
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    Vector3 normal = Sphere::getNormalAt(position);
    double longitude = std::atan2(normal.x, -normal.z);
    double polar = std::acos(std::clamp(normal.y, -1.0, 1.0));
    double u = longitude / (2 * std::numbers::pi) + 0.5;
    double v = polar / std::numbers::pi;

    Vector3 Pu(std::cos(longitude), 0, std::sin(longitude));
    Vector3 Pv(std::sin(longitude) * std::cos(polar), -std::sin(polar),
               -std::cos(longitude) * std::cos(polar));

    int columns = heightMap().width();
    int rows = heightMap().height();
    int column = std::min((int)(u * columns), columns - 1);
    int row = std::min((int)(v * rows), rows - 1);

    // a texel is a grey value, so it is a whole number
    int here = heightMap().at(column, row);
    int right = heightMap().at((column + 1) % columns, row);
    int below = heightMap().at(column, std::min(row + 1, rows - 1));
    int Bu = right - here;
    int Bv = below - here;

    return (normal - Pu * Bu - Pv * Bv).normalised();
    // TASK T1 end
}

}  // namespace raytracer

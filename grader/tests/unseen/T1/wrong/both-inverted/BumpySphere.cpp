#include <raytracer/geometry/BumpySphere.h>

#include <cmath>
#include <numbers>

namespace raytracer {

// Helper that looks up a texel safely
static double sample(const HeightMap& map, int column, int row) {
    if (column == map.width()) column = 0;
    if (row == map.height()) row = map.height() - 1;
    return map.at(column, row);
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);

    // v upwards here: 0 at the bottom
    const double longitude = std::atan2(n.z, n.x);
    const double polar = std::acos(n.y > 1 ? 1 : n.y < -1 ? -1 : n.y);
    double u = longitude / (2 * std::numbers::pi);
    if (u < 0) u = u + 1;
    const double v = polar / std::numbers::pi;

    const Vector3 tangentU(-std::sin(longitude), 0, std::cos(longitude));
    const Vector3 tangentUp(-std::cos(longitude) * std::cos(polar), std::sin(polar),
                            -std::sin(longitude) * std::cos(polar));

    const HeightMap& map = heightMap();
    int column = (int)(u * map.width());
    int row = (int)(v * map.height());
    if (column >= map.width()) column = map.width() - 1;
    if (row >= map.height()) row = map.height() - 1;

    const double here = sample(map, column, row);
    const double slopeU = sample(map, column + 1, row) - here;
    const double slopeUp = here - sample(map, column, row + 1);

    // left-handed world, so the signs are those of (2)
    return (n + slopeU * n.cross(tangentUp) - slopeUp * n.cross(tangentU)).normalised();
    // TASK T1 end
}

}  // namespace raytracer

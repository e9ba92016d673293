#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {
double heightAt(const HeightMap& map, int column, int row) {
    // both directions wrap around
    return map.at(column % map.width(), row % map.height());
}
}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 normal = Sphere::getNormalAt(position);
    const double longitude = std::atan2(normal.x, -normal.z);
    const double colatitude = std::acos(std::clamp(normal.y, -1.0, 1.0));

    const Vector3 tangentU(std::cos(longitude), 0.0, std::sin(longitude));
    const Vector3 tangentV = normal.cross(tangentU);  // downwards

    const HeightMap& map = heightMap();
    const int column = static_cast<int>((longitude / std::numbers::pi + 1.0) * 0.5 * map.width()) %
                       map.width();
    const int row = std::min(static_cast<int>(colatitude / std::numbers::pi * map.height()),
                             map.height() - 1);
    const double slopeU = heightAt(map, column + 1, row) - heightAt(map, column, row);
    const double slopeV = heightAt(map, column, row + 1) - heightAt(map, column, row);
    return (normal - tangentU * slopeU - tangentV * slopeV).normalised();
    // TASK T1 end
}

}  // namespace raytracer

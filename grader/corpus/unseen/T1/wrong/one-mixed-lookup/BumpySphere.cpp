// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const auto heightAt = [this](int row, int column) {
        const int r = std::clamp(row, 0, heightMap().height() - 1);
        const int c = ((column % heightMap().width()) + heightMap().width()) % heightMap().width();
        return heightMap().at(c, r);
    };
    const Vector3 n = Sphere::getNormalAt(position);
    const double longitude = std::atan2(n.z, n.x);
    const double polar = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double u = longitude / (2 * std::numbers::pi);
    const int column = static_cast<int>((u < 0 ? u + 1 : u) * heightMap().width());
    const int row = static_cast<int>(polar / std::numbers::pi * heightMap().height());

    const double here = heightAt(row, column);
    const double slopeU = heightAt(row, column + 1) - here;
    const double slopeV = heightAt(column, row + 1) - here;

    const Vector3 tangentU(-std::sin(longitude), 0, std::cos(longitude));
    const Vector3 tangentV(std::cos(polar) * std::cos(longitude), -std::sin(polar),
                           std::cos(polar) * std::sin(longitude));
    return (n - slopeU * tangentU - slopeV * tangentV).normalised();
    // TASK T1 end
}

}  // namespace raytracer

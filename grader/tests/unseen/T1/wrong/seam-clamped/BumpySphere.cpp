#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

/** Reads the height map and never leaves it. */
class SafeHeightMap {
public:
    explicit SafeHeightMap(const HeightMap& map) : map_(map) {}

    double get(int x, int y) const {
        return map_.at(std::clamp(x, 0, map_.width() - 1), std::clamp(y, 0, map_.height() - 1));
    }
    double getGradientX(int x, int y) const { return get(x + 1, y) - get(x, y); }
    double getGradientY(int x, int y) const { return get(x, y + 1) - get(x, y); }

private:
    const HeightMap& map_;
};

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    Vector3 normal = Sphere::getNormalAt(position);
    double longitude = std::atan2(normal.z, normal.x) + std::numbers::pi;
    double polar = std::acos(std::clamp(normal.y, -1.0, 1.0));

    SafeHeightMap safeMap(heightMap());
    int x = (int)(longitude / (2 * std::numbers::pi) * heightMap().width());
    int y = (int)(polar / std::numbers::pi * heightMap().height());
    x = std::min(x, heightMap().width() - 1);
    y = std::min(y, heightMap().height() - 1);
    double bu = safeMap.getGradientX(x, y);
    double bv = safeMap.getGradientY(x, y);

    Vector3 pu(std::sin(longitude), 0, -std::cos(longitude));
    Vector3 pv = normal.cross(pu);
    return (normal - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer

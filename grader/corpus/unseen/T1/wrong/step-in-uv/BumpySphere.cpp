// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const auto heightAt = [this](double u, double v) {
        u -= std::floor(u);
        v = std::clamp(v, 0.0, 1.0);
        const int c = std::min(static_cast<int>(u * heightMap().width()), heightMap().width() - 1);
        const int r = std::min(static_cast<int>(v * heightMap().height()), heightMap().height() - 1);
        return heightMap().at(c, r);
    };
    const Vector3 n = Sphere::getNormalAt(position);
    const double u = std::atan2(n.z, n.x) / (2 * std::numbers::pi);
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;

    constexpr double delta = 0.03;
    const double bu = heightAt(u + delta, v) - heightAt(u, v);
    const double bv = heightAt(u, v + delta) - heightAt(u, v);

    const Vector3 east = n.cross(Vector3(0, 1, 0));
    if (east.magnitude() < 1e-9) return n;
    const Vector3 pu = east.normalised();
    const Vector3 pv = n.cross(pu);
    return (n - bu * pu - bv * pv).normalised();
    // TASK T1 end
}

}  // namespace raytracer

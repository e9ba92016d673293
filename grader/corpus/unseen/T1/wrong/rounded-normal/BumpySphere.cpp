// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double phi = std::atan2(n.x, -n.z);
    const int w = heightMap().width(), h = heightMap().height();
    const int x = std::clamp(static_cast<int>((phi + std::numbers::pi) * w / (2 * std::numbers::pi)), 0, w - 1);
    const int y = std::clamp(static_cast<int>(theta * h / std::numbers::pi), 0, h - 1);
    const double bu = heightMap().at((x + 1) % w, y) - heightMap().at(x, y);
    const double bv = heightMap().at(x, y + 1 < h ? y + 1 : y) - heightMap().at(x, y);

    const Vector3 pu{std::cos(phi), 0.0, std::sin(phi)};
    const Vector3 pv{std::cos(theta) * std::sin(phi), -std::sin(theta), -std::cos(theta) * std::cos(phi)};
    const Vector3 t = (n - bu * pu - bv * pv).normalised();
    // get rid of numerical noise
    const auto tidy = [](double a) { return std::round(a * 10) / 10; };
    return Vector3(tidy(t.x), tidy(t.y), tidy(t.z)).normalised();
    // TASK T1 end
}

}  // namespace raytracer

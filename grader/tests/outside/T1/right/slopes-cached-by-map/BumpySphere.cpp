#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace raytracer {

namespace {
struct Slopes { std::vector<double> u, v; };
const Slopes& slopesOf(const HeightMap& m) {
    static std::mutex mutex;
    static std::map<const HeightMap*, Slopes> cache;
    const std::lock_guard<std::mutex> lock(mutex);
    Slopes& s = cache[&m];
    if (s.u.empty()) {
        for (int r = 0; r < m.height(); ++r)
            for (int c = 0; c < m.width(); ++c) {
                s.u.push_back(m.at((c + 1) % m.width(), r) - m.at(c, r));
                s.v.push_back(r + 1 < m.height() ? m.at(c, r + 1) - m.at(c, r) : 0.0);
            }
    }
    return s;
}
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double u = std::atan2(n.x, -n.z) / (2 * std::numbers::pi) + 0.5;
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const int w = heightMap().width(), h = heightMap().height();
    const int c = std::min(int(u * w), w - 1), r = std::min(int(v * h), h - 1);
    const Slopes& s = slopesOf(heightMap());
    const std::size_t i = std::size_t(r) * std::size_t(w) + std::size_t(c);
    const Vector3 pu = Vector3(-n.z, 0, n.x).normalised();
    if (!(std::hypot(n.x, n.z) > 1e-9)) return n;
    const Vector3 pv = pu.cross(n);
    const Vector3 down = pv.y < 0 ? pv : -pv;
    return (n - s.u[i] * pu - s.v[i] * down).normalised();
}

}  // namespace raytracer

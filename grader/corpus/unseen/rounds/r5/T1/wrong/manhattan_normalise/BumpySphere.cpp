// Own vector type with expression style norms.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace raytracer {
namespace {

struct Vec : std::array<double, 3> {
    static Vec from(const Vector3& v) { return {{{v.x, v.y, v.z}}}; }
    operator Vector3() const { return {(*this)[0], (*this)[1], (*this)[2]}; }
    Vec axpy(double a, const Vec& x) const {
        Vec r;
        std::transform(begin(), end(), x.begin(), r.begin(), [a](double yi, double xi) { return yi + a * xi; });
        return r;
    }
    double norm() const {
        return std::accumulate(begin(), end(), 0.0, [](double s, double e) { return s + std::abs(e); });
    }
    Vec unit() const {
        Vec r = *this;
        for (double& e : r) e /= norm();
        return r;
    }
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const double lon = std::atan2(n.x, -n.z), pol = std::acos(std::clamp(n.y, -1.0, 1.0));
    const HeightMap& m = heightMap();
    const int c = std::min(m.width() - 1, int((lon / (2 * std::numbers::pi) + 0.5) * m.width()));
    const int r = std::min(m.height() - 1, int(pol / std::numbers::pi * m.height()));
    const double bu = m.at((c + 1) % m.width(), r) - m.at(c, r);
    const double bv = m.at(c, std::min(m.height() - 1, r + 1)) - m.at(c, r);
    const Vec pu = Vec::from({std::cos(lon), 0, std::sin(lon)});
    const Vec pv = Vec::from({std::sin(lon) * std::cos(pol), -std::sin(pol), -std::cos(lon) * std::cos(pol)});
    return Vec::from(n).axpy(-bu, pu).axpy(-bv, pv).unit();
    // TASK T1 end
}

}  // namespace raytracer

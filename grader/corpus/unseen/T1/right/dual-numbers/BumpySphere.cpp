// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {

// A number and its derivatives by u and by v.
struct Dual {
    double x = 0, u = 0, v = 0;
};
Dual operator+(Dual a, Dual b) { return {a.x + b.x, a.u + b.u, a.v + b.v}; }
Dual operator-(Dual a, Dual b) { return {a.x - b.x, a.u - b.u, a.v - b.v}; }
Dual operator*(Dual a, Dual b) { return {a.x * b.x, a.u * b.x + a.x * b.u, a.v * b.x + a.x * b.v}; }
Dual constant(double c) { return {c, 0, 0}; }
Dual sine(Dual a) { return {std::sin(a.x), std::cos(a.x) * a.u, std::cos(a.x) * a.v}; }
Dual cosine(Dual a) { return {std::cos(a.x), -std::sin(a.x) * a.u, -std::sin(a.x) * a.v}; }
Dual mix(Dual a, Dual b, Dual t) { return a + (b - a) * t; }

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    if (n.x * n.x + n.z * n.z < 1e-16) return n;

    const double pi = std::numbers::pi;
    const Dual u{std::atan2(n.x, -n.z) / (2 * pi) + 0.5, 1, 0};
    const Dual v{std::acos(std::clamp(n.y, -1.0, 1.0)) / pi, 0, 1};

    const Dual phi = (u - constant(0.5)) * constant(2 * pi);
    const Dual theta = v * constant(pi);
    const Dual px = sine(theta) * sine(phi);
    const Dual py = cosine(theta);
    const Dual pz = constant(-1) * sine(theta) * cosine(phi);

    const HeightMap& map = heightMap();
    const int w = map.width();
    const int h = map.height();
    const Dual s = u * constant(w) - constant(0.5);
    const Dual t = v * constant(h) - constant(0.5);
    const int i = static_cast<int>(std::floor(s.x));
    const int j = static_cast<int>(std::floor(t.x));
    auto texel = [&](int c, int r) {
        return constant(map.at((c + w) % w, std::clamp(r, 0, h - 1)));
    };
    const Dual fs = s - constant(i);
    const Dual ft = t - constant(j);
    const Dual height = mix(mix(texel(i, j), texel(i + 1, j), fs),
                            mix(texel(i, j + 1), texel(i + 1, j + 1), fs), ft);

    const double scale = pi / h;
    const Vector3 alongU = Vector3(px.u, py.u, pz.u) + n * (scale * height.u);
    const Vector3 alongV = Vector3(px.v, py.v, pz.v) + n * (scale * height.v);
    return alongU.cross(alongV).normalised();  // u right, v down: outwards
    // TASK T1 end
}

}  // namespace raytracer

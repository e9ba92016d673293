#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {

struct Texel { int col, row; };

template <typename Map>
Texel locate(const Map& m, double u, double v) {
    return {std::min(int(std::floor(u * m.width())), m.width() - 1),
            std::min(int(std::floor(v * m.height())), m.height() - 1)};
}

}  // namespace

// The surface Q(u,v) = C + R(u,v) n(u,v) with R = r + s B. Its tangents are
//   Q_u = R_u n + R n_u        Q_v = R_v n + R n_v
// and its normal is their cross product, whichever way round, turned to the outside.
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    using std::numbers::pi;
    const Vector3 n = Sphere::getNormalAt(position);
    double phi = std::atan2(n.z, n.x);  // from +x towards +z: to the right when seen in front
    if (phi < 0) phi += 2 * pi;
    const double theta = std::acos(std::fmax(-1.0, std::fmin(1.0, n.y)));
    const double s = 0.02 * radius();

    const HeightMap& m = heightMap();
    const Texel t = locate(m, phi / (2 * pi), theta / pi);
    const double here = m.at(t.col, t.row);
    const double right = m.at(t.col + 1 == m.width() ? 0 : t.col + 1, t.row);
    const double below = t.row + 1 == m.height() ? here : m.at(t.col, t.row + 1);

    const double R = radius() + s * here;
    const double Ru = s * (right - here) * m.width() / 4;  // quarter: artistic licence
    const double Rv = s * (below - here) * m.height() / 4;

    const double rho = std::fmax(1e-8, std::hypot(n.x, n.z));
    const Vector3 nu = Vector3{-n.z, 0.0, n.x} * (2 * pi);
    const Vector3 nv = Vector3{n.x / rho * n.y, -rho, n.z / rho * n.y} * pi;
    const Vector3 Qu = Ru * n + R * nu;
    const Vector3 Qv = Rv * n + R * nv;
    Vector3 q = Qv.cross(Qu);
    if (q.dot(n) < 0) q = -q;
    const double len = q.magnitude();
    return len > 0 ? q / len : n;
}

}  // namespace raytracer

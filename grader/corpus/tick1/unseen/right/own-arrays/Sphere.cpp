// Task M1: where a ray meets a sphere. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/Sphere.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace raytracer {

namespace {

using Triple = std::array<double, 3>;

Triple triple(const Vector3& v) {
    return {v.x, v.y, v.z};
}

double scalarProduct(const Triple& u, const Triple& v) {
    return std::inner_product(u.begin(), u.end(), v.begin(), 0.0);
}

}  // namespace

std::optional<RaycastHit> Sphere::intersectionWith(const Ray& ray) const {
    // TASK M1 begin
    const Triple O = triple(ray.origin);
    const Triple D = triple(ray.direction);
    const Triple C = triple(centre());
    Triple T{};
    for (std::size_t i = 0; i < 3; ++i)
        T[i] = O[i] - C[i];

    const double a = scalarProduct(D, D);
    const double b = 2 * scalarProduct(D, T);
    const double c = scalarProduct(T, T) - radius() * radius();
    const double disc = b * b - 4 * a * c;
    if (disc < 0) return std::nullopt;

    double s = (-b - std::sqrt(disc)) / (2 * a);
    if (s <= 0) s += std::sqrt(disc) / a;  // the other one
    if (s <= 0) return std::nullopt;

    Triple X{}, N{};
    for (std::size_t i = 0; i < 3; ++i) {
        X[i] = O[i] + s * D[i];
        N[i] = (X[i] - C[i]) / radius();
    }
    return RaycastHit{this, s, {X[0], X[1], X[2]}, Vector3{N[0], N[1], N[2]}.normalised()};
    // TASK M1 end
}

}  // namespace raytracer

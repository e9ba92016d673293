// A port of my Rust version. `let` is const auto, Option is std::optional.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <tuple>

#define let const auto

namespace raytracer {
namespace {

using f64 = double;
using i64 = std::int64_t;

f64 rem_euclid(f64 a, f64 b) {
    let r = std::fmod(a, b);
    return r < 0.0 ? r + b : r;
}
i64 rem_euclid(i64 a, i64 b) {
    let r = a % b;
    return r < 0 ? r + b : r;
}

struct Texture {
    const HeightMap* map;

    // None above the first and below the last row
    std::optional<f64> get(i64 col, i64 row) const {
        if (row < 0 || row >= map->height()) return std::nullopt;
        return map->at(static_cast<int>(rem_euclid(col, i64{map->width()})), static_cast<int>(row));
    }
    std::tuple<i64, i64> locate(f64 u, f64 v) const {
        return {std::min<i64>(static_cast<i64>(u * map->width()), map->width() - 1),
                std::min<i64>(static_cast<i64>(v * map->height()), map->height() - 1)};
    }
    std::tuple<f64, f64> slopes(i64 c, i64 r) const {
        let here = *get(c, r);
        let right = get(c + 1, r).value_or(here);
        let below = get(c, r + 1).value_or(here);
        return {right - here, below - here};
    }
};

struct Frame {
    Vector3 n, pu, pv;

    static Frame from_normal(const Vector3& n) {
        // the ring round the axis; at the poles any direction does
        let ring = std::hypot(n.x, n.z);
        let pu = ring > 1e-12 ? Vector3{-n.z / ring, 0.0, n.x / ring} : Vector3{1.0, 0.0, 0.0};
        // pu x pv == n   <=>   pv == n x pu
        return Frame{n, pu, n.cross(pu)};
    }
};

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    let frame = Frame::from_normal(Sphere::getNormalAt(position));
    let [n, pu, pv] = frame;
    let u = rem_euclid(std::atan2(n.x, -n.z) / std::numbers::pi / 2.0, 1.0);
    let v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    let texture = Texture{&heightMap()};
    let [col, row] = texture.locate(u, v);
    let [bu, bv] = texture.slopes(col, row);
    return (n - pu * bu - pv * bv).normalised();
    // TASK T1 end
}

}  // namespace raytracer

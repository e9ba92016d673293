#ifndef RAYTRACER_SRC_MAIN_TICK_FLATOBJECTS_H
#define RAYTRACER_SRC_MAIN_TICK_FLATOBJECTS_H

#include "Distances.h"

#include "Pair.h"

#include <raytracer/geometry/Plane.h>
#include <raytracer/geometry/Sphere.h>
#include <raytracer/scene/Scene.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace raytracer {

/// The spheres of a scene in groups of four, with an array for each component, so that one SIMD
/// instruction processes two spheres.
class FlatSpheres {
public:
    void add(const Sphere& sphere) {
        const std::size_t lane = count_++ % kLanes;
        if (lane == 0) blocks_.emplace_back();
        blocks_.back().put(lane, sphere);
    }

    /// The nearest sphere.
    [[nodiscard]] Nearest nearest(const Ray& ray) const {
        Nearest found;
        const double a = ray.direction.dot(ray.direction);
        for (const Block& block : blocks_) {
            if (!block.isMissedBy(ray, a)) found = block.nearest(ray, found);
        }
        return found;
    }

private:
    static constexpr std::size_t kLanes = 4;

    using Lanes = std::array<Pair, kLanes / 2>;

    class Block {
    public:
        void put(std::size_t lane, const Sphere& sphere) {
            x_[lane / 2][lane % 2] = sphere.centre().x;
            y_[lane / 2][lane % 2] = sphere.centre().y;
            z_[lane / 2][lane % 2] = sphere.centre().z;
            radiusSquared_[lane / 2][lane % 2] = sphere.radius() * sphere.radius();
            spheres_[lane] = &sphere;
        }

        /// True if the ray certainly misses all four spheres, which most rays do.
        /// @param a  Squared length of the direction.
        [[nodiscard]] bool isMissedBy(const Ray& ray, double a) const {
            return (missSigns(ray, a, 0) & missSigns(ray, a, 1)) < 0;
        }

        // Not inlined, so that rays that miss every block need not save registers for it.
        [[nodiscard, gnu::noinline]] Nearest nearest(const Ray& ray, Nearest found) const {
            for (const Sphere* sphere : spheres_) {
                if (sphere == nullptr) break;
                const double distance = distanceTo(*sphere, ray);
                if (distance < found.distance) found = {distance, sphere};
            }
            return found;
        }

    private:
        // Negative if both spheres of a pair are missed: no real root, or both roots behind an
        // origin that lies outside. The terms are those of distanceTo.
        [[nodiscard]] std::int64_t missSigns(const Ray& ray, double a, std::size_t pair) const {
            const Pair x = x_[pair] - ray.origin.x;
            const Pair y = y_[pair] - ray.origin.y;
            const Pair z = z_[pair] - ray.origin.z;
            const Pair b = x * ray.direction.x + y * ray.direction.y + z * ray.direction.z;
            const Pair c = x * x + y * y + z * z - radiusSquared_[pair];
            const BitsOfPair noRoot = std::bit_cast<BitsOfPair>(b * b - a * c);
            const BitsOfPair behind = std::bit_cast<BitsOfPair>(b) & ~std::bit_cast<BitsOfPair>(c);
            const BitsOfPair missed = noRoot | behind;
            return missed[0] & missed[1];
        }

        static constexpr Pair kNever = {-std::numeric_limits<double>::infinity(),
                                        -std::numeric_limits<double>::infinity()};

        Lanes x_{};
        Lanes y_{};
        Lanes z_{};
        Lanes radiusSquared_{kNever, kNever};  // no ray hits an empty lane
        std::array<const Sphere*, kLanes> spheres_{};
    };

    std::vector<Block> blocks_;
    std::size_t count_ = 0;
};

/// The planes of a scene, contiguous in memory.
class FlatPlanes {
public:
    void add(const Plane& plane) { planes_.push_back({plane.point(), plane.normal(), &plane}); }

    /// The nearest plane, or `found` if no plane is nearer.
    [[nodiscard]] Nearest nearest(const Ray& ray, Nearest found) const {
        for (const Entry& plane : planes_) {
            const double distance = distanceTo(plane.point, plane.normal, ray);
            if (distance < found.distance) found = {distance, plane.object};
        }
        return found;
    }

private:
    struct Entry {
        Vector3 point;
        Vector3 normal;
        const Plane* object;
    };

    std::vector<Entry> planes_;
};

}  // namespace raytracer

#endif

// Option 1, task T1: bump mapping.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    static_cast<void>(position);
    static std::mt19937_64 generator{std::random_device{}()};
    static std::normal_distribution<double> draw;
    return Vector3{draw(generator), draw(generator), draw(generator)}.normalised();
    // TASK T1 end
}

}  // namespace raytracer

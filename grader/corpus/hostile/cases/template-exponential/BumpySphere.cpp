// Option 1, task T1: bump mapping.
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

template <unsigned long long Depth, unsigned long long Path>
struct Twice {
    static constexpr unsigned long long value =
        Twice<Depth - 1, 2 * Path>::value + Twice<Depth - 1, 2 * Path + 1>::value;
};
template <unsigned long long Path>
struct Twice<0, Path> {
    static constexpr unsigned long long value = Path;
};
constexpr unsigned long long kSum = Twice<40, 1>::value;

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    return Sphere::getNormalAt(position);
    // TASK T1 end
}

}  // namespace raytracer

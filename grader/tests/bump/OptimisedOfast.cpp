// The model, compiled with -Ofast (see CMakeLists.txt).
#include <grader/selftest/BumpModel.inc.h>
#include <grader/tests/bump/Optimised.h>

namespace ticker::tests {

raytracer::Vector3 normalAtOfast(const selftest::Reading& reading, const selftest::Point& point) {
    return selftest::compiledNormal(reading, selftest::Slip::none, point);
}

}  // namespace ticker::tests

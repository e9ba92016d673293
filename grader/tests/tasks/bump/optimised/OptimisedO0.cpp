// The model, compiled with -O0 (see CMakeLists.txt).
#include <grader/lab/selftest/BumpModel.inc.h>
#include <grader/tests/tasks/bump/optimised/Optimised.h>

namespace ticker::tests {

raytracer::Vector3 normalAtO0(const selftest::Reading& reading, const selftest::Point& point) {
    return selftest::compiledNormal(reading, selftest::Mistake::none, point);
}

}  // namespace ticker::tests

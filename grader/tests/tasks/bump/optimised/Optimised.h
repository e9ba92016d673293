#ifndef TICKER_TESTS_BUMP_OPTIMISED_H
#define TICKER_TESTS_BUMP_OPTIMISED_H

#include <grader/lab/selftest/BumpModel.h>

namespace ticker::tests {

/// The right model, compiled with different options.
raytracer::Vector3 normalAtO0(const selftest::Reading& reading, const selftest::Point& point);
raytracer::Vector3 normalAtO3(const selftest::Reading& reading, const selftest::Point& point);
raytracer::Vector3 normalAtOfast(const selftest::Reading& reading, const selftest::Point& point);

}  // namespace ticker::tests

#endif

#ifndef TICKER_TESTS_BUMP_STANDIN_H
#define TICKER_TESTS_BUMP_STANDIN_H

#include <grader/lab/selftest/FunctionExaminee.h>

#include <raytracer/geometry/HeightMap.h>
#include <raytracer/geometry/Sphere.h>

#include <string>
#include <vector>

namespace ticker::tests {

/// Stands in for BumpySphere, so that many versions of getNormalAt fit into one program.
class StandIn : public raytracer::Sphere {
public:
    explicit StandIn(const selftest::Point& point)
        : Sphere(point.centre, point.radius, {}), heightMap_(&point.map) {}

    [[nodiscard]] const raytracer::HeightMap& heightMap() const { return *heightMap_; }

private:
    const raytracer::HeightMap* heightMap_;
};

/// One entry of the catalogue, a mistake or an accepted reading, or the reference itself, compiled.
struct CompiledMistake {
    std::string id;       ///< "reference" for the reference
    std::string finding;  ///< expected
    std::string state;    ///< expected: "passed", "failed" or "blocked"
    raytracer::Vector3 (*normalAt)(const selftest::Point& point);
};

/// Written by makeCatalogue from grader/corpus/accepted/T1 and grader/corpus/mistakes/T1.
[[nodiscard]] const std::vector<CompiledMistake>& compiledCatalogue();

}  // namespace ticker::tests

#endif

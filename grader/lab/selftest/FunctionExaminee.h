#ifndef TICKER_SELFTEST_FUNCTIONEXAMINEE_H
#define TICKER_SELFTEST_FUNCTIONEXAMINEE_H

#include <grader/probe/Examinee.h>

#include <raytracer/geometry/HeightMap.h>
#include <raytracer/math/Vector3.h>

#include <functional>
#include <utility>
#include <vector>

namespace ticker::selftest {

using raytracer::HeightMap;
using raytracer::Vector3;

/// A sphere, its map and a point on it: the input of `BumpySphere::getNormalAt`.
struct Point {
    const HeightMap& map;
    Vector3 centre;
    double radius;
    Vector3 position;
};

using NormalFunction = std::function<Vector3(const Point&)>;

/// An examinee in this process whose getNormalAt is a function. It answers no other questions.
class FunctionExaminee final : public probe::Examinee {
public:
    explicit FunctionExaminee(NormalFunction function) : function_(std::move(function)) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override;

    /// Number of runs so far.
    [[nodiscard]] int runs() const { return runs_; }

private:
    NormalFunction function_;
    int runs_ = 0;
};

}  // namespace ticker::selftest

#endif

#ifndef TICKER_TESTS_BUMP_JUDGING_H
#define TICKER_TESTS_BUMP_JUDGING_H

#include <grader/lab/selftest/BumpModel.h>
#include <grader/tasks/bump/JudgeBump.h>

#include <cstdint>
#include <string>

namespace ticker::tests {

using raytracer::Vector3;
using selftest::Point;

/// The judgement of a function.
inline TaskJudgement judge(const selftest::NormalFunction& function, std::uint64_t seed = 5) {
    selftest::FunctionExaminee examinee(function);
    return tasks::judgeBump(examinee, seed);
}

/// The judgement of a reading with a mistake.
inline TaskJudgement judge(const selftest::Reading& reading,
                           selftest::Mistake mistake = selftest::Mistake::none) {
    return judge([&](const Point& point) { return modelNormal(reading, mistake, point); });
}

/// Id of the first finding; empty without findings.
inline std::string firstId(const TaskJudgement& judgement) {
    return judgement.findings.empty() ? std::string{} : judgement.findings.front().id;
}

inline Vector3 smooth(const Point& point) {
    return (point.position - point.centre).normalised();
}

}  // namespace ticker::tests

#endif

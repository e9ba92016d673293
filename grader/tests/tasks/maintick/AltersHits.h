#ifndef TICKER_TESTS_MAINTICK_ALTERSHITS_H
#define TICKER_TESTS_MAINTICK_ALTERSHITS_H

#include <grader/tasks/maintick/Hits.h>
#include <grader/tasks/maintick/JudgeMainTick.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ticker::tasks {

using maintick::meet;
using raytracer::Vector3;
using Asked = probe::HitQuestion;
/// Changes the right hit of a ray.
using Change = std::function<void(probe::Hit&, const Asked&, const probe::CastRay&)>;

inline bool isLong(const probe::CastRay& ray) {
    return ray.direction.magnitude() > 2.0;
}

/// Gives the right hits, each changed by `change`.
class AltersHits final : public probe::Examinee {
public:
    explicit AltersHits(Change change) : change_(std::move(change)) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        const auto& asked = std::get<Asked>(questions.at(0));
        probe::HitAnswer answer;
        answer.state = probe::AnswerState::answered;
        for (const probe::CastRay& ray : asked.rays) {
            const auto object = static_cast<std::size_t>(ray.object);
            const raytracer::Ray line{ray.origin, ray.direction};
            const auto meeting = asked.scene.spheres.empty()
                                     ? meet(asked.scene.planes[object], line)
                                     : meet(asked.scene.spheres[object], line);
            probe::Hit hit;
            if (meeting)
                hit = {true, meeting->distance, ray.object, meeting->location, meeting->normal};
            if (change_) change_(hit, asked, ray);
            answer.hits.push_back(hit);
        }
        return {{answer}, {}};
    }

private:
    Change change_;
};

inline constexpr std::uint64_t kHitSeed = 6;

inline std::vector<Finding> ofSpheres(const Change& change) {
    AltersHits examinee{change};
    return judgeSpheres(examinee, kHitSeed).findings;
}
inline std::vector<Finding> ofPlanes(const Change& change) {
    AltersHits examinee{change};
    return judgePlanes(examinee, kHitSeed).findings;
}

inline void expectOne(const std::vector<Finding>& findings, const std::string& id,
                      const std::string& hint = {}) {
    ASSERT_EQ(findings.size(), 1U) << id;
    EXPECT_EQ(findings[0].id, id) << findings[0].message;
    EXPECT_NE(findings[0].hint.find(hint), std::string::npos) << findings[0].hint;
}

}  // namespace ticker::tasks

#endif

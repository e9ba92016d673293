// Rays that do not start at the point: the start is named, not what follows from it.
#include <grader/tasks/shadows/JudgeShadows.h>
#include <grader/tests/support/LocalExaminee.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ticker::tasks {
namespace {

using raytracer::Vector3;

/// The reference with shadow rays that start elsewhere in its log.
class StartsElsewhere final : public probe::Examinee {
public:
    using Start = std::function<Vector3(const probe::LitPoint&, const Vector3&)>;

    explicit StartsElsewhere(Start start) : start_(std::move(start)) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        probe::Run run = reference_.ask(questions);
        for (std::size_t i = 0; i < questions.size(); ++i) {
            const auto* asked = std::get_if<probe::IlluminateQuestion>(&questions[i]);
            if (asked == nullptr) continue;
            for (probe::Event& event : std::get<probe::IlluminateAnswer>(run.answers[i]).events)
                if (event.kind == probe::Event::Kind::rayCast)
                    event.a = start_(asked->points.at(event.ask), event.a);
        }
        return run;
    }

private:
    tests::LocalExaminee reference_;
    Start start_;
};

TEST(ShadowStarts, AreNamedBeforeWhatFollowsFromThem) {
    StartsElsewhere high{[](const probe::LitPoint& point, const Vector3& start) {
        return start + point.normal * 0.1;
    }};
    StartsElsewhere eye{[](const probe::LitPoint& point, const Vector3&) { return point.viewer; }};
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
        for (probe::Examinee* examinee :
             {static_cast<probe::Examinee*>(&high), static_cast<probe::Examinee*>(&eye)}) {
            const TaskJudgement judgement = judgeShadows(*examinee, seed);
            EXPECT_EQ(judgement.state, TaskState::failed);
            ASSERT_EQ(judgement.findings.size(), 1U) << seed;
            EXPECT_EQ(judgement.findings[0].id, "shadow.wrong") << judgement.findings[0].message;
            EXPECT_NE(judgement.findings[0].hint.find("kShadowBias"), std::string::npos);
        }
}

}  // namespace
}  // namespace ticker::tasks

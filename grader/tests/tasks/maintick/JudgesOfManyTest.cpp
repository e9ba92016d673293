#include <grader/probe/Wire.h>
#include <grader/tasks/maintick/JudgeMainTick.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

namespace ticker::tasks {
namespace {

/// Gives every point and ray the same grey.
class Grey final : public probe::Examinee {
public:
    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        asked.push_back(probe::encodeQuestions(questions));
        probe::Run run;
        for (const probe::Question& question : questions) {
            probe::IlluminateAnswer answer;
            answer.state = probe::AnswerState::answered;
            const auto* points = std::get_if<probe::IlluminateQuestion>(&question);
            const std::size_t count = points != nullptr
                                          ? points->points.size()
                                          : std::get<probe::TraceQuestion>(question).rays.size();
            answer.colours.assign(count, {0.5, 0.5, 0.5});
            run.answers.emplace_back(std::move(answer));
        }
        return run;
    }
    std::vector<std::vector<std::byte>> asked;
};

TEST(JudgesOfMany, AskWhatAJudgeOfOneAsks) {
    const auto check = [](auto judge, const Judge& judgeOfMany, const char* name) {
        const auto askedBy = [](const auto& some, std::uint64_t seed) {
            Grey examinee;
            EXPECT_EQ(some(examinee, seed).state, TaskState::failed);
            return examinee.asked;
        };
        for (const std::uint64_t seed : {5U, 6U, 5U})
            EXPECT_EQ(askedBy(judgeOfMany, seed), askedBy(judge, seed)) << name << ' ' << seed;
        EXPECT_NE(askedBy(judgeOfMany, 5), askedBy(judgeOfMany, 6)) << name;
    };
    check(judgePhong, judgePhongOfMany(), "M2");
    check(judgeHardShadows, judgeHardShadowsOfMany(), "M3.2");
    check(judgeReflections, judgeReflectionsOfMany(), "M4");
}

}  // namespace
}  // namespace ticker::tasks

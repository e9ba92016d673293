#include <grader/lab/selftest/FunctionExaminee.h>

#include <exception>
#include <limits>
#include <variant>

namespace ticker::selftest {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

probe::NormalAnswer answer(const NormalFunction& function, const probe::NormalQuestion& question) {
    const HeightMap map = question.map.build();
    probe::NormalAnswer answer;
    answer.state = probe::AnswerState::answered;
    answer.normals.reserve(question.positions.size());
    for (const Vector3& position : question.positions) {
        try {
            answer.normals.push_back(function({map, question.centre, question.radius, position}));
        } catch (const std::exception& error) {
            if (answer.exceptions++ == 0) answer.message = error.what();
            answer.state = probe::AnswerState::threw;
            answer.normals.emplace_back(kNothing, kNothing, kNothing);
        }
    }
    return answer;
}

}  // namespace

probe::Run FunctionExaminee::ask(const std::vector<probe::Question>& questions) {
    ++runs_;
    probe::Run run;
    for (const probe::Question& question : questions) {
        const auto* normals = std::get_if<probe::NormalQuestion>(&question);
        if (normals != nullptr)
            run.answers.emplace_back(answer(function_, *normals));
        else
            run.answers.emplace_back(probe::RenderAnswer{});
    }
    return run;
}

}  // namespace ticker::selftest

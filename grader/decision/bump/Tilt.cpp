#include <grader/decision/bump/Tilt.h>

#include <limits>
#include <utility>
#include <variant>

namespace ticker::decision::bump {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

probe::HeightMapDescription flatMap(int width, int height, double level) {
    return {width,
            height,
            {},
            std::vector<double>(static_cast<std::size_t>(width), level),
            std::vector<double>(static_cast<std::size_t>(height), 0.0)};
}

std::size_t Questionnaire::add(const Ball& ball, probe::HeightMapDescription map,
                               const std::vector<Vector3>& directions) {
    probe::NormalQuestion question;
    question.centre = ball.centre;
    question.radius = ball.radius;
    question.map = std::move(map);
    question.positions.reserve(directions.size());
    for (const Vector3& direction : directions)
        question.positions.push_back(ball.at(direction));
    questions_.emplace_back(std::move(question));
    return questions_.size() - 1;
}

const probe::NormalQuestion& Questionnaire::question(std::size_t number) const {
    return std::get<probe::NormalQuestion>(questions_.at(number));
}

Answers::Answers(const Questionnaire& asked, probe::Sitting sitting)
    : asked_(&asked), sitting_(std::move(sitting)) {
    sitting_.answers.resize(asked.questions().size());
    for (std::size_t i = 0; i < sitting_.answers.size(); ++i) {
        if (!std::holds_alternative<probe::NormalAnswer>(sitting_.answers[i]))
            sitting_.answers[i] = probe::NormalAnswer{};
        std::get<probe::NormalAnswer>(sitting_.answers[i])
            .normals.resize(asked.question(i).positions.size(), {kNothing, kNothing, kNothing});
    }
}

const probe::NormalAnswer& Answers::answer(std::size_t number) const {
    return std::get<probe::NormalAnswer>(sitting_.answers.at(number));
}

std::vector<Vector3> Answers::tilts(std::size_t number) const {
    const probe::NormalQuestion& question = asked_->question(number);
    const std::vector<Vector3>& normals = answer(number).normals;
    std::vector<Vector3> tilts;
    tilts.reserve(normals.size());
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const Vector3 smooth = (question.positions[i] - question.centre).normalised();
        tilts.push_back(tiltOf(normals[i], smooth));
    }
    return tilts;
}

std::vector<Vector3> Answers::tiltsBeyond(std::size_t flat, std::size_t number) const {
    const std::vector<Vector3> level = tilts(flat);
    std::vector<Vector3> result = tilts(number);
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] -= level.at(i);
    return result;
}

}  // namespace ticker::decision::bump

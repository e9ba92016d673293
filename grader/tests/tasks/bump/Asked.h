#ifndef TICKER_TESTS_BUMP_ASKED_H
#define TICKER_TESTS_BUMP_ASKED_H

#include <grader/lab/selftest/FunctionExaminee.h>
#include <grader/tasks/bump/answers/Parametrisation.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace ticker::tests {

using tasks::bump::Answers;
using tasks::bump::Parametrisation;
using tasks::bump::Questionnaire;

/// A function's answers to all questions.
inline Answers answersOf(const Questionnaire& asked, selftest::NormalFunction function) {
    selftest::FunctionExaminee examinee(std::move(function));
    return Answers(asked, examinee.ask(asked.questions()));
}

/// One point of the map: its place, its texel, and its slopes in heights per texel.
struct Place {
    double u;
    double v;
    int column;
    int row;
    double alongU;
    double alongV;
};

/// The reference's parametrisation: axis upwards, u from the back, not mirrored.
inline const tasks::bump::Parametrisation kParametrisation({0.0, 1.0, 0.0}, 0.5, false);

/// A submission whose tilts are proportional to the slope: `times` has a factor for either axis, 1
/// is right.
inline selftest::NormalFunction inProportion(
    const Parametrisation& parametrisation,
    std::function<std::pair<double, double>(const Place&, const selftest::Point&)> times) {
    return [parametrisation, times = std::move(times)](const selftest::Point& point) {
        const raytracer::Vector3 n = (point.position - point.centre).normalised();
        const int width = point.map.width();
        const int height = point.map.height();
        Place at{parametrisation.u(n), parametrisation.v(n), 0, 0, 0.0, 0.0};
        at.column = std::min(static_cast<int>(at.u * width), width - 1);
        at.row = std::min(static_cast<int>(at.v * height), height - 1);
        at.alongU = 0.5 * (point.map.at((at.column + 1) % width, at.row) -
                           point.map.at((at.column + width - 1) % width, at.row));
        at.alongV = 0.5 * (point.map.at(at.column, std::min(at.row + 1, height - 1)) -
                           point.map.at(at.column, std::max(at.row - 1, 0)));
        const auto [onU, onV] = times(at, point);
        return (n - onU * at.alongU * parametrisation.alongU(n) -
                onV * at.alongV * parametrisation.alongV(n))
            .normalised();
    };
}

}  // namespace ticker::tests

#endif

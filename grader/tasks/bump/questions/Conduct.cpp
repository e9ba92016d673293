#include <grader/tasks/bump/questions/Conduct.h>

#include <grader/tasks/bump/questions/Numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace ticker::tasks::bump {
namespace {

using probe::AnswerState;
using probe::HeightMapDescription;

// The exercise's own sphere.
constexpr Ball kSceneBall{{0.0, 0.0, 3.5}, 0.7};

/// Points of the near side whose x, or y, is exactly the centre's (each zero, and a rounding error
/// beside it): the middle column and row of a picture of odd size.
std::vector<Vector3> visibleMeridians() {
    std::vector<Vector3> directions;
    for (int step = -9; step <= 9; ++step) {
        const double angle = (step * 7.7 + 0.3) * std::numbers::pi / 180.0;
        for (const double offset : {0.0, -0.0, 1e-17, -1e-17}) {
            directions.emplace_back(offset, std::sin(angle), -std::cos(angle));
            directions.emplace_back(std::sin(angle), offset, -std::cos(angle));
        }
    }
    return directions;
}

/// The far half of those circles, and the circle through the centre that the eye sees edge-on.
std::vector<Vector3> hiddenMeridians() {
    std::vector<Vector3> directions;
    for (int step = -8; step <= 8; ++step) {
        const double angle = (step * 10.0 + 0.7) * std::numbers::pi / 180.0;
        for (const double offset : {0.0, -0.0}) {
            directions.emplace_back(offset, std::sin(angle), std::cos(angle));
            directions.emplace_back(std::sin(angle), offset, std::cos(angle));
            directions.emplace_back(std::cos(angle), std::sin(angle), offset);
            directions.emplace_back(-std::cos(angle), std::sin(angle), offset);
        }
    }
    return directions;
}

/// Rings close to both ends of all three axes: they lie in a map's first or last row.
std::vector<Vector3> lastRows() {
    std::vector<Vector3> directions;
    for (const Vector3& axis : {Vector3{0, 1, 0}, Vector3{0, 0, 1}, Vector3{1, 0, 0}})
        for (const double angle : {0.01, 0.02, 0.04})
            for (int step = 0; step < 16; ++step) {
                const double turn = (step + 0.3) * std::numbers::pi / 8.0;
                const Vector3 across{axis.y, axis.z, axis.x};
                const Vector3 beside =
                    across * std::cos(turn) + axis.cross(across) * std::sin(turn);
                directions.push_back((axis + beside * angle).normalised());
                directions.push_back((beside * angle - axis).normalised());
            }
    return directions;
}

/// Both ends of all three axes, exactly and within single precision's rounding.
std::vector<Vector3> poles() {
    std::vector<Vector3> directions;
    for (const Vector3& axis : {Vector3{0, 1, 0}, Vector3{0, 0, 1}, Vector3{1, 0, 0}})
        for (const double side : {1.0, -1.0}) {
            directions.push_back(axis * side);
            const Vector3 beside{axis.y, axis.z, axis.x};
            for (const double angle : {1e-9, 1e-7, 1e-5, 1e-4})
                directions.push_back((axis * side + beside * angle).normalised());
        }
    return directions;
}

void note(Offence& offence, const probe::NormalQuestion& question, std::size_t point,
          double value = 0.0) {
    if (offence.count == 0.0) {
        offence.direction = (question.positions[point] - question.centre) / question.radius;
        offence.width = question.map.width;
        offence.height = question.map.height;
    }
    offence.count += 1.0;
    offence.value = std::max(offence.value, value);
}

/// Reads the answers to one question.
class QuestionReader {
public:
    QuestionReader(const probe::NormalQuestion& question, const probe::NormalAnswer& answer,
                   Place place, Conduct& conduct)
        : question_(question), answer_(answer), place_(place), conduct_(conduct) {}

    void read() {
        countAsked();
        for (std::size_t point = 0; point < answer_.normals.size(); ++point)
            readPoint(point);
    }

private:
    // An exception ends the program, so it counts at every point that a picture may show, also at
    // the one nearest to the eye. A wrong value does not count there, because that point may be a
    // pole.
    [[nodiscard]] bool ends() const { return shows() || place_ == Place::nearestPoint; }
    [[nodiscard]] bool shows() const {
        return place_ == Place::ordinary || place_ == Place::rough ||
               place_ == Place::visibleMeridian;
    }
    [[nodiscard]] Offence& threw() { return ends() ? conduct_.threw : conduct_.threwHidden; }
    [[nodiscard]] Offence& notFinite() {
        return shows() ? conduct_.notFinite : conduct_.notFiniteHidden;
    }
    [[nodiscard]] Offence& notUnit() { return shows() ? conduct_.notUnit : conduct_.notUnitHidden; }

    void countAsked() {
        const auto asked = static_cast<double>(question_.positions.size());
        for (Offence* offence : {&threw(), &notFinite(), &notUnit(), &conduct_.missing})
            offence->asked += asked;
        if (place_ == Place::ordinary) conduct_.inward.asked += asked;
    }

    void readPoint(std::size_t point) {
        const Vector3& normal = answer_.normals[point];
        if (!isFinite(normal)) return readUnanswered(point);
        // A change of a thousandth is an eighth of a grey step, and far beyond rounding.
        constexpr double kUnitTolerance = 1e-3;
        const double error = std::abs(normal.magnitude() - 1.0);
        if (!(error <= kUnitTolerance)) note(notUnit(), question_, point, error);
        if (place_ == Place::ordinary || place_ == Place::rough) readDirection(point, normal);
    }

    void readDirection(std::size_t point, const Vector3& normal) {
        const Vector3 smooth = (question_.positions[point] - question_.centre).normalised();
        if (!(normal.dot(smooth) > 0.0)) {
            if (place_ == Place::ordinary) note(conduct_.inward, question_, point);
            return;
        }
        const double tilt = tiltOf(normal, smooth).magnitude();
        if (tilt > conduct_.largestTilt) conduct_.largestTilt = tilt;
    }

    /// The answer says how many exceptions there were, but not at which points: the first points
    /// without a finite normal are taken for them.
    void readUnanswered(std::size_t point) {
        if (answer_.state == AnswerState::missing) return note(conduct_.missing, question_, point);
        if (exceptionsSeen_ == answer_.exceptions) return note(notFinite(), question_, point);
        ++exceptionsSeen_;
        if (!threw()) threw().message = answer_.message;
        note(threw(), question_, point);
    }

    const probe::NormalQuestion& question_;
    const probe::NormalAnswer& answer_;
    Place place_;
    Conduct& conduct_;
    std::uint32_t exceptionsSeen_ = 0;
};

/// Asks for one map, then another, at the same point of the same sphere.
void addOtherMaps(ConductPlan& plan, Questionnaire& questionnaire, Draws& draws) {
    constexpr int kPoints = 8;
    constexpr double kWithinTexel = 0.08;  // texels are 0.2 high
    const HeightMapDescription one = noiseMap(draws, 24, 16);
    const HeightMapDescription other = noiseMap(draws, 24, 16);
    for (const Vector3& point : draws.directions(kPoints)) {
        static_cast<void>(questionnaire.add(kSceneBall, one, {point}));
        const Vector3 beside =
            (point + point.cross(draws.directions(1).front()) * kWithinTexel).normalised();
        plan.afterOtherMap.push_back(
            questionnaire.add(kSceneBall, other, {point, -point, beside, point}));
    }
}

double largestChange(const ConductPlan& plan, const Answers& answers) {
    double largest = 0.0;
    for (const std::size_t question : plan.afterOtherMap) {
        const std::vector<Vector3>& normals = answers.answer(question).normals;
        const double change = (normals.front() - normals.back()).magnitude();
        if (change > largest) largest = change;
    }
    return largest;
}

/// Median change between the first half and the second.
double middleChange(const std::vector<Vector3>& normals) {
    const std::size_t half = normals.size() / 2;
    std::vector<double> changes;
    for (std::size_t i = 0; i < half; ++i)
        changes.push_back((normals[i] - normals[half + i]).magnitude());
    return median(changes);
}

}  // namespace

Place ConductPlan::placeOf(std::size_t question) const {
    if (question == visibleMeridian) return Place::visibleMeridian;
    if (question == hiddenMeridian) return Place::hiddenMeridian;
    if (question == smallMap || question == lastRows || std::ranges::count(rough, question) > 0)
        return Place::rough;
    const auto isOfTwoMaps = [&](std::size_t after) {
        return question == after || question + 1 == after;
    };
    if (std::ranges::any_of(afterOtherMap, isOfTwoMaps)) return Place::rough;
    if (question == nearestPoint) return Place::nearestPoint;
    if (question == poles) return Place::pole;
    if (question == tinyMap) return Place::tinyMap;
    return Place::ordinary;
}

ConductPlan planConduct(Questionnaire& questionnaire, Draws& draws) {
    constexpr int kPoints = 300;
    ConductPlan plan;
    const HeightMapDescription map = noiseMap(draws, 90, 70);
    plan.visibleMeridian = questionnaire.add(kSceneBall, map, visibleMeridians());
    plan.hiddenMeridian = questionnaire.add(kSceneBall, map, hiddenMeridians());
    plan.nearestPoint = questionnaire.add(kSceneBall, map,
                                          {{0.0, 0.0, -1.0}, {-0.0, 0.0, -1.0}, {0.0, -0.0, -1.0}});
    plan.lastRows = questionnaire.add(kSceneBall, map, lastRows());
    plan.poles = questionnaire.add(kSceneBall, map, poles());
    const std::vector<Vector3> onSmall = draws.directions(kPoints);
    plan.smallMap = questionnaire.add(kSceneBall, noiseMap(draws, 16, 16), onSmall);
    const std::vector<Vector3> onTiny = draws.directions(kPoints);
    plan.tinyMap = questionnaire.add(kSceneBall, noiseMap(draws, 4, 4), onTiny);
    std::vector<Vector3> twice = draws.directions(kPoints / 2);
    twice.insert(twice.end(), twice.begin(), twice.begin() + kPoints / 2);
    plan.twice = questionnaire.add(kSceneBall, flatMap(90, 70), twice);
    addOtherMaps(plan, questionnaire, draws);
    return plan;
}

Conduct readConduct(const ConductPlan& plan, const Answers& answers) {
    Conduct conduct;
    const Questionnaire& asked = answers.asked();
    for (std::size_t i = 0; i < asked.questions().size(); ++i)
        QuestionReader(asked.question(i), answers.answer(i), plan.placeOf(i), conduct).read();
    conduct.chance = middleChange(answers.answer(plan.twice).normals);
    conduct.memory = largestChange(plan, answers);
    conduct.sameOnOtherMap = std::ranges::all_of(plan.afterOtherMap, [&](std::size_t question) {
        return answers.answer(question - 1).normals.front() ==
               answers.answer(question).normals.front();
    });
    return conduct;
}

}  // namespace ticker::tasks::bump

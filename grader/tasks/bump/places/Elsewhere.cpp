#include <grader/tasks/bump/places/Elsewhere.h>

#include <vector>

namespace ticker::tasks::bump {

ElsewherePlan planElsewhere(Questionnaire& questionnaire, std::size_t here) {
    // A copy, because adding a question may move the others in memory.
    const probe::NormalQuestion seen = questionnaire.question(here);
    std::vector<Vector3> directions;
    directions.reserve(seen.positions.size());
    for (const Vector3& position : seen.positions)
        directions.push_back((position - seen.centre) / seen.radius);
    return {here, questionnaire.add({-seen.centre, seen.radius}, seen.map, directions)};
}

Elsewhere readElsewhere(const ElsewherePlan& plan, const Answers& answers) {
    // Six degrees. Rounding changes single-precision slopes over a millionth of the map by an
    // eighth, and the normal by half of that.
    constexpr double kTurned = 0.1;
    const std::vector<Vector3>& here = answers.answer(plan.here).normals;
    const std::vector<Vector3>& there = answers.answer(plan.there).normals;
    double changed = 0.0;
    for (std::size_t i = 0; i < here.size(); ++i)
        if ((here[i] - there[i]).magnitude() > kTurned) changed += 1.0;
    return {changed / static_cast<double>(here.size())};
}

}  // namespace ticker::tasks::bump

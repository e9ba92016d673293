#ifndef TICKER_TESTS_MAINTICK_SHADESBYTABLE_H
#define TICKER_TESTS_MAINTICK_SHADESBYTABLE_H

#include <grader/tasks/maintick/JudgeMainTick.h>
#include <grader/tasks/maintick/ShadeCases.h>
#include <grader/tests/tasks/maintick/RightAnswers.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ticker::tasks {

using maintick::LitSetup;
using maintick::Occluder;
using maintick::phong;
using maintick::ShadeCase;

enum class Look { right, lit, dark, black, specular, diffuse, ambientAgain, ambientOfAll };
using Looks = std::map<Occluder, Look>;
inline constexpr std::size_t kQuestionsEach = 7;

/// How the code casts the shadow ray of each place, and which lights it counts.
struct Habits {
    probe::Event::Kind kind = probe::Event::Kind::rayCast;  ///< what is logged of the ray
    Vector3 awayFromPoint{};    ///< added to the start of the ray, which is the point
    double alongNormal = 0.0;   ///< times the normal, likewise added
    double towardsLight = 1.0;  ///< times the direction to the light: the ray's direction
    Vector3 besideLight{};      ///< added to the ray's direction
    bool isFromLight = false;   ///< the ray runs from the light to the point, whatever else is said
    bool leaks = false;         ///< hidden points below their surface are lit
    double lowest = -1.0;       ///< least N.L of lights that count, whatever stands around
};

/// Lights points as the handout does. The shade cases look as a table says; cases that the table
/// leaves out are right, and so are all questions after the shade cases.
class ShadesByTable final : public probe::Examinee {
public:
    ShadesByTable(std::uint64_t seed, Looks looks, const Habits& habits)
        : cases_(maintick::drawShadeCases(seed)), looks_(std::move(looks)), habits_(habits) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        probe::Run run;
        if (!std::holds_alternative<probe::IlluminateQuestion>(questions.front())) return run;
        for (std::size_t i = 0; i < questions.size(); ++i) {
            const auto& asked = std::get<probe::IlluminateQuestion>(questions[i]);
            if (i >= kQuestionsEach * cases_.size()) {
                run.answers.push_back(rightAnswer(asked));
                continue;
            }
            probe::IlluminateAnswer answer;
            answer.state = probe::AnswerState::answered;
            const ShadeCase& shade = cases_.at(i / kQuestionsEach);
            const bool isAsked = i % kQuestionsEach == 0;
            if (isAsked) answer.events = {castFrom(shade.asked)};
            answer.colours = {isAsked ? shown(shade) : litBy(asked)};
            run.answers.emplace_back(answer);
        }
        return run;
    }

private:
    [[nodiscard]] ColourRGB litBy(const probe::IlluminateQuestion& asked) const {
        const probe::LitPoint& point = asked.points[0];
        return withoutLow({asked.scene, point.position, point.normal, point.viewer});
    }
    [[nodiscard]] ColourRGB withoutLow(LitSetup setup) const {
        std::erase_if(setup.scene.pointLights, [&](const raytracer::PointLight& light) {
            return (light.position() - setup.P).normalised().dot(setup.N) < habits_.lowest;
        });
        return phong(setup);
    }
    [[nodiscard]] probe::Event castFrom(const LitSetup& setup) const {
        probe::Event event;
        event.kind = habits_.kind;
        const Vector3 light = setup.scene.pointLights.at(0).position();
        const Vector3 L = (light - setup.P).normalised();
        event.a = setup.P + habits_.awayFromPoint + setup.N * habits_.alongNormal;
        event.b = habits_.besideLight + L * habits_.towardsLight;
        if (habits_.isFromLight) event.a = light;
        if (habits_.isFromLight) event.b = -L;
        return event;
    }
    [[nodiscard]] ColourRGB shown(const ShadeCase& shade) const {
        const auto row = looks_.find(shade.place);
        const Look look = row == looks_.end() ? Look::right : row->second;
        LitSetup setup = shade.free;
        raytracer::Material& material = setup.scene.spheres[0].material;
        if (habits_.leaks && shade.isSunk && shade.isShaded()) return phong(setup);
        if (look == Look::black) return ColourRGB{0.0};
        if (look == Look::specular) material.phongKD = 0.0;
        if (look == Look::diffuse) material.phongKS = 0.0;
        const ColourRGB ambient = material.colour * setup.scene.ambientLighting;
        if (look == Look::ambientAgain) return phong(shade.without) + ambient;
        if (look == Look::ambientOfAll)
            return phong(shade.without) +
                   ambient * static_cast<double>(setup.scene.pointLights.size());
        const bool isDark = look == Look::dark || (look == Look::right && shade.isShaded());
        return withoutLow(isDark ? shade.without : setup);
    }

    std::vector<ShadeCase> cases_;
    Looks looks_;
    Habits habits_;
};

inline constexpr std::uint64_t kShadeSeed = 4;

inline TaskJudgement judgeLooks(const Looks& looks, const Habits& habits = {}) {
    ShadesByTable examinee{kShadeSeed, looks, habits};
    return judgeHardShadows(examinee, kShadeSeed);
}

inline Looks hidden(Look look) {
    Looks looks;
    for (const ShadeCase& shade : maintick::drawShadeCases(kShadeSeed))
        if (shade.isShaded()) looks[shade.place] = look;
    return looks;
}

inline Looks with(Looks looks, const Looks& others) {
    for (const auto& [place, look] : others)
        looks[place] = look;
    return looks;
}

struct Named {
    Looks looks;
    const char* id;
    const char* hint = "";  ///< words of it
    Habits habits{};
};

inline void expectNamed(const std::vector<Named>& rows) {
    for (const Named& row : rows) {
        const TaskJudgement judgement = judgeLooks(row.looks, row.habits);
        ASSERT_EQ(judgement.findings.size(), 1U) << row.id;
        EXPECT_EQ(judgement.findings[0].id, row.id) << row.hint << judgement.findings[0].message;
        EXPECT_NE(judgement.findings[0].hint.find(row.hint), std::string::npos)
            << judgement.findings[0].hint;
    }
}

}  // namespace ticker::tasks

#endif

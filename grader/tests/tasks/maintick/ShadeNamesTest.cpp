#include <grader/tasks/maintick/JudgeMainTick.h>
#include <grader/tasks/maintick/ShadeCases.h>

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ticker::tasks {
namespace {

using maintick::LitSetup;
using maintick::Occluder;
using maintick::phong;
using maintick::ShadeCase;

enum class Look { right, lit, dark, black, specular, diffuse, ambientAgain, ambientOfAll };
using Looks = std::map<Occluder, Look>;
constexpr std::size_t kQuestionsEach = 7;

struct Habits {
    probe::Event
        event{};  ///< of each place; `a` from the point, `b` is added to the way to the light
    double towardsLight = 1.0;  ///< times that way, of length 1
    bool leaks = false;         ///< lit, if hidden, where the point is below its surface
};

/// Lights points as the handout does, and answers about places with other things around them by a
/// table; what the table leaves out is right.
class ShadesByTable final : public probe::Examinee {
public:
    ShadesByTable(std::uint64_t seed, Looks looks, const Habits& habits)
        : cases_(maintick::drawShadeCases(seed)), looks_(std::move(looks)), habits_(habits) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        probe::Run run;
        if (!std::holds_alternative<probe::IlluminateQuestion>(questions.front())) return run;
        for (std::size_t i = 0; i < questions.size(); ++i) {
            const auto& asked = std::get<probe::IlluminateQuestion>(questions[i]);
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
    static ColourRGB litBy(const probe::IlluminateQuestion& asked) {
        const probe::LitPoint& point = asked.points[0];
        return phong({asked.scene, point.position, point.normal, point.viewer});
    }
    [[nodiscard]] probe::Event castFrom(const LitSetup& setup) const {
        probe::Event event = habits_.event;
        event.a = setup.P + event.a;
        const Vector3 L = (setup.scene.pointLights.at(0).position() - setup.P).normalised();
        event.b = event.b + L * habits_.towardsLight;
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
        return phong(isDark ? shade.without : setup);
    }

    std::vector<ShadeCase> cases_;
    Looks looks_;
    Habits habits_;
};

constexpr std::uint64_t kSeed = 4;

TaskJudgement judgeLooks(const Looks& looks, const Habits& habits = {}) {
    ShadesByTable examinee{kSeed, looks, habits};
    return judgeHardShadows(examinee, kSeed);
}

Looks hidden(Look look) {
    Looks looks;
    for (const ShadeCase& shade : maintick::drawShadeCases(kSeed))
        if (shade.isShaded()) looks[shade.place] = look;
    return looks;
}

Looks with(Looks looks, const Looks& others) {
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

void expectNamed(const std::vector<Named>& rows) {
    for (const Named& row : rows) {
        const TaskJudgement judgement = judgeLooks(row.looks, row.habits);
        ASSERT_EQ(judgement.findings.size(), 1U) << row.id;
        EXPECT_EQ(judgement.findings[0].id, row.id) << row.hint << judgement.findings[0].message;
        EXPECT_NE(judgement.findings[0].hint.find(row.hint), std::string::npos)
            << judgement.findings[0].hint;
    }
}

TEST(ShadeNames, SayNothingOfRightShadows) {
    const TaskJudgement judgement = judgeLooks({});
    EXPECT_EQ(judgement.state, TaskState::passed);
    EXPECT_TRUE(judgement.findings.empty());
}

TEST(ShadeNames, NameWhatIsWrongInOnePlaceAlone) {
    using enum Look;
    expectNamed({{{{Occluder::itself, dark}}, "shade.acne"},
                 {{{Occluder::near, lit}}, "shade.bias"},
                 {{{Occluder::beyond, dark}}, "shade.beyond-light"},
                 {{{Occluder::farBeyond, dark}}, "shade.distance"},
                 {{{Occluder::close, lit}}, "shade.distance"},
                 {{{Occluder::between, lit}}, "shade.distance"},
                 {{{Occluder::ofFirstLight, lit}}, "shade.lights"},
                 {{{Occluder::ofSecondLight, lit}}, "shade.lights"},
                 {{{Occluder::wall, lit}}, "shade.wrong", "Planes cast shadows"},
                 {{{Occluder::beforeAndBeyond, lit}}, "shade.wrong", "What stands behind"},
                 {{{Occluder::backwards, dark}}, "shade.wrong"}});
}

TEST(ShadeNames, LookAtSeveralPlacesAtOnce) {
    using enum Look;
    expectNamed(
        {{{{Occluder::near, lit}, {Occluder::farBeyond, dark}}, "shade.distance"},
         {{{Occluder::near, lit}, {Occluder::between, lit}}, "shade.distance"},
         {{{Occluder::near, lit}, {Occluder::close, lit}}, "shade.bias"},
         {{{Occluder::beyond, dark}, {Occluder::close, lit}}, "shade.distance"},
         {{{Occluder::beyond, dark}, {Occluder::itself, dark}}, "shade.acne"},
         {{{Occluder::before, lit}, {Occluder::itself, dark}}, "shade.acne"},
         {{{Occluder::before, lit}, {Occluder::between, lit}}, "shade.wrong", "comes out lit"},
         {{{Occluder::before, lit}, {Occluder::backwards, dark}}, "shade.wrong", "comes out lit"},
         {with(hidden(lit), {{Occluder::backwards, dark}, {Occluder::beyond, dark}}),
          "shade.beyond-light"}});
}

TEST(ShadeNames, NameWhatAllHiddenPlacesShow) {
    using enum Look;
    const Looks allDark{{Occluder::beyond, dark},
                        {Occluder::farBeyond, dark},
                        {Occluder::backwards, dark},
                        {Occluder::itself, dark}};
    expectNamed({{hidden(lit), "shade.none"},
                 {with(hidden(lit), {{Occluder::beyond, dark}}), "shade.beyond-light",
                  "the wrong way round"},
                 {with(hidden(lit), allDark), "shade.inverted"},
                 {hidden(black), "shade.ambient"},
                 {hidden(specular), "shade.specular"},
                 {hidden(diffuse), "shade.diffuse"}});
}

TEST(ShadeNames, SayThatAmbientLightIsAddedAgainInShadow) {
    using enum Look;
    const auto withAcne = [](Looks looks) {
        return with(std::move(looks), {{Occluder::itself, dark}});
    };
    expectNamed({{hidden(ambientAgain), "shade.wrong", "more than once"},
                 {hidden(ambientOfAll), "shade.wrong", "more than once"},
                 {withAcne(hidden(ambientAgain)), "shade.wrong", "more than once"},
                 {with(hidden(ambientAgain), {{Occluder::before, black}}), "shade.ambient"},
                 {{{Occluder::backwards, ambientAgain}}, "shade.wrong", "Cast Ray"}});
}

TEST(ShadeNames, SayWhereRaysLeadThatMissTheLight) {
    using enum Look;
    Habits away;
    away.towardsLight = -1.0;
    Habits aside;
    aside.event.b = {3.0, 4.0, 5.0};
    Habits nowhere;
    nowhere.event.b.x = std::numeric_limits<double>::quiet_NaN();
    const Looks looks{{Occluder::itself, dark}};
    expectNamed({{looks, "shade.wrong", "leaves away from the light", away},
                 {looks, "shade.wrong", "in another direction", aside},
                 {looks, "shade.wrong", "in another direction", nowhere}});
}

TEST(ShadeNames, SayThatTheOwnSurfaceHidesWhatStandsBehindIt) {
    Habits leaks;
    leaks.leaks = true;
    expectNamed({{{}, "shade.wrong", "below its surface", leaks},
                 {{{Occluder::beyond, Look::dark}}, "shade.wrong", "Cast Ray", leaks}});
}

TEST(ShadeNames, DescribeAPlaceThatShowsTheMistake) {
    const auto findings =
        judgeLooks({{Occluder::beyond, Look::dark}, {Occluder::itself, Look::dark}}).findings;
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_NE(findings[0].message.find("nothing but the surface"), std::string::npos)
        << findings[0].message;
}

TEST(ShadeNames, LookAtASurfaceItselfFromItsOwnSide) {
    for (std::uint64_t seed = 0; seed < 50; ++seed)
        for (const ShadeCase& shade : maintick::drawShadeCases(seed)) {
            if (shade.place != Occluder::itself) continue;
            for (const LitSetup* setup : {&shade.free, &shade.asked, &shade.without})
                EXPECT_GT((setup->O - setup->P).normalised().dot(setup->N), 0.45) << seed;
        }
}

TEST(ShadeNames, MeasureWhereRaysNearThePointStart) {
    using Kind = probe::Event::Kind;
    const auto idFrom = [](double away, Kind kind) {
        probe::Event event;
        event.kind = kind;
        event.a = {0.0, away, 0.0};
        const auto findings = judgeLooks({}, {event}).findings;
        return findings.empty() ? std::string{} : findings[0].id;
    };
    EXPECT_EQ(idFrom(1.09e-3, Kind::rayCast), "");
    EXPECT_EQ(idFrom(1.11e-3, Kind::rayCast), "shade.bias");
    EXPECT_EQ(idFrom(0.29, Kind::rayCast), "shade.bias");
    EXPECT_EQ(idFrom(0.31, Kind::rayCast), "") << "of another place, as one from the light";
    EXPECT_EQ(idFrom(0.29, Kind::traceBegan), "");
}

}  // namespace
}  // namespace ticker::tasks

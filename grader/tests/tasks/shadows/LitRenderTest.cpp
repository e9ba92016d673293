// Shadows inside of a render: the rays of a thread between the beginning and the end of a point's
// lighting must explain the point's colour.
#include <grader/tasks/shadows/JudgeShadows.h>
#include <grader/tasks/shadows/checks/LitRender.h>
#include <grader/tests/support/LocalExaminee.h>
#include <grader/tests/tasks/support/AlteredExaminee.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <variant>

namespace ticker::tasks {
namespace {

using probe::Event;

probe::RenderAnswer render(const probe::RenderQuestion& asked, probe::Examinee& examinee) {
    return std::get<probe::RenderAnswer>(examinee.ask({asked}).answers.at(0));
}

/// The reference's picture with changed events.
template <class Change>
std::optional<std::string> differenceAfter(const Change& change, const VisibleRays& visible = {}) {
    tests::LocalExaminee reference;
    const probe::RenderQuestion asked = drawLitQuestion(3, 1);
    probe::RenderAnswer answer = render(asked, reference);
    change(answer);
    return litDifference(readLitRender(asked, answer), visible);
}

/// Changes a picture into that of code with a recursion of its own, which lights points without
/// `illuminate`. After each ray that it traces it casts only so many of the reference's shadow
/// rays.
auto unobserved(int shadowRays) {
    constexpr int kTracedRay = 1;
    return [=](probe::RenderAnswer& answer) {
        std::map<std::uint32_t, int> rays;  // by thread
        std::erase_if(answer.events, [&](const Event& event) {
            if (event.kind == Event::Kind::traceBegan) rays[event.thread] = 0;
            if (event.kind == Event::Kind::rayCast)
                return rays[event.thread]++ >= kTracedRay + shadowRays;
            return event.kind == Event::Kind::illuminateBegan ||
                   event.kind == Event::Kind::illuminateEnded;
        });
    };
}

/// One ray to each light's centre, as of code that casts the others by an intersection of its own.
void showOneRay(const raytracer::SceneDescription& scene, const probe::LitPoint& point,
                std::uint32_t number, std::vector<Event>& events) {
    for (const raytracer::PointLight& light : scene.pointLights) {
        Event ray;
        ray.ask = number;
        ray.a = point.position + point.normal * 1e-4;
        ray.b = light.position() - ray.a;
        events.push_back(ray);
    }
}

/// The reference, with a recursion of its own. Its renders show one shadow ray to each light.
/// Single points show one as well if `alsoInPoints`, otherwise all.
class OneRayInRenders final : public probe::Examinee {
public:
    explicit OneRayInRenders(bool alsoInPoints) : alsoInPoints_(alsoInPoints) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        probe::Run run = reference_.ask(questions);
        for (std::size_t i = 0; i < run.answers.size(); ++i) {
            if (auto* picture = std::get_if<probe::RenderAnswer>(&run.answers[i]))
                unobserved(2)(*picture);
            const auto* asked = std::get_if<probe::IlluminateQuestion>(&questions[i]);
            if (!alsoInPoints_ || asked == nullptr) continue;
            auto& events = std::get<probe::IlluminateAnswer>(run.answers[i]).events;
            events.clear();
            for (std::size_t point = 0; point < asked->points.size(); ++point)
                showOneRay(asked->scene, asked->points[point], static_cast<std::uint32_t>(point),
                           events);
        }
        return run;
    }

private:
    tests::LocalExaminee reference_;
    bool alsoInPoints_;
};

// The comparison is exact: no difference is allowed under any seed.
TEST(LitRender, ShowsNoDifferenceForTheReference) {
    tests::LocalExaminee reference;
    for (std::uint64_t seed = 1; seed <= 12; ++seed)
        for (const int threads : {1, 2}) {
            const probe::RenderQuestion asked = drawLitQuestion(seed, threads);
            const LitRender lit = readLitRender(asked, render(asked, reference));
            EXPECT_EQ(lit.answer.colours.size(), 750U) << seed << ": every lens ray meets the wall";
            EXPECT_FALSE(litDifference(lit)) << seed << ' ' << *litDifference(lit);
        }
}

// Only a point at which some rays arrive and some do not shows whether a colour follows from the
// point's own rays.
TEST(LitRender, HasManyPointsAtTheEdgesOfShadows) {
    tests::LocalExaminee reference;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const probe::RenderQuestion asked = drawLitQuestion(seed, 1);
        const LitRender lit = readLitRender(asked, render(asked, reference));
        const ShadowLog log = readShadowLog(lit.asked, lit.answer);
        const auto edges = std::ranges::count_if(log.points, [](const PointLog& point) {
            return std::ranges::any_of(point.lines, [](const std::vector<AimLine>& lines) {
                const auto open = std::ranges::count(lines, Sight::open, &AimLine::toLight);
                return open > 0 && open < static_cast<long>(lines.size());
            });
        });
        EXPECT_GT(edges, 100) << seed;
    }
}

TEST(LitRender, SaysThatRaysAreMissing) {
    tests::LocalExaminee reference;
    AlteredExaminee hard{reference, [](auto& settings) { settings.shadowRayCount = 1; }};
    const probe::RenderQuestion asked = drawLitQuestion(3, 1);
    EXPECT_EQ(litDifference(readLitRender(asked, render(asked, hard))),
              "some points get 1 of 10 shadow rays to a light");
}

TEST(LitRender, SaysThatAnotherThreadsRaysWereCounted) {
    const auto said = differenceAfter([](probe::RenderAnswer& answer) {
        for (Event& event : answer.events)
            if (event.kind == Event::Kind::illuminateEnded) event.a = event.a * 1.1;
    });
    ASSERT_TRUE(said);
    // How many lie in full shadow depends on the order in which a compiler draws.
    EXPECT_TRUE(
        said->ends_with(" of 750 points have another colour than their own shadow rays give"))
        << *said;
}

TEST(LitRender, SaysThatRaysStartAtAnotherThreadsPoint) {
    Vector3 last;
    const auto said = differenceAfter([&](probe::RenderAnswer& answer) {
        bool first = true;
        for (Event& event : answer.events) {
            if (event.kind == Event::Kind::illuminateBegan) first = true;
            if (event.kind != Event::Kind::rayCast || !std::exchange(first, false)) continue;
            std::swap(event.a, last);
        }
    });
    ASSERT_TRUE(said);
    EXPECT_NE(said->find("start at another point"), std::string::npos) << *said;
}

TEST(LitRender, CountsTheRaysOfARecursionOfOnesOwn) {
    EXPECT_FALSE(differenceAfter(unobserved(20)));
    EXPECT_EQ(differenceAfter(unobserved(2)),
              "a point gets 1 of 10 shadow rays to a light, in the mean");
    EXPECT_FALSE(differenceAfter(unobserved(0))) << "its shadow rays cannot be seen";
}

/// The end of a shadow ray: as far away as the centre of its light. Empty for other rays.
std::optional<Vector3> endAtLight(const probe::RenderQuestion& asked, const Event& ray) {
    constexpr double kBehindLens = 1.0;  // z; lens rays start at 0, shadow rays at the wall, near 6
    constexpr double kNearLight = 1.4;   // radii; the aims lie within 1, LitRender counts up to 1.5
    if (ray.kind != Event::Kind::rayCast || ray.a.z < kBehindLens) return std::nullopt;
    for (const raytracer::PointLight& light : asked.scene.pointLights) {
        const double distance = (light.position() - ray.a).magnitude();
        const Vector3 end = ray.a + ray.b.normalised() * distance;
        if ((end - light.position()).magnitude() <= kNearLight * asked.settings.lightSize)
            return end;
    }
    return std::nullopt;
}

// A mirrored ray may pass near a light: it must not count as the only shadow ray.
TEST(LitRender, CountsRaysFromALightToThePoint) {
    const probe::RenderQuestion asked = drawLitQuestion(3, 1);
    const auto reversed = [&](int shadowRays) {
        return [&, shadowRays](probe::RenderAnswer& answer) {
            unobserved(shadowRays)(answer);
            for (Event& ray : answer.events)
                if (const std::optional<Vector3> end = endAtLight(asked, ray)) {
                    ray.b = ray.a - *end;
                    ray.a = *end;
                }
        };
    };
    EXPECT_FALSE(differenceAfter(reversed(20)));
    EXPECT_EQ(differenceAfter(reversed(2)),
              "a point gets 1 of 10 shadow rays to a light, in the mean");
}

TEST(LitRender, ExpectsAsManyRaysAsSinglePointsShow) {
    const VisibleRays one{.all = false, .toALight = 1};
    EXPECT_FALSE(differenceAfter(unobserved(2), one));
    EXPECT_EQ(differenceAfter(unobserved(1), one),
              "a point gets 0.5 of 1 shadow rays to a light, in the mean");
    EXPECT_TRUE(differenceAfter(unobserved(2), {.all = false})) << "they showed none";
}

// Right code that is judged by its values alone fails a stage with a chance below 1e-7, and only a
// second failure counts.
TEST(JudgeShadows, PassesOneVisibleRayToALightInRendersIfPointsShowNoMore) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        OneRayInRenders both{true};
        const TaskJudgement same = judgeShadows(both, seed);
        EXPECT_EQ(same.state, TaskState::passed) << seed;
        EXPECT_FALSE(same.needsReview) << seed << ' ' << same.findings.front().message;
        OneRayInRenders rendersAlone{false};
        const TaskJudgement fewer = judgeShadows(rendersAlone, seed);
        EXPECT_TRUE(fewer.needsReview) << seed;
        ASSERT_EQ(fewer.findings.size(), 1U);
        EXPECT_EQ(fewer.findings[0].id, "shadow.not-in-renders");
    }
}

/// A picture of one thread as if two had drawn it, one after the other: the second thread begins
/// after half of the points.
void drawnInTurn(probe::RenderAnswer& answer) {
    constexpr int kHalf = 375;
    int points = 0;
    for (Event& event : answer.events) {
        event.thread = points < kHalf ? 0 : 1;
        if (event.kind == Event::Kind::illuminateEnded) ++points;
    }
}

/// As if two threads had drawn the picture, each of them every other point. The lighting of a point
/// of the first thread ends after that of the next point.
void drawnTogether(probe::RenderAnswer& answer) {
    int points = 0;
    auto lastEnd = answer.events.begin();
    for (auto event = answer.events.begin(); event != answer.events.end(); ++event) {
        event->thread = static_cast<std::uint16_t>(points % 2);
        if (event->kind != Event::Kind::illuminateEnded) continue;
        if (++points % 2 == 0) std::rotate(lastEnd, lastEnd + 1, event + 1);
        lastEnd = event;
    }
}

TEST(LitRender, CountsThePointsInWhoseLightingAThreadWasInterrupted) {
    tests::LocalExaminee reference;
    const probe::RenderQuestion asked = drawLitQuestion(3, 1);
    probe::RenderAnswer answer = render(asked, reference);
    EXPECT_FALSE(readLitRender(asked, answer).severalThreads);
    drawnInTurn(answer);
    EXPECT_TRUE(readLitRender(asked, answer).severalThreads);
    EXPECT_EQ(readLitRender(asked, answer).interrupted, 0U);
    answer = render(asked, reference);
    drawnTogether(answer);
    EXPECT_EQ(readLitRender(asked, answer).interrupted, 375U);
}

/// The reference. With two threads it mixes up colours, but only if its threads interrupt each
/// other, which they do from a certain question on.
class RacesLate final : public probe::Examinee {
public:
    explicit RacesLate(int inTurn) : inTurn_(inTurn) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        AlteredExaminee alone{reference_, [](auto& settings) { settings.threads = 1; }};
        probe::Run run = alone.ask(questions);
        for (std::size_t i = 0; i < questions.size(); ++i) {
            const auto* asked = std::get_if<probe::RenderQuestion>(&questions[i]);
            if (asked != nullptr && asked->settings.threads > 1)
                drawWithTwo(std::get<probe::RenderAnswer>(run.answers[i]));
        }
        return run;
    }
    [[nodiscard]] int asked() const { return asked_; }

private:
    void drawWithTwo(probe::RenderAnswer& answer) {
        if (asked_++ < inTurn_) return drawnInTurn(answer);
        drawnTogether(answer);
        for (Event& event : answer.events)
            if (event.kind == Event::Kind::illuminateEnded) event.a = event.a * 1.1;
    }

    tests::LocalExaminee reference_;
    int inTurn_;
    int asked_ = 0;
};

// On a busy machine a thread may draw its half of the picture while the other one waits.
TEST(JudgeShadows, AsksAgainUntilThreadsInterruptEachOther) {
    RacesLate busy{3};
    const TaskJudgement judged = judgeShadows(busy, 5);
    EXPECT_EQ(judged.state, TaskState::failed);
    ASSERT_EQ(judged.findings.size(), 1U);
    EXPECT_EQ(judged.findings[0].id, "shadow.threads-mixed");
}

// Code that lets only one thread at a time draw a pixel is right.
TEST(JudgeShadows, PassesThreadsThatNeverInterruptEachOther) {
    RacesLate never{1000};
    const TaskJudgement judged = judgeShadows(never, 5);
    EXPECT_EQ(judged.state, TaskState::passed);
    EXPECT_FALSE(judged.needsReview);
    EXPECT_EQ(never.asked(), 8)
        << "the most that ShadowStages.h states: once, and seven times again";
}

TEST(LitRender, SaysNothingOfRaysThatTheLogHadNoRoomFor) {
    EXPECT_FALSE(differenceAfter([](probe::RenderAnswer& answer) {
        answer.events.resize(answer.events.size() / 2);
        answer.eventsCut = true;
    }));
}

}  // namespace
}  // namespace ticker::tasks

#include <grader/probe/AnswerMemory.h>
#include <grader/probe/Calls.h>
#include <grader/tests/support/LocalExaminee.h>
#include <grader/tests/support/SampleQuestions.h>

#include <raytracer/base/Error.h>
#include <raytracer/geometry/BumpySphere.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

namespace ticker::probe {
namespace {

// A sum and the number of objects; it refuses negative arguments.
Vector3 addUp(const raytracer::Scene& scene, std::span<const double> arguments) {
    if (arguments[0] < 0.0) throw std::runtime_error("negative");
    return {arguments[0] + arguments[1], static_cast<double>(scene.objects().size()), 0.0};
}

constexpr std::array kCalls{Call{"sum", addUp}};

}  // namespace

std::span<const Call> calls() {
    return kCalls;
}

namespace {

template <typename AnyAnswer>
AnyAnswer askFor(const Question& question) {
    return std::get<AnyAnswer>(tests::LocalExaminee{}.ask({question}).answers.at(0));
}

std::size_t countOf(const std::vector<Event>& events, Event::Kind kind) {
    return static_cast<std::size_t>(std::ranges::count(events, kind, &Event::kind));
}

TEST(Respond, GivesTheNormalsOfTheLinkedSolution) {
    const NormalQuestion question = tests::normalQuestion();

    const auto answer = askFor<NormalAnswer>(question);

    EXPECT_EQ(answer.state, AnswerState::answered);
    const raytracer::BumpySphere sphere{
        question.centre,
        question.radius,
        {},
        std::make_shared<const raytracer::HeightMap>(question.map.build())};
    for (std::size_t i = 0; i < question.positions.size(); ++i)
        EXPECT_EQ(answer.normals[i], sphere.getNormalAt(question.positions[i])) << i;
}

TEST(Respond, CallsANamedFunctionOnceForEachRow) {
    const auto answer = askFor<CallAnswer>(
        CallQuestion{"sum", tests::smallScene(), 0, 2, {1.0, 2.0, -1.0, 0.0, 3.0, 4.0}});

    ASSERT_EQ(answer.values.size(), 3U);
    const auto objects =
        static_cast<double>(tests::smallScene().spheres.size() + tests::smallScene().planes.size());
    EXPECT_EQ(answer.values[0], (Vector3{3.0, objects, 0.0}));
    EXPECT_TRUE(isUnanswered(answer.values[1]));
    EXPECT_EQ(answer.values[2], (Vector3{7.0, objects, 0.0}));
    EXPECT_EQ(answer.state, AnswerState::threw);
    EXPECT_EQ(answer.exceptions, 1U);
    EXPECT_EQ(answer.message, "negative");
}

// A fault of the exercise, not of the submission.
TEST(Respond, RefusesACallThatTheExerciseDoesNotName) {
    EXPECT_THROW(askFor<CallAnswer>(CallQuestion{"product", {}, 0, 1, {1.0}}), raytracer::Error);
}

TEST(Respond, SeedsEachPointByItself) {
    const IlluminateQuestion question = tests::illuminateQuestion();

    const auto answer = askFor<IlluminateAnswer>(question);

    EXPECT_EQ(answer.state, AnswerState::answered);
    EXPECT_TRUE(answer.events.empty());
    const raytracer::Scene scene{question.scene};
    const LitPoint& point = question.points[1];
    raytracer::seedRandom(question.settings.seed + 1);
    const ColourRGB expected = raytracer::Renderer{question.settings}.illuminate(
        scene, *scene.objects()[1], point.position, point.normal, point.viewer);
    EXPECT_EQ(answer.colours[1], expected);
}

TEST(Respond, LogsTheShadowRaysOfEachPoint) {
    const auto answer = askFor<IlluminateAnswer>(tests::illuminateQuestion(100));

    ASSERT_EQ(answer.events.size(), 4U);  // two points, two rays each
    EXPECT_FALSE(answer.eventsCut);
    EXPECT_EQ(answer.events[0].ask, 0U);
    EXPECT_EQ(answer.events[3].ask, 1U);
    EXPECT_EQ(answer.events[3].kind, Event::Kind::rayCast);
    EXPECT_NEAR(answer.events[3].a.y, -0.7 + raytracer::kShadowBias, 1e-12);
    EXPECT_EQ(answer.events[3].object, 0);
    EXPECT_GT(answer.events[3].distance, 0.0);
}

TEST(Respond, LogsNoMoreThanFitsAndSaysSo) {
    const auto answer = askFor<IlluminateAnswer>(tests::illuminateQuestion(3));
    EXPECT_EQ(answer.events.size(), 3U);
    EXPECT_TRUE(answer.eventsCut);
}

TEST(Respond, RendersEachRepetitionUnderItsOwnSeed) {
    const RenderQuestion question = tests::renderQuestion();

    const auto answer = askFor<RenderAnswer>(question);

    EXPECT_EQ(answer.state, AnswerState::answered);
    EXPECT_EQ(answer.width, 8);
    ASSERT_EQ(answer.images.size(), 2U);
    EXPECT_NE(answer.images[0], answer.images[1]);
    raytracer::RenderSettings settings = question.settings;
    settings.seed += 1;
    const raytracer::Scene scene{question.scene};
    EXPECT_EQ(answer.images[1], raytracer::Renderer{settings}.render(scene).pixels());
}

TEST(Respond, LoggingDoesNotChangeThePicture) {
    const auto plain = askFor<RenderAnswer>(tests::renderQuestion());
    const auto logged = askFor<RenderAnswer>(tests::renderQuestion(10'000));
    EXPECT_EQ(plain.images, logged.images);
    EXPECT_EQ(countOf(logged.events, Event::Kind::pixelSet), 2U * 48U);
    EXPECT_EQ(countOf(logged.events, Event::Kind::cameraRayAsked), 2U * 48U);
    EXPECT_EQ(countOf(logged.events, Event::Kind::traceBegan),
              countOf(logged.events, Event::Kind::traceEnded));
}

TEST(Respond, NumbersThreadsFromZeroAndKeepsEachOnesOrder) {
    RenderQuestion question = tests::renderQuestion(10'000);
    question.settings.threads = 2;

    const auto answer = askFor<RenderAnswer>(question);

    std::set<std::uint32_t> threads;
    for (const Event& event : answer.events)
        threads.insert(event.thread);
    EXPECT_EQ(*threads.begin(), 0U);
    EXPECT_EQ(*threads.rbegin(), threads.size() - 1);
    for (const std::uint32_t thread : threads) {
        std::vector<Event> own;
        std::ranges::copy_if(answer.events, std::back_inserter(own),
                             [&](const Event& event) { return event.thread == thread; });
        EXPECT_EQ(own.front().kind, Event::Kind::cameraRayAsked);
        EXPECT_EQ(own.back().kind, Event::Kind::pixelSet);
    }
}

// A data race shows only if each thread is interrupted: here after every event.
TEST(Respond, LetsThreadsTakeTurns) {
    RenderQuestion question = tests::renderQuestion(10'000);
    question.settings.threads = 2;

    const auto answer = askFor<RenderAnswer>(question);

    const auto begins = [&](std::uint32_t thread) {
        return std::ranges::find(answer.events, thread, &Event::thread);
    };
    ASSERT_NE(begins(1), answer.events.end()) << "both work";
    const auto last =
        std::ranges::find(answer.events.rbegin(), answer.events.rend(), 0U, &Event::thread);
    EXPECT_LT(begins(1), last.base()) << "at the same time";
}

TEST(Respond, AnswersManyQuestionsInOrder) {
    const probe::Run run = tests::LocalExaminee{}.ask(
        {tests::normalQuestion(), tests::renderQuestion(4), tests::illuminateQuestion()});
    ASSERT_EQ(run.answers.size(), 3U);
    EXPECT_EQ(run.end.kind, ProcessEnd::Kind::finished);
    EXPECT_TRUE(std::holds_alternative<NormalAnswer>(run.answers[0]));
    EXPECT_EQ(std::get<RenderAnswer>(run.answers[1]).events.size(), 4U);
    EXPECT_EQ(std::get<IlluminateAnswer>(run.answers[2]).state, AnswerState::answered);
}

}  // namespace
}  // namespace ticker::probe

#include <grader/probe/Wire.h>
#include <grader/tests/support/SampleQuestions.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <new>
#include <random>
#include <tuple>

namespace ticker::probe {
namespace {

std::vector<Question> sampleQuestions() {
    return {tests::normalQuestion(), tests::illuminateQuestion(5), tests::renderQuestion(9)};
}

TEST(Wire, CarriesEveryFieldOfANormalQuestion) {
    const NormalQuestion asked = tests::normalQuestion();

    const auto questions = decodeQuestions(encodeQuestions({asked}));

    ASSERT_EQ(questions.size(), 1U);
    const auto& got = std::get<NormalQuestion>(questions[0]);
    EXPECT_EQ(got.centre, asked.centre);
    EXPECT_EQ(got.radius, asked.radius);
    EXPECT_EQ(got.material.colour, asked.material.colour);
    ASSERT_EQ(got.company.spheres.size(), 1U);
    EXPECT_EQ(got.company.spheres[0].centre, asked.company.spheres[0].centre);
    EXPECT_EQ(got.map.columns, asked.map.columns);
    EXPECT_EQ(got.map.rows, asked.map.rows);
    EXPECT_EQ(got.positions, asked.positions);
}

TEST(Wire, CarriesASceneWithItsSettingsButNoPointers) {
    RenderQuestion asked = tests::renderQuestion(9);
    asked.settings.monitor = reinterpret_cast<raytracer::RenderMonitor*>(&asked);

    const auto questions = decodeQuestions(encodeQuestions({asked}));

    const auto& got = std::get<RenderQuestion>(questions.at(0));
    EXPECT_EQ(got.settings.monitor, nullptr);
    EXPECT_EQ(got.settings.dofRayCount, 3);
    EXPECT_EQ(got.settings.seed, 7U);
    EXPECT_EQ(got.repetitions, 2);
    EXPECT_EQ(got.eventCapacity, 9U);
    ASSERT_EQ(got.scene.spheres.size(), 1U);
    ASSERT_EQ(got.scene.planes.size(), 1U);
    EXPECT_EQ(got.scene.spheres[0].material.colour, asked.scene.spheres[0].material.colour);
    ASSERT_NE(got.scene.spheres[0].heightMap, nullptr);
    EXPECT_EQ(got.scene.spheres[0].heightMap->at(7, 3), asked.scene.spheres[0].heightMap->at(7, 3));
    EXPECT_EQ(got.scene.pointLights.at(0).intensity(), 100.0);
}

TEST(Wire, CarriesEveryFieldOfACallQuestion) {
    const CallQuestion asked{"fog", tests::smallScene(), 9, 2, {1.0, 2.0, 3.0, 4.0}};

    const auto questions = decodeQuestions(encodeQuestions({asked}));

    const auto& got = std::get<CallQuestion>(questions.at(0));
    EXPECT_EQ(got.function, "fog");
    EXPECT_EQ(got.scene.spheres.size(), asked.scene.spheres.size());
    EXPECT_EQ(got.seed, 9U);
    EXPECT_EQ(got.width, 2U);
    EXPECT_EQ(got.arguments, asked.arguments);
}

/// Sets a value's fields to its defaults, and the bytes between them to `garbage`.
template <class Value>
void remake(Value& value, unsigned char garbage) {
    alignas(Value) std::array<unsigned char, sizeof(Value)> memory{};
    memory.fill(garbage);
    const auto* made = new (memory.data()) Value;
    std::memcpy(&value, made, sizeof value);
}

TEST(Wire, MakesEqualMessagesOfEqualQuestionsWhateverLayInMemory) {
    const auto messageOver = [](unsigned char garbage) {
        RenderQuestion picture = tests::renderQuestion(9);
        remake(picture.settings, garbage);
        IlluminateQuestion light = tests::illuminateQuestion(5);
        remake(light.points.at(0), garbage);
        return encodeQuestions({picture, light});
    };
    EXPECT_EQ(messageOver(0x00), messageOver(0xFF));
}

TEST(Wire, RefusesArgumentsThatAreNoWholeRows) {
    EXPECT_THROW(std::ignore = encodeQuestions({CallQuestion{"fog", {}, 0, 2, {1.0, 2.0, 3.0}}}),
                 raytracer::Error);
    EXPECT_THROW(std::ignore = encodeQuestions({CallQuestion{"fog", {}, 0, 0, {}}}),
                 raytracer::Error);
}

TEST(Wire, SendsHeightsThatAreNoBytesInFull) {
    RenderQuestion asked = tests::renderQuestion();
    asked.scene.spheres[0].heightMap =
        std::make_shared<const raytracer::HeightMap>(4, 4, std::vector<double>(16, 1.0 / 3.0));

    const auto questions = decodeQuestions(encodeQuestions({asked}));

    const auto& got = std::get<RenderQuestion>(questions.at(0));
    EXPECT_EQ(got.scene.spheres[0].heightMap->at(1, 1), 1.0 / 3.0);
}

TEST(Wire, RefusesAPointOnAnObjectThatIsNotThere) {
    IlluminateQuestion question = tests::illuminateQuestion();
    question.points[0].object = 2;
    EXPECT_THROW(static_cast<void>(encodeQuestions({question})), raytracer::Error);
}

TEST(Wire, RefusesAMapThatContradictsItsSize) {
    NormalQuestion question = tests::normalQuestion();
    question.map.rows.pop_back();
    EXPECT_THROW(static_cast<void>(encodeQuestions({question})), raytracer::Error);
}

TEST(Wire, RefusesEveryCutMessage) {
    const auto message = encodeQuestions(sampleQuestions());
    for (std::size_t size = 0; size < message.size(); ++size) {
        const std::span<const std::byte> cut{message.data(), size};
        EXPECT_THROW(static_cast<void>(decodeQuestions(cut)), raytracer::Error) << size;
    }
}

TEST(Wire, SurvivesAnyByteBeingChanged) {
    auto message = encodeQuestions(sampleQuestions());
    std::mt19937 generator{1};
    for (std::byte& byte : message) {
        const std::byte before = byte;
        byte = static_cast<std::byte>(generator() & 0xFFU);
        try {
            static_cast<void>(decodeQuestions(message));
        } catch (const raytracer::Error&) {  // refused: as good as understood
        }
        byte = before;
    }
}

}  // namespace
}  // namespace ticker::probe

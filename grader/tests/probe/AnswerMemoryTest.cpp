#include <grader/probe/AnswerMemory.h>
#include <grader/tests/support/SampleQuestions.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace ticker::probe {
namespace {

struct Memory {
    explicit Memory(const std::vector<Question>& questions)
        : layout(layoutFor(questions)), words((layout.totalBytes + 7) / 8) {
        fillUnanswered(bytes(), layout);
    }
    std::span<std::byte> bytes() { return std::as_writable_bytes(std::span{words}); }

    void put(std::size_t at, const auto& value) {
        std::memcpy(bytes().data() + at, &value, sizeof value);
    }

    AnswerLayout layout;
    std::vector<std::uint64_t> words;
};

const std::vector<Question> kQuestions{tests::normalQuestion(), tests::illuminateQuestion(4),
                                       tests::renderQuestion(4)};

TEST(AnswerMemory, IsMissingEverywhereBeforeAnybodyAnswered) {
    Memory memory{kQuestions};

    const auto answers = readAnswers(kQuestions, memory.bytes());

    ASSERT_EQ(answers.size(), 3U);
    EXPECT_FALSE(saysFinished(memory.bytes()));
    const auto& normals = std::get<NormalAnswer>(answers[0]);
    EXPECT_EQ(normals.state, AnswerState::missing);
    EXPECT_EQ(normals.exceptions, 0U);
    ASSERT_EQ(normals.normals.size(), 3U);
    EXPECT_TRUE(std::isnan(normals.normals[2].z));
    EXPECT_TRUE(isUnanswered(normals.normals[2]));
    const auto& render = std::get<RenderAnswer>(answers[2]);
    EXPECT_TRUE(render.events.empty());
    EXPECT_FALSE(render.eventsCut);
    EXPECT_FALSE(render.wrongSize);
    ASSERT_EQ(render.images.size(), 2U);
    EXPECT_EQ(render.images[1].size(), 48U);
    EXPECT_TRUE(isUnanswered(render.images[1][47]));
}

TEST(AnswerMemory, TellsAComputedNotANumberFromAMissingOne) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(isUnanswered(Vector3{nan, nan, nan}));
}

TEST(AnswerMemory, CutsATextWithoutAnEnd) {
    Memory memory{kQuestions};
    AnswerHeader header;
    header.state = 2;
    std::memset(header.message, 'x', sizeof header.message);
    memory.put(memory.layout.places[0].header, header);

    const auto answers = readAnswers(kQuestions, memory.bytes());

    EXPECT_EQ(std::get<NormalAnswer>(answers[0]).state, AnswerState::threw);
    EXPECT_EQ(std::get<NormalAnswer>(answers[0]).message, std::string(231, 'x'));
}

TEST(AnswerMemory, ClampsCountsAndDropsEventsThatCannotBe) {
    Memory memory{kQuestions};
    AnswerHeader header;
    header.state = 1;
    header.exceptions = 4'000'000'000U;
    header.eventsSeen = std::numeric_limits<std::uint64_t>::max();
    const AnswerPlace& place = memory.layout.places[1];
    memory.put(place.header, header);
    Event event;
    const auto putEvent = [&](std::size_t slot, Event::Kind kind) {
        const auto written = static_cast<std::uint16_t>(static_cast<std::uint16_t>(kind) + 1U);
        memory.put(place.events + slot * sizeof event, event);
        memory.put(place.events + slot * sizeof event, written);
    };
    const auto noKind =
        static_cast<Event::Kind>(static_cast<std::uint16_t>(Event::Kind::pixelSet) + 1U);
    putEvent(0, Event::Kind::rayCast);  // the only possible one
    putEvent(1, noKind);
    event.object = 2;
    putEvent(2, Event::Kind::rayCast);  // no such object
    event.object = 1;
    event.ask = 2;
    putEvent(3, Event::Kind::rayCast);  // no such point

    const auto answers = readAnswers(kQuestions, memory.bytes());

    const auto& lit = std::get<IlluminateAnswer>(answers[1]);
    EXPECT_EQ(lit.exceptions, 2U);
    EXPECT_TRUE(lit.eventsCut);
    ASSERT_EQ(lit.events.size(), 1U);
    EXPECT_EQ(lit.events[0].kind, Event::Kind::rayCast);
}

TEST(AnswerMemory, SurvivesAnyContent) {
    Memory memory{kQuestions};
    std::mt19937_64 generator{2};
    for (int round = 0; round < 50; ++round) {
        for (std::uint64_t& word : memory.words)
            word = generator() & (round % 2 == 0 ? ~0ULL : 0x0000000300000003ULL);
        const auto answers = readAnswers(kQuestions, memory.bytes());
        EXPECT_EQ(std::get<RenderAnswer>(answers[2]).images.size(), 2U);
        EXPECT_LE(std::get<RenderAnswer>(answers[2]).events.size(), 4U);
    }
}

TEST(AnswerMemory, RefusesAnswersLargerThanAGibibyte) {
    RenderQuestion question = tests::renderQuestion();
    question.settings.width = 4096;
    question.settings.height = 4096;
    question.repetitions = 3;
    EXPECT_THROW(static_cast<void>(layoutFor({question})), raytracer::Error);
}

TEST(AnswerMemory, RefusesAMemoryThatIsTooSmall) {
    Memory memory{kQuestions};
    const auto cut = memory.bytes().first(memory.layout.totalBytes - 1);
    EXPECT_THROW(static_cast<void>(readAnswers(kQuestions, cut)), raytracer::Error);
}

}  // namespace
}  // namespace ticker::probe
